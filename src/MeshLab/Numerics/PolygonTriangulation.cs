namespace MeshLab.Numerics;

/// <summary>三角化 (triangulation) of one polygon in space, by clipping ears in the plane of its vector area.</summary>
/// <remarks>
/// Meisters 1975: a simple polygon with more than three corners has two ears. Of all ears the one with the largest smallest angle goes first, ties
/// by position in the polygon, so that convex polygons become good triangles too. A polygon so bent or degenerate, or crossing itself, that no ear is left
/// is cut as a fan from there on. O(n²) mostly, O(n³) at worst.
/// </remarks>
public static class PolygonTriangulation
{
    private const int OnStack = 32;

    /// <summary>Adds the polygon's n − 2 triangles, in its orientation.</summary>
    /// <param name="positions">Per vertex.</param>
    /// <param name="polygon">Vertex indices, counter-clockwise; three or more.</param>
    /// <param name="corners">Gets three vertex indices per triangle.</param>
    /// <exception cref="ArgumentException">Fewer than three corners.</exception>
    public static void Triangulate(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon, List<int> corners)
    {
        ArgumentNullException.ThrowIfNull(corners);
        int n = polygon.Length;
        if (n < 3)
            throw new ArgumentException($"A polygon has three or more corners; this has {n}.", nameof(polygon));
        if (n == 3)
        {
            corners.AddRange(polygon);
            return;
        }

        var ring = new Ring(
            n <= OnStack ? stackalloc Vector2D[OnStack] : new Vector2D[n],
            n <= OnStack ? stackalloc int[OnStack] : new int[n],
            n <= OnStack ? stackalloc int[OnStack] : new int[n],
            n <= OnStack ? stackalloc double[OnStack] : new double[n],
            n <= OnStack ? stackalloc bool[OnStack] : new bool[n]);
        Project(positions, polygon, ring.Points);
        ring.Close(n);
        for (int left = n; left > 3; left--)
        {
            int ear = ring.BestEar(left);
            corners.Add(polygon[ring.Previous[ear]]);
            corners.Add(polygon[ear]);
            corners.Add(polygon[ring.Next[ear]]);
            ring.Remove(ear);
        }
        int last = ring.First;
        corners.Add(polygon[last]);
        corners.Add(polygon[ring.Next[last]]);
        corners.Add(polygon[ring.Previous[last]]);
    }

    /// <summary>The polygon in its own plane, seen from outside.</summary>
    private static void Project(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon, Span<Vector2D> points)
    {
        Vector3D origin = positions[polygon[0]], normal = default;
        for (int i = 1; i + 1 < polygon.Length; i++)
            normal += Vector3D.Cross(positions[polygon[i]] - origin, positions[polygon[i + 1]] - origin);
        normal = normal.Normalized();
        if (normal == default)
            normal = Vector3D.UnitZ;
        Vector3D x = Vector3D.Cross(Math.Abs(normal.X) < 0.6 ? Vector3D.UnitX : Vector3D.UnitY, normal).Normalized();
        Vector3D y = Vector3D.Cross(normal, x);
        for (int i = 0; i < polygon.Length; i++)
        {
            Vector3D p = positions[polygon[i]] - origin;
            points[i] = new(Vector3D.Dot(p, x), Vector3D.Dot(p, y));
        }
    }

    /// <summary>What is left of the polygon: a ring of corners, each with its slenderness as a triangle.</summary>
    private ref struct Ring(Span<Vector2D> points, Span<int> next, Span<int> previous, Span<double> slenderness, Span<bool> isKnownEar)
    {
        public readonly Span<Vector2D> Points = points;
        public readonly Span<int> Next = next, Previous = previous;
        private readonly Span<double> slenderness = slenderness;
        private readonly Span<bool> isKnownEar = isKnownEar;

        /// <summary>The lowest corner that is left.</summary>
        public int First { get; private set; }

        public void Close(int n)
        {
            for (int i = 0; i < n; i++)
            {
                Next[i] = i + 1 < n ? i + 1 : 0;
                Previous[i] = i > 0 ? i - 1 : n - 1;
            }
            for (int i = 0; i < n; i++)
                Measure(i);
        }

        public void Remove(int i)
        {
            (int before, int after) = (Previous[i], Next[i]);
            Next[before] = after;
            Previous[after] = before;
            if (i == First)
                First = after;
            Measure(before);
            Measure(after);
        }

        /// <summary>The ear with the largest smallest angle; if there is none, the first corner.</summary>
        public readonly int BestEar(int left)
        {
            int best = First;
            double least = double.PositiveInfinity;
            for (int i = First, k = 0; k < left; i = Next[i], k++)
            {
                if (slenderness[i] < least && IsEar(i))
                    (best, least) = (i, slenderness[i]);
            }
            return best;
        }

        /// <summary>An ear stays one while its two neighbours stay: points only go.</summary>
        private readonly bool IsEar(int i)
        {
            if (isKnownEar[i])
                return true;
            int before = Previous[i], after = Next[i];
            Vector2D a = Points[before], b = Points[i], c = Points[after];
            for (int other = Next[after]; other != before; other = Next[other])
            {
                Vector2D p = Points[other];
                if (Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0)
                    return false;
            }
            isKnownEar[i] = true;
            return true;
        }

        /// <summary>The cotangent of the smallest angle, which is opposite the shortest side; infinite where the corner does not turn left.</summary>
        private readonly void Measure(int i)
        {
            Vector2D a = Points[Previous[i]], b = Points[i], c = Points[Next[i]];
            isKnownEar[i] = false;
            double turn = Turn(a, b, c);
            if (!(turn > 0))
            {
                slenderness[i] = double.PositiveInfinity;
                return;
            }
            double atA = Vector2D.Dot(b - a, c - a), atB = Vector2D.Dot(c - b, a - b), atC = Vector2D.Dot(a - c, b - c);
            slenderness[i] = Math.Max(atA, Math.Max(atB, atC)) / turn;
        }

        private static double Turn(Vector2D a, Vector2D b, Vector2D c) => Vector2D.Cross(b - a, c - a);
    }
}
