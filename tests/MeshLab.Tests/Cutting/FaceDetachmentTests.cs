using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.3")]
public class FaceDetachmentTests
{
    [Fact]
    public void Detach_HalfAGrid_RimVerticesAreInBoth()
    {
        Mesh grid = Models.QuadGrid(4, 2);
        Face[] left = [.. grid.Faces.Where(f => f.Barycenter.X < 0.5)];
        MeshPart part = grid.Detach(left);
        Assert.Equal((9, 4), (part.Mesh.Vertices.Count, part.Mesh.Faces.Count));
        Assert.Equal((9, 4), (grid.Vertices.Count, grid.Faces.Count));
        Assert.Equal(0.5, part.Mesh.Area, 1e-14);
        Assert.Equal([0, 1, 4, 5], part.SourceFace);
        Assert.Equal(2, part.NewVertex[2]);
        Assert.Equal(-1, part.NewVertex[4]);
        Assert.Empty(part.Mesh.Validate());
        Assert.Empty(grid.Validate());
        grid.Append(part.Mesh);
        Assert.Equal(1, grid.Area, 1e-14);
    }

    [Fact]
    public void Detach_Diagonal_NamesTheCopiesOnBothSides()
    {
        // Two squares of four that meet in the middle alone, on either side.
        Mesh grid = Models.QuadGrid(2, 2);
        MeshPart part = grid.Detach([grid.Faces[0], grid.Faces[3]]);
        Assert.Equal(2, part.SourceVertex.Count(v => v == 4));
        Assert.Equal(Array.IndexOf(part.SourceVertex, 4), part.NewVertex[4]);
        Assert.Equal([0, 3], part.SourceFace);
        Assert.Equal([0, -1, -1, 1], part.NewFace);
        Assert.All(part.SourceEdge, e => Assert.Equal(-1, e));
        Assert.Equal([4], part.CopiesLeftBehind);
        Assert.Equal(grid.Positions[4], grid.Positions[9]);
        Assert.Empty(grid.Validate());
        Assert.Empty(part.Mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Detach_EveryOtherFace_BothStayManifolds(string name)
    {
        Mesh mesh = Models.Create(name);
        double area = mesh.Faces.Count == 0 ? 0 : mesh.Area;
        int faces = mesh.Faces.Count;
        MeshPart part = mesh.Detach([.. mesh.Faces.Where(f => f.Index % 2 == 0)]);
        Assert.Empty(part.Mesh.Validate());
        Assert.Empty(mesh.Validate());
        Assert.Equal(faces, mesh.Faces.Count + part.Mesh.Faces.Count);
        Assert.Equal(area, (mesh.Faces.Count == 0 ? 0 : mesh.Area) + (part.Mesh.Faces.Count == 0 ? 0 : part.Mesh.Area), 1e-9 * (1 + area));
    }

    [Fact]
    public void Detach_ForeignOrDeletedFace_IsNamed()
    {
        Mesh cube = Models.Create("cube");
        Assert.Throws<ArgumentException>(() => cube.Detach([Models.Create("cube").Faces[0]]));
        Face gone = cube.Faces[3];
        cube.Detach([gone]);
        Assert.Contains("f3", Assert.Throws<ArgumentException>(() => cube.Detach([gone])).Message, StringComparison.Ordinal);
    }
}
