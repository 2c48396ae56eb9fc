using System.Globalization;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>What stands for the vertices of a cell.</summary>
public enum CellRepresentative
{
    /// <summary>Their mean, as in the book.</summary>
    Mean,

    /// <summary>Where the summed quadric of the faces at them is smallest (Lindstrom 2000); the mean if that is singular or lies beside the cell.</summary>
    QuadricOptimum,
}

/// <summary>Options of <see cref="VertexClustering"/>. Set the cells' size or their number.</summary>
public sealed record ClusteringOptions
{
    /// <summary>The side of a cell, in model units.</summary>
    public double? CellSize
    {
        get;
        init
        {
            if (value is double size && !(size > 0 && double.IsFinite(size)))
                throw new ArgumentOutOfRangeException(nameof(CellSize), size, "The size of a cell is positive and finite.");
            field = value;
        }
    }

    /// <summary>The number of cells along the shortest side of the bounding box that is not zero.</summary>
    public int? Cells
    {
        get;
        init
        {
            if (value is int cells)
                ArgumentOutOfRangeException.ThrowIfNegativeOrZero(cells, nameof(Cells));
            field = value;
        }
    }

    /// <summary>What stands for the vertices of a cell.</summary>
    public CellRepresentative Representative { get; init; }

    /// <summary>What happens to faces that are no manifold together.</summary>
    public NonManifoldPolicy NonManifold { get; init; } = NonManifoldPolicy.Skip;
}

/// <summary>What clustering made.</summary>
/// <param name="Mesh">The new mesh.</param>
/// <param name="Cells">Cells with vertices.</param>
/// <param name="CollapsedFaces">Faces that fell into a point or a line.</param>
/// <param name="DuplicateFaces">Faces on the same three cells as an earlier one.</param>
/// <param name="Report">What the builder did with faces that are no manifold together.</param>
public sealed record ClusteringResult(Mesh Mesh, int Cells, int CollapsedFaces, int DuplicateFaces, BuildReport Report);

/// <summary>§7.1 顶点聚类 (vertex clustering): all vertices in one cell of a grid become one.</summary>
/// <remarks>
/// Rossignac and Borrel 1993. The grid begins at the lowest corner of the bounding box; only cells with vertices are kept, in a hash table, so memory is O(n)
/// whatever the size of the cells. Topology may change: the faces go through the builder's policy. The book's program instead contracts legal edges within a
/// cell: <c>CollapseCells</c>, which keeps the topology. Traits are not carried by the first form. O(n).
/// </remarks>
public static class VertexClustering
{
    private const int BitsPerAxis = 21;

    extension(Mesh mesh)
    {
        /// <summary>A new mesh with one vertex per cell.</summary>
        /// <exception cref="ArgumentException">Neither size nor number of cells is set, or the cells are too small to be numbered.</exception>
        /// <exception cref="TopologyException">The policy is to throw, and the faces are no manifold.</exception>
        public ClusteringResult ClusterVertices(ClusteringOptions options, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            SimplificationInput.CheckTriangles(mesh);
            var grid = Grid.For(mesh, options);
            int[] cellOf = NumberCells(mesh, grid, out int cells);
            cancellationToken.ThrowIfCancellationRequested();
            Vector3D[] positions = Means(mesh, cellOf, cells);
            if (options.Representative == CellRepresentative.QuadricOptimum)
                MoveToOptimum(mesh, grid, cellOf, positions);
            cancellationToken.ThrowIfCancellationRequested();
            int[] corners = DistinctFaces(mesh, cellOf, out int collapsed, out int duplicates);
            Mesh result = MeshBuilder.FromPolygons(PolygonSoup.FromTriangles(positions, corners), options.NonManifold, out BuildReport report);
            return new(result, cells, collapsed, duplicates, report);
        }

        /// <summary>The book's form: contracts edges within a cell, as long as that is legal, to the mean of their vertices. Changes the mesh and keeps its topology.</summary>
        /// <returns>What was done; <see cref="StopReason.NothingCollapsible"/>, since it ends when no edge within a cell can be contracted.</returns>
        /// <exception cref="ArgumentException">Neither size nor number of cells is set, or the cells are too small to be numbered.</exception>
        /// <exception cref="OperationCanceledException">Cancelled; the mesh is valid, simplified so far.</exception>
        public SimplificationResult CollapseCells(
            ClusteringOptions options, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            SimplificationInput.CheckTriangles(mesh);
            int[] cellOf = NumberCells(mesh, Grid.For(mesh, options), out _);
            int before = mesh.Faces.Count, collapses = 0, refused, done;
            var members = new int[mesh.VertexSlots];
            Array.Fill(members, 1);
            do
            {
                (refused, done) = (0, 0);
                for (int e = 0; e < mesh.EdgeSlots; e++)
                {
                    cancellationToken.ThrowIfCancellationRequested();
                    if (mesh.IsDeletedEdge(e))
                        continue;
                    HalfEdge h = new Edge(mesh, e).HalfEdge0;
                    int u = h.Source.Index, v = h.Target.Index;
                    if (cellOf[u] != cellOf[v])
                        continue;
                    Vector3D mean = Vector3D.Lerp(h.Source.Position, h.Target.Position, (double)members[v] / (members[u] + members[v]));
                    if (!h.TryCollapse(mean, out _))
                    {
                        refused++;
                        continue;
                    }
                    members[v] += members[u];
                    done++;
                }
                collapses += done;
                progress?.Report(0.5);
            }
            while (done > 0 && refused > 0);
            if (mesh.Listener is null)
                mesh.Compact();
            return new(StopReason.NothingCollapsible, before, mesh.Faces.Count, collapses, 0, new(refused, 0, 0, 0));
        }
    }

    private static int[] NumberCells(Mesh mesh, Grid grid, out int count)
    {
        var table = new KeyNumbers(mesh.Vertices.Count);
        int[] cellOf = GC.AllocateUninitializedArray<int>(mesh.VertexSlots);
        ReadOnlySpan<Vector3D> positions = mesh.Positions;
        ReadOnlySpan<int> outgoing = mesh.Outgoing;
        for (int v = 0; v < cellOf.Length; v++)
            cellOf[v] = outgoing[v] >= 0 ? table.NumberOf(grid.KeyOf(positions[v])) : -1;
        count = table.Count;
        return cellOf;
    }

    private static Vector3D[] Means(Mesh mesh, int[] cellOf, int cells)
    {
        var sums = new Vector3D[cells];
        var counts = new int[cells];
        ReadOnlySpan<Vector3D> positions = mesh.Positions;
        for (int v = 0; v < cellOf.Length; v++)
        {
            if (cellOf[v] < 0)
                continue;
            sums[cellOf[v]] += positions[v];
            counts[cellOf[v]]++;
        }
        for (int c = 0; c < cells; c++)
            sums[c] /= counts[c];
        return sums;
    }

    private static void MoveToOptimum(Mesh mesh, Grid grid, int[] cellOf, Vector3D[] positions)
    {
        var quadrics = new Quadric[positions.Length];
        ReadOnlySpan<int> halfEdgeOf = mesh.HalfEdgeOf, target = mesh.Target, next = mesh.Next, previous = mesh.Previous;
        ReadOnlySpan<Vector3D> from = mesh.Positions;
        for (int f = 0; f < halfEdgeOf.Length; f++)
        {
            int h = halfEdgeOf[f];
            if (h < 0)
                continue;
            int i = target[h], j = target[next[h]], k = target[previous[h]];
            Vector3D a = from[i] - grid.Origin, normal = Vector3D.Cross(from[j] - from[i], from[k] - from[i]);
            double length = normal.Length;
            if (!(length > 0))
                continue;
            normal /= length;
            Quadric plane = Quadric.OfPlane(normal, -Vector3D.Dot(normal, a), length / 2);
            quadrics[cellOf[i]].Add(in plane);
            if (cellOf[j] != cellOf[i])
                quadrics[cellOf[j]].Add(in plane);
            if (cellOf[k] != cellOf[i] && cellOf[k] != cellOf[j])
                quadrics[cellOf[k]].Add(in plane);
        }
        for (int c = 0; c < positions.Length; c++)
        {
            if (quadrics[c].TryMinimize(out Vector3D best, out _) && grid.KeyOf(best + grid.Origin) == grid.KeyOf(positions[c]))
                positions[c] = best + grid.Origin;
        }
    }

    private static int[] DistinctFaces(Mesh mesh, int[] cellOf, out int collapsed, out int duplicates)
    {
        var corners = new List<int>();
        ReadOnlySpan<int> halfEdgeOf = mesh.HalfEdgeOf, target = mesh.Target, next = mesh.Next, previous = mesh.Previous;
        (collapsed, duplicates) = (0, 0);
        var seen = new HashSet<(int, int, int)>();
        for (int f = 0; f < halfEdgeOf.Length; f++)
        {
            int h = halfEdgeOf[f];
            if (h < 0)
                continue;
            int a = cellOf[target[previous[h]]], b = cellOf[target[h]], c = cellOf[target[next[h]]];
            if (a == b || b == c || c == a)
            {
                collapsed++;
                continue;
            }
            int least = Math.Min(a, Math.Min(b, c)), most = Math.Max(a, Math.Max(b, c));
            if (!seen.Add((least, a + b + c - least - most, most)))
            {
                duplicates++;
                continue;
            }
            corners.AddRange([a, b, c]);
        }
        return [.. corners];
    }

    private readonly struct Grid
    {
        private readonly Vector3D end;
        private readonly double size;

        private Grid(BoundingBox box, double size)
        {
            Origin = box.Min;
            end = box.Max;
            this.size = size;
        }

        public Vector3D Origin { get; }

        public static Grid For(Mesh mesh, ClusteringOptions options)
        {
            BoundingBox box = mesh.BoundingBox;
            double size = options.CellSize ?? options.Cells switch
            {
                int cells => ShortestSide(box) / cells,
                null => throw new ArgumentException("Set the size of the cells or their number.", nameof(options)),
            };
            // The numbers of cells, before anything is allocated.
            double x = Along(box.Size.X, size), y = Along(box.Size.Y, size), z = Along(box.Size.Z, size);
            if (!(Math.Max(x, Math.Max(y, z)) < 1 << BitsPerAxis))
            {
                throw new ArgumentException(
                    string.Create(CultureInfo.InvariantCulture, $"Cells of size {size:G6} would number {x:G6} × {y:G6} × {z:G6}; at most {1 << BitsPerAxis} along a side can be told apart."),
                    nameof(options));
            }
            return new(box, size);
        }

        public long KeyOf(Vector3D p) =>
            Cell(p.X, Origin.X, end.X) | Cell(p.Y, Origin.Y, end.Y) << BitsPerAxis | Cell(p.Z, Origin.Z, end.Z) << (2 * BitsPerAxis);

        /// <summary>The number along an axis. The upper side of the box belongs to the last cell, not to an empty one beyond; what lies outside belongs to none.</summary>
        private long Cell(double x, double first, double last)
        {
            double slack = 1e-9 * size;
            if (x > last - slack && x <= last + slack)
                x = Math.Max(first, last - slack);
            return (long)Math.Floor((x - first) / size) & ((1L << BitsPerAxis) - 1);
        }

        private static double Along(double side, double size) => side == 0 ? 1 : Math.Ceiling(side / size);

        private static double ShortestSide(BoundingBox box)
        {
            double shortest = double.PositiveInfinity;
            foreach (double side in (ReadOnlySpan<double>)[box.Size.X, box.Size.Y, box.Size.Z])
                shortest = side > 0 ? Math.Min(shortest, side) : shortest;
            return double.IsFinite(shortest) ? shortest : 1;
        }
    }

    /// <summary>Numbers keys by first appearance: open addressing, at most half full.</summary>
    private sealed class KeyNumbers
    {
        private readonly long[] keys;
        private readonly int[] numbers;
        private readonly int shift;

        public KeyNumbers(int most)
        {
            int bits = Math.Max(4, 33 - int.LeadingZeroCount(Math.Max(1, most)));
            keys = new long[1 << bits];
            numbers = new int[1 << bits];
            Array.Fill(numbers, -1);
            shift = 64 - bits;
        }

        public int Count { get; private set; }

        public int NumberOf(long key)
        {
            int at = (int)((ulong)key * 0x9E3779B97F4A7C15 >> shift);
            while (numbers[at] >= 0)
            {
                if (keys[at] == key)
                    return numbers[at];
                at = (at + 1) & (keys.Length - 1);
            }
            keys[at] = key;
            return numbers[at] = Count++;
        }
    }
}
