using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Spatial;

/// <summary>Points on single triangles.</summary>
public static class TriangleMath
{
    /// <summary>The point of the triangle closest to a point.</summary>
    /// <param name="query">The point.</param>
    /// <param name="a">First corner.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner; degenerate triangles are allowed.</param>
    public static Vector3D ClosestPoint(Vector3D query, Vector3D a, Vector3D b, Vector3D c)
    {
        ClosestDistanceSquared(query, a, b, c, out Vector3D weights);
        return At(weights, a, b, c);
    }

    /// <summary>The squared distance of a point from a triangle, and where the triangle is closest.</summary>
    /// <remarks>
    /// The best of the three edges and, where the foot of the perpendicular is inside, the plane: right for slivers too, whose inside
    /// is decided by rounding.
    /// </remarks>
    /// <param name="query">The point.</param>
    /// <param name="a">First corner.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner; degenerate triangles are allowed.</param>
    /// <param name="weights">The barycentric weights (重心坐标) of the closest point at the three corners.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static double ClosestDistanceSquared(Vector3D query, Vector3D a, Vector3D b, Vector3D c, out Vector3D weights)
    {
        Vector3D u = b - a, v = c - a, w = query - a;
        double uu = Vector3D.Dot(u, u), uv = Vector3D.Dot(u, v), vv = Vector3D.Dot(v, v), uw = Vector3D.Dot(u, w), vw = Vector3D.Dot(v, w);

        double t = Clamp(uw, uu);
        double best = (w - t * u).LengthSquared;
        weights = new(1 - t, t, 0);

        t = Clamp(vw, vv);
        double distance = (w - t * v).LengthSquared;
        if (distance < best)
            (best, weights) = (distance, new(1 - t, 0, t));

        Vector3D e = v - u, f = w - u;
        t = Clamp(Vector3D.Dot(e, f), e.LengthSquared);
        distance = (f - t * e).LengthSquared;
        if (distance < best)
            (best, weights) = (distance, new(0, 1 - t, t));

        double s = vv * uw - uv * vw, r = uu * vw - uv * uw, determinant = uu * vv - uv * uv;
        if (s > 0 && r > 0 && s + r < determinant)
        {
            double inverse = 1 / determinant, bs = s * inverse, br = r * inverse;
            Vector3D rest = w - bs * u - br * v;
            distance = rest.LengthSquared;
            if (distance <= best)
                (best, weights) = (distance, new(1 - bs - br, bs, br));

            // Once more from what is left: the weights of slivers lose digits with the square of their thinness.
            double ru = Vector3D.Dot(u, rest), rv = Vector3D.Dot(v, rest);
            double ds = (vv * ru - uv * rv) * inverse, dr = (uu * rv - uv * ru) * inverse;
            bs += ds;
            br += dr;
            distance = (rest - ds * u - dr * v).LengthSquared;
            if (bs >= 0 && br >= 0 && bs + br <= 1 && distance <= best)
                (best, weights) = (distance, new(1 - bs - br, bs, br));
        }
        return best;
    }

    /// <summary>The point with the given barycentric weights.</summary>
    public static Vector3D At(Vector3D barycentric, Vector3D a, Vector3D b, Vector3D c) =>
        // A weight of one gives the corner's own bits.
        barycentric.X == 1 ? a : barycentric.Y == 1 ? b : barycentric.Z == 1 ? c
        : a + (b - a) * barycentric.Y + (c - a) * barycentric.Z;

    private static double Clamp(double along, double lengthSquared) =>
        Math.Min(Math.Max(along / Math.Max(lengthSquared, double.Epsilon * (1L << 52)), 0), 1);
}
