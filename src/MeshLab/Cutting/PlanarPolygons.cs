using MeshLab.Numerics;

namespace MeshLab.Cutting;

/// <summary>Questions about polygons of the plane.</summary>
internal static class PlanarPolygons
{
    private const int Witnesses = 5;

    /// <summary>Whether a point lies inside a polygon, by the number of edges that a ray to the right crosses. Exact but for points on the rim.</summary>
    public static bool Contains(ReadOnlySpan<Vector2D> polygon, Vector2D p)
    {
        bool inside = false;
        Vector2D a = polygon[^1];
        foreach (Vector2D b in polygon)
        {
            if (a.Y > p.Y != b.Y > p.Y)
            {
                int side = ExactPredicates.Orient2D(a, b, p);
                if (side > 0 == b.Y > a.Y)
                    inside = !inside;
            }
            a = b;
        }
        return inside;
    }

    /// <summary>Whether a loop lies in a polygon that it does not cross, but may touch: by a few of its points, those on the rim apart.</summary>
    public static bool Holds(ReadOnlySpan<Vector2D> polygon, ReadOnlySpan<Vector2D> loop)
    {
        int votes = 0, n = loop.Length, step = Math.Max(1, n / Witnesses);
        for (int i = 0; i < n; i += step)
            votes += Side(polygon, loop[i]);
        for (int i = 0; i < n && votes == 0; i++)
            votes = Side(polygon, (loop[i] + loop[(i + 1) % n]) * 0.5);
        return votes >= 0;
    }

    /// <summary>1 inside, −1 outside, 0 on the rim.</summary>
    private static int Side(ReadOnlySpan<Vector2D> polygon, Vector2D p)
    {
        Vector2D a = polygon[^1];
        foreach (Vector2D b in polygon)
        {
            bool between = Math.Min(a.X, b.X) <= p.X && p.X <= Math.Max(a.X, b.X) && Math.Min(a.Y, b.Y) <= p.Y && p.Y <= Math.Max(a.Y, b.Y);
            if (between && ExactPredicates.Orient2D(a, b, p) == 0)
                return 0;
            a = b;
        }
        return Contains(polygon, p) ? 1 : -1;
    }

    /// <summary>Twice the signed area.</summary>
    public static double DoubleArea(ReadOnlySpan<Vector2D> polygon)
    {
        double sum = 0;
        for (int i = 1; i + 1 < polygon.Length; i++)
            sum += Vector2D.Cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
        return sum;
    }
}
