using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.8")]
public class EdgeSplitTests
{
    //      2                2
    //    /   \            / | \
    //   0 ─── 1    ⟶    0 ─ 4 ─ 1
    //    \   /            \ | /
    //      3                3
    private static Mesh TwoTriangles() => MeshBuilder.FromTriangles(
        [new(0, 0, 0), new(2, 0, 0), new(1, 1, 0), new(1, -1, 0)], [0, 1, 2, 1, 0, 3]);

    [Fact]
    public void TrySplit_BothApexesOneVertex_RefusesAndLeavesTheMeshAlone()
    {
        Mesh mesh = MeshBuilder.FromFaces(3, [0, 1, 2], [0, 2, 1]);
        ulong before = mesh.StateHash();
        Assert.False(mesh.Edges[0].TrySplit(default, out Vertex created, out EdgeSplitRefusal why));
        Assert.Equal(EdgeSplitRefusal.SameApex, why);
        Assert.True(created.IsNone);
        Assert.False(mesh.Edges[0].CanSplit(out _));
        Assert.Throws<TopologyException>(() => mesh.Edges[0].Split());
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void Split_DeletedOrNoneOrNotFinite_Throws()
    {
        Mesh mesh = TwoTriangles();
        Edge edge = mesh.Edges[0];
        Assert.Throws<ArgumentException>(() => edge.Split(new Vector3D(double.NaN, 0, 0)));
        Assert.Throws<ArgumentException>(() => default(Edge).Split());
        edge.Delete();
        Assert.Throws<ArgumentException>(() => edge.Split());
    }

    [Fact]
    public void Split_InnerEdge_MakesFourTriangles()
    {
        Mesh mesh = TwoTriangles();
        Vertex m = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).Split();

        Assert.Equal(4, m.Index);
        Assert.Equal(new Vector3D(1, 0, 0), m.Position);
        Assert.Equal([0, 1, 2, 3], m.Neighbors.Select(v => v.Index).Order());
        Assert.Equal((5, 8, 4), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.True(mesh.IsTriangleMesh);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_BoundaryEdge_SplitsItsOneTriangle()
    {
        Mesh mesh = TwoTriangles();
        Vertex m = mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[2]).Split(new(1.5, 0.5, 0));

        Assert.True(m.IsBoundary);
        Assert.Equal([0, 1, 2], m.Neighbors.Select(v => v.Index).Order());
        Assert.Equal((5, 7, 3), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_BetweenQuads_OnlyAddsTheVertex()
    {
        Mesh mesh = Models.QuadGrid(2, 1);
        Vertex m = mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[4]).Split();

        Assert.Equal(2, m.Valence);
        Assert.All(mesh.Faces, f => Assert.Equal(5, f.Degree));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_WithTraits_BlendsByTheParameter()
    {
        Mesh mesh = TwoTriangles();
        VertexTrait<double> x = mesh.AddVertexTrait<double>("x", 0, Blend.Linear);
        HalfEdgeTrait<double> cornerX = mesh.AddHalfEdgeTrait<double>("x", 0, Blend.Linear);
        EdgeTrait<int> edgeName = mesh.AddEdgeTrait("name", -1);
        FaceTrait<int> faceName = mesh.AddFaceTrait("name", -1);
        foreach (Vertex v in mesh.Vertices)
            x[v] = v.Position.X;
        foreach (HalfEdge h in mesh.HalfEdges)
            cornerX[h] = h.Target.Position.X;
        foreach (Face f in mesh.Faces)
            faceName[f] = f.Index;
        Edge edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]);
        edgeName[edge] = 7;

        Vertex m = edge.Split(new(0.5, 0, 0));

        Assert.Equal(0.5, x[m]);
        Assert.All(mesh.HalfEdges.Where(h => !h.IsBoundary), h => Assert.Equal(h.Target.Position.X, cornerX[h]));
        Assert.Equal(2, mesh.Edges.Count(e => edgeName[e] == 7));
        Assert.Equal([0, 0, 1, 1], mesh.Faces.Select(f => faceName[f]).Order());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void UndoAndRedo_AfterSplittingEveryEdge_RestoreEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        mesh.AddVertexTrait("t", 1.0, Blend.Linear);
        ulong before = mesh.StateHash();
        int characteristic = mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count, edges = mesh.EdgeSlots;
        using OperationHistory history = mesh.StartRecording();

        for (int e = 0; e < edges; e++)
            mesh.Edges[e].Split();
        Assert.Empty(mesh.Validate());
        Assert.Equal(characteristic, mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count);
        ulong after = mesh.StateHash();

        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
        history.RedoAll();
        Assert.Equal(after, mesh.StateHash());
    }
}
