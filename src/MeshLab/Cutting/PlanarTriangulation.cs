using MeshLab.Numerics;

namespace MeshLab.Cutting;

/// <summary>Triangulates outlines with holes in the plane over their own vertices: every rim edge is an edge of one triangle.</summary>
/// <remarks>
/// Every hole is joined to its outline by a bridge (Eberly 1998, 2008: the visible vertex to the right of the hole's rightmost one), then ears are clipped (Meisters 1975), each test with exact
/// signs. Only reflex corners can lie in an ear; they are kept in a grid. About O(n √n) in practice, O(n²) at worst. Loops may touch each other in vertices: there two triangles without area join
/// them. Outlines that cross
/// themselves have no triangulation: then ears are forced, so that the result folds over, but its signed area and its rim are still those of the input.
/// </remarks>
internal sealed class PlanarTriangulation
{
    private readonly Vector2D[] points;

    private PlanarTriangulation(Vector2D[] points) => this.points = points;

    /// <summary>Triangulates.</summary>
    /// <param name="points">The vertices.</param>
    /// <param name="loops">Outlines counter-clockwise, holes clockwise, three vertices or more each, with the insides to the left.</param>
    /// <param name="corners">Gets three vertices per triangle, counter-clockwise.</param>
    /// <returns>Whether all ears were real; false if some had to be forced.</returns>
    public static bool Triangulate(Vector2D[] points, IReadOnlyList<int[]> loops, List<int> corners)
    {
        var job = new PlanarTriangulation(points);
        bool sound = true;
        foreach (List<int[]> group in job.Group(loops))
        {
            List<int> polygon = [.. group[0]];
            // Rightmost holes first: a bridge may end at a hole that is joined already.
            foreach (int[] hole in group.Skip(1).OrderByDescending(h => h.Max(v => points[v].X)))
                sound &= job.Bridge(polygon, hole);
            sound &= job.ClipEars(polygon, corners);
        }
        return sound;
    }

    /// <summary>Every outline with the holes of which it is the smallest outline around; holes in no outline stand alone.</summary>
    private List<List<int[]>> Group(IReadOnlyList<int[]> loops)
    {
        Vector2D[][] flat = [.. loops.Select(loop => loop.Select(v => points[v]).ToArray())];
        double[] area = Array.ConvertAll(flat, polygon => PlanarPolygons.DoubleArea(polygon));
        var groups = new List<int[]>[loops.Count];
        for (int i = 0; i < loops.Count; i++)
        {
            if (area[i] >= 0)
                groups[i] = [loops[i]];
        }
        for (int i = 0; i < loops.Count; i++)
        {
            if (area[i] >= 0)
                continue;
            int around = -1;
            for (int j = 0; j < loops.Count; j++)
            {
                if (area[j] > -area[i] && (around < 0 || area[j] < area[around]) && PlanarPolygons.Holds(flat[j], flat[i]))
                    around = j;
            }
            if (around >= 0)
                groups[around].Add(loops[i]);
            else
                groups[i] = [loops[i]];
        }
        return [.. groups.Where(group => group is not null)];
    }

    /// <summary>Joins a hole to the polygon by an edge there and back.</summary>
    private bool Bridge(List<int> polygon, int[] hole)
    {
        int rightmost = 0;
        for (int i = 1; i < hole.Length; i++)
        {
            if (points[hole[i]].X > points[hole[rightmost]].X)
                rightmost = i;
        }
        int at = VisibleFrom(polygon, points[hole[rightmost]], points[hole[(rightmost + 1) % hole.Length]]);
        bool found = at >= 0;
        if (!found)
            at = Nearest(polygon, points[hole[rightmost]]);
        var detour = new List<int>(hole.Length + 2);
        for (int i = 0; i <= hole.Length; i++)
            detour.Add(hole[(rightmost + i) % hole.Length]);
        detour.Add(polygon[at]);
        polygon.InsertRange(at + 1, detour);
        return found;
    }

    /// <summary>The place in the polygon of a vertex that a point inside sees, to its right; −1 if the ray meets no edge.</summary>
    private int VisibleFrom(List<int> polygon, Vector2D m, Vector2D afterM)
    {
        int edge = -1;
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < polygon.Count; i++)
        {
            Vector2D a = points[polygon[i]], b = points[polygon[(i + 1) % polygon.Count]];
            // The inside is to the left of edges that go up, where the ray leaves it.
            if (!(a.Y <= m.Y && b.Y >= m.Y) || a.Y == b.Y)
                continue;
            double x = a.X + (m.Y - a.Y) / (b.Y - a.Y) * (b.X - a.X);
            if (x >= m.X && x < nearest)
            {
                nearest = x;
                edge = i;
            }
        }
        if (edge < 0)
            return -1;

        int next = (edge + 1) % polygon.Count;
        int candidate = points[polygon[edge]].X > points[polygon[next]].X ? edge : next;
        Vector2D hit = new(nearest, m.Y), p = points[polygon[candidate]];
        if (p.Y == m.Y && p.X == nearest)
            return BestCopy(polygon, candidate, p == m ? afterM : m);
        // Reflex corners in the triangle m, hit, p hide p; the one nearest in direction to the ray is seen.
        double bestSlope = double.PositiveInfinity, bestDistance = 0;
        int best = candidate;
        bool up = p.Y > m.Y;
        for (int i = 0; i < polygon.Count; i++)
        {
            Vector2D q = points[polygon[i]];
            if (q.X < m.X || q == p || q == m || !(up ? InTriangle(m, hit, p, q) : InTriangle(m, p, hit, q)))
                continue;
            double slope = Math.Abs(q.Y - m.Y) / Math.Max(q.X - m.X, double.Epsilon), distance = (q - m).Length;
            if (slope < bestSlope || (slope == bestSlope && distance < bestDistance))
                (best, bestSlope, bestDistance) = (i, slope, distance);
        }
        return BestCopy(polygon, best, m);
    }

    /// <summary>Of the places with the same point, one whose corner opens towards m: bridges have made some vertices twice.</summary>
    private int BestCopy(List<int> polygon, int place, Vector2D m)
    {
        Vector2D p = points[polygon[place]];
        for (int i = 0; i < polygon.Count; i++)
        {
            if (points[polygon[i]] == p && SeesInside(polygon, i, m))
                return i;
        }
        return place;
    }

    private bool SeesInside(List<int> polygon, int i, Vector2D m)
    {
        int n = polygon.Count;
        Vector2D before = points[polygon[(i + n - 1) % n]], at = points[polygon[i]], after = points[polygon[(i + 1) % n]];
        bool leftOfIn = ExactPredicates.Orient2D(before, at, m) > 0, leftOfOut = ExactPredicates.Orient2D(at, after, m) > 0;
        return ExactPredicates.Orient2D(before, at, after) > 0 ? leftOfIn && leftOfOut : leftOfIn || leftOfOut;
    }

    private int Nearest(List<int> polygon, Vector2D m)
    {
        int best = 0;
        for (int i = 1; i < polygon.Count; i++)
        {
            if ((points[polygon[i]] - m).Length < (points[polygon[best]] - m).Length)
                best = i;
        }
        return best;
    }

    private static bool InTriangle(Vector2D a, Vector2D b, Vector2D c, Vector2D p) =>
        ExactPredicates.Orient2D(a, b, p) >= 0 && ExactPredicates.Orient2D(b, c, p) >= 0 && ExactPredicates.Orient2D(c, a, p) >= 0;

    private bool ClipEars(List<int> polygon, List<int> corners)
    {
        var ears = new EarClipping(points, polygon);
        return ears.Run(corners);
    }

    /// <summary>Ear clipping of one polygon, which may touch itself along bridges.</summary>
    private sealed class EarClipping
    {
        private readonly Vector2D[] points;
        private readonly int[] vertex;
        private readonly int[] next;
        private readonly int[] previous;
        private readonly List<int>[] cells;
        private readonly double lowX;
        private readonly double lowY;
        private readonly double cellSize;
        private readonly int columns;
        private readonly int rows;

        public EarClipping(Vector2D[] points, List<int> polygon)
        {
            this.points = points;
            vertex = [.. polygon];
            int n = vertex.Length;
            next = new int[n];
            previous = new int[n];
            double highX = double.NegativeInfinity, highY = double.NegativeInfinity;
            lowX = lowY = double.PositiveInfinity;
            for (int i = 0; i < n; i++)
            {
                next[i] = (i + 1) % n;
                previous[i] = (i + n - 1) % n;
                Vector2D p = points[vertex[i]];
                (lowX, lowY) = (Math.Min(lowX, p.X), Math.Min(lowY, p.Y));
                (highX, highY) = (Math.Max(highX, p.X), Math.Max(highY, p.Y));
            }
            int side = Math.Max(1, (int)Math.Sqrt(n));
            cellSize = Math.Max(Math.Max(highX - lowX, highY - lowY) / side, double.Epsilon * 1e10);
            columns = Math.Clamp((int)((highX - lowX) / cellSize) + 1, 1, side + 1);
            rows = Math.Clamp((int)((highY - lowY) / cellSize) + 1, 1, side + 1);
            cells = new List<int>[columns * rows];
            for (int i = 0; i < n; i++)
            {
                if (Turn(i) <= 0)
                    (cells[Row(points[vertex[i]].Y) * columns + Column(points[vertex[i]].X)] ??= []).Add(i);
            }
        }

        public bool Run(List<int> corners)
        {
            int left = vertex.Length, at = 0, sinceEar = 0;
            bool sound = true;
            while (left > 3)
            {
                bool ear = IsEar(at);
                if (!ear && ++sinceEar <= left)
                {
                    at = next[at];
                    continue;
                }
                if (!ear)
                {
                    at = Forced(at, left);
                    // A corner without area hurts nobody; any other is a sign of an outline that crosses itself.
                    sound &= Turn(at) == 0;
                }
                sinceEar = 0;
                int a = previous[at], b = next[at];
                Emit(corners, a, at, b);
                next[a] = b;
                previous[b] = a;
                next[at] = -1;
                left--;
                // Where loops touch, what has no area goes at once: later it would hide behind its other half. Else going on behind the next corner makes rounder triangles than a fan would be.
                at = IsBare(a) ? a : IsBare(b) ? b : next[b];
            }
            Emit(corners, previous[at], at, next[at]);
            return sound && Turn(at) >= 0;
        }

        private bool IsEar(int at)
        {
            int before = previous[at], after = next[at];
            if (IsBare(at))
                return true;
            if (Turn(at) <= 0)
                return false;
            Vector2D a = points[vertex[before]], b = points[vertex[at]], c = points[vertex[after]];
            int x0 = Column(Math.Min(a.X, Math.Min(b.X, c.X))), x1 = Column(Math.Max(a.X, Math.Max(b.X, c.X)));
            int y0 = Row(Math.Min(a.Y, Math.Min(b.Y, c.Y))), y1 = Row(Math.Max(a.Y, Math.Max(b.Y, c.Y)));
            for (int y = y0; y <= y1; y++)
            {
                for (int x = x0; x <= x1; x++)
                {
                    if (cells[y * columns + x] is { } cell && Blocks(cell, before, at, after, a, b, c))
                        return false;
                }
            }
            return true;
        }

        /// <summary>Whether two vertices of a corner lie in one place, so that its triangle is an edge there and back.</summary>
        private bool IsBare(int at)
        {
            Vector2D a = points[vertex[previous[at]]], b = points[vertex[at]], c = points[vertex[next[at]]];
            return (a == b || b == c || c == a) && vertex[previous[at]] != vertex[next[at]];
        }

        private bool Blocks(List<int> cell, int before, int at, int after, Vector2D a, Vector2D b, Vector2D c)
        {
            foreach (int i in cell)
            {
                if (next[i] < 0 || i == before || i == at || i == after)
                    continue;
                Vector2D p = points[vertex[i]];
                if (p == a || p == b || p == c)
                {
                    // Loops that touch here: the other one may go on inside.
                    if (p == a ? Enters(i, a, b, c) : p == b ? Enters(i, b, c, a) : Enters(i, c, a, b))
                        return true;
                    continue;
                }
                if (!InTriangle(a, b, c, p))
                    continue;
                // A corner that clipping has made convex cannot be the first to lie in an ear.
                if (Turn(i) <= 0)
                    return true;
            }
            return false;
        }

        /// <summary>Whether an edge of a corner at the tip of a triangle leads into the triangle.</summary>
        private bool Enters(int i, Vector2D tip, Vector2D right, Vector2D left)
        {
            return Leads(points[vertex[previous[i]]]) || Leads(points[vertex[next[i]]]);

            bool Leads(Vector2D to) => ExactPredicates.Orient2D(tip, right, to) > 0 && ExactPredicates.Orient2D(tip, to, left) > 0;
        }

        /// <summary>What is cut off when no ear is left: a corner without area, else the first convex one, else any.</summary>
        private int Forced(int at, int left)
        {
            int convex = -1, any = -1;
            for (int i = at, k = 0; k < left; k++, i = next[i])
            {
                if (vertex[previous[i]] == vertex[next[i]])
                    continue;
                int turn = Turn(i);
                if (turn == 0)
                    return i;
                if (turn > 0 && convex < 0)
                    convex = i;
                if (any < 0)
                    any = i;
            }
            return convex >= 0 ? convex : any >= 0 ? any : at;
        }

        private int Turn(int i) => ExactPredicates.Orient2D(points[vertex[previous[i]]], points[vertex[i]], points[vertex[next[i]]]);

        private int Column(double x) => Math.Clamp((int)((x - lowX) / cellSize), 0, columns - 1);

        private int Row(double y) => Math.Clamp((int)((y - lowY) / cellSize), 0, rows - 1);

        private void Emit(List<int> corners, int a, int b, int c)
        {
            corners.Add(vertex[a]);
            corners.Add(vertex[b]);
            corners.Add(vertex[c]);
        }
    }
}
