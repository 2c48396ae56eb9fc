using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Spatial;

/// <summary>
/// The coordinates of the tree's boxes: relative to the middle of the mesh and scaled by a power of two to about unit size, so that
/// single precision serves coordinates of 1e6 and sizes of 1e-6 as well as any others.
/// </summary>
/// <param name="Center">The middle of the mesh.</param>
/// <param name="Scale">The power of two.</param>
internal readonly record struct Frame(Vector3D Center, double Scale)
{
    // A float has 24 bits; rounding to it errs by 2⁻²⁴ of the value. The subtraction before it errs by 2⁻⁵³ of its result. Twice 2⁻²⁴
    // covers both without a branch; the absolute part covers results that are not normal floats.
    private const double Margin = 1.2e-7, Tiny = 1e-30;

    /// <summary>Beyond this, points are moved to the surface of a box far outside: distances stay below the true ones and finite in single precision.</summary>
    private const double Far = 1e15;

    /// <summary>The factor that makes a squared distance between floats a lower bound, in spite of its rounding.</summary>
    public const float Shrink = 1 - 1e-6f;

    /// <summary>The frame of a box.</summary>
    public static Frame Of(BoundingBox box)
    {
        Vector3D size = box.Size;
        double largest = Math.Max(size.X, Math.Max(size.Y, size.Z));
        return new(box.Center, largest > 0 && double.IsFinite(largest) ? Math.ScaleB(1, -Math.Clamp(Math.ILogB(largest), -1000, 1000)) : 1);
    }

    /// <summary>A float at most the coordinate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Below(double coordinate, double center)
    {
        double x = (coordinate - center) * Scale;
        return (float)(x - (Math.Abs(x) * Margin + Tiny));
    }

    /// <summary>A float at least the coordinate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Above(double coordinate, double center)
    {
        double x = (coordinate - center) * Scale;
        return (float)(x + (Math.Abs(x) * Margin + Tiny));
    }

    /// <summary>As <see cref="Below"/>, for points that may be far away from the mesh.</summary>
    public float BelowClamped(double coordinate, double center)
    {
        double x = Math.Clamp((coordinate - center) * Scale, -Far, Far);
        return (float)(x - (Math.Abs(x) * Margin + Tiny));
    }

    /// <summary>As <see cref="Above"/>, for points that may be far away from the mesh.</summary>
    public float AboveClamped(double coordinate, double center)
    {
        double x = Math.Clamp((coordinate - center) * Scale, -Far, Far);
        return (float)(x + (Math.Abs(x) * Margin + Tiny));
    }

    /// <summary>A float at least the squared length, in the frame's units, and finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float SquaredAbove(double squared) => (float)Math.Min(squared * Scale * Scale * (1 + Margin) + Tiny * Tiny, 3e38);
}
