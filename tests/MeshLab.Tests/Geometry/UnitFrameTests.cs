using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "7.2")]
public class UnitFrameTests
{
    [Fact]
    public void ToUnit_AnyPlaceAndSize_HasTheUnitDiagonalAboutTheOrigin()
    {
        Mesh mesh = Models.Moved(Models.Sphere(8, 10), 1e6 / 3, new(1e7, 0.1, -3));
        UnitFrame frame = UnitFrame.Of(mesh);
        Mesh unit = frame.ToUnit(mesh);
        Assert.Equal(1, unit.BoundingBox.Diagonal, 10);
        Assert.Equal(0, unit.BoundingBox.Center.Length, 10);
        Assert.Equal(mesh.BoundingBox.Diagonal, frame.Scale);
    }

    [Fact]
    public void FromUnit_UnmovedAndMoved_GivesTheBitsBackOrThePlace()
    {
        Mesh mesh = Models.Moved(Models.Sphere(8, 10), 1e6 / 3, new(1e7, 0.1, -3));
        UnitFrame frame = UnitFrame.Of(mesh);
        Mesh unit = frame.ToUnit(mesh);
        for (int v = 0; v < mesh.VertexSlots; v++)
            Assert.Equal(mesh.Positions[v], frame.FromUnit(unit.Positions[v], mesh, v));
        Vector3D moved = unit.Positions[3] + new Vector3D(0.01, 0, 0);
        Assert.Equal(0.01 * frame.Scale, frame.FromUnit(moved, mesh, 3).X - mesh.Positions[3].X, 3);
        // A new vertex beyond those of the input.
        Assert.Equal(frame.FromUnit(unit.Positions[3]), frame.FromUnit(unit.Positions[3], mesh, mesh.VertexSlots));
    }

    [Theory]
    [InlineData(1e6)]
    [InlineData(1e-6)]
    [InlineData(25.4)]
    public void ToUnit_OtherUnits_HasTheSameBits(double scale)
    {
        Mesh mesh = Models.Sphere(20, 24), other = Models.Moved(mesh, scale, default);
        Assert.Equal(UnitFrame.Of(mesh).ToUnit(mesh).Positions.ToArray(), UnitFrame.Of(other).ToUnit(other).Positions.ToArray());
    }

    [Theory]
    [InlineData(1e200)]
    [InlineData(1e-200)]
    [InlineData(1e-290)]
    public void ToUnit_SquaresBeyondNumbers_HasTheUnitDiagonal(double scale)
    {
        Mesh mesh = Models.Moved(Models.Sphere(8, 10), scale, default);
        Assert.Equal(1, UnitFrame.Of(mesh).ToUnit(mesh).BoundingBox.Diagonal, 10);
    }

    [Fact]
    public void Of_NothingOrOnePoint_HasTheScaleOne()
    {
        Assert.Equal(1, UnitFrame.Of(new Mesh()).Scale);
        var mesh = new Mesh();
        mesh.AddVertex(new(5, 6, 7));
        Assert.Equal(1, UnitFrame.Of(mesh).Scale);
    }
}
