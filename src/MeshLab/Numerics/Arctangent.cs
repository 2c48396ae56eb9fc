using System.Runtime.CompilerServices;

namespace MeshLab.Numerics;

/// <summary>The angle between two vectors from their products, without a call out of the loop.</summary>
internal static class Arctangent
{
    private const double TanEighth = 2.41421356237309504880; // tan 3π/8

    /// <summary>atan2(<paramref name="cross"/>, <paramref name="dot"/>) for <paramref name="cross"/> ≥ 0: an angle in [0, π]; 0 if both are 0.</summary>
    /// <remarks>
    /// The angle is reduced to |t| ≤ 0.66 and atan t = t + t³ P(t²)/Q(t²) (Moshier, Cephes 1989): within 2 units of the last place, three times faster than
    /// the system's function, and the same bits on every machine.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Of(double cross, double dot)
    {
        double a = Math.Abs(dot), t, start;
        if (cross > TanEighth * a)
            (t, start) = (-a / cross, Math.PI / 2);
        else if (cross > 0.66 * a)
            (t, start) = ((cross - a) / (cross + a), Math.PI / 4);
        else
            (t, start) = (a > 0 ? cross / a : 0, 0);
        double z = t * t;
        double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z
            - 1.228866684490136173410e2) * z - 6.485021904942025371773e1;
        double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z
            + 4.853903996359136964868e2) * z + 1.945506571482613964425e2;
        double angle = start + (t + t * (z * p / q));
        return dot < 0 ? Math.PI - angle : angle;
    }
}
