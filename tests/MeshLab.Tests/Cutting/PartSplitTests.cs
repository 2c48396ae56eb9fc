using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.5")]
public class PartSplitTests
{
    [Fact]
    public void SplitComponents_ThreeShapes_AppendIsTheInverse()
    {
        Mesh mesh = Models.Create("components");
        VertexTrait<int> number = mesh.AddVertexTrait("number", 0);
        foreach (Vertex v in mesh.Vertices)
            number[v] = v.Index;
        IReadOnlyList<MeshPart> parts = mesh.SplitComponents();
        Assert.Equal(3, parts.Count);
        var whole = new Mesh();
        foreach (MeshPart part in parts)
        {
            Assert.Equal(1, part.Mesh.ComponentCount);
            Assert.Empty(part.Mesh.Validate());
            Assert.All(part.Mesh.Faces, f => Assert.Equal(f.Index, part.NewFace[part.SourceFace[f.Index]]));
            Assert.All(part.Mesh.Vertices, v => Assert.Equal(v.Index, part.NewVertex[part.SourceVertex[v.Index]]));
            Assert.True(part.Mesh.TryGetVertexTrait("number", out VertexTrait<int>? kept));
            Assert.All(part.Mesh.Vertices, v => Assert.Equal(part.SourceVertex[v.Index], kept![v]));
            whole.Append(part.Mesh);
        }
        Assert.Equal((mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count), (whole.Vertices.Count, whole.Edges.Count, whole.Faces.Count));
        Assert.Equal(mesh.Area, whole.Area, 1e-12);
        Assert.Empty(whole.Validate());
    }

    [Fact]
    public void SplitRegions_Cube_GivesSixSquares()
    {
        IReadOnlyList<MeshPart> sides = Models.Create("cube").SplitRegions(Math.PI / 4);
        Assert.Equal(6, sides.Count);
        Assert.All(sides, side => Assert.Equal((4, 2, 1.0), (side.Mesh.Vertices.Count, side.Mesh.Faces.Count, side.Mesh.Area)));
        Assert.Single(Models.Create("cube").SplitRegions(Math.PI * 0.6));
        // An edge exactly as sharp as the bound is not sharper.
        Assert.Single(Models.Create("cube").SplitRegions(Math.PI / 2));
        Assert.Equal(6, Models.Create("cube").SplitRegions(0).Count);
        Assert.Single(Models.Create("cube").SplitRegions(Math.PI));
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitRegions(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitRegions(-1e-9));
    }
}
