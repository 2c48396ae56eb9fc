using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Which element goes next.</summary>
public enum DeletionMeasure
{
    /// <summary>The shortest edge (最短边), to its midpoint.</summary>
    ShortestEdge,

    /// <summary>The smallest triangle (最小三角形), to its barycentre: two contractions.</summary>
    SmallestTriangle,

    /// <summary>The vertex of the smallest absolute Gaussian curvature (最小高斯曲率顶点), into the neighbour that turns the faces around least.</summary>
    LowestCurvature,
}

/// <summary>Options of <see cref="ElementDeletion"/>.</summary>
public sealed record DeletionOptions
{
    /// <summary>Which element goes next.</summary>
    public DeletionMeasure Measure { get; init; }

    /// <summary>The number of faces to reach.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive.</exception>
    public required int TargetFaces
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            field = value;
        }
    }

    /// <summary>Whether faces may turn over.</summary>
    public bool AllowFlips { get; init; }

    /// <summary>Whether boundary vertices neither move nor vanish.</summary>
    public bool LockBoundary { get; init; }

    /// <summary>Takes one line of JSON per contraction (step, edge, vertices, measure as cost, position, running hash); <see langword="null"/> for no trace.</summary>
    public TextWriter? Trace { get; init; }
}

/// <summary>§7.3 元素删除 (element deletion): removes the smallest edge, triangle or curvature, again and again.</summary>
/// <remarks>
/// Simple measures that know nothing of the original surface; see <see cref="QuadricErrorMetric"/> for one that does. The book's program contracts a flat vertex
/// into its first neighbour; here it goes into the one that turns the faces around least. Equal measures go by index. Works through <see cref="EdgeCollapse"/>, so it can
/// be recorded and undone; a cancelled call leaves the mesh valid, simplified so far. O(n log n).
/// </remarks>
public static class ElementDeletion
{
    extension(Mesh mesh)
    {
        /// <summary>Removes small elements until a number of faces is reached.</summary>
        /// <param name="options">Which, and how many.</param>
        /// <param name="progress">Hears of the part that is done.</param>
        /// <param name="cancellationToken">Ends the work; the mesh is valid.</param>
        /// <returns>What was done; its error is the largest measure of a removed element: a length, an area, or an angle defect.</returns>
        /// <exception cref="ArgumentException">The target exceeds the mesh's faces, or the mesh has faces that are not triangles.</exception>
        public SimplificationResult DeleteElements(
            DeletionOptions options, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            SimplificationInput.CheckTarget(mesh, options.TargetFaces, nameof(options));
            SimplificationInput.CheckTriangles(mesh);
            return new Deletion(mesh, options).Run(progress, cancellationToken);
        }
    }

    private sealed class Deletion(Mesh mesh, DeletionOptions options)
    {
        private const double LeastTurnCosine = 0.2;
        private readonly IndexedHeap queue = new(options.Measure switch
        {
            DeletionMeasure.ShortestEdge => mesh.EdgeSlots,
            DeletionMeasure.SmallestTriangle => mesh.FaceSlots,
            _ => mesh.VertexSlots,
        });

        private readonly TraceLog? trace = TraceLog.For(options.Trace);
        private int collapses;
        private double measure;

        public SimplificationResult Run(IProgress<double>? progress, CancellationToken cancellationToken)
        {
            int before = mesh.Faces.Count, collapsesAtRefill = -1, refused = 0;
            double largest = 0;
            while (mesh.Faces.Count > options.TargetFaces)
            {
                cancellationToken.ThrowIfCancellationRequested();
                if (queue.Count == 0)
                {
                    // What was refused may be possible now; if nothing changed since it was tried, it is not.
                    if (collapses == collapsesAtRefill)
                        break;
                    collapsesAtRefill = collapses;
                    refused = 0;
                    MeasureAll();
                }
                measure = queue.KeyOf(queue.Top);
                if (!TryDelete(queue.Pop()))
                {
                    refused++;
                    continue;
                }
                largest = Math.Max(largest, measure);
                if (collapses % 256 == 0)
                    progress?.Report((double)(before - mesh.Faces.Count) / Math.Max(1, before - options.TargetFaces));
            }
            if (mesh.Listener is null)
                mesh.Compact();
            StopReason reason = mesh.Faces.Count <= options.TargetFaces ? StopReason.TargetReached : StopReason.NothingCollapsible;
            return new(reason, before, mesh.Faces.Count, collapses, largest, new(reason == StopReason.TargetReached ? 0 : refused, 0, 0, 0));
        }

        private bool TryDelete(int element)
        {
            switch (options.Measure)
            {
                case DeletionMeasure.ShortestEdge:
                    HalfEdge h = new Edge(mesh, element).HalfEdge0;
                    return TryContract(h, (h.Source.Position + h.Target.Position) * 0.5);
                case DeletionMeasure.SmallestTriangle:
                    return TryContractTriangle(new Face(mesh, element));
                default:
                    return TryContractVertex(new Vertex(mesh, element));
            }
        }

        /// <summary>Two sides to the barycentre, one after the other; the first alone if the second is not possible any more.</summary>
        private bool TryContractTriangle(Face face)
        {
            Vertex first = face.HalfEdge.Source, second = face.HalfEdge.Target, third = face.HalfEdge.Next.Target;
            Vector3D barycentre = (first.Position + second.Position + third.Position) / 3;
            if (!TryContract(face.HalfEdge, barycentre))
                return false;
            HalfEdge side = mesh.FindHalfEdge(third, second.IsDeleted ? first : second);
            if (mesh.Faces.Count > options.TargetFaces && !side.IsNone)
                TryContract(side, barycentre);
            return true;
        }

        private bool TryContractVertex(Vertex vertex)
        {
            HalfEdge best = default;
            double leastTurn = double.NegativeInfinity;
            foreach (HalfEdge h in vertex.OutgoingHalfEdges)
            {
                double cosine = LeastCosine(h);
                if (cosine > leastTurn && IsAllowed(h, h.Target.Position))
                    (best, leastTurn) = (h, cosine);
            }
            return !best.IsNone && TryContract(best, best.Target.Position);
        }

        /// <summary>The cosine of the largest turn of a face around the source that stays, if the source goes to the target.</summary>
        private static double LeastCosine(HalfEdge h)
        {
            double least = 1;
            Vector3D old = h.Source.Position, then = h.Target.Position;
            foreach (HalfEdge spoke in h.Source.OutgoingHalfEdges)
            {
                if (spoke.IsBoundary || spoke.Target == h.Target || spoke.Next.Target == h.Target)
                    continue;
                Vector3D a = spoke.Target.Position, b = spoke.Next.Target.Position;
                Vector3D n = Vector3D.Cross(a - old, b - old), m = Vector3D.Cross(a - then, b - then);
                double product = n.Length * m.Length;
                least = Math.Min(least, product > 0 ? Vector3D.Dot(n, m) / product : 0);
            }
            return least;
        }

        private bool IsAllowed(HalfEdge h, Vector3D position)
        {
            if (options.LockBoundary && h.Source.IsBoundary)
                return false;
            return h.CanCollapse(out _) && (options.AllowFlips || !h.CollapseFlips(position, LeastTurnCosine));
        }

        private bool TryContract(HalfEdge h, Vector3D position)
        {
            if (options.LockBoundary && h.Source.IsBoundary != h.Target.IsBoundary)
            {
                h = h.Source.IsBoundary ? h.Twin : h;
                position = h.Target.Position;
            }
            if (!IsAllowed(h, position))
                return false;
            Vertex kept = h.Target;
            Forget(h);
            trace?.Write(h.Edge.Index, kept.Index, h.Source.Index, measure, position);
            h.Collapse(position);
            collapses++;
            MeasureAround(kept);
            return true;
        }

        /// <summary>Takes what is about to vanish out of the queue; a vertex that goes has been taken out already.</summary>
        private void Forget(HalfEdge h)
        {
            switch (options.Measure)
            {
                case DeletionMeasure.ShortestEdge:
                    foreach (Edge e in h.Source.Edges)
                        queue.Remove(e.Index);
                    break;
                case DeletionMeasure.SmallestTriangle:
                    foreach (Face f in h.Edge.Faces)
                        queue.Remove(f.Index);
                    break;
            }
        }

        private void MeasureAll()
        {
            switch (options.Measure)
            {
                case DeletionMeasure.ShortestEdge:
                    foreach (Edge e in mesh.Edges)
                        MeasureEdge(e);
                    break;
                case DeletionMeasure.SmallestTriangle:
                    foreach (Face f in mesh.Faces)
                        MeasureFace(f);
                    break;
                default:
                    foreach (Vertex v in mesh.Vertices)
                        MeasureVertex(v);
                    break;
            }
        }

        private void MeasureAround(Vertex vertex)
        {
            switch (options.Measure)
            {
                case DeletionMeasure.ShortestEdge:
                    foreach (Edge e in vertex.Edges)
                        MeasureEdge(e);
                    break;
                case DeletionMeasure.SmallestTriangle:
                    foreach (Face f in vertex.Faces)
                        MeasureFace(f);
                    break;
                default:
                    MeasureVertex(vertex);
                    foreach (Vertex v in vertex.Neighbors)
                        MeasureVertex(v);
                    break;
            }
        }

        private void MeasureEdge(Edge e) => queue.Set(e.Index, Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position));

        private void MeasureFace(Face f)
        {
            Vector3D a = f.HalfEdge.Source.Position;
            queue.Set(f.Index, 0.5 * Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a).Length);
        }

        /// <summary>|2π − Σ angles|, on a boundary |π − Σ angles|: the angle defect (角亏).</summary>
        private void MeasureVertex(Vertex v)
        {
            if (v.IsIsolated)
                return;
            double sum = 0;
            foreach (HalfEdge h in v.OutgoingHalfEdges)
            {
                if (!h.IsBoundary)
                    sum += Vector3D.Angle(h.Target.Position - v.Position, h.Next.Target.Position - v.Position);
            }
            queue.Set(v.Index, Math.Abs((v.IsBoundary ? Math.PI : 2 * Math.PI) - sum));
        }
    }
}
