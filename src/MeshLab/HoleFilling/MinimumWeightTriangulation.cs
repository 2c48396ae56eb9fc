using MeshLab.Numerics;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 (d) 最小权三角化: of all triangulations of a loop the one with the smallest weight: total bend, largest bend and then area, or area.</summary>
/// <remarks>
/// <code>
///            m               W(i, j): the best triangulation of the loop's part i … j.
///          ╱   ╲             W(i, j) = min over m of W(i, m) + W(m, j) + triangle(i, m, j), where "+" is the sum, or the maximum of
///     W(i,m)  W(m,j)         the bends and the sum of the areas. The bend is that between the new triangle and the triangle chosen under
///      ╱         ╲           (i, m) and (m, j), or the mesh's own face where that is an edge of the loop.
///     i ───────── j
/// </code>
/// Barequet, Sharir 1995; weights of Liepa 2003, §3. The total bend is Σ length · angle over all edges, twice the total absolute mean curvature: a crease costs the same when it is rounded off by many small bends; the largest bend is 1 − cos of the angle between normals, rounded to 10⁻⁷, so that on a plane the area decides and
/// not the noise. The total takes a crease once, however sharp, and prefers planes that go on and meet; the largest says nothing more where the rim has a sharp edge itself. Most m are dismissed by the bends of the two parts alone. The table is kept by rows and by columns, so that both parts are
/// read in order; the cells of a diagonal do not depend on each other and are shared out to threads. O(n³) time, O(n²) memory.
/// </remarks>
internal static class MinimumWeightTriangulation
{
    private const double BendStep = 1e-7;

    /// <summary>The triangles, three numbers each, or <see langword="null"/> if the mesh has too many of the chords already.</summary>
    public static List<int>? Triangulate(HoleLoop loop, HoleWeight weight, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var table = new Table(loop, weight);
        for (int span = 2; span < loop.Count; span++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            table.FillDiagonal(span);
            progress?.Report((double)span / loop.Count);
        }
        return table.Read();
    }

    private sealed class Table
    {
        private readonly HoleLoop loop;
        private readonly int n;
        private readonly bool bendWeighs;
        private readonly bool total;
        private readonly Vector3D[] points;

        // Bend and area of W(i, j) at i·n + j and, a second time, at j·n + i.
        private readonly double[] bend;
        private readonly double[] area;
        private readonly int[] apex;
        private readonly Vector3D[] normal;

        // Distances of the loop's vertices, both ways; for the total bend alone.
        private readonly double[] length = [];

        public Table(HoleLoop loop, HoleWeight weight)
        {
            total = weight == HoleWeight.TotalBend;
            bendWeighs = weight == HoleWeight.BendThenArea;
            this.loop = loop;
            n = loop.Count;
            points = loop.Points;
            bend = new double[n * n];
            area = new double[n * n];
            apex = new int[n * n];
            normal = new Vector3D[n * n];
            Array.Fill(apex, -1);
            if (total)
            {
                length = new double[n * n];
                for (int i = 0; i < n; i++)
                {
                    for (int j = 0; j < i; j++)
                        length[i * n + j] = length[j * n + i] = Vector3D.Distance(points[i], points[j]);
                }
            }
            for (int i = 0; i + 1 < n; i++)
                normal[i * n + i + 1] = loop.RimNormals[i];
        }

        public void FillDiagonal(int span)
        {
            int cells = n - span;
            if ((long)cells * span < 20_000)
            {
                for (int i = 0; i < cells; i++)
                    FillCell(i, i + span);
                return;
            }
            Parallelism.ForBlocks(cells, 16, (from, to) =>
            {
                for (int i = from; i < to; i++)
                    FillCell(i, i + span);
            });
        }

        private void FillCell(int i, int j)
        {
            double bestBend = double.PositiveInfinity, bestArea = double.PositiveInfinity;
            int best = -1;
            Vector3D bestNormal = default;
            bool isLast = i == 0 && j == n - 1;
            if (isLast || !loop.IsTaken(i, j))
            {
                ReadOnlySpan<double> leftBend = bend.AsSpan(i * n, n), rightBend = bend.AsSpan(j * n, n);
                ReadOnlySpan<double> leftArea = area.AsSpan(i * n, n), rightArea = area.AsSpan(j * n, n);
                ReadOnlySpan<double> leftLength = total ? length.AsSpan(i * n, n) : default, rightLength = total ? length.AsSpan(j * n, n) : default;
                Vector3D a = points[i], ab = points[j] - a;
                // The apex of the part that is one shorter is tried first: a good guess lets most others be dismissed.
                int guess = Math.Max(apex[i * n + j - 1], i + 1);
                for (int k = i; k < j; k++)
                {
                    int m = k == i ? guess : k;
                    double b = total ? leftBend[m] + rightBend[m] : Math.Max(leftBend[m], rightBend[m]);
                    if (b > bestBend || double.IsPositiveInfinity(b))
                        continue;
                    double parts = leftArea[m] + rightArea[m];
                    if (b == bestBend && parts >= bestArea)
                        continue;
                    Vector3D cross = Vector3D.Cross(points[m] - a, ab);
                    double size = cross.Length;
                    double whole = parts + size / 2;
                    Vector3D unit = size > 0 ? cross / size : default;
                    if (total)
                    {
                        double left = Chord(unit, normal[i * n + m]), right = Chord(unit, normal[m * n + j]);
                        // The chord is less than the angle, and cheaper.
                        if (b + left * leftLength[m] + right * rightLength[m] > bestBend)
                            continue;
                        b += Angle(left) * leftLength[m] + Angle(right) * rightLength[m];
                        if (b > bestBend)
                            continue;
                        if (isLast)
                            b += Angle(Chord(unit, loop.RimNormals[n - 1])) * leftLength[j];
                    }
                    else if (bendWeighs)
                    {
                        b = Math.Max(b, Bend(unit, normal[i * n + m]));
                        b = Math.Max(b, Bend(unit, normal[m * n + j]));
                        if (isLast)
                            b = Math.Max(b, Bend(unit, loop.RimNormals[n - 1]));
                    }
                    if (b < bestBend || (b == bestBend && whole < bestArea))
                        (bestBend, bestArea, best, bestNormal) = (b, whole, m, unit);
                }
            }
            int at = i * n + j, mirrored = j * n + i;
            bend[at] = bend[mirrored] = bestBend;
            area[at] = area[mirrored] = bestArea;
            apex[at] = best;
            normal[at] = bestNormal;
        }

        /// <summary>The distance of two unit normals, 2 sin of half the angle between them; 0 for what is rounding.</summary>
        private static double Chord(Vector3D a, Vector3D b)
        {
            double squared = Vector3D.DistanceSquared(a, b);
            return squared > BendStep * BendStep ? Math.Sqrt(squared) : 0;
        }

        /// <summary>The angle of a chord of the unit circle.</summary>
        private static double Angle(double chord) => 2 * Math.Asin(Math.Min(1, chord / 2));

        private static double Bend(Vector3D a, Vector3D b) => Math.Round((1 - Vector3D.Dot(a, b)) / BendStep) * BendStep;

        public List<int>? Read()
        {
            if (apex[n - 1] < 0)
                return null;
            var triangles = new List<int>(3 * (n - 2));
            var waiting = new Stack<(int I, int J)>();
            waiting.Push((0, n - 1));
            while (waiting.TryPop(out var part))
            {
                if (part.J - part.I < 2)
                    continue;
                int m = apex[part.I * n + part.J];
                triangles.AddRange([part.I, m, part.J]);
                waiting.Push((m, part.J));
                waiting.Push((part.I, m));
            }
            return triangles;
        }
    }
}
