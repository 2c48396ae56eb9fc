using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.8")]
public class BoundaryStitchTests
{
    private static HalfEdge Rim(Mesh mesh, int from, int to) => mesh.FindHalfEdge(mesh.Vertices[from], mesh.Vertices[to]);

    [Fact]
    public void TryStitch_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone()
    {
        Mesh mesh = Models.QuadGrid(2, 1);
        ulong before = mesh.StateHash();
        HalfEdge bottom = Rim(mesh, 1, 0), inner = Rim(mesh, 1, 4);

        Assert.False(bottom.TryStitch(inner, out StitchRefusal why));
        Assert.Equal(StitchRefusal.NotBoundary, why);
        Assert.False(bottom.TryStitch(bottom, out why));
        Assert.Equal(StitchRefusal.NotBoundary, why);
        // 3 → 4 against 1 → 0 would bring 0 and 3 together, which an edge joins.
        Assert.False(bottom.TryStitch(Rim(mesh, 3, 4), out why));
        Assert.Equal(StitchRefusal.Adjacent, why);
        // 3 and 5 have the inner neighbour 4; 1 does not count, since 0–1 and 1–2 would be stitched as well.
        Mesh larger = Models.QuadGrid(2, 2);
        Assert.False(Rim(larger, 0, 3).TryStitch(Rim(larger, 5, 2), out why));
        Assert.Equal(StitchRefusal.LinkCondition, why);
        Assert.False(mesh.Vertices[0].TryMerge(mesh.Vertices[5], out why));
        Assert.Equal(StitchRefusal.Pinch, why);
        Assert.False(mesh.Vertices[0].TryMerge(mesh.Vertices[1], out why));
        Assert.Equal(StitchRefusal.Adjacent, why);
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<TopologyException>(() => bottom.Stitch(inner));
        Assert.Throws<TopologyException>(() => mesh.Vertices[0].Merge(mesh.Vertices[5]));
    }

    //   3 ─ 2   7 ─ 6          3 ─ 2 ─ 6
    //   │   │   │   │    ⟶     │   │   │
    //   0 ─ 1   4 ─ 5          0 ─ 1 ─ 5
    [Fact]
    public void Stitch_TwoSquares_GluesThem()
    {
        Mesh mesh = MeshBuilder.FromPolygons(
            [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(2, 0, 0), new(3, 0, 0), new(3, 1, 0), new(2, 1, 0)],
            [0, 1, 2, 3],
            [4, 5, 6, 7]);
        Rim(mesh, 2, 1).Stitch(Rim(mesh, 4, 7));

        Assert.Equal((6, 7, 2), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Equal(new Vector3D(1.5, 0, 0), mesh.Vertices[1].Position);
        Assert.True(mesh.Vertices[4].IsDeleted);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Stitch_EndsOfAStrip_MakesARing()
    {
        Mesh mesh = Models.QuadGrid(6, 1);
        Rim(mesh, 0, 7).Stitch(Rim(mesh, 13, 6));
        Assert.Equal((12, 18, 6), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    //   A hole of four edges: merging two opposite corners closes it altogether.
    [Fact]
    public void Merge_AcrossAQuadHole_ClosesBothSides()
    {
        Mesh mesh = Models.Create("sphere");
        Edge edge = mesh.Edges[60];
        Vertex c = edge.HalfEdge0.Next.Target, d = edge.HalfEdge1.Next.Target;
        edge.Delete();
        c.Merge(d);

        Assert.True(d.IsDeleted);
        Assert.True(mesh.IsClosed);
        Assert.Equal(2, mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Merge_TwoStepsApart_KeepsTheVertexItIsCalledOn()
    {
        Mesh mesh = Models.Fan(8);
        Vertex v = mesh.Vertices[3], w = mesh.Vertices[5];
        Assert.False(v.CanMerge(w, out StitchRefusal why));
        Assert.Equal(StitchRefusal.LinkCondition, why);

        mesh = Models.Create("grid");
        mesh.Vertices[18].Delete();
        Vertex keep = mesh.Vertices.First(x => x.IsBoundary && !x.Outgoing.Next.Target.IsNeighborOf(x)
            && x.CanMerge(x.Outgoing.Next.Target, out _));
        Vertex gone = keep.Outgoing.Next.Target;
        keep.Merge(gone);
        Assert.True(gone.IsDeleted);
        Assert.False(keep.IsDeleted);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.BoundaryMeshes), MemberType = typeof(Models))]
    public void Undo_AfterStitchingWhateverIsLegal_RestoresEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count > 500)
            return;
        mesh.AddVertexTrait("t", 0.0, Blend.Linear);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        var random = new Random(5);
        for (int i = 0; i < 200; i++)
        {
            HalfEdge[] rims = [.. mesh.HalfEdges.Where(h => h.IsBoundary)];
            if (rims.Length == 0)
                break;
            HalfEdge g = rims[random.Next(rims.Length)], k = i % 3 == 0 ? g.Next : rims[random.Next(rims.Length)];
            ulong state = mesh.StateHash();
            bool done = i % 2 == 0 ? g.TryStitch(k, out _) : g.Source.TryMerge(k.Target, out _);
            Assert.Equal(!done, state == mesh.StateHash());
            Assert.Empty(mesh.Validate());
        }
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }
}
