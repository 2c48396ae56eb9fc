using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.6")]
public class EdgeCollapseTests
{
    //         c                     c
    //       / | \                   |
    //   ── u ─h→ v ──     ⟶     ─── v ───
    //       \ | /                   |
    //         d                     d
    [Theory]
    [InlineData(CollapseRefusal.LinkCondition)]
    [InlineData(CollapseRefusal.Pinch)]
    [InlineData(CollapseRefusal.LastBoundaryTriangle)]
    [InlineData(CollapseRefusal.Tetrahedron)]
    [InlineData(CollapseRefusal.TwoGon)]
    public void TryCollapse_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone(CollapseRefusal reason)
    {
        (Mesh mesh, HalfEdge h) = Illegal(reason);
        ulong before = mesh.StateHash();

        Assert.False(h.TryCollapse(out CollapseRefusal why));
        Assert.Equal(reason, why);
        Assert.False(h.Twin.CanCollapse(out why));
        Assert.Equal(reason, why);
        Assert.Equal(before, mesh.StateHash());
        Assert.Contains(h.Edge.ToString(), Assert.Throws<TopologyException>(() => h.Collapse()).Message, StringComparison.Ordinal);
    }

    private static (Mesh Mesh, HalfEdge H) Illegal(CollapseRefusal reason)
    {
        Mesh mesh = reason switch
        {
            // A ring of three vertices between two apexes: the ends of a ring edge have the third ring vertex in common.
            CollapseRefusal.LinkCondition => Models.Bipyramid(3),
            // The diagonal of a square.
            CollapseRefusal.Pinch => MeshBuilder.FromFaces(4, [0, 1, 2], [0, 2, 3]),
            // A triangle without neighbours, whose rim has three edges.
            CollapseRefusal.LastBoundaryTriangle => MeshBuilder.FromFaces(3, [0, 1, 2]),
            CollapseRefusal.Tetrahedron => Models.Tetrahedron(),
            // Two triangles back to back.
            _ => MeshBuilder.FromFaces(3, [0, 1, 2], [0, 2, 1]),
        };
        int to = reason == CollapseRefusal.Pinch ? 2 : 1;
        return (mesh, mesh.FindHalfEdge(mesh.Vertices[0], mesh.Vertices[to]));
    }

    [Fact]
    public void CanCollapse_HoleOfThreeEdges_SaysLastBoundaryTriangle()
    {
        Mesh mesh = Models.Create("sphere");
        mesh.Faces[40].Delete();
        HalfEdge rim = mesh.HalfEdges.First(h => h.IsBoundary);
        Assert.False(rim.CanCollapse(out CollapseRefusal why));
        Assert.Equal(CollapseRefusal.LastBoundaryTriangle, why);
    }

    // A cube whose edge 0–1 lies between two quads; a hexagon elsewhere has both ends as corners.
    //   4 ─── 5
    //   │     │
    //   0 ─── 1
    //   │     │
    //   2 ─── 3
    [Fact]
    public void CanCollapse_EndsInACommonPolygonElsewhere_SaysLinkCondition()
    {
        Mesh mesh = MeshBuilder.FromFaces(8, [0, 1, 5, 4], [1, 0, 2, 3], [4, 6, 0], [7, 1, 3], [0, 6, 7, 3, 2]);
        Assert.Empty(mesh.Validate());
        Mesh closed = MeshBuilder.FromFaces(7, [0, 1, 5, 4], [1, 0, 2, 3], [0, 4, 6, 1, 3, 2]);
        Assert.False(closed.FindHalfEdge(closed.Vertices[0], closed.Vertices[1]).CanCollapse(out CollapseRefusal why));
        Assert.Equal(CollapseRefusal.LinkCondition, why);
    }

    [Fact]
    public void Collapse_DeadOrNoneOrNotFinite_Throws()
    {
        Mesh mesh = Models.Create("sphere");
        HalfEdge h = mesh.HalfEdges[0];
        Assert.Throws<ArgumentException>(() => h.Collapse(new Vector3D(0, double.NaN, 0)));
        Assert.Throws<ArgumentException>(() => default(HalfEdge).Collapse());
        h.Collapse();
        Assert.Throws<ArgumentException>(() => h.CanCollapse(out _));
    }

    [Fact]
    public void Collapse_InnerEdge_KeepsTheTargetAndRemovesOneThreeTwo()
    {
        Mesh mesh = Models.Create("sphere");
        (int v, int e, int f) = (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count);
        HalfEdge h = mesh.FindHalfEdge(mesh.Vertices[23], mesh.Vertices[24]);
        Vertex source = h.Source, target = h.Target;
        Vector3D middle = (source.Position + target.Position) * 0.5;

        Assert.Equal(target, h.Collapse());

        Assert.True(source.IsDeleted);
        Assert.Equal(middle, target.Position);
        Assert.Equal((v - 1, e - 3, f - 2), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Collapse_BoundaryEdge_RemovesOneTwoOne()
    {
        Mesh mesh = Models.Create("grid");
        (int v, int e, int f) = (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count);
        Vertex survivor = mesh.FindHalfEdge(mesh.Vertices[3], mesh.Vertices[2]).Collapse(mesh.Vertices[2].Position);

        Assert.True(survivor.IsBoundary);
        Assert.Equal((v - 1, e - 2, f - 1), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Collapse_BoundaryVertexIntoInnerOne_MakesItABoundaryVertex()
    {
        Mesh mesh = Models.Create("grid");
        Vertex inner = mesh.Vertices.First(v => !v.IsBoundary);
        HalfEdge h = inner.IncomingHalfEdges.First(k => k.Source.IsBoundary && k.CanCollapse(out _));

        Assert.True(h.Collapse().IsBoundary);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Collapse_BetweenQuads_MakesThemTriangles()
    {
        Mesh mesh = Models.QuadGrid(3, 3);
        HalfEdge h = mesh.FindHalfEdge(mesh.Vertices[5], mesh.Vertices[6]);
        Face left = h.Face, right = h.Twin.Face;
        h.Collapse();

        Assert.Equal((3, 3), (left.Degree, right.Degree));
        Assert.Equal(15, mesh.Vertices.Count);
        Assert.Equal(9, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Collapse_WithTraits_BlendsByTheNewPosition()
    {
        Mesh mesh = Models.Create("grid");
        VertexTrait<double> x = mesh.AddVertexTrait<double>("x", 0, Blend.Linear);
        EdgeTrait<double> weight = mesh.AddEdgeTrait<double>("weight", 0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            x[v] = v.Position.X;
        HalfEdge h = mesh.FindHalfEdge(mesh.Vertices[18], mesh.Vertices[19]);
        weight[h.Next.Edge] = 4;
        weight[h.Previous.Edge] = 2;
        Edge merged = h.Next.Edge;
        Vector3D p = Vector3D.Lerp(h.Source.Position, h.Target.Position, 0.25);

        Vertex survivor = h.Collapse(p);

        Assert.Equal(p.X, x[survivor], 1e-14);
        Assert.Equal(3, weight[merged]);
    }

    [Fact]
    public void Collapse_Hub_IsLegalThroughTheSortedPath()
    {
        Mesh mesh = Models.Bipyramid(300);
        mesh.FindHalfEdge(mesh.Vertices[7], mesh.Vertices[8]).Collapse();
        mesh.FindHalfEdge(mesh.Vertices[20], mesh.Vertices[300]).CanCollapse(out CollapseRefusal why);
        Assert.Equal(CollapseRefusal.None, why);
        mesh.FindHalfEdge(mesh.Vertices[300], mesh.Vertices[301].Neighbors.First()).TryCollapse(out _);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Undo_AfterCollapsingWhateverIsLegal_RestoresEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        mesh.AddHalfEdgeTrait("corner", 1.5, Blend.Linear);
        ulong before = mesh.StateHash();
        int characteristic = mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count;
        using OperationHistory history = mesh.StartRecording();

        int collapsed = 0;
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (!mesh.Edges[e].IsDeleted && mesh.Edges[e].HalfEdge0.TryCollapse(out _) && ++collapsed % 20 == 0)
                Assert.Empty(mesh.Validate());
        }
        Assert.Empty(mesh.Validate());
        Assert.Equal(characteristic, mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count);

        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void CollapseFlips_MovingBeyondTheRing_IsTrue()
    {
        Mesh mesh = Models.Create("grid");
        HalfEdge h = mesh.FindHalfEdge(mesh.Vertices[18], mesh.Vertices[19]);
        Assert.False(h.CollapseFlips((h.Source.Position + h.Target.Position) * 0.5));
        Assert.True(h.CollapseFlips(new Vector3D(5, 5, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => h.CollapseFlips(default, 1.5));
    }

    /// <summary>Beside the definition itself: a face of the ring, other than the two that vanish, turns by 90° or more.</summary>
    [Theory]
    [InlineData("grid")]
    [InlineData("holes")]
    [InlineData("bumpy-sphere")]
    public void CollapseFlips_AnyPlace_AgreesWithTheDefinition(string name)
    {
        Mesh mesh = Models.Create(name);
        var random = new Random(4);
        int flips = 0;
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            Vector3D source = h.Source.Position, target = h.Target.Position;
            Vector3D place = (source + target) * 0.5 + (target - source).Length * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5) * 2;
            bool expected = Turns(h.Source) || Turns(h.Target);
            Assert.True(expected == h.CollapseFlips(place), $"{name} {h}");
            flips += expected ? 1 : 0;

            bool Turns(Vertex v) => v.Faces.Any(f => f != h.Face && f != h.Twin.Face && Vector3D.Dot(Normal(f, v, v.Position), Normal(f, v, place)) < 0);
        }
        Assert.InRange(flips, mesh.HalfEdges.Count / 20, mesh.HalfEdges.Count);

        static Vector3D Normal(Face f, Vertex moved, Vector3D to)
        {
            Vector3D[] p = [.. f.Vertices.Select(v => v == moved ? to : v.Position)];
            return Vector3D.Cross(p[1] - p[0], p[2] - p[0]);
        }
    }
}
