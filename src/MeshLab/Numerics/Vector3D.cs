using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace MeshLab.Numerics;

/// <summary>A point or a direction of space (三维向量): three <see langword="double"/>s.</summary>
/// <remarks>
/// Doubles, because curvature differentiates twice: at a million faces single precision spoils it (<c>docs/architecture.md</c>).
/// All operations round as IEEE 754 says, in the order written here, so results are the same bits on every machine.
/// </remarks>
/// <param name="X">The first coordinate.</param>
/// <param name="Y">The second coordinate.</param>
/// <param name="Z">The third coordinate.</param>
public readonly record struct Vector3D(double X, double Y, double Z)
    : IAdditionOperators<Vector3D, Vector3D, Vector3D>,
      ISubtractionOperators<Vector3D, Vector3D, Vector3D>,
      IMultiplyOperators<Vector3D, double, Vector3D>,
      IDivisionOperators<Vector3D, double, Vector3D>,
      IUnaryNegationOperators<Vector3D, Vector3D>,
      IAdditiveIdentity<Vector3D, Vector3D>,
      IFormattable
{
    /// <summary>(0, 0, 0).</summary>
    public static Vector3D Zero => default;

    /// <summary>(1, 0, 0).</summary>
    public static Vector3D UnitX => new(1, 0, 0);

    /// <summary>(0, 1, 0).</summary>
    public static Vector3D UnitY => new(0, 1, 0);

    /// <summary>(0, 0, 1).</summary>
    public static Vector3D UnitZ => new(0, 0, 1);

    /// <summary>The neutral element of addition, (0, 0, 0).</summary>
    public static Vector3D AdditiveIdentity => default;

    /// <summary>The Euclidean length.</summary>
    public double Length => Math.Sqrt(X * X + Y * Y + Z * Z);

    /// <summary>The square of the length; cheaper than <see cref="Length"/> and enough to compare.</summary>
    public double LengthSquared => X * X + Y * Y + Z * Z;

    /// <summary>Whether no coordinate is NaN or infinite.</summary>
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>The coordinate with the given index.</summary>
    /// <param name="axis">0, 1 or 2.</param>
    public double this[int axis] => axis switch
    {
        0 => X,
        1 => Y,
        2 => Z,
        _ => throw new ArgumentOutOfRangeException(nameof(axis), axis, "An axis is 0, 1 or 2."),
    };

    /// <summary>Sum.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator +(Vector3D left, Vector3D right) => new(left.X + right.X, left.Y + right.Y, left.Z + right.Z);

    /// <summary>Difference; of two points, the vector from <paramref name="right"/> to <paramref name="left"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator -(Vector3D left, Vector3D right) => new(left.X - right.X, left.Y - right.Y, left.Z - right.Z);

    /// <summary>The opposite vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator -(Vector3D value) => new(-value.X, -value.Y, -value.Z);

    /// <summary>The vector scaled.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator *(Vector3D left, double right) => new(left.X * right, left.Y * right, left.Z * right);

    /// <summary>The vector scaled.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator *(double left, Vector3D right) => new(left * right.X, left * right.Y, left * right.Z);

    /// <summary>The vector divided by a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D operator /(Vector3D left, double right) => new(left.X / right, left.Y / right, left.Z / right);

    /// <summary>The scalar product (点积).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(Vector3D a, Vector3D b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    /// <summary>The vector product (叉积), right-handed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D Cross(Vector3D a, Vector3D b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>The determinant of three columns: six times the signed volume of a tetrahedron at the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Determinant(Vector3D a, Vector3D b, Vector3D c) => Dot(a, Cross(b, c));

    /// <summary>The distance of two points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Distance(Vector3D a, Vector3D b) => (a - b).Length;

    /// <summary>The squared distance of two points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double DistanceSquared(Vector3D a, Vector3D b) => (a - b).LengthSquared;

    /// <summary>The point at parameter <paramref name="t"/> from <paramref name="a"/> (0) to <paramref name="b"/> (1).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D Lerp(Vector3D a, Vector3D b, double t) => a * (1 - t) + b * t;

    /// <summary>The smaller of each coordinate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D Min(Vector3D a, Vector3D b) => new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));

    /// <summary>The larger of each coordinate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D Max(Vector3D a, Vector3D b) => new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));

    /// <summary>The angle between two vectors in [0, π], by atan2: exact also near 0 and π. Zero vectors give 0.</summary>
    public static double Angle(Vector3D a, Vector3D b) => Math.Atan2(Cross(a, b).Length, Dot(a, b));

    /// <summary>The vector of length 1 in the same direction; the zero vector stays zero.</summary>
    public Vector3D Normalized()
    {
        double length = Length;
        // Tiny vectors underflow when squared; scaling first keeps their direction.
        if (length is > 1e-140 and < 1e140)
            return this / length;
        double largest = Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));
        if (largest == 0 || !double.IsFinite(largest))
            return default;
        Vector3D scaled = this / largest;
        return scaled / scaled.Length;
    }

    /// <summary>From single precision.</summary>
    public static implicit operator Vector3D(Vector3 value) => new(value.X, value.Y, value.Z);

    /// <summary>To single precision; digits are lost.</summary>
    public static explicit operator Vector3(Vector3D value) => new((float)value.X, (float)value.Y, (float)value.Z);

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <inheritdoc/>
    public string ToString(string? format, IFormatProvider? formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"({X.ToString(format, formatProvider)}, {Y.ToString(format, formatProvider)}, {Z.ToString(format, formatProvider)})";
    }
}
