using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// Cuts a polygon of space into triangles for drawing: a fan if it is convex, else by cutting off ears (Meisters, 1975) in the plane of its
/// largest projection. O(n) for convex, O(n²) to O(n³) for other polygons.
/// </summary>
internal static class PolygonTriangulation
{
    /// <summary>Adds the polygon's n − 2 triangles, in its orientation.</summary>
    public static void Add(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon, List<int> triangles)
    {
        if (polygon.Length < 3)
            return;
        if (polygon.Length == 3)
        {
            Add(triangles, polygon[0], polygon[1], polygon[2]);
            return;
        }
        Vector2D[] points = Project(positions, polygon);
        if (polygon.Length == 4 && IsConvex(points))
            AddQuad(positions, polygon, triangles);
        else if (IsConvex(points))
            AddFan(polygon, triangles);
        else
            CutEars(points, polygon, triangles);
    }

    // The shorter diagonal bends a quad that is not planar the least.
    private static void AddQuad(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> q, List<int> triangles)
    {
        double d02 = Vector3D.DistanceSquared(positions[q[0]], positions[q[2]]), d13 = Vector3D.DistanceSquared(positions[q[1]], positions[q[3]]);
        if (d02 <= d13)
        {
            Add(triangles, q[0], q[1], q[2]);
            Add(triangles, q[0], q[2], q[3]);
        }
        else
        {
            Add(triangles, q[1], q[2], q[3]);
            Add(triangles, q[1], q[3], q[0]);
        }
    }

    private static void AddFan(ReadOnlySpan<int> polygon, List<int> triangles)
    {
        for (int i = 2; i < polygon.Length; i++)
            Add(triangles, polygon[0], polygon[i - 1], polygon[i]);
    }

    private static void CutEars(Vector2D[] points, ReadOnlySpan<int> polygon, List<int> triangles)
    {
        var left = new List<int>(points.Length);
        for (int i = 0; i < points.Length; i++)
            left.Add(i);
        int at = 0, failed = 0;
        while (left.Count > 3)
        {
            int a = left[(at + left.Count - 1) % left.Count], b = left[at % left.Count], c = left[(at + 1) % left.Count];
            // A full round without an ear means the outline crosses itself: cut anyway, the picture shows something and the loop ends.
            if (failed >= left.Count || IsEar(points, left, a, b, c))
            {
                Add(triangles, polygon[a], polygon[b], polygon[c]);
                left.RemoveAt(at % left.Count);
                at %= left.Count;
                failed = 0;
            }
            else
            {
                at = (at + 1) % left.Count;
                failed++;
            }
        }
        Add(triangles, polygon[left[0]], polygon[left[1]], polygon[left[2]]);
    }

    private static bool IsEar(Vector2D[] points, List<int> left, int a, int b, int c)
    {
        if (Turn(points[a], points[b], points[c]) <= 0)
            return false;
        foreach (int i in left)
        {
            if (i == a || i == b || i == c)
                continue;
            Vector2D p = points[i];
            if (p == points[a] || p == points[b] || p == points[c])
                continue;
            if (Turn(points[a], points[b], p) >= 0 && Turn(points[b], points[c], p) >= 0 && Turn(points[c], points[a], p) >= 0)
                return false;
        }
        return true;
    }

    private static bool IsConvex(Vector2D[] points)
    {
        int n = points.Length;
        double turning = 0;
        for (int i = 0; i < n; i++)
        {
            Vector2D a = points[i], b = points[(i + 1) % n], c = points[(i + 2) % n];
            double turn = Turn(a, b, c);
            if (turn < 0)
                return false;
            turning += Math.Atan2(turn, Vector2D.Dot(b - a, c - b));
        }
        return turning < 2 * Math.PI * 1.5;
    }

    // Drops the coordinate in which the polygon's normal (Newell, 1972) is largest; counter-clockwise in the result.
    private static Vector2D[] Project(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon)
    {
        Vector3D normal = default, origin = positions[polygon[0]];
        for (int i = 0; i < polygon.Length; i++)
            normal += Vector3D.Cross(positions[polygon[i]] - origin, positions[polygon[(i + 1) % polygon.Length]] - origin);
        double x = Math.Abs(normal.X), y = Math.Abs(normal.Y), z = Math.Abs(normal.Z);
        var points = new Vector2D[polygon.Length];
        for (int i = 0; i < polygon.Length; i++)
        {
            Vector3D p = positions[polygon[i]];
            if (x >= y && x >= z)
                points[i] = new(p.Y * Math.Sign(normal.X), p.Z);
            else if (y >= z)
                points[i] = new(p.Z * Math.Sign(normal.Y), p.X);
            else
                points[i] = new(p.X * Math.Sign(normal.Z), p.Y);
        }
        return points;
    }

    private static double Turn(Vector2D a, Vector2D b, Vector2D c) => Vector2D.Cross(b - a, c - a);

    private static void Add(List<int> triangles, int a, int b, int c)
    {
        triangles.Add(a);
        triangles.Add(b);
        triangles.Add(c);
    }
}
