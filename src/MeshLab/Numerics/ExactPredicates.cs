using System.Numerics;
using System.Runtime.CompilerServices;

namespace MeshLab.Numerics;

/// <summary>Orientation tests (定向判断) whose sign is that of exact arithmetic on the doubles given, for every finite input.</summary>
/// <remarks>
/// Three stages: a double evaluation with Shewchuk's error bound settles nearly everything; equal arguments and planes along the axes (the
/// usual cases on technical models) give 0 at once; floating-point expansions settle the rest. Coordinates so large or small that products would over- or
/// underflow go to integers of any size. Shewchuk 1997, §4; the bounds are his, widened against underflow. Constant cost.
/// </remarks>
public static class ExactPredicates
{
    private const double Bound2D = 3.3306690738754716e-16; // (3 + 16 ε) ε with ε = 2⁻⁵³
    private const double Bound3D = 7.7715611723761027e-16; // (7 + 56 ε) ε

    // Between these magnitudes no product of three differences loses a bit: 53-bit numbers above 2⁻²⁸² have lowest bits above 2⁻³³⁵.
    private const double Smallest = 1e-85, Largest = 1e95;

    // More than what underflow can take away; far below anything the filter should accept.
    private const double Underflow = 1e-300;

    /// <summary>On which side of the line a → b the point c lies.</summary>
    /// <returns>1 if a, b, c turn counter-clockwise, −1 if clockwise, 0 if they are on one line.</returns>
    public static int Orient2D(Vector2D a, Vector2D b, Vector2D c) => Orient2D(a.X, a.Y, b.X, b.Y, c.X, c.Y);

    /// <summary>On which side of the line a → b the point c lies, by coordinates.</summary>
    /// <returns>1 if a, b, c turn counter-clockwise, −1 if clockwise, 0 if they are on one line.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Orient2D(double ax, double ay, double bx, double by, double cx, double cy)
    {
        double left = (ax - cx) * (by - cy);
        double right = (ay - cy) * (bx - cx);
        double determinant = left - right;
        double error = Bound2D * (Math.Abs(left) + Math.Abs(right)) + Underflow;
        if (determinant > error)
            return 1;
        if (determinant < -error)
            return -1;
        return Orient2DExact(ax, ay, bx, by, cx, cy);
    }

    /// <summary>On which side of the plane through a, b, c the point d lies.</summary>
    /// <returns>
    /// 1 if d is on the side from which a, b, c are seen counter-clockwise (where (b − a) × (c − a) points), −1 on the other, 0 in the plane:
    /// the sign of the volume of the tetrahedron a, b, c, d.
    /// </returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Orient3D(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D d)
    {
        double adx = a.X - d.X, ady = a.Y - d.Y, adz = a.Z - d.Z;
        double bdx = b.X - d.X, bdy = b.Y - d.Y, bdz = b.Z - d.Z;
        double cdx = c.X - d.X, cdy = c.Y - d.Y, cdz = c.Z - d.Z;
        double bc = bdx * cdy, cb = cdx * bdy;
        double ca = cdx * ady, ac = adx * cdy;
        double ab = adx * bdy, ba = bdx * ady;

        double determinant = adz * (bc - cb) + bdz * (ca - ac) + cdz * (ab - ba);
        double za = Math.Abs(adz), zb = Math.Abs(bdz), zc = Math.Abs(cdz);
        double permanent = (Math.Abs(bc) + Math.Abs(cb)) * za + (Math.Abs(ca) + Math.Abs(ac)) * zb + (Math.Abs(ab) + Math.Abs(ba)) * zc;
        double error = Bound3D * permanent + Underflow * (1 + za + zb + zc);
        // The determinant of the differences to d is minus the volume of the definition above.
        if (determinant > error)
            return -1;
        if (determinant < -error)
            return 1;
        return Orient3DExact(a, b, c, d);
    }

    [MethodImpl(MethodImplOptions.NoInlining), SkipLocalsInit]
    private static int Orient2DExact(double ax, double ay, double bx, double by, double cx, double cy)
    {
        // Both products are zero, for equal points and lines along an axis, or the points are a and b themselves.
        if (((ax == cx || by == cy) && (ay == cy || bx == cx)) || (ax == bx && ay == by))
            return 0;
        ReadOnlySpan<double> coordinates = [ax, ay, bx, by, cx, cy];
        if (!FitsExpansions(coordinates))
            return Orient2DIntegers(coordinates);

        Span<double> room = stackalloc double[64];
        Span<double> acx = room[..2], bcy = room.Slice(2, 2), acy = room.Slice(4, 2), bcx = room.Slice(6, 2);
        Span<double> left = room.Slice(8, 8), right = room.Slice(16, 8), scratch = room.Slice(24, 8), determinant = room.Slice(32, 16);
        acx = acx[..Expansion.Difference(ax, cx, acx)];
        bcy = bcy[..Expansion.Difference(by, cy, bcy)];
        acy = acy[..Expansion.Difference(ay, cy, acy)];
        bcx = bcx[..Expansion.Difference(bx, cx, bcx)];
        left = left[..Expansion.Multiply(acx, bcy, left, scratch)];
        right = right[..Expansion.Multiply(acy, bcx, right, scratch)];
        Negate(right);
        return Expansion.Sign(determinant[..Expansion.Sum(left, right, determinant)]);
    }

    [MethodImpl(MethodImplOptions.NoInlining), SkipLocalsInit]
    private static int Orient3DExact(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D d)
    {
        if ((a.Z == d.Z && b.Z == d.Z && c.Z == d.Z) || (a.Y == d.Y && b.Y == d.Y && c.Y == d.Y) || (a.X == d.X && b.X == d.X && c.X == d.X)
            || Same(a, b) || Same(a, c) || Same(a, d) || Same(b, c) || Same(b, d) || Same(c, d))
            return 0;
        ReadOnlySpan<double> coordinates = [a.X, a.Y, a.Z, b.X, b.Y, b.Z, c.X, c.Y, c.Z, d.X, d.Y, d.Z];
        if (!FitsExpansions(coordinates))
            return Orient3DIntegers(coordinates);

        // Nine differences of at most 2 components, minors of 16, products of 64, their sum of 192.
        Span<double> differences = stackalloc double[18];
        Span<int> length = stackalloc int[9];
        for (int k = 0; k < 9; k++)
            length[k] = Expansion.Difference(coordinates[k], coordinates[9 + k % 3], differences.Slice(2 * k, 2));
        Span<double> room = stackalloc double[8 + 8 + 16 + 64 + 64 + 128 + 192];
        Span<double> partial = room.Slice(160, 128), determinant = room.Slice(288, 192);
        int n = 0;
        for (int k = 0; k < 3; k++)
        {
            // The term of row k: its z times the minor of the other two rows, in cyclic order.
            int p = 3 * ((k + 1) % 3), q = 3 * ((k + 2) % 3), r = 3 * k;
            int size = Term(
                differences.Slice(2 * p, length[p]), differences.Slice(2 * p + 2, length[p + 1]),
                differences.Slice(2 * q, length[q]), differences.Slice(2 * q + 2, length[q + 1]),
                differences.Slice(2 * r + 4, length[r + 2]), room);
            Span<double> term = room.Slice(32, size);
            // Sums alternate between two places.
            if (k == 0)
            {
                term.CopyTo(partial);
                n = size;
            }
            else if (k == 1)
            {
                n = Expansion.Sum(partial[..n], term, determinant);
                determinant[..n].CopyTo(partial);
            }
            else
            {
                n = Expansion.Sum(partial[..n], term, determinant);
            }
        }
        return -Expansion.Sign(determinant[..n]);
    }

    private static bool Same(in Vector3D a, in Vector3D b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z;

    // z · (px · qy − qx · py), left at room[32..].
    private static int Term(
        ReadOnlySpan<double> px, ReadOnlySpan<double> py, ReadOnlySpan<double> qx, ReadOnlySpan<double> qy, ReadOnlySpan<double> z, Span<double> room)
    {
        Span<double> left = room[..8], right = room.Slice(8, 8), minor = room.Slice(16, 16), product = room.Slice(32, 64), scratch = room.Slice(96, 64);
        left = left[..Expansion.Multiply(px, qy, left, scratch)];
        right = right[..Expansion.Multiply(qx, py, right, scratch)];
        Negate(right);
        minor = minor[..Expansion.Sum(left, right, minor)];
        return Expansion.Multiply(minor, z, product, scratch);
    }

    private static void Negate(Span<double> e)
    {
        for (int i = 0; i < e.Length; i++)
            e[i] = -e[i];
    }

    private static bool FitsExpansions(ReadOnlySpan<double> coordinates)
    {
        foreach (double x in coordinates)
        {
            double size = Math.Abs(x);
            if (!(size <= Largest) || (size < Smallest && size != 0))
                return false;
        }
        return true;
    }

    private static int Orient2DIntegers(ReadOnlySpan<double> coordinates)
    {
        BigInteger[] x = ToIntegers(coordinates);
        return ((x[0] - x[4]) * (x[3] - x[5]) - (x[1] - x[5]) * (x[2] - x[4])).Sign;
    }

    private static int Orient3DIntegers(ReadOnlySpan<double> coordinates)
    {
        BigInteger[] x = ToIntegers(coordinates);
        for (int k = 0; k < 9; k++)
            x[k] -= x[9 + k % 3];
        return -(x[2] * (x[3] * x[7] - x[6] * x[4]) + x[5] * (x[6] * x[1] - x[0] * x[7]) + x[8] * (x[0] * x[4] - x[3] * x[1])).Sign;
    }

    /// <summary>The numbers times one power of two that makes all of them integers.</summary>
    /// <exception cref="ArgumentOutOfRangeException">One is NaN or infinite.</exception>
    internal static BigInteger[] ToIntegers(ReadOnlySpan<double> values)
    {
        int lowest = int.MaxValue;
        foreach (double value in values)
        {
            if (!double.IsFinite(value))
                throw new ArgumentOutOfRangeException(nameof(values), value, "A coordinate is not finite.");
            if (value != 0)
                lowest = Math.Min(lowest, Exponent(value));
        }
        var result = new BigInteger[values.Length];
        for (int i = 0; i < values.Length; i++)
        {
            long bits = BitConverter.DoubleToInt64Bits(values[i]);
            long mantissa = bits & 0xFFFFFFFFFFFFF;
            if (((bits >> 52) & 0x7FF) != 0)
                mantissa |= 1L << 52;
            result[i] = mantissa == 0 ? BigInteger.Zero : new BigInteger(bits < 0 ? -mantissa : mantissa) << (Exponent(values[i]) - lowest);
        }
        return result;

        // Subnormal numbers have the exponent of the smallest normal ones.
        static int Exponent(double value) => Math.Max(1, (int)((BitConverter.DoubleToInt64Bits(value) >> 52) & 0x7FF));
    }
}
