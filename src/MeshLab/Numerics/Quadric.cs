using System.Runtime.CompilerServices;

namespace MeshLab.Numerics;

/// <summary>A quadratic function of space, q(p) = pᵀA p + 2 bᵀp + c with symmetric A: a sum of squared distances to planes (二次误差, §7.2).</summary>
/// <remarks>Ten numbers, as in Garland and Heckbert 1997: K = ppᵀ for the plane p = (n, d), n·x + d = 0. The fields are open so that sums run in registers.</remarks>
public struct Quadric : IEquatable<Quadric>
{
    /// <summary>Entry (1, 1) of A.</summary>
    public double XX;

    /// <summary>Entry (1, 2) of A.</summary>
    public double XY;

    /// <summary>Entry (1, 3) of A.</summary>
    public double XZ;

    /// <summary>Entry (2, 2) of A.</summary>
    public double YY;

    /// <summary>Entry (2, 3) of A.</summary>
    public double YZ;

    /// <summary>Entry (3, 3) of A.</summary>
    public double ZZ;

    /// <summary>First entry of b.</summary>
    public double X;

    /// <summary>Second entry of b.</summary>
    public double Y;

    /// <summary>Third entry of b.</summary>
    public double Z;

    /// <summary>The constant c.</summary>
    public double C;

    /// <summary>A determinant of A below this part of its trace cubed counts as zero: no unique minimum. Nearly parallel planes meet far away and inexactly;
    /// a smaller bound costs accuracy on models of flat parts.</summary>
    private const double Flat = 1e-10;

    /// <summary>The trace of A: the sum of the weights of all planes.</summary>
    public readonly double Weight => XX + YY + ZZ;

    /// <summary>The squared distance to the plane n·x + d = 0, times a weight.</summary>
    /// <param name="normal">The unit normal n.</param>
    /// <param name="offset">The offset d.</param>
    /// <param name="weight">The weight.</param>
    public static Quadric OfPlane(Vector3D normal, double offset, double weight)
    {
        Quadric q = default;
        q.AddPlane(normal, offset, weight);
        return q;
    }

    /// <summary>The sum of two.</summary>
    public static Quadric operator +(Quadric left, Quadric right)
    {
        left.Add(in right);
        return left;
    }

    /// <summary>Whether all entries are equal.</summary>
    public static bool operator ==(Quadric left, Quadric right) => left.Equals(right);

    /// <summary>Whether some entry differs.</summary>
    public static bool operator !=(Quadric left, Quadric right) => !left.Equals(right);

    /// <summary>Adds the squared distance to the plane n·x + d = 0 with a weight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AddPlane(Vector3D normal, double offset, double weight)
    {
        double x = weight * normal.X, y = weight * normal.Y, z = weight * normal.Z;
        XX += x * normal.X;
        XY += x * normal.Y;
        XZ += x * normal.Z;
        YY += y * normal.Y;
        YZ += y * normal.Z;
        ZZ += z * normal.Z;
        X += x * offset;
        Y += y * offset;
        Z += z * offset;
        C += weight * offset * offset;
    }

    /// <summary>Adds another quadric.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(ref readonly Quadric other)
    {
        XX += other.XX;
        XY += other.XY;
        XZ += other.XZ;
        YY += other.YY;
        YZ += other.YZ;
        ZZ += other.ZZ;
        X += other.X;
        Y += other.Y;
        Z += other.Z;
        C += other.C;
    }

    /// <summary>Adds a multiple of another quadric.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(ref readonly Quadric other, double factor)
    {
        XX += factor * other.XX;
        XY += factor * other.XY;
        XZ += factor * other.XZ;
        YY += factor * other.YY;
        YZ += factor * other.YZ;
        ZZ += factor * other.ZZ;
        X += factor * other.X;
        Y += factor * other.Y;
        Z += factor * other.Z;
        C += factor * other.C;
    }

    /// <summary>The value at a point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double At(Vector3D p) =>
        p.X * (XX * p.X + 2 * (XY * p.Y + XZ * p.Z + X)) + p.Y * (YY * p.Y + 2 * (YZ * p.Z + Y)) + p.Z * (ZZ * p.Z + 2 * Z) + C;

    /// <summary>The point of the smallest value, A p = −b by cofactors, and that value.</summary>
    /// <returns>False if A is singular as far as doubles can tell (planes that meet in no single point); then the outputs are 0.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool TryMinimize(out Vector3D point, out double value)
    {
        double c11 = YY * ZZ - YZ * YZ, c12 = XZ * YZ - XY * ZZ, c13 = XY * YZ - XZ * YY;
        double determinant = XX * c11 + XY * c12 + XZ * c13, trace = XX + YY + ZZ;
        if (determinant > Flat * trace * trace * trace)
        {
            double c22 = XX * ZZ - XZ * XZ, c23 = XY * XZ - XX * YZ, c33 = XX * YY - XY * XY, scale = -1 / determinant;
            double x = (c11 * X + c12 * Y + c13 * Z) * scale;
            double y = (c12 * X + c22 * Y + c23 * Z) * scale;
            double z = (c13 * X + c23 * Y + c33 * Z) * scale;
            point = new(x, y, z);
            value = X * x + Y * y + Z * z + C;
            return true;
        }
        point = default;
        value = 0;
        return false;
    }

    /// <summary>The parameter in [0, 1] of the point between two points at which the value is smallest; 0.5 if it is the same everywhere.</summary>
    public readonly double MinimizeOnSegment(Vector3D from, Vector3D to)
    {
        Vector3D d = to - from;
        // Along the segment the value is a parabola: curvature dᵀA d, slope at the start 2 dᵀ(A from + b).
        var gradient = new Vector3D(
            XX * from.X + XY * from.Y + XZ * from.Z + X,
            XY * from.X + YY * from.Y + YZ * from.Z + Y,
            XZ * from.X + YZ * from.Y + ZZ * from.Z + Z);
        double slope = Vector3D.Dot(gradient, d);
        double curvature = d.X * (XX * d.X + 2 * (XY * d.Y + XZ * d.Z)) + d.Y * (YY * d.Y + 2 * YZ * d.Z) + ZZ * d.Z * d.Z;
        if (curvature > Flat * Weight * d.LengthSquared)
            return Math.Clamp(-slope / curvature, 0, 1);
        double start = At(from), end = At(to);
        return start < end ? 0 : end < start ? 1 : 0.5;
    }

    /// <inheritdoc/>
    public readonly bool Equals(Quadric other) =>
        XX == other.XX && XY == other.XY && XZ == other.XZ && YY == other.YY && YZ == other.YZ && ZZ == other.ZZ
        && X == other.X && Y == other.Y && Z == other.Z && C == other.C;

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is Quadric other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode() => HashCode.Combine(XX, YY, ZZ, X, Y, Z, C);
}
