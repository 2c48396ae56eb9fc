using MeshLab.Numerics;

namespace MeshLab.Generation;

/// <summary>Points of the unit circle at whole parts of a turn, exact at multiples of an eighth and symmetric to the last bit.</summary>
internal static class UnitCircle
{
    /// <summary>(cos 2πi/n, sin 2πi/n).</summary>
    public static Vector2D At(long i, long n)
    {
        i %= n;
        if (i < 0)
            i += n;
        long quarter = 4 * i / n, rest = 4 * i - quarter * n;
        (double x, double y) = FirstQuarter(rest, n);
        return quarter switch
        {
            0 => new(x, y),
            1 => new(-y, x),
            2 => new(-x, -y),
            _ => new(y, -x),
        };
    }

    private static (double X, double Y) FirstQuarter(long rest, long n)
    {
        if (rest == 0)
            return (1, 0);
        if (2 * rest == n)
            return (Math.Sqrt(0.5), Math.Sqrt(0.5));
        if (2 * rest > n)
        {
            (double y, double x) = FirstQuarter(n - rest, n);
            return (x, y);
        }
        (double sin, double cos) = Math.SinCos(Math.PI / 2 * rest / n);
        return (cos, sin);
    }
}
