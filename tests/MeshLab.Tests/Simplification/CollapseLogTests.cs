using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>What contractions do to traits.</summary>
[Trait("Section", "7.2")]
public class CollapseLogTests
{
    [Theory]
    [InlineData(3, 0, 0.25)]
    [InlineData(2, 0, 0)]
    [InlineData(6, 0, 1)]
    [InlineData(-5, 0, 0)]
    [InlineData(11, 0, 1)]
    [InlineData(4, 9, 0.5)]
    public void Parameter_PlaceBesideTheEdge_IsThatOfItsFoot(double x, double y, double expected) =>
        Assert.Equal(expected, TraitLog.Parameter(new(2, 0, 0), new(6, 0, 0), new(x, y, -y)));

    [Fact]
    public void Parameter_EdgeWithoutLength_IsTheMiddle() => Assert.Equal(0.5, TraitLog.Parameter(new(1, 2, 3), new(1, 2, 3), new(4, 4, 4)));

    /// <summary>Two pairs of edges become one each, with the mean of their values; all others keep theirs.</summary>
    [Fact]
    public void Simplify_EdgeTraits_AreMixedWhereTwoEdgesBecomeOne()
    {
        Mesh mesh = Shapes.Moved(Models.Create("octahedron"), p => p + new Vector3D(0.1 * p.X * p.Y, 0.3 * p.Z, 0.2 * p.X));
        EdgeTrait<double> number = mesh.AddEdgeTrait("number", 0.0, Blend.Linear);
        foreach (Edge e in mesh.Edges)
            number[e] = Math.Pow(2, e.Index);
        Mesh before = mesh.Clone();
        using var trace = new StringWriter();

        mesh.Simplify(new() { TargetFaces = 6, AllowFlips = true, Trace = trace });

        System.Text.Json.JsonElement line = System.Text.Json.JsonDocument.Parse(trace.ToString()).RootElement;
        Vertex kept = before.Vertices[line.GetProperty("kept").GetInt32()], removed = before.Vertices[line.GetProperty("removed").GetInt32()];
        double Value(Edge e) => Math.Pow(2, e.Index);
        var expected = before.Edges.Where(e => !e.Vertices.Contains(removed) && !e.Vertices.Contains(kept)).Select(Value).ToList();
        foreach (Vertex v in kept.Neighbors.Union(removed.Neighbors).Where(v => v != kept && v != removed))
        {
            Edge a = before.FindEdge(kept, v), b = before.FindEdge(removed, v);
            expected.Add(a.IsNone ? Value(b) : b.IsNone ? Value(a) : (Value(a) + Value(b)) / 2);
        }
        Assert.Equal(expected.Order(), mesh.Edges.Select(e => number[e]).Order());
        Assert.Empty(mesh.Validate());
    }

    /// <summary>Along borders too, on whichever side of its edge the border lies; holes make borders to the left.</summary>
    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    public void Simplify_TextureWithHoles_StaysWithThePositions(QuadricMode mode)
    {
        Mesh mesh = Shapes.Sheet(14);
        for (int f = 60; f < 300; f += 61)
            mesh.Faces[f].Delete();
        HalfEdgeTrait<Vector2D> texture = mesh.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear);
        foreach (HalfEdge h in mesh.HalfEdges)
            texture[h] = h.IsBoundary ? new(77, 77) : new(h.Target.Position.X, h.Target.Position.Y);

        mesh.Simplify(new() { TargetFaces = 60, Mode = mode, Placement = VertexPlacement.Segment });

        foreach (HalfEdge h in mesh.HalfEdges.Where(h => !h.IsBoundary))
            Assert.Equal(0, Vector3D.Distance(h.Target.Position, new(texture[h].X, texture[h].Y, 0)), 1e-10);
        Assert.Empty(mesh.Validate());
    }
}
