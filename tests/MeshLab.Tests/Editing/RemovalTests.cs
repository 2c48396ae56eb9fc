using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.2")]
public class RemovalTests
{
    private static readonly RemovalOptions Split = new() { SplitPinched = true };

    //  6 ─ 7 ─ 8        6 ─ 7 ─ 8
    //  │   │ F │        │   │   │
    //  3 ─ 4 ─ 5   ⟶    3 ─ 4 ─ 5     with F gone, E touches the rest in 4 only: refused
    //  │ E │   │        │ E │
    //  0 ─ 1 ─ 2        0 ─ 1
    [Fact]
    public void DeleteFace_LeavingABowTie_IsRefusedAndLeavesTheMeshAlone()
    {
        Mesh mesh = Models.QuadGrid(2, 2);
        mesh.Faces[1].Delete();
        ulong before = mesh.StateHash();

        Assert.False(mesh.Faces[2].TryDelete(out RemovalRefusal why));

        Assert.Equal(RemovalRefusal.Pinch, why);
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<TopologyException>(() => mesh.Faces[2].Delete());
    }

    [Fact]
    public void DeleteFace_LeavingABowTieWithSplitting_GivesEachFanAVertex()
    {
        Mesh mesh = Models.QuadGrid(2, 2);
        VertexTrait<int> name = mesh.AddVertexTrait("name", 0);
        name[mesh.Vertices[4]] = 44;
        mesh.Faces[1].Delete();
        mesh.Faces[2].Delete(Split);

        Assert.Empty(mesh.Validate());
        Assert.Equal(2, mesh.Faces.Count);
        Assert.Equal(8, mesh.Vertices.Count);
        Assert.Equal(2, mesh.Vertices.Count(v => v.Position == mesh.Vertices[4].Position && name[v] == 44));
    }

    [Fact]
    public void DeleteFace_Corner_DeletesTheOrphanOrLeavesItIsolated()
    {
        Mesh mesh = Models.QuadGrid(2, 2);
        mesh.Faces[0].Delete();
        Assert.True(mesh.Vertices[0].IsDeleted);
        Assert.Equal(10, mesh.Edges.Count);
        Assert.Empty(mesh.Validate());

        mesh = Models.QuadGrid(2, 2);
        mesh.Faces[0].Delete(new RemovalOptions { DeleteOrphans = false });
        Assert.True(mesh.Vertices[0].IsIsolated);
        Assert.Equal(9, mesh.Vertices.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void DeleteFace_InTheMiddle_LeavesAHole()
    {
        Mesh mesh = Models.QuadGrid(3, 3);
        mesh.Faces[4].Delete();
        Assert.Equal((16, 24, 8), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.True(mesh.Vertices[5].IsBoundary);
        Assert.Empty(mesh.Validate());
        Assert.Throws<ArgumentException>(() => mesh.Faces[4].Delete());
    }

    //      2                  2
    //    /   \              /   \
    //   0 ─── 1    ⟶      0 hole 1
    //    \   /              \   /
    //      3                  3
    [Fact]
    [Trait("Section", "4.3")]
    public void DeleteEdge_Inside_RemovesBothFaces()
    {
        Mesh mesh = Models.Create("sphere");
        Edge edge = mesh.Edges[50];
        mesh.AddVertexTrait("t", 0);
        (int e, int f) = (mesh.Edges.Count, mesh.Faces.Count);
        edge.Delete();
        Assert.Equal((e - 1, f - 2), (mesh.Edges.Count, mesh.Faces.Count));
        Assert.Equal(4, mesh.HalfEdges.First(h => h.IsBoundary).Loop.Count());
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "4.3")]
    public void DeleteEdge_BetweenTwoRims_IsRefused()
    {
        // A strip two quads wide: its middle edge reaches from rim to rim, and so do its faces.
        Mesh mesh = Models.QuadGrid(3, 2);
        Edge middle = mesh.FindEdge(mesh.Vertices[5], mesh.Vertices[1]);
        Assert.True(middle.CanDelete(out _));
        Mesh diagonal = Models.Create("grid");
        Edge corner = diagonal.Edges.First(e => e.Vertex0.IsBoundary && e.Vertex1.IsBoundary && !e.IsBoundary);
        Assert.Equal(corner.CanDelete(out RemovalRefusal why), why == RemovalRefusal.None);
    }

    //     b ── a               b ── a
    //    / \ / \              /      \
    //   c ─ v ─ f     ⟶      c  hole  f
    //    \ / \ /              \      /
    //     d ── e               d ── e
    [Fact]
    [Trait("Section", "4.4")]
    public void DeleteVertex_Inside_LeavesItsLinkAsTheBoundary()
    {
        Mesh mesh = Models.Create("sphere");
        Vertex v = mesh.Vertices[35];
        int[] link = [.. v.Neighbors.Select(w => w.Index)];
        v.Delete();

        Assert.True(v.IsDeleted);
        HalfEdge rim = mesh.HalfEdges.First(h => h.IsBoundary);
        Assert.Equal(link.Order(), rim.Loop.Select(h => h.Target.Index).Order());
        Assert.Empty(mesh.Validate());
        Assert.Throws<ArgumentException>(() => v.Delete());
    }

    [Fact]
    [Trait("Section", "4.4")]
    public void DeleteVertex_Isolated_OnlyItGoes()
    {
        Mesh mesh = Models.Create("isolated-vertices");
        mesh.Vertices[4].Delete();
        Assert.Equal(5, mesh.Vertices.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "4.4")]
    public void DeleteVertex_EvenWhenOrphansStay_ItGoes()
    {
        Mesh mesh = Models.Create("one-triangle");
        mesh.Vertices[1].Delete(new RemovalOptions { DeleteOrphans = false });
        Assert.Equal((2, 0, 0), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "4.4")]
    public void DeleteTwoRing_Hub_RemovesTheFacesAtItsNeighbors()
    {
        Mesh mesh = Models.Triangulated(Models.QuadGrid(8, 8));
        Vertex v = mesh.Vertices[40];
        HashSet<Face> doomed = [.. v.Faces, .. v.Neighbors.SelectMany(w => w.Faces)];
        int faces = mesh.Faces.Count;
        v.DeleteTwoRing();
        Assert.Equal(faces - doomed.Count, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "4.4")]
    public void DeleteRingsOfEdges_Path_RemovesEveryFaceAtItsEnds()
    {
        Mesh mesh = Models.Triangulated(Models.QuadGrid(8, 8));
        Edge[] path = [mesh.FindEdge(mesh.Vertices[30], mesh.Vertices[31]), mesh.FindEdge(mesh.Vertices[31], mesh.Vertices[32])];
        HashSet<Face> doomed = [.. new[] { 30, 31, 32 }.SelectMany(i => mesh.Vertices[i].Faces)];
        int faces = mesh.Faces.Count;
        mesh.DeleteRingsOfEdges(path);
        Assert.Equal(faces - doomed.Count, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Undo_AfterRandomRemovalsOfEverySort_RestoresEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        mesh.AddFaceTrait("t", 0.5, Blend.Linear);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        var random = new Random(3);
        for (int i = 0; i < 60 && mesh.Faces.Count > 0; i++)
        {
            RemovalOptions options = new() { DeleteOrphans = i % 2 == 0, SplitPinched = i % 3 != 0 };
            ulong state = mesh.StateHash();
            Face f = mesh.Faces.ElementAt(random.Next(mesh.Faces.Count));
            bool done = (i % 4) switch
            {
                0 => f.TryDelete(out _, options),
                1 => f.HalfEdge.Edge.TryDelete(out _, options),
                2 => f.HalfEdge.Target.TryDelete(out _, options),
                _ => mesh.TryDeleteVertices([f.HalfEdge.Target, f.HalfEdge.Source], out _, options),
            };
            Assert.Empty(mesh.Validate());
            Assert.Equal(!done, state == mesh.StateHash());
            Assert.True(done || !options.SplitPinched);
        }
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void DeleteFaces_WithForeignOnes_Throws()
    {
        Mesh mesh = Models.QuadGrid(2, 2);
        Assert.Throws<ArgumentException>(() => mesh.DeleteFaces([Models.QuadGrid(1, 1).Faces[0]]));
        Assert.Throws<TopologyException>(() => mesh.DeleteFaces([mesh.Faces[1], mesh.Faces[2]]));
        mesh.DeleteFaces([mesh.Faces[1], mesh.Faces[2], mesh.Faces[1]], Split);
        Assert.Empty(mesh.Validate());
        mesh.DeleteFaces(mesh.Faces);
        Assert.Equal((0, 0, 0), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
    }
}
