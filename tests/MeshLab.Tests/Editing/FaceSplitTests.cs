using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.8")]
public class FaceSplitTests
{
    //      2                2
    //     / \              /│\
    //    /   \     ⟶      / 3 \
    //   /     \          / / \ \
    //  0 ───── 1        0 ───── 1
    [Fact]
    public void Split_Triangle_MakesThreeAroundItsMean()
    {
        Mesh mesh = Models.Create("one-triangle");
        Vertex m = mesh.Faces[0].Split();

        Assert.Equal(0, Vector3D.Distance(new(1 / 3.0, 1 / 3.0, 0), m.Position), 1e-15);
        Assert.Equal(3, m.Valence);
        Assert.False(m.IsBoundary);
        Assert.Equal((4, 6, 3), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Equal([0, 1, 3], mesh.Faces[0].Vertices.Select(v => v.Index));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_Hexagon_MakesSix()
    {
        Mesh mesh = Models.Prism(6);
        Face hexagon = mesh.Faces.First(f => f.Degree == 6);
        Vertex m = hexagon.Split(new Vector3D(0, 0, -1));

        Assert.Equal(6, m.Valence);
        Assert.All(m.Faces, f => Assert.True(f.IsTriangle));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Split_DeletedFaceOrBadPosition_Throws()
    {
        Mesh mesh = Models.Create("cube");
        Face face = mesh.Faces[0];
        Assert.Throws<ArgumentException>(() => face.Split(new Vector3D(0, double.PositiveInfinity, 0)));
        face.Delete();
        Assert.Throws<ArgumentException>(() => face.Split());
    }

    [Fact]
    public void Split_WithTraits_BlendsAllCorners()
    {
        Mesh mesh = MeshBuilder.FromPolygons([new(0, 0, 0), new(4, 0, 0), new(4, 4, 0), new(0, 4, 0)], [0, 1, 2, 3]);
        VertexTrait<Vector3D> place = mesh.AddVertexTrait<Vector3D>("place", default, Blend.Linear);
        HalfEdgeTrait<Vector3D> cornerPlace = mesh.AddHalfEdgeTrait<Vector3D>("place", default, Blend.Linear);
        FaceTrait<int> name = mesh.AddFaceTrait("name", 5);
        foreach (Vertex v in mesh.Vertices)
            place[v] = v.Position;
        foreach (HalfEdge h in mesh.HalfEdges)
            cornerPlace[h] = h.Target.Position;
        name[mesh.Faces[0]] = 9;

        Vertex m = mesh.Faces[0].Split();

        Assert.Equal(0, Vector3D.Distance(m.Position, place[m]), 1e-14);
        Assert.All(mesh.HalfEdges.Where(h => !h.IsBoundary), h => Assert.Equal(0, Vector3D.Distance(h.Target.Position, cornerPlace[h]), 1e-14));
        Assert.All(mesh.Faces, f => Assert.Equal(9, name[f]));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Undo_AfterSplittingEveryFace_RestoresEveryBit(string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();
        int corners = mesh.HalfEdges.Count(h => !h.IsBoundary), faces = mesh.FaceSlots;
        using OperationHistory history = mesh.StartRecording();

        for (int f = 0; f < faces; f++)
            mesh.Faces[f].Split();
        Assert.Equal(corners, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());

        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }
}
