using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

[Trait("Section", "7.2")]
public class QuadricTests
{
    [Fact]
    public void At_OnePlane_IsTheWeightedSquaredDistance()
    {
        Quadric q = Quadric.OfPlane(new(0, 0.6, 0.8), -2, 3);

        Assert.Equal(3 * Math.Pow(0.6 * 5 + 0.8 * 7 - 2, 2), q.At(new(11, 5, 7)), 1e-12);
        Assert.Equal(3, q.Weight, 1e-15);
    }

    [Fact]
    public void TryMinimize_ThreePlanes_FindsTheirCommonPoint()
    {
        Quadric q = Quadric.OfPlane(Vector3D.UnitX, -1, 1) + Quadric.OfPlane(Vector3D.UnitY, -2, 5) + Quadric.OfPlane(new(0, 0.6, 0.8), -3.6, 0.5);

        Assert.True(q.TryMinimize(out Vector3D point, out double value));

        Assert.Equal(0, Vector3D.Distance(point, new(1, 2, 3)), 1e-12);
        Assert.Equal(0, value, 1e-12);
    }

    [Fact]
    public void TryMinimize_PlanesThroughALine_HasNoUniquePoint()
    {
        Quadric q = Quadric.OfPlane(Vector3D.UnitX, 0, 1) + Quadric.OfPlane(Vector3D.UnitY, 0, 1) + Quadric.OfPlane(new(0.6, 0.8, 0), 0, 1);

        Assert.False(q.TryMinimize(out _, out _));
    }

    [Fact]
    public void MinimizeOnSegment_PlaneAcrossIt_StopsAtThePlaneOrTheEnd()
    {
        Quadric q = Quadric.OfPlane(Vector3D.UnitX, -3, 1);

        Assert.Equal(0.3, q.MinimizeOnSegment(default, new(10, 5, 0)), 1e-15);
        Assert.Equal(1, q.MinimizeOnSegment(default, new(2, 5, 0)));
        Assert.Equal(0.5, q.MinimizeOnSegment(default, new(0, 5, 0)));
    }
}
