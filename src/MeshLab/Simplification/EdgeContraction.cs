using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Contracts edges on a private copy: a bucket queue of lower bounds, and on large meshes regions at once.</summary>
internal sealed class EdgeContraction
{
    /// <summary>Counting ahead is worth while if it saves the regions so many meetings.</summary>
    private const int LeastBucketsAhead = 4;
    private readonly QuadricOptions options;
    private readonly int facesBefore;
    private readonly IProgress<double>? progress;
    private readonly CancellationToken cancellationToken;
    private readonly CollapseLog? extraLog;
    private readonly TraitLog? traits;
    private UncheckedArray<int> links;
    private int stamp;

    public EdgeContraction(Mesh mesh, QuadricOptions options, TraitLog? traits, CollapseLog? extraLog, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        this.options = options;
        this.extraLog = extraLog;
        this.progress = progress;
        this.cancellationToken = cancellationToken;
        facesBefore = mesh.Faces.Count;
        Working = new WorkingMesh(mesh) { Constraints = Constraints.From(mesh, options) };
        this.traits = traits;
        links = UncheckedArray<int>.Uninitialized(Working.EdgeSlots);
    }

    public WorkingMesh Working { get; }

    private VertexQuadrics Planes => new(Working, options.AreaWeights, options.BoundaryWeight, options.Boundary != BoundaryTreatment.Free);

    /// <summary>The part of the whole work that this is, for progress.</summary>
    public double ProgressShare { get; init; } = 1;

    public int Collapses { get; private set; }

    public double MaxMeanSquare { get; private set; }

    /// <summary>Blends the mesh's traits as the contractions ask for. The first change to the mesh: call when nothing can fail any more.</summary>
    public void ApplyTraits(Mesh mesh) => traits?.Apply(mesh);

    /// <summary>Contracts edges with summed quadrics until the number of faces is reached.</summary>
    /// <returns>The sums, for those who go on.</returns>
    public UncheckedArray<Quadric> ContractBySums(int targetFaces)
    {
        Regions? regions = RegionsFor(targetFaces);
        UncheckedArray<Quadric> quadrics = Planes.GatherAll();
        Contract(new SummedQuadrics(Working, quadrics, new Placement(Working, options.Placement)), regions, targetFaces);
        return quadrics;
    }

    /// <summary>Contracts edges with costs from the current faces until the number of faces is reached.</summary>
    /// <param name="history">The sums so far.</param>
    /// <param name="targetFaces">The number of faces.</param>
    public void ContractMemoryless(UncheckedArray<Quadric> history, int targetFaces)
    {
        Regions? regions = RegionsFor(targetFaces);
        Contract(new MemorylessQuadrics(Working, Planes, new Placement(Working, options.Placement), history), regions, targetFaces);
    }

    /// <summary>The parts to begin with, if parts pay. Asked for before the quadrics are gathered: sorting needs room of its own for a moment.</summary>
    private Regions? RegionsFor(int targetFaces)
    {
        int count = extraLog is null && traits is null ? Regions.CountFor(Working.FaceCount) : 1;
        return count > 1 && Working.FaceCount > Math.Max(targetFaces, targetFaces / 3 * 4) ? new Regions(Working, count) : null;
    }

    /// <summary>Contracts edges with any cost until the number of faces is reached or nothing is left.</summary>
    private void Contract<TCost>(TCost cost, Regions? regions, int targetFaces)
        where TCost : struct, IEdgeCost
    {
        if (Working.FaceCount <= targetFaces)
            return;
        BucketScale scale = EvaluateAll(cost);
        if (regions is not null)
            RunRegions(cost, scale, regions, targetFaces);

        while (Working.FaceCount > targetFaces)
        {
            CollapseLoop<TCost> loop = NewLoop(cost, new BucketQueue(scale, links), Report);
            for (int e = Working.EdgeSlots - 1; e >= 0; e--)
            {
                if (Working.States[e] == EdgeState.Deleted)
                    continue;
                if (Working.States[e] >= EdgeState.Parked)
                    Release(ref cost, e);
                loop.Queue.Insert(e, Working.Keys[e]);
            }
            loop.Run(scale, Working.FaceCount - targetFaces);
            Take(loop);
            // What was refused may have become possible since; only a round without a contraction shows that nothing is left.
            if (loop.Collapses == 0)
                return;
        }
    }

    /// <summary>Lets go of what only contracting needs.</summary>
    public void Release()
    {
        links = default;
        Working.ReleaseConnectivity();
    }

    /// <summary>The reasons of the edges that were refused and are waiting.</summary>
    public RefusalCounts CountRefusals()
    {
        var counts = new int[EdgeState.RefusedByError + 1];
        foreach (byte state in Working.States.Items)
            counts[state]++;
        return new(counts[EdgeState.RefusedByTopology], counts[EdgeState.RefusedByConstraint], counts[EdgeState.RefusedByFlip], counts[EdgeState.RefusedByError]);
    }

    private BucketScale EvaluateAll<TCost>(TCost cost)
        where TCost : struct, IEdgeCost
    {
        UncheckedArray<byte> states = Working.States;
        UncheckedArray<double> keys = Working.Keys;
        Parallelism.ForBlocks(Working.EdgeSlots, (first, end) =>
        {
            for (int e = first; e < end; e++)
            {
                if (states[e] == EdgeState.Deleted)
                    continue;
                states[e] = EdgeState.Clean;
                keys[e] = CostKey.Of(cost.Evaluate(e, out _, out double weight), weight);
            }
        });
        double largest = 0;
        for (int e = 0; e < states.Length; e++)
        {
            if (states[e] != EdgeState.Deleted)
                largest = Math.Max(largest, keys[e]);
        }
        return new BucketScale(largest);
    }

    private void RunRegions<TCost>(TCost cost, BucketScale scale, Regions regions, int targetFaces)
        where TCost : struct, IEdgeCost
    {
        var loops = new CollapseLoop<TCost>[regions.Count];
        byte[] regionOf = regions.RegionsOfEdges();
        Parallelism.ForBlocks(loops.Length, 1, (r, _) =>
        {
            loops[r] = NewLoop(cost, new BucketQueue(scale, links), null);
            for (int e = regionOf.Length - 1; e >= 0; e--)
            {
                if (regionOf[e] == r)
                    loops[r].Queue.Insert(e, Working.Keys[e]);
            }
        });
        int stop = regions.WhereToStop(targetFaces);
        bool looksAhead = true;
        for (int bucket = 0; bucket < scale.Count && Working.FaceCount - Removed(loops) > stop;)
        {
            int first = bucket, end = bucket + 1;
            if (looksAhead)
            {
                end = EndOfRound(scale, regionOf, first, Working.FaceCount - Removed(loops) - stop);
                looksAhead = end - first >= LeastBucketsAhead;
            }
            Parallelism.ForBlocks(loops.Length, 1, (r, _) => loops[r].Drain(first, end));
            cancellationToken.ThrowIfCancellationRequested();
            Report(Removed(loops));
            bucket = end;
        }

        foreach (CollapseLoop<TCost> loop in loops)
            Take(loop);
    }

    /// <summary>Up to which bucket all regions may go before they have to wait for each other. An edge's key only grows, so no more edges can be contracted in these
    /// buckets than have their key there now; and as long as that is too few to reach the number of faces at which to stop, nobody has to count.</summary>
    private int EndOfRound(BucketScale scale, byte[] regionOf, int first, int facesToRemove)
    {
        var counts = new int[scale.Count];
        for (int e = 0; e < regionOf.Length; e++)
        {
            if (regionOf[e] != Regions.None && Working.States[e] != EdgeState.Deleted)
                counts[scale.BucketOf(Working.Keys[e])]++;
        }
        int end = first, edges = 0;
        while (end < counts.Length && 2L * (edges += counts[end]) < facesToRemove)
            end++;
        return Math.Min(Math.Max(end, first + 1), scale.Count);
    }

    private static int Removed<TCost>(CollapseLoop<TCost>[] loops)
        where TCost : struct, IEdgeCost
    {
        int removed = 0;
        foreach (CollapseLoop<TCost> loop in loops)
            removed += loop.FacesRemoved;
        return removed;
    }

    private void Release<TCost>(ref TCost cost, int edge)
        where TCost : struct, IEdgeCost
    {
        Working.States[edge] = EdgeState.Clean;
        Working.Keys[edge] = cost.ReleaseKey(edge);
    }

    private CollapseLoop<TCost> NewLoop<TCost>(TCost cost, BucketQueue queue, Action<int>? report)
        where TCost : struct, IEdgeCost
    {
        double limit = options.MaxError is double error ? error / Working.Scale : double.PositiveInfinity;
        var settings = new LoopSettings(options.AllowFlips, limit * limit, LogGroup.Of(extraLog, traits));
        return new CollapseLoop<TCost>(Working, cost, queue, settings, stamp, report, cancellationToken);
    }

    private void Take<TCost>(CollapseLoop<TCost> loop)
        where TCost : struct, IEdgeCost
    {
        Working.FaceCount -= loop.FacesRemoved;
        Collapses += loop.Collapses;
        MaxMeanSquare = Math.Max(MaxMeanSquare, loop.MaxMeanSquare);
        stamp = Math.Max(stamp, loop.Stamp);
    }

    private void Report(int facesRemoved) =>
        progress?.Report(ProgressShare * (facesBefore - Working.FaceCount + facesRemoved) / Math.Max(1, facesBefore));
}
