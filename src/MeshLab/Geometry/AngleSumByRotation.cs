using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Geometry;

/// <summary>Adds angles in [0, π] by turning a vector: one arctangent per vertex instead of one per corner.</summary>
/// <remarks>
/// The complex number (u · w) + i |u × w| has the angle between u and w as its argument, and arguments add when complex numbers are multiplied.
/// The product is kept in the upper half plane; every half turn taken out is counted. What is missing to a full turn then comes out of one
/// arctangent of a small angle, with all its digits, where 2π − Σθ would lose them by subtraction.
/// </remarks>
internal struct AngleSumByRotation : ICornerSum
{
    private double re = 1;
    private double im;
    private int halfTurns;

    public AngleSumByRotation()
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(Vector3D u, Vector3D w) => Add(Vector3D.Dot(u, w), Vector3D.Cross(u, w).Length);

    /// <summary>Adds the argument of <paramref name="dot"/> + i <paramref name="cross"/>, with <paramref name="cross"/> ≥ 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(double dot, double cross)
    {
        double x = re * dot - im * cross, y = re * cross + im * dot;
        if (y < 0 || (y == 0 && x < 0))
        {
            (x, y) = (-x, -y);
            halfTurns++;
        }
        double size = Math.Abs(x) + y;
        if (size is > 1e-100 and < 1e100)
            (re, im) = (x, y);
        else
            (re, im, halfTurns) = Rescaled(x, y, size);
    }

    /// <summary>That many half turns less the sum.</summary>
    public readonly double MissingTo(int turns) => (turns - halfTurns) * Math.PI - Math.Atan2(im, re);

    /// <summary>Out of the loop, and without a reference to the sums, so that they can stay in registers. A side of length zero makes no angle.</summary>
    private readonly (double Re, double Im, int HalfTurns) Rescaled(double x, double y, double size) =>
        size == 0 ? (re, im, halfTurns) : (x / size, y / size, halfTurns);
}
