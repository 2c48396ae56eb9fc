using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.1")]
public class FaceAdditionTests
{
    private static Mesh Points(int n)
    {
        var mesh = new Mesh();
        for (int i = 0; i < n; i++)
            mesh.AddVertex(new(i, i * i, 0));
        return mesh;
    }

    private static Vertex[] At(Mesh mesh, params int[] indices) => [.. indices.Select(i => mesh.Vertices[i])];

    [Theory]
    [InlineData(AddFaceRefusal.TooFewVertices, new[] { 3, 4 })]
    [InlineData(AddFaceRefusal.RepeatedVertex, new[] { 3, 4, 3 })]
    [InlineData(AddFaceRefusal.EdgeTaken, new[] { 0, 1, 4 })]
    [InlineData(AddFaceRefusal.Pinch, new[] { 0, 4, 5 })]
    public void TryAddFace_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone(AddFaceRefusal reason, int[] vertices)
    {
        Mesh mesh = Points(6);
        mesh.AddFace(At(mesh, 0, 1, 2));
        mesh.AddFace(At(mesh, 1, 0, 3));
        ulong before = mesh.StateHash();

        Assert.False(mesh.TryAddFace(At(mesh, vertices), out Face face, out AddFaceRefusal why));

        Assert.Equal(reason, why);
        Assert.True(face.IsNone);
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<TopologyException>(() => mesh.AddFace(At(mesh, vertices)));
    }

    [Fact]
    public void TryAddFace_AtAnInnerVertex_SaysSo()
    {
        Mesh mesh = Models.Fan(5);
        mesh.AddVertex(default);
        Assert.False(mesh.TryAddFace(At(mesh, 0, 1, 6), out _, out AddFaceRefusal why));
        Assert.Equal(AddFaceRefusal.InnerVertex, why);
    }

    [Fact]
    public void AddFace_ForeignOrDeletedVertex_Throws()
    {
        Mesh mesh = Points(4);
        Vertex gone = mesh.Vertices[3];
        gone.Delete();
        Assert.Throws<ArgumentException>(() => mesh.AddFace(At(mesh, 0, 1, 3)));
        Assert.Throws<ArgumentException>(() => mesh.AddFace(mesh.Vertices[0], mesh.Vertices[1], Points(3).Vertices[2]));
        Assert.Throws<ArgumentException>(() => mesh.AddFace(mesh.Vertices[0], mesh.Vertices[1], default));
    }

    //                     2
    //   0  1  2    ⟶     / \      one component more
    //                   0 ─ 1
    [Fact]
    public void AddFace_IsolatedVertices_MakesATriangle()
    {
        Mesh mesh = Points(3);
        Face face = mesh.AddFace(At(mesh, 1, 2, 0));
        Assert.Equal([1, 2, 0], face.Vertices.Select(v => v.Index));
        Assert.Equal(3, mesh.Edges.Count);
        Assert.Empty(mesh.Validate());
    }

    //   2 ─ 3          2 ─ 3
    //   │ \            │ \ │
    //   0 ─ 1    ⟶     0 ─ 1     two edges were there, one is new
    [Fact]
    public void AddFace_BesideAFace_SharesItsEdge()
    {
        Mesh mesh = Points(4);
        mesh.AddFace(At(mesh, 0, 1, 2));
        mesh.AddFace(At(mesh, 2, 1, 3));
        Assert.Equal(5, mesh.Edges.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void AddFace_IntoAHole_ClosesIt()
    {
        Mesh mesh = Models.Create("cube-quads");
        Vertex[] corners = [.. mesh.Faces[2].Vertices];
        mesh.Faces[2].Delete();
        Assert.False(mesh.IsClosed);
        mesh.AddFace(corners);
        Assert.True(mesh.IsClosed);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void AddFaces_OfAnOctahedronInAnyOrder_JoinsTheFans(int seed)
    {
        Mesh model = Models.Create("octahedron");
        int[][] faces = [.. model.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        new Random(seed).Shuffle(faces);
        Mesh mesh = Points(6);

        Face[] added = mesh.AddFaces([.. faces.Select(f => At(mesh, f))]);

        Assert.Equal(8, added.Length);
        Assert.True(mesh.IsClosed);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void AddFaces_OfEveryModelShuffled_RebuildsIt(string name)
    {
        Mesh model = Models.Create(name);
        int[][] faces = [.. model.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        new Random(11).Shuffle(faces);
        var mesh = new Mesh();
        foreach (Vertex v in model.Vertices)
            mesh.AddVertex(v.Position);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();

        // Where three or more fans meet, an order may close a circle that leaves others outside.
        try
        {
            mesh.AddFaces([.. faces.Select(f => At(mesh, f))]);
        }
        catch (TopologyException error)
        {
            Assert.Contains(nameof(AddFaceRefusal.FansDoNotJoin), error.Message, StringComparison.Ordinal);
            Assert.Equal(before, mesh.StateHash());
            return;
        }
        Assert.Empty(mesh.Validate());
        Assert.Equal((model.Edges.Count, model.Faces.Count), (mesh.Edges.Count, mesh.Faces.Count));
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void AddFaces_OneImpossible_TakesAllBackWithoutAListener()
    {
        Mesh mesh = Points(7);
        ulong before = mesh.StateHash();
        Assert.Throws<TopologyException>(() => mesh.AddFaces(At(mesh, 0, 1, 2), At(mesh, 2, 1, 3), At(mesh, 0, 1, 4)));
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<TopologyException>(() => mesh.AddFaces(At(mesh, 0, 1, 2), At(mesh, 0, 3, 4)));
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<ArgumentNullException>(() => mesh.AddFaces(At(mesh, 0, 1, 2), null!));
        Assert.Equal(before, mesh.StateHash());
    }
}
