using MeshLab.Numerics;

namespace MeshLab.Generation;

/// <summary>Cuts a polygon with holes into triangles: holes are joined to the outside by bridges (Eberly), then ears are clipped (Meisters 1975). O(n²).</summary>
/// <remarks>No vertex is added, so long thin triangles are normal. Orientation tests are exact.</remarks>
internal static class EarClipping
{
    /// <summary>Cuts the polygon.</summary>
    /// <param name="points">The outline counter-clockwise, then the holes clockwise, one after the other.</param>
    /// <param name="loopStart">Where each loop begins; one more entry at the end.</param>
    /// <param name="name">The argument to blame.</param>
    /// <returns>Three indices per triangle, counter-clockwise.</returns>
    public static List<int> Triangulate(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, string name)
    {
        CheckTurns(points, loopStart, name);
        CheckCrossings(points, loopStart, name);
        CheckNesting(points, loopStart, name);
        List<int> polygon = JoinHoles(points, loopStart, name);
        return Clip(points, polygon, name);
    }

    private static void CheckTurns(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, string name)
    {
        for (int loop = 0; loop + 1 < loopStart.Length; loop++)
        {
            int first = loopStart[loop], end = loopStart[loop + 1];
            if (end - first < 3)
                throw new ArgumentException($"Loop {loop} has fewer than three points.", name);
            double area = 0;
            for (int i = first, j = end - 1; i < end; j = i++)
                area += Vector2D.Cross(points[j] - points[first], points[i] - points[first]);
            if (loop == 0 ? area <= 0 : area >= 0)
                throw new ArgumentException($"Loop {loop} must run {(loop == 0 ? "counter-clockwise" : "clockwise")}.", name);
        }
    }

    private static void CheckCrossings(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, string name)
    {
        var end = new int[points.Length];
        for (int loop = 0; loop + 1 < loopStart.Length; loop++)
        {
            for (int i = loopStart[loop]; i < loopStart[loop + 1]; i++)
                end[i] = i + 1 < loopStart[loop + 1] ? i + 1 : loopStart[loop];
        }
        for (int i = 0; i < points.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                bool neighbors = end[i] == j || end[j] == i;
                if (neighbors ? FoldsBack(points, i, j, end) : Meet(points[i], points[end[i]], points[j], points[end[j]]))
                    throw new ArgumentException($"The sides at {points[i]} and {points[j]} cross or touch.", name);
            }
        }
    }

    private static bool FoldsBack(ReadOnlySpan<Vector2D> points, int i, int j, int[] end)
    {
        (int before, int corner) = end[i] == j ? (i, j) : (j, i);
        Vector2D a = points[before], b = points[corner], c = points[end[corner]];
        return a == b || (ExactPredicates.Orient2D(a, b, c) == 0 && Vector2D.Dot(b - a, c - b) <= 0);
    }

    /// <summary>Whether two segments have a point in common.</summary>
    private static bool Meet(Vector2D a, Vector2D b, Vector2D c, Vector2D d)
    {
        if (Math.Max(a.X, b.X) < Math.Min(c.X, d.X) || Math.Max(c.X, d.X) < Math.Min(a.X, b.X)
            || Math.Max(a.Y, b.Y) < Math.Min(c.Y, d.Y) || Math.Max(c.Y, d.Y) < Math.Min(a.Y, b.Y))
            return false;
        return ExactPredicates.Orient2D(a, b, c) * ExactPredicates.Orient2D(a, b, d) <= 0
            && ExactPredicates.Orient2D(c, d, a) * ExactPredicates.Orient2D(c, d, b) <= 0;
    }

    /// <summary>Every hole lies inside the outline and outside the other holes; no two loops meet, so one point of each tells.</summary>
    private static void CheckNesting(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, string name)
    {
        for (int hole = 1; hole + 1 < loopStart.Length; hole++)
        {
            for (int loop = 0; loop + 1 < loopStart.Length; loop++)
            {
                if (loop != hole && Contains(points[loopStart[loop]..loopStart[loop + 1]], points[loopStart[hole]]) != (loop == 0))
                    throw new ArgumentException($"Hole {hole} does not lie inside the outline and outside the other holes.", name);
            }
        }
    }

    private static bool Contains(ReadOnlySpan<Vector2D> loop, Vector2D p)
    {
        bool inside = false;
        Vector2D a = loop[^1];
        foreach (Vector2D b in loop)
        {
            if (a.Y > p.Y != b.Y > p.Y)
                inside ^= ExactPredicates.Orient2D(a, b, p) > 0 == b.Y > a.Y;
            a = b;
        }
        return inside;
    }

    private static List<int> JoinHoles(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, string name)
    {
        var polygon = new List<int>();
        for (int i = loopStart[0]; i < loopStart[1]; i++)
            polygon.Add(i);
        var holes = new List<(double X, int Rightmost, int Loop)>();
        for (int loop = 1; loop + 1 < loopStart.Length; loop++)
        {
            int rightmost = loopStart[loop];
            for (int i = rightmost + 1; i < loopStart[loop + 1]; i++)
            {
                if (points[i].X > points[rightmost].X)
                    rightmost = i;
            }
            holes.Add((points[rightmost].X, rightmost, loop));
        }
        holes.Sort((a, b) => a.X != b.X ? b.X.CompareTo(a.X) : a.Rightmost.CompareTo(b.Rightmost));
        foreach ((_, int rightmost, int loop) in holes)
        {
            int first = loopStart[loop], count = loopStart[loop + 1] - first;
            int at = VisibleCorner(points, loopStart, polygon, rightmost, name);
            var bridge = new List<int>(count + 2);
            for (int k = 0; k <= count; k++)
                bridge.Add(first + (rightmost - first + k) % count);
            bridge.Add(polygon[at]);
            polygon.InsertRange(at + 1, bridge);
        }
        return polygon;
    }

    /// <summary>The corner of the polygon nearest to a hole's point among those that see it. The rightmost point of all holes left always finds one.</summary>
    private static int VisibleCorner(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, List<int> polygon, int hole, string name)
    {
        Vector2D p = points[hole];
        int best = -1;
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < polygon.Count; i++)
        {
            double distance = (points[polygon[i]] - p).Length;
            if (distance < nearest && LooksInside(points, polygon, i, p)
                && !BlockedByBridges(points, polygon, i, p) && !BlockedByLoops(points, loopStart, points[polygon[i]], p))
                (nearest, best) = (distance, i);
        }
        return best >= 0 ? best : throw new ArgumentException($"A hole with the point {p} does not lie inside the outline.", name);
    }

    /// <summary>Whether the point lies within the angle of the polygon at a corner (corners appear twice at bridges).</summary>
    private static bool LooksInside(ReadOnlySpan<Vector2D> points, List<int> polygon, int i, Vector2D p)
    {
        Vector2D before = points[polygon[(i + polygon.Count - 1) % polygon.Count]], corner = points[polygon[i]], after = points[polygon[(i + 1) % polygon.Count]];
        bool leftOfIn = ExactPredicates.Orient2D(before, corner, p) > 0, leftOfOut = ExactPredicates.Orient2D(corner, after, p) > 0;
        return ExactPredicates.Orient2D(before, corner, after) > 0 ? leftOfIn && leftOfOut : leftOfIn || leftOfOut;
    }

    private static bool BlockedByBridges(ReadOnlySpan<Vector2D> points, List<int> polygon, int corner, Vector2D p)
    {
        Vector2D q = points[polygon[corner]];
        for (int i = 0; i < polygon.Count; i++)
        {
            if (Blocks(points[polygon[i]], points[polygon[(i + 1) % polygon.Count]], p, q))
                return true;
        }
        return false;
    }

    private static bool BlockedByLoops(ReadOnlySpan<Vector2D> points, ReadOnlySpan<int> loopStart, Vector2D q, Vector2D p)
    {
        for (int loop = 0; loop + 1 < loopStart.Length; loop++)
        {
            Vector2D a = points[loopStart[loop + 1] - 1];
            foreach (Vector2D b in points[loopStart[loop]..loopStart[loop + 1]])
            {
                if (Blocks(a, b, p, q))
                    return true;
                a = b;
            }
        }
        return false;
    }

    /// <summary>Whether the segment a–b stands between p and q; segments that end at either do not, as no three loop points in a row fold back.</summary>
    private static bool Blocks(Vector2D a, Vector2D b, Vector2D p, Vector2D q) =>
        a != p && b != p && a != q && b != q && Meet(a, b, p, q);

    private static List<int> Clip(ReadOnlySpan<Vector2D> points, List<int> polygon, string name)
    {
        var triangles = new List<int>(3 * polygon.Count);
        int position = 0, tried = 0;
        while (polygon.Count > 3)
        {
            int n = polygon.Count, i = position % n, h = (i + n - 1) % n, j = (i + 1) % n;
            if (IsEar(points, polygon, h, i, j))
            {
                triangles.AddRange([polygon[h], polygon[i], polygon[j]]);
                polygon.RemoveAt(i);
                tried = 0;
                // Going on behind the ear spreads the triangles instead of making one fan.
                position = i;
                continue;
            }
            position = i + 1;
            if (++tried > n)
                throw new ArgumentException("The loops cross themselves or each other.", name);
        }
        triangles.AddRange([polygon[0], polygon[1], polygon[2]]);
        return triangles;
    }

    private static bool IsEar(ReadOnlySpan<Vector2D> points, List<int> polygon, int h, int i, int j)
    {
        Vector2D a = points[polygon[h]], b = points[polygon[i]], c = points[polygon[j]];
        if (ExactPredicates.Orient2D(a, b, c) <= 0)
            return false;
        for (int k = 0; k < polygon.Count; k++)
        {
            Vector2D p = points[polygon[k]];
            if (k == h || k == i || k == j || p == a || p == b || p == c)
                continue;
            if (ExactPredicates.Orient2D(a, b, p) >= 0 && ExactPredicates.Orient2D(b, c, p) >= 0 && ExactPredicates.Orient2D(c, a, p) >= 0)
                return false;
        }
        return true;
    }
}
