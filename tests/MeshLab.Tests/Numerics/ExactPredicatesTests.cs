using System.Numerics;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

public class ExactPredicatesTests
{
    [Fact]
    public void Orient2D_Triangle_IsPositiveCounterClockwise()
    {
        Assert.Equal(1, ExactPredicates.Orient2D(new(0, 0), new(1, 0), new(0, 1)));
        Assert.Equal(-1, ExactPredicates.Orient2D(new(0, 0), new(0, 1), new(1, 0)));
        Assert.Equal(0, ExactPredicates.Orient2D(new(0, 0), new(1, 1), new(3, 3)));
    }

    [Fact]
    public void Orient3D_PointAboveTheTriangle_IsPositive()
    {
        Vector3D a = new(0, 0, 0), b = new(1, 0, 0), c = new(0, 1, 0);
        Assert.Equal(1, ExactPredicates.Orient3D(a, b, c, new(0.3, 0.3, 1)));
        Assert.Equal(-1, ExactPredicates.Orient3D(a, b, c, new(0.3, 0.3, -1)));
        Assert.Equal(0, ExactPredicates.Orient3D(a, b, c, new(7, -5, 0)));
        Assert.Equal(0, ExactPredicates.Orient3D(a, b, a, new(1, 2, 3)));
    }

    [Fact]
    public void Orient2D_OneBitOffTheDiagonal_SeesTheSide()
    {
        // Kettner et al. 2008: the plain determinant is wrong for many points of this grid of neighbouring doubles.
        int plainWrong = 0;
        for (int i = 0; i < 64; i++)
        {
            for (int j = 0; j < 64; j++)
            {
                double x = 0.5 + i * Math.Pow(2, -53), y = 0.5 + j * Math.Pow(2, -53);
                int expected = Math.Sign(j.CompareTo(i));
                Assert.Equal(expected, ExactPredicates.Orient2D(new(12, 12), new(24, 24), new(x, y)));
                double plain = (12 - x) * (24 - y) - (12 - y) * (24 - x);
                plainWrong += Math.Sign(plain) == expected ? 0 : 1;
            }
        }
        Assert.True(plainWrong > 100);
    }

    [Theory]
    [InlineData(3, 1.0)]
    [InlineData(9, 1.0)]
    [InlineData(100, 1.0)]
    [InlineData(5, 0.1)] // multiples of 0.1 are not exact, so coplanarity is broken by single bits
    [InlineData(5, 1e-6)]
    [InlineData(1 << 26, 1.0)]
    public void Orientations_RandomGrids_AgreeWithIntegers(int grid, double step)
    {
        var random = new Random(grid);
        Span<double> x = stackalloc double[12];
        Span<int> signs = stackalloc int[3];
        for (int round = 0; round < 20_000; round++)
        {
            for (int k = 0; k < 12; k++)
                x[k] = step * random.Next(-grid, grid + 1);
            signs[1 + Check3D(x)]++;
            Check2D(x);
        }
        Assert.True(signs[0] > 1000 && signs[2] > 1000);
    }

    [Fact]
    public void Orientations_PointsNearlyInOnePlaneFarFromTheOrigin_AgreeWithIntegers()
    {
        var random = new Random(5);
        Span<double> x = stackalloc double[12];
        int zero = 0;
        for (int round = 0; round < 20_000; round++)
        {
            double ux = random.NextDouble(), uy = random.NextDouble(), vx = random.NextDouble(), vy = random.NextDouble();
            for (int k = 0; k < 4; k++)
            {
                double s = random.NextDouble(), t = random.NextDouble();
                x[3 * k] = 1e6 + s * ux + t * vx;
                x[3 * k + 1] = 1e6 + s * uy + t * vy;
                x[3 * k + 2] = 1e6 + s + t;
            }
            zero += Check3D(x) == 0 ? 1 : 0;
            x[4] = x[0] + (x[2] - x[0]) * random.NextDouble();
            Check2D(x);
        }
        Assert.True(zero < 19_000);
    }

    [Theory]
    [InlineData(-320, 0)]
    [InlineData(-160, -90)]
    [InlineData(80, 300)]
    [InlineData(-300, 300)]
    public void Orientations_ExtremeMagnitudes_AgreeWithIntegers(int lowest, int highest)
    {
        var random = new Random(lowest);
        Span<double> x = stackalloc double[12];
        for (int round = 0; round < 500; round++)
        {
            double scale = Math.Pow(10, random.Next(lowest, highest + 1));
            for (int k = 0; k < 12; k++)
                x[k] = random.Next(-3, 4) * (round % 2 == 0 ? scale : Math.Pow(10, random.Next(lowest, highest + 1)));
            Check3D(x);
            Check2D(x);
        }
    }

    [Fact]
    public void Orient3D_NotANumber_ThrowsArgumentOutOfRange()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => ExactPredicates.Orient3D(new(double.NaN, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => ExactPredicates.Orient2D(new(double.PositiveInfinity, 0), new(1, 0), new(0, 1)));
    }

    // Both return the sign, after comparing it with integers and with the permuted call.
    private static int Check3D(ReadOnlySpan<double> x)
    {
        BigInteger[] i = ExactPredicates.ToIntegers(x);
        for (int k = 0; k < 9; k++)
            i[3 + k] -= i[k % 3];
        int expected = (i[3] * (i[7] * i[11] - i[8] * i[10]) + i[4] * (i[8] * i[9] - i[6] * i[11]) + i[5] * (i[6] * i[10] - i[7] * i[9])).Sign;
        Vector3D a = new(x[0], x[1], x[2]), b = new(x[3], x[4], x[5]), c = new(x[6], x[7], x[8]), d = new(x[9], x[10], x[11]);
        Assert.Equal(expected, ExactPredicates.Orient3D(a, b, c, d));
        Assert.Equal(-expected, ExactPredicates.Orient3D(b, a, c, d));
        Assert.Equal(-expected, ExactPredicates.Orient3D(a, b, d, c));
        return expected;
    }

    private static void Check2D(ReadOnlySpan<double> x)
    {
        BigInteger[] i = ExactPredicates.ToIntegers(x[..6]);
        int expected = ((i[2] - i[0]) * (i[5] - i[1]) - (i[3] - i[1]) * (i[4] - i[0])).Sign;
        Assert.Equal(expected, ExactPredicates.Orient2D(x[0], x[1], x[2], x[3], x[4], x[5]));
        Assert.Equal(-expected, ExactPredicates.Orient2D(x[2], x[3], x[0], x[1], x[4], x[5]));
    }
}
