using MeshLab.Numerics;

namespace MeshLab.Cutting;

/// <summary>Questions about polygons of the plane.</summary>
internal static class PlanarPolygons
{
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
                if (side == 0 ? Math.Max(a.X, b.X) > p.X : side > 0 == b.Y > a.Y)
                    inside = !inside;
            }
            a = b;
        }
        return inside;
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
