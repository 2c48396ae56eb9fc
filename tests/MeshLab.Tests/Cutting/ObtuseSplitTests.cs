using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.6")]
public class ObtuseSplitTests
{
    [Fact]
    public void SplitObtuse_FlatTriangle_BecomesTwoRightAngledOnes()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(1, 0.1, 0)], [0, 1, 2]);
        ObtuseSplitResult result = mesh.SplitObtuse();
        Assert.Equal((1, 1), (result.Splits, result.Passes));
        Assert.Empty(result.Remaining);
        Assert.Equal(new Vector3D(1, 0, 0), mesh.Positions[3]);
        Assert.Equal(2, mesh.Faces.Count);
        Assert.Equal(0.2, mesh.Area, 1e-15);
        Assert.Equal([0, 0], result.SourceFace);
        Assert.Equal([0, 1], result.Pieces.Single());
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void SplitObtuse_Models_AreaStaysAndWhatRemainsIsReported(string name)
    {
        Mesh mesh = Models.Create(name);
        double area = mesh.Faces.Count == 0 ? 0 : mesh.Area;
        Mesh old = mesh.Clone();
        ObtuseSplitResult result = mesh.SplitObtuse(Math.PI * 110 / 180, 3);
        Assert.True(result.Passes <= 3);
        Assert.Equal(mesh.Faces.Where(f => f.Triangle.MaxAngle > Math.PI * 110 / 180 + 1e-12).Select(f => f.Index).Order(), result.Remaining.Select(f => f.Index).Where(f => mesh.Faces[f].Triangle.MaxAngle > Math.PI * 110 / 180 + 1e-12).Order());
        Assert.Equal(area, mesh.Faces.Count == 0 ? 0 : mesh.Area, 1e-9 * (1 + area));
        Assert.Empty(mesh.Validate());
        // The pieces of a face make it up.
        Assert.Equal(mesh.FaceSlots, result.SourceFace.Length);
        Assert.Equal(mesh.Faces.Count, result.Pieces.Sum(pieces => pieces.Count));
        foreach (Face f in old.Faces)
        {
            Assert.Equal(f.Index, result.Pieces[f.Index][0]);
            Assert.Equal(f.Area, result.Pieces[f.Index].Sum(piece => mesh.Faces[piece].Area), 1e-12 * (1 + area));
        }
    }

    [Fact]
    public void SplitObtuse_BadInput_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => Models.Create("cube-quads").SplitObtuse());
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitObtuse(1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitObtuse(2, -1));
    }
}
