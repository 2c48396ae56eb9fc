using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>An order of elimination with little fill-in, by nested dissection (嵌套剖分).</summary>
/// <remarks>
/// <para>
/// A few rows are taken as separator so that the rest falls into two parts with no entry between them. Eliminating the parts first and the
/// separator last keeps the factor empty between the parts; each part is ordered in the same way. On a surface of n vertices separators have
/// O(√n) rows, so the factor has O(n log n) entries and costs O(n^1.5). George 1973, SIAM J. Numer. Anal. 10(2); Lipton, Rose, Tarjan 1979.
/// </para>
/// <para>
/// Where to cut is read off positions: across the direction in which the part is longest. Large parts try 127 parallel planes and take the one
/// that cuts fewest rows; small ones are halved. The rows of one side that touch the other are the separator, thinned by a few greedy passes.
/// </para>
/// </remarks>
public static class NestedDissection
{
    /// <summary>The rows in the order of elimination: entry k is the row eliminated k-th.</summary>
    /// <param name="matrix">The matrix; only the places of its entries matter.</param>
    /// <param name="positions">A point per row. Rows joined by an entry should lie near each other. Empty: distances in the graph serve instead.</param>
    /// <exception cref="ArgumentException">The number of positions is neither 0 nor the number of rows.</exception>
    public static int[] Order(SparseMatrix matrix, ReadOnlySpan<Vector3D> positions = default)
    {
        ArgumentNullException.ThrowIfNull(matrix);
        if (positions.Length != 0 && positions.Length != matrix.Size)
            throw new ArgumentException($"{positions.Length} positions for {matrix.Size} rows.", nameof(positions));
        Vector3D[] points = positions.IsEmpty ? LandmarkCoordinates.Of(matrix) : positions.ToArray();
        var dissection = new Dissection(matrix.RowStartArray, matrix.ColumnArray, points);
        dissection.Dissect(0, matrix.Size);
        return dissection.Order;
    }

    private sealed class Dissection
    {
        private const int LeafSize = 16;
        private const int ScanSize = 1000;
        private const int ParallelSize = 8192;
        private const int RefinementPasses = 4;
        private const int Bins = 128;
        private const byte Left = 0, Right = 1, Separator = 2;

        private readonly int[] rowStart, columns;
        private readonly Vector3D[] position;

        // Per row: the part it belongs to now, its side of the cut, its height along the cut's direction.
        private readonly int[] part;
        private readonly byte[] side;
        private readonly double[] height;

        // A part is the range [from, to) of order; the same range of buffer is its scratch space.
        private readonly int[] order, buffer;
        private int lastPart;

        // Per row its number in the copy of its half of the part; used when the part is large.
        private readonly int[] place;

        public Dissection(int[] rowStart, int[] columns, Vector3D[] position)
        {
            this.rowStart = rowStart;
            this.columns = columns;
            this.position = position;
            int n = position.Length;
            place = n >= ParallelSize ? GC.AllocateUninitializedArray<int>(n) : [];
            part = new int[n];
            side = new byte[n];
            height = new double[n];
            buffer = new int[n];
            order = new int[n];
            for (int i = 0; i < n; i++)
                order[i] = i;
        }

        public int[] Order => order;

        public void Dissect(int from, int to)
        {
            if (to - from <= LeafSize)
                return;

            Vector3D direction = LongestDirection(from, to);
            int id = ++lastPart;
            foreach (int v in order.AsSpan(from, to - from))
                part[v] = id;
            if (to - from <= ScanSize || !CutAcrossThinnestPlace(from, to, id, direction))
                Halve(from, to, direction);

            int separator = TakeSmallerBorder(from, to, id);
            Thin(from, separator, id);
            (int left, int right) = Group(from, to);
            if (left == to - from || right == to - from || left + right == 0)
                return;

            int middle = from + left, end = middle + right;
            if (to - from >= ParallelSize)
            {
                Parallelism.Invoke(() => DissectApart(from, middle), () => DissectApart(middle, end));
            }
            else
            {
                Dissect(from, middle);
                Dissect(middle, end);
            }
        }

        // The same on a copy of the part's graph: threads that wrote to arrays in common would take each other's cache lines away, and
        // its rows lie closer together there.
        private void DissectApart(int from, int to)
        {
            int[] rows = order.AsSpan(from, to - from).ToArray();
            int entries = 0;
            for (int i = 0; i < rows.Length; i++)
            {
                place[rows[i]] = i;
                entries += rowStart[rows[i] + 1] - rowStart[rows[i]];
            }

            var start = new int[rows.Length + 1];
            var column = GC.AllocateUninitializedArray<int>(entries);
            var point = GC.AllocateUninitializedArray<Vector3D>(rows.Length);
            int at = 0, id = part[rows[0]];
            byte half = side[rows[0]];
            for (int i = 0; i < rows.Length; i++)
            {
                point[i] = position[rows[i]];
                foreach (int u in columns.AsSpan(rowStart[rows[i]], rowStart[rows[i] + 1] - rowStart[rows[i]]))
                {
                    if (part[u] == id && side[u] == half)
                        column[at++] = place[u];
                }
                start[i + 1] = at;
            }

            var apart = new Dissection(start, column, point);
            apart.Dissect(0, rows.Length);
            for (int i = 0; i < rows.Length; i++)
                order[from + i] = rows[apart.order[i]];
        }

        // The principal axis of the positions, by a few steps of the power method; exactness does not matter.
        private Vector3D LongestDirection(int from, int to)
        {
            int step = Math.Max(1, (to - from) / 2000);
            Vector3D mean = default;
            int samples = 0;
            for (int i = from; i < to; i += step, samples++)
                mean += position[order[i]];
            mean /= samples;

            double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
            for (int i = from; i < to; i += step)
            {
                Vector3D p = position[order[i]] - mean;
                xx += p.X * p.X;
                xy += p.X * p.Y;
                xz += p.X * p.Z;
                yy += p.Y * p.Y;
                yz += p.Y * p.Z;
                zz += p.Z * p.Z;
            }

            var axis = new Vector3D(xx >= yy && xx >= zz ? 1 : 0.3, yy > xx && yy >= zz ? 1 : 0.31, zz > xx && zz > yy ? 1 : 0.29);
            for (int iteration = 0; iteration < 6; iteration++)
            {
                var next = new Vector3D(
                    xx * axis.X + xy * axis.Y + xz * axis.Z,
                    xy * axis.X + yy * axis.Y + yz * axis.Z,
                    xz * axis.X + yz * axis.Y + zz * axis.Z).Normalized();
                if (next == default)
                    break;
                axis = next;
            }
            return axis;
        }

        // Tries planes between 30 % and 70 % of the rows and keeps the one that the fewest rows' entries cross.
        private bool CutAcrossThinnestPlace(int from, int to, int id, Vector3D direction)
        {
            double low = double.PositiveInfinity, high = double.NegativeInfinity;
            foreach (int v in order.AsSpan(from, to - from))
            {
                double h = Vector3D.Dot(position[v], direction);
                height[v] = h;
                low = Math.Min(low, h);
                high = Math.Max(high, h);
            }
            if (!(high > low) || !double.IsFinite(high - low))
                return false;

            // crossing[t]: by how much the number of crossed rows changes from plane t − 1 to plane t.
            Span<int> below = stackalloc int[Bins + 2], crossing = stackalloc int[Bins + 2];
            below.Clear();
            crossing.Clear();
            double scale = (Bins - 0.001) / (high - low);
            ReadOnlySpan<int> start = rowStart, neighbors = columns, parts = part;
            ReadOnlySpan<double> heights = height;
            foreach (int v in order.AsSpan(from, to - from))
            {
                double h = heights[v], highest = h;
                foreach (int u in neighbors[start[v]..start[v + 1]])
                {
                    if (parts[u] == id && heights[u] > highest)
                        highest = heights[u];
                }
                int bin = (int)((h - low) * scale), last = (int)((highest - low) * scale);
                below[bin + 1]++;
                crossing[bin + 1]++;
                crossing[last + 1]--;
            }

            double least = double.PositiveInfinity, plane = 0;
            int rows = 0, crossed = 0;
            for (int t = 1; t < Bins; t++)
            {
                rows += below[t];
                crossed += crossing[t];
                double fraction = (double)rows / (to - from);
                if (fraction is < 0.3 or > 0.7)
                    continue;
                double cost = (crossed + 1) * (1 + 2 * (fraction - 0.5) * (fraction - 0.5));
                if (cost >= least)
                    continue;
                least = cost;
                plane = low + t / scale;
            }
            if (double.IsPositiveInfinity(least))
                return false;

            foreach (int v in order.AsSpan(from, to - from))
                side[v] = height[v] < plane ? Left : Right;
            return true;
        }

        private void Halve(int from, int to, Vector3D direction)
        {
            foreach (int v in order.AsSpan(from, to - from))
                height[v] = Vector3D.Dot(position[v], direction);
            int middle = from + (to - from) / 2;
            SelectByHeight(from, to - 1, middle);
            for (int i = from; i < to; i++)
                side[order[i]] = i < middle ? Left : Right;
        }

        // Hoare's quickselect: afterwards order[from..k) is nowhere higher than order[k..].
        private void SelectByHeight(int low, int high, int k)
        {
            Span<int> rows = order;
            ReadOnlySpan<double> heights = height;
            while (high > low)
            {
                double a = heights[rows[low]], b = heights[rows[(low + high) >> 1]], c = heights[rows[high]];
                double pivot = Math.Max(Math.Min(a, b), Math.Min(Math.Max(a, b), c));
                int i = low - 1, j = high + 1;
                while (true)
                {
                    do
                        i++;
                    while (heights[rows[i]] < pivot);
                    do
                        j--;
                    while (heights[rows[j]] > pivot);
                    if (i >= j)
                        break;
                    (rows[i], rows[j]) = (rows[j], rows[i]);
                }
                if (k <= j)
                    high = j;
                else
                    low = j + 1;
            }
        }

        // The rows that touch the other side, of the side that has fewer of them, become the separator: buffer[from ..].
        private int TakeSmallerBorder(int from, int to, int id)
        {
            int left = from, right = to;
            ReadOnlySpan<int> start = rowStart, neighbors = columns, parts = part;
            ReadOnlySpan<byte> sides = side;
            foreach (int v in order.AsSpan(from, to - from))
            {
                int across = sides[v] ^ 1;
                foreach (int u in neighbors[start[v]..start[v + 1]])
                {
                    if (sides[u] != across || parts[u] != id)
                        continue;
                    if (across == Right)
                        buffer[left++] = v;
                    else
                        buffer[--right] = v;
                    break;
                }
            }

            if (left - from > to - right)
            {
                left = from;
                for (int i = to - 1; i >= right; i--)
                    buffer[left++] = buffer[i];
            }
            foreach (int v in buffer.AsSpan(from, left - from))
                side[v] = Separator;
            return left - from;
        }

        // A row of the separator with no neighbour on one side moves to the other side; one with a single neighbour there changes places
        // with it. The passes favour the sides in turn.
        private void Thin(int from, int count, int id)
        {
            ReadOnlySpan<int> start = rowStart, neighbors = columns, parts = part;
            for (int pass = 0; pass < RefinementPasses; pass++)
            {
                bool changed = false;
                for (int i = from; i < from + count; i++)
                {
                    int v = buffer[i];
                    int lefts = 0, rights = 0, lastRight = -1, lastLeft = -1;
                    foreach (int u in neighbors[start[v]..start[v + 1]])
                    {
                        if (parts[u] != id)
                            continue;
                        if (side[u] == Left)
                        {
                            lefts++;
                            lastLeft = u;
                        }
                        else if (side[u] == Right)
                        {
                            rights++;
                            lastRight = u;
                        }
                    }

                    if (lefts == 0)
                        side[v] = Right;
                    else if (rights == 0)
                        side[v] = Left;
                    else if (rights == 1 && (pass & 1) == 0)
                        (side[v], side[lastRight], buffer[i]) = (Left, Separator, lastRight);
                    else if (lefts == 1 && (pass & 1) == 1)
                        (side[v], side[lastLeft], buffer[i]) = (Right, Separator, lastLeft);
                    else
                        continue;
                    changed = true;
                }
                if (!changed)
                    return;

                int kept = 0;
                for (int i = from; i < from + count; i++)
                {
                    if (side[buffer[i]] == Separator)
                        buffer[from + kept++] = buffer[i];
                }
                count = kept;
            }
        }

        // Puts the left part first, then the right part, then the separator, each in the order it had.
        private (int Left, int Right) Group(int from, int to)
        {
            ReadOnlySpan<byte> sides = side;
            Span<int> grouped = buffer, counts = stackalloc int[3], next = stackalloc int[3];
            counts.Clear();
            foreach (int v in order.AsSpan(from, to - from))
                counts[sides[v]]++;
            (int left, int right) = (counts[Left], counts[Right]);
            (next[Left], next[Right], next[Separator]) = (from, from + left, from + left + right);
            foreach (int v in order.AsSpan(from, to - from))
                grouped[next[sides[v]]++] = v;
            buffer.AsSpan(from, to - from).CopyTo(order.AsSpan(from, to - from));
            return (left, right);
        }
    }
}
