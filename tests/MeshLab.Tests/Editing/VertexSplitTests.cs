using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.5")]
public class VertexSplitTests
{
    //      \   a   /              \   a   /
    //        \ | /                  / \
    //      ─── v ───      ⟶     ─ w ─── v ─
    //        / | \                  \ /
    //      /   b   \              /   b   \
    private static Mesh Wheel() => Models.Fan(6);

    [Fact]
    public void TrySplit_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone()
    {
        Mesh mesh = Wheel();
        Vertex hub = mesh.Vertices[0], rim = mesh.Vertices[1];
        ulong before = mesh.StateHash();

        Assert.False(hub.TrySplit(rim, rim, out _, out VertexSplitRefusal why));
        Assert.Equal(VertexSplitRefusal.OneSector, why);
        Assert.False(rim.TrySplit(default, default, out _, out why));
        Assert.Equal(VertexSplitRefusal.OneSector, why);
        Assert.False(rim.TrySplit(hub, mesh.Vertices[4], out _, out why));
        Assert.Equal(VertexSplitRefusal.NotNeighbor, why);
        Assert.False(hub.TrySplit(rim, default, out _, out why));
        Assert.Equal(VertexSplitRefusal.NoHole, why);
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<TopologyException>(() => hub.Split(rim, rim));
        Assert.Throws<ArgumentException>(() => hub.Split(rim, Wheel().Vertices[3]));
        Assert.Throws<ArgumentException>(() => hub.Split(rim, mesh.Vertices[3], default, new(double.NaN, 0, 0)));
    }

    [Fact]
    public void Split_Hub_GivesTheNewVertexTheSectorFromAToB()
    {
        Mesh mesh = Wheel();
        Vertex v = mesh.Vertices[0], a = mesh.Vertices[1], b = mesh.Vertices[4];
        (int vertices, int edges, int faces) = (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count);

        Vertex w = v.Split(a, b);

        Assert.Equal([0, 1, 2, 3, 4], w.Neighbors.Select(u => u.Index).Order());
        Assert.Equal([1, 4, 5, 6, 7], v.Neighbors.Select(u => u.Index).Order());
        Assert.Equal((vertices + 1, edges + 3, faces + 2), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Equal(a, mesh.FindHalfEdge(w, v).Next.Target);
        Assert.Equal(b, mesh.FindHalfEdge(v, w).Next.Target);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_WithoutPositions_GoesThreeTenthsToTheMiddleNeighbors()
    {
        Mesh mesh = Wheel();
        Vertex v = mesh.Vertices[0];
        Vector3D inNew = mesh.Vertices[2].Position, inOld = mesh.Vertices[5].Position;

        Vertex w = v.Split(mesh.Vertices[1], mesh.Vertices[3]);

        // From 1 to 3 the middle is 2; from 3 to 1 over 4, 5, 6 it is 5.
        Assert.Equal(0, Vector3D.Distance(inNew * 0.3, w.Position), 1e-15);
        Assert.Equal(0, Vector3D.Distance(inOld * 0.3, v.Position), 1e-15);
    }

    [Theory]
    [InlineData("octahedron")]
    [InlineData("cube-quads")]
    [InlineData("prism-6")]
    [InlineData("annulus")]
    [InlineData("mixed-polygons")]
    [InlineData("one-triangle")]
    [InlineData("tetrahedron")]
    public void SplitThenCollapse_EveryPairOfNeighbors_RestoresTheConnectivity(string name)
    {
        Mesh mesh = Models.Create(name);
        string before = Faces(mesh);
        ulong hash = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        for (int i = 0; i < mesh.VertexSlots; i++)
        {
            Vertex v = mesh.Vertices[i];
            List<Vertex> spokes = [.. v.Neighbors];
            if (v.IsBoundary)
                spokes.Add(default);
            foreach (Vertex a in spokes)
            {
                foreach (Vertex b in spokes.Where(b => b != a))
                {
                    Vector3D p = v.Position;
                    Vertex w = v.Split(a, b, p, p);
                    Assert.Empty(mesh.Validate());
                    mesh.FindHalfEdge(w, v).Collapse(p);
                    Assert.Empty(mesh.Validate());
                    Assert.Equal(before, Faces(mesh));
                    history.UndoAll();
                    Assert.Equal(hash, mesh.StateHash());
                }
            }
        }
    }

    //    2 ─ 1          2 ─ 1
    //     \ │    ⟶       \ │ \
    //       0              0 ─ 3
    [Fact]
    public void Split_BoundaryTowardsTheHole_MakesOneTriangle()
    {
        Mesh mesh = Models.Create("one-triangle");
        Vertex w = mesh.Vertices[0].Split(default, mesh.Vertices[1]);

        Assert.True(w.IsBoundary);
        Assert.Equal((4, 5, 2), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_WithTraits_CopiesThem()
    {
        Mesh mesh = Wheel();
        VertexTrait<int> name = mesh.AddVertexTrait("name", 0);
        FaceTrait<int> face = mesh.AddFaceTrait("face", 0);
        foreach (Face f in mesh.Faces)
            face[f] = 3;
        name[mesh.Vertices[0]] = 8;

        Vertex w = mesh.Vertices[0].Split(mesh.Vertices[1], mesh.Vertices[4]);

        Assert.Equal(8, name[w]);
        Assert.All(mesh.Faces, f => Assert.Equal(3, face[f]));
    }

    /// <summary>The faces as cyclic lists of vertices, whatever their indices.</summary>
    private static string Faces(Mesh mesh) => string.Join('\n', mesh.Faces.Select(Cycle).Order(StringComparer.Ordinal));

    private static string Cycle(Face f)
    {
        int[] v = [.. f.Vertices.Select(x => x.Index)];
        int least = Array.IndexOf(v, v.Min());
        return string.Join(' ', v.Skip(least).Concat(v.Take(least)));
    }
}
