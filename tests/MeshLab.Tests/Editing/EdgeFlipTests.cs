using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.7")]
public class EdgeFlipTests
{
    //      2                2
    //    /   \            / | \
    //   0 ─── 1    ⟶    0   |   1
    //    \   /            \ | /
    //      3                3
    private static Mesh TwoTriangles() => MeshBuilder.FromFaces(4, [0, 1, 2], [1, 0, 3]);

    [Fact]
    public void TryFlip_OuterEdge_RefusesAndLeavesTheMeshAlone()
    {
        Mesh mesh = TwoTriangles();
        ulong before = mesh.StateHash();

        Assert.False(mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[2]).TryFlip(out FlipRefusal why));

        Assert.Equal(FlipRefusal.Boundary, why);
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void CanFlip_EveryEdgeOfATetrahedron_SaysThatTheDiagonalExists()
    {
        foreach (Edge edge in Models.Tetrahedron().Edges)
        {
            Assert.False(edge.CanFlip(out FlipRefusal why));
            Assert.Equal(FlipRefusal.DiagonalExists, why);
        }
    }

    [Fact]
    public void CanFlip_BesideAQuad_SaysNotTriangles()
    {
        Mesh mesh = MeshBuilder.FromFaces(5, [0, 1, 2], [1, 0, 3, 4]);
        Assert.False(mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).CanFlip(out FlipRefusal why));
        Assert.Equal(FlipRefusal.NotTriangles, why);
    }

    //   Vertex 0 has two triangles and a quad around it; without the edge 0–1 it would have two edges.
    //      2 ─── 4
    //    / | \   │
    //   1 ─0  │  │      faces 0 1 3, 0 2 1, 0 3 4 2
    //    \ | /   │
    //      3 ────┘
    [Fact]
    public void CanFlip_EndOfValenceThreeWithAPolygon_SaysSo()
    {
        Mesh mesh = MeshBuilder.FromFaces(5, [0, 1, 3], [0, 2, 1], [0, 3, 4, 2]);
        Assert.False(mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).CanFlip(out FlipRefusal why));
        Assert.Equal(FlipRefusal.EndOfValenceThree, why);
    }

    [Fact]
    public void Flip_ARefusedEdge_ThrowsWithItsName()
    {
        Edge edge = Models.Tetrahedron().Edges[2];
        var error = Assert.Throws<TopologyException>(() => edge.Flip());
        Assert.Contains("e2", error.Message, StringComparison.Ordinal);
        Assert.Equal(["e2"], error.Elements);
    }

    [Fact]
    public void Flip_TwoTriangles_JoinsTheOtherDiagonal()
    {
        Mesh mesh = TwoTriangles();
        Edge edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]);

        edge.Flip();

        Assert.Equal([2, 3], edge.Vertices.Select(v => v.Index).Order());
        Assert.True(mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).IsNone);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Flip_WithCornerValues_KeepsThemAtTheirVertices()
    {
        Mesh mesh = TwoTriangles();
        HalfEdgeTrait<int> corner = mesh.AddHalfEdgeTrait("vertex", -1);
        foreach (HalfEdge h in mesh.HalfEdges)
            corner[h] = h.Target.Index;

        mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).Flip();

        foreach (HalfEdge h in mesh.HalfEdges)
            Assert.Equal(h.Target.Index, corner[h]);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Undo_AfterFlippingEveryLegalEdge_RestoresEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();

        foreach (Edge edge in mesh.Edges)
            edge.TryFlip(out _);
        Assert.Empty(mesh.Validate());

        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    // A dart: vertex 1 lies inside the triangle 0 2 3, so the other diagonal runs outside.
    [Fact]
    public void FlipFolds_ConcaveQuadrilateral_IsTrue()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(0.2, 0, 0), new(1, 1, 0), new(1, -1, 0)], [0, 1, 2, 1, 0, 3]);
        Assert.True(mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).FlipFolds());
    }

    [Fact]
    public void FlipFolds_Square_IsFalseAtEveryCosine()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 1, 0), new(0, 1, 0), new(1, 0, 0)], [0, 1, 2, 1, 0, 3]);
        Edge edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]);
        Assert.False(edge.FlipFolds());
        Assert.False(edge.FlipFolds(0.999));
        Assert.Throws<ArgumentOutOfRangeException>(() => edge.FlipFolds(2));
        Assert.Throws<ArgumentException>(() => mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[2]).FlipFolds());
    }

    [Fact]
    public void FlipFolds_BentAtARightAngleAfterwards_DependsOnTheCosine()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(-1, 0, 1), new(1, 0, 1), new(0, 1, 0), new(0, -1, 0)], [0, 1, 2, 1, 0, 3]);
        Edge edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]);
        Assert.False(edge.FlipFolds(-0.5));
        Assert.True(edge.FlipFolds(0.5));
    }
}
