using MeshLab.Numerics;
using MeshLab.Spatial;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class TriangleTriangleTests
{
    [Theory]
    [InlineData(1, 1.0)]
    [InlineData(2, 1.0)]
    [InlineData(4, 1.0)]
    [InlineData(4, 1.0 / (1 << 20))]
    public void Intersect_SmallGrids_AgreesWithSeparatingPlanes(int grid, double scale)
    {
        // Small grids are full of touching, coplanar, collinear and degenerate pairs.
        var random = new Random(grid);
        int meet = 0;
        for (int round = 0; round < 800; round++)
        {
            (long X, long Y, long Z)[] x = [.. Enumerable.Range(0, 6).Select(_ => ((long)random.Next(-grid, grid + 1), (long)random.Next(-grid, grid + 1), (long)random.Next(-grid, grid + 1)))];
            if (round % 3 == 0)
                x = [.. x.Select(v => v with { Z = 0 })];
            Vector3D[] v = [.. x.Select(p => new Vector3D(p.X * scale, p.Y * scale, p.Z * scale))];

            bool expected = ConvexHullOracle.Meet(x[..3], x[3..]);
            Assert.Equal(expected, TriangleTriangle.Intersect(v[0], v[1], v[2], v[3], v[4], v[5]));
            Assert.Equal(expected, TriangleTriangle.Intersect(v[4], v[3], v[5], v[2], v[0], v[1]));
            Assert.Equal(ConvexHullOracle.Meet(x[..2], x[3..]), TriangleTriangle.SegmentMeets(v[0], v[1], v[3], v[4], v[5]));
            Assert.Equal(ConvexHullOracle.Meet(x[..2], x[3..5]), TriangleTriangle.SegmentsMeet(v[0], v[1], v[3], v[4]));
            meet += expected ? 1 : 0;
        }
        Assert.InRange(meet, 80, 720);
    }

    [Fact]
    public void Intersect_OneBitApart_SeesTheGap()
    {
        Vector3D a = new(0, 0, 0), b = new(1, 0, 0), c = new(0, 1, 0);
        Assert.True(TriangleTriangle.Intersect(a, b, c, new(0.2, 0.2, 0), new(0.2, 0.2, 1), new(0.3, 0.2, 1)));
        Assert.False(TriangleTriangle.Intersect(a, b, c, new(0.2, 0.2, double.Epsilon), new(0.2, 0.2, 1), new(0.3, 0.2, 1)));
    }
}
