using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "1.4")]
public class TraitTests
{
    [Fact]
    public void AddTrait_EachKind_HasADefaultPerSlotAndGrows()
    {
        Mesh mesh = Models.Create("cube");
        VertexTrait<int> vertex = mesh.AddVertexTrait("t", 7);
        HalfEdgeTrait<double> halfEdge = mesh.AddHalfEdgeTrait("t", 0.5);
        EdgeTrait<string> edge = mesh.AddEdgeTrait("t", "x");
        FaceTrait<Color> face = mesh.AddFaceTrait<Color>("t");
        Assert.Equal((mesh.VertexSlots, mesh.HalfEdgeSlots, mesh.EdgeSlots, mesh.FaceSlots), (vertex.Count, halfEdge.Count, edge.Count, face.Count));

        Vertex m = mesh.Edges[0].Split();

        Assert.Equal((mesh.VertexSlots, mesh.HalfEdgeSlots, mesh.EdgeSlots, mesh.FaceSlots), (vertex.Count, halfEdge.Count, edge.Count, face.Count));
        Assert.Equal(7, vertex[m]);
        Assert.Equal("x", edge[mesh.EdgeSlots - 1]);
        Assert.Equal(typeof(int), vertex.ValueType);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void AddTrait_NameTakenOrEmpty_Throws()
    {
        Mesh mesh = Models.Create("cube");
        mesh.AddVertexTrait("t", 0);
        mesh.AddFaceTrait("t", 0);
        Assert.Throws<ArgumentException>(() => mesh.AddVertexTrait("t", 0.0));
        Assert.Throws<ArgumentException>(() => mesh.AddVertexTrait("", 0.0));
        Assert.Throws<ArgumentNullException>(() => mesh.TryGetVertexTrait<int>(null!, out _));
        Assert.False(mesh.TryGetVertexTrait<double>("t", out _));
    }

    [Fact]
    public void Trait_ForeignElement_Throws()
    {
        Mesh mesh = Models.Create("cube");
        VertexTrait<int> t = mesh.AddVertexTrait("t", 0);
        Assert.Throws<ArgumentException>(() => t[Models.Create("cube").Vertices[0]]);
    }

    [Fact]
    public void RemoveTrait_Present_IsGone()
    {
        Mesh mesh = Models.Create("cube");
        FaceLabels labels = mesh.GetOrAddFaceLabels("material");
        Assert.Same(labels, mesh.GetOrAddFaceLabels("material"));
        Assert.True(mesh.RemoveTrait(labels.Labels));
        Assert.False(mesh.RemoveTrait(labels.Labels));
        Assert.Empty(mesh.FaceLabels);
    }

    [Fact]
    public void TextbookTraits_WrittenOnce_HaveAColumnAndReadBack()
    {
        Mesh mesh = Models.Create("cube");
        Assert.Empty(mesh.VertexTraits);
        Assert.Equal(default, mesh.Vertices[0].Traits.Normal);
        Assert.Empty(mesh.VertexTraits);

        mesh.Vertices[0].Traits.Normal = Vector3D.UnitZ;
        mesh.Vertices[1].Traits.SelectedFlag = 3;
        mesh.Edges[2].Traits.SelectedFlag = 4;
        mesh.Faces[3].Traits.Color = new Color(1, 0, 0);

        Assert.Equal(Vector3D.UnitZ, mesh.Vertices[0].Traits.Normal);
        Assert.Equal((3, 4, new Color(1, 0, 0)), (mesh.Vertices[1].Traits.SelectedFlag, mesh.Edges[2].Traits.SelectedFlag, mesh.Faces[3].Traits.Color));
        Assert.Equal($"{TraitNames.Normal} {TraitNames.SelectedFlag}", string.Join(' ', mesh.VertexTraits.Select(t => t.Name)));
    }

    [Fact]
    public void Blend_Rules_DoWhatTheySay()
    {
        Assert.Equal(1, Blend.Nearest(1, 2, 0.5));
        Assert.Equal(2, Blend.Nearest(1, 2, 0.6));
        Assert.Equal(1.25, Blend.Linear(1.0, 2.0, 0.25));
        Assert.Equal(5, Blend.Largest(3, 5, 0.1));
        Assert.Equal(1, Blend.Direction(Vector3D.UnitX, Vector3D.UnitY, 0.3).Length, 1e-15);
    }

    [Fact]
    public void Undo_OfASplit_RestoresTheTraitsOfEveryKind()
    {
        Mesh mesh = Models.Create("grid");
        VertexTrait<double> vertex = mesh.AddVertexTrait<double>("x", 0, Blend.Linear);
        mesh.AddHalfEdgeTrait<Vector2D>("corner", default, Blend.Linear);
        mesh.AddEdgeTrait("edge", 1.0, Blend.Linear);
        mesh.AddFaceTrait("face", "text");
        foreach (Vertex v in mesh.Vertices)
            vertex[v] = v.Position.X;
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        mesh.Edges[10].Split();
        mesh.Faces[3].Split();
        mesh.HalfEdges[20].TryCollapse(out _);
        Assert.NotEqual(before, mesh.StateHash());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }
}
