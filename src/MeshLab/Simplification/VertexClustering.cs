using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Spatial;
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

    /// <summary>Takes one line of JSON per cell, in <c>CollapseCells</c> per contraction with the edge's length as cost; <see langword="null"/> for no trace.</summary>
    public TextWriter? Trace { get; init; }
}

/// <summary>What clustering made.</summary>
/// <param name="Mesh">The new mesh.</param>
/// <param name="Cells">Cells with vertices.</param>
/// <param name="CollapsedFaces">Faces that fell into a point or a line.</param>
/// <param name="DuplicateFaces">Faces on the same three cells as an earlier one.</param>
/// <param name="Report">What the builder did with faces that are no manifold together.</param>
/// <param name="StopReason">Why it ended: always because every cell has one vertex.</param>
/// <param name="MaxError">The longest way from a vertex to what stands for its cell, in model units.</param>
public sealed record ClusteringResult(
    Mesh Mesh, int Cells, int CollapsedFaces, int DuplicateFaces, BuildReport Report, StopReason StopReason, double MaxError);

/// <summary>§7.1 顶点聚类 (vertex clustering): all vertices in one cell of a grid become one.</summary>
/// <remarks>
/// Rossignac and Borrel 1993. The grid begins at the lowest corner of the bounding box; only cells with vertices are kept, so memory is O(n)
/// whatever the size of the cells. Topology may change: the faces go through the builder's policy. The book's program instead contracts legal edges within a
/// cell: <c>CollapseCells</c>, which keeps the topology. The first form carries traits by place. O(n), with traits O(n log n).
/// </remarks>
public static class VertexClustering
{
    /// <summary>Smaller meshes are not worth a second thread.</summary>
    private const int FacesForTwoParts = 20_000;

    extension(Mesh mesh)
    {
        /// <summary>A new mesh with one vertex per cell.</summary>
        /// <exception cref="ArgumentException">Neither size nor number of cells is set, or the cells are too small to be numbered.</exception>
        /// <exception cref="TopologyException">The policy is to throw, and the faces are no manifold.</exception>
        public ClusteringResult ClusterVertices(
            ClusteringOptions options, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            SimplificationInput.CheckTriangles(mesh);
            bool optimum = options.Representative == CellRepresentative.QuadricOptimum;

            // 1. The cells.
            var grid = CellGrid.For(mesh, options);
            int[] cellOf = grid.NumberCells(mesh, out int cells);
            Vector3D[] positions = Means(mesh, cellOf, cells);
            Report(0.3);

            // 2. What the faces become, and their planes, in a few runs at once.
            Part[] parts = new Part[mesh.FaceSlots < FacesForTwoParts ? 1 : 2];
            int run = (mesh.FaceSlots + parts.Length - 1) / parts.Length;
            Parallelism.ForBlocks(parts.Length, 1, (i, _) =>
            {
                int first = i * run, end = Math.Min(first + run, mesh.FaceSlots);
                parts[i] = new Part(end - first, cells, optimum);
                parts[i].Add(mesh, cellOf, grid.Origin, first, end);
            });
            if (optimum)
                MoveToOptimum(grid, parts, positions);
            WriteCells(TraceLog.For(options.Trace), cellOf, positions);
            Report(0.6);

            // 3. A mesh of the faces that are left.
            int[] corners = DistinctFaces(parts, cells, out int duplicates);
            var soup = new PolygonSoup(positions, PolygonSoup.TriangleStarts(corners.Length, nameof(mesh)), corners);
            Mesh result = MeshBuilder.FromSoup(soup, options.NonManifold, out BuildReport report);
            result.TakeTraitsFrom(mesh, cancellationToken);
            progress?.Report(1);
            return new(result, cells, parts.Sum(part => part.CollapsedFaces), duplicates, report, StopReason.CellsDone, LongestWay(mesh, cellOf, positions));

            void Report(double done)
            {
                cancellationToken.ThrowIfCancellationRequested();
                progress?.Report(done);
            }
        }

        /// <summary>The book's form: contracts edges within a cell, as long as that is legal, to the mean of their vertices. Changes the mesh and keeps its topology.</summary>
        /// <returns>What was done; <see cref="StopReason.CellsDone"/>, or <see cref="StopReason.NothingCollapsible"/> if edges within a cell are left that cannot be contracted.</returns>
        /// <exception cref="ArgumentException">Neither size nor number of cells is set, or the cells are too small to be numbered.</exception>
        /// <exception cref="OperationCanceledException">Cancelled; the mesh is valid, simplified so far.</exception>
        public SimplificationResult CollapseCells(
            ClusteringOptions options, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            SimplificationInput.CheckTriangles(mesh);
            int[] cellOf = CellGrid.For(mesh, options).NumberCells(mesh, out _);
            int before = mesh.Faces.Count, collapses = 0, refused, done;
            double longest = 0;
            TraceLog? trace = TraceLog.For(options.Trace);
            var members = new int[mesh.VertexSlots];
            Array.Fill(members, 1);
            do
            {
                (refused, done) = (0, 0);
                for (int e = 0; e < mesh.EdgeSlots; e++)
                {
                    cancellationToken.ThrowIfCancellationRequested();
                    if (e % 4096 == 0)
                        progress?.Report((double)e / mesh.EdgeSlots);
                    if (mesh.IsDeletedEdge(e))
                        continue;
                    HalfEdge h = new Edge(mesh, e).HalfEdge0;
                    int u = h.Source.Index, v = h.Target.Index;
                    if (cellOf[u] != cellOf[v])
                        continue;
                    Vector3D mean = Vector3D.Lerp(h.Source.Position, h.Target.Position, (double)members[v] / (members[u] + members[v]));
                    double length = Vector3D.Distance(h.Source.Position, h.Target.Position);
                    if (!h.TryCollapse(mean, out _))
                    {
                        refused++;
                        continue;
                    }
                    trace?.Write(e, v, u, length, mean);
                    members[v] += members[u];
                    longest = Math.Max(longest, length);
                    done++;
                }
                collapses += done;
            }
            while (done > 0 && refused > 0);
            if (mesh.Listener is null)
                mesh.Compact();
            progress?.Report(1);
            return new(refused > 0 ? StopReason.NothingCollapsible : StopReason.CellsDone, before, mesh.Faces.Count, collapses, longest, new(refused, 0, 0, 0));
        }
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

    private static double LongestWay(Mesh mesh, int[] cellOf, Vector3D[] positions)
    {
        ReadOnlySpan<Vector3D> old = mesh.Positions;
        double longest = 0;
        for (int v = 0; v < cellOf.Length; v++)
        {
            if (cellOf[v] >= 0)
                longest = Math.Max(longest, Vector3D.DistanceSquared(old[v], positions[cellOf[v]]));
        }
        return Math.Sqrt(longest);
    }

    private static void WriteCells(TraceLog? trace, int[] cellOf, Vector3D[] positions)
    {
        if (trace is null)
            return;
        var counts = new int[positions.Length];
        foreach (int cell in cellOf)
        {
            if (cell >= 0)
                counts[cell]++;
        }
        for (int c = 0; c < positions.Length; c++)
            trace.WriteCell(c, counts[c], positions[c]);
    }

    private static void MoveToOptimum(CellGrid grid, Part[] parts, Vector3D[] positions)
    {
        for (int c = 0; c < positions.Length; c++)
        {
            Quadric sum = parts[0].Quadrics[c];
            for (int i = 1; i < parts.Length; i++)
                sum.Add(in parts[i].Quadrics[c]);
            if (sum.TryMinimize(out Vector3D best, out _) && grid.AreTogether(best + grid.Origin, positions[c]))
                positions[c] = best + grid.Origin;
        }
    }

    /// <summary>The faces that three different cells are left of, in the order of the parts, without repetitions.</summary>
    private static int[] DistinctFaces(Part[] parts, int cells, out int duplicates)
    {
        int most = parts.Sum(part => part.CornerCount);
        int[] corners = GC.AllocateUninitializedArray<int>(most);
        // Per cell a list of the faces of which it is the lowest: its first face plus one, and per face the next.
        var first = new int[cells];
        int[] following = GC.AllocateUninitializedArray<int>(most / 3);
        int faces = 0;
        foreach (Part part in parts)
        {
            for (int i = 0; i < part.CornerCount; i += 3)
            {
                int a = part.Corners[i], b = part.Corners[i + 1], c = part.Corners[i + 2], least = Math.Min(a, Math.Min(b, c));
                int entry = first[least];
                while (entry != 0 && !HasCorners(corners.AsSpan(3 * (entry - 1), 3), a, b, c))
                    entry = following[entry - 1];
                if (entry != 0)
                    continue;
                (corners[3 * faces], corners[3 * faces + 1], corners[3 * faces + 2]) = (a, b, c);
                following[faces] = first[least];
                first[least] = ++faces;
            }
        }
        duplicates = most / 3 - faces;
        return corners[..(3 * faces)];
    }

    private static bool HasCorners(ReadOnlySpan<int> face, int a, int b, int c) =>
        face.Contains(a) && face.Contains(b) && face.Contains(c);

    /// <summary>What a run of the faces contributes: runs depend on the mesh alone, so that sums have the same bits on every number of threads.</summary>
    private sealed class Part(int faces, int cells, bool withQuadrics)
    {
        /// <summary>Per cell the quadric of the run's faces at it; none if nobody asks.</summary>
        public Quadric[] Quadrics { get; } = withQuadrics ? new Quadric[cells] : [];

        /// <summary>Three cells per face with three different ones.</summary>
        public int[] Corners { get; } = GC.AllocateUninitializedArray<int>(3 * faces);

        public int CornerCount { get; private set; }

        public int CollapsedFaces { get; private set; }

        public void Add(Mesh mesh, int[] cellOf, Vector3D origin, int firstFace, int endFace)
        {
            ReadOnlySpan<int> halfEdgeOf = mesh.HalfEdgeOf, target = mesh.Target, next = mesh.Next, previous = mesh.Previous;
            ReadOnlySpan<Vector3D> positions = mesh.Positions;
            for (int f = firstFace; f < endFace; f++)
            {
                int h = halfEdgeOf[f];
                if (h < 0)
                    continue;
                int i = target[previous[h]], j = target[h], k = target[next[h]];
                int a = cellOf[i], b = cellOf[j], c = cellOf[k];
                if (Quadrics.Length > 0)
                    AddPlane(positions[i] - origin, positions[j] - origin, positions[k] - origin, a, b, c);
                if (a == b || b == c || c == a)
                {
                    CollapsedFaces++;
                    continue;
                }
                (Corners[CornerCount], Corners[CornerCount + 1], Corners[CornerCount + 2]) = (a, b, c);
                CornerCount += 3;
            }
        }

        private void AddPlane(Vector3D p, Vector3D q, Vector3D r, int a, int b, int c)
        {
            Vector3D normal = Vector3D.Cross(q - p, r - p);
            double length = normal.Length;
            if (!(length > 0))
                return;
            // The plane's distance squared, weighted by area: with n not of unit length, n·x + d is |n| times the distance.
            Quadric plane = Quadric.OfPlane(normal, -Vector3D.Dot(normal, p), 0.5 / length);
            Quadrics[a].Add(in plane);
            if (b != a)
                Quadrics[b].Add(in plane);
            if (c != a && c != b)
                Quadrics[c].Add(in plane);
        }
    }
}
