using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests;

public class ModelsTests
{
    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Create_EveryModel_IsSoundAndOfItsSort(string name)
    {
        Mesh mesh = Models.Create(name);

        Assert.Empty(mesh.Validate());
        Assert.Equal(((IEnumerable<object[]>)Models.TriangleMeshes).Any(row => (string)row[0] == name), mesh.IsTriangleMesh);
        Assert.Equal(((IEnumerable<object[]>)Models.BoundaryMeshes).Any(row => (string)row[0] == name), !mesh.IsClosed);
    }

    [Theory]
    [InlineData("sphere", 2)]
    [InlineData("torus", 0)]
    [InlineData("genus-2", -2)]
    [InlineData("genus-2-quads", -2)]
    [InlineData("prism-6", 2)]
    [InlineData("annulus", 0)]
    public void Create_KnownShape_HasItsEulerCharacteristic(string name, int expected)
    {
        Mesh mesh = Models.Create(name);
        Assert.Equal(expected, mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count);
    }
}
