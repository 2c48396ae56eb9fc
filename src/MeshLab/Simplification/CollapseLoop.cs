using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>What an edge costs. Structs, so that the loop is compiled once for each without calls through an interface.</summary>
internal interface IEdgeCost
{
    /// <summary>The cost of contracting an edge, where its vertex goes, and the weight of the planes that the cost is a sum over.</summary>
    double Evaluate(int edge, out Vector3D position, out double weight);

    /// <summary>The mean squared distance of a position to the original planes that the edge stands for, in working units; the value is the edge's cost there.</summary>
    double MeanSquare(int edge, Vector3D position, double value, double weight);

    /// <summary>Whether the edge's key is only a lower bound of its cost.</summary>
    bool IsStale(int edge);

    /// <summary>Notes that the key of the edge is its cost at this time.</summary>
    void MarkFresh(int edge, int time);

    /// <summary>Called after each contraction, before the ring is walked.</summary>
    void VertexMerged(int kept, int removed, int time);

    /// <summary>Called for every half-edge that leaves the new vertex.</summary>
    void RingChanged(int halfEdge, int time);

    /// <summary>Called for every edge around the new vertex that waits in the queue.</summary>
    void MarkStale(int edge);

    /// <summary>The key with which a parked edge goes back to the queue.</summary>
    double ReleaseKey(int edge);
}

/// <summary>Costs as the queue compares them: so coarsely that rounding does not decide. Two edges of a symmetric or flat part cost the same but for the last
/// bits, and those depend on where the model lies and how large it is; their order is that of their indices.</summary>
internal static class CostKey
{
    /// <summary>What a mean square is off by through rounding, in working units: places are up to ½, and their squares have 53 bits.</summary>
    public const double Noise = 1e-15;

    /// <summary>All but the twelve leading bits of the fraction.</summary>
    private const long Dropped = (1L << 40) - 1;

    /// <summary>The key of a cost: at most a four-thousandth below it, but never below what rounding makes of it. So in flat parts, where costs say nothing, the
    /// edges of small faces come first.</summary>
    /// <param name="cost">The cost.</param>
    /// <param name="weight">The weight of the planes it is a sum over.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Of(double cost, double weight)
    {
        double key = Math.Max(cost, Noise * weight);
        return BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(key) & ~Dropped);
    }
}

/// <summary>What all loops of one simplification share.</summary>
internal sealed record LoopSettings(bool AllowFlips, double MaxMeanSquare, CollapseLog? Log);

/// <summary>Contracts the cheapest edge, again and again.</summary>
/// <typeparam name="TCost">What an edge costs.</typeparam>
/// <remarks>A key in the queue may be older than the costs around it. With summed quadrics costs only grow when a neighbour is contracted, so an old key
/// is a lower bound, and it is enough to look again when the edge reaches the front: most edges are merged away before that.</remarks>
internal sealed class CollapseLoop<TCost>
    where TCost : struct, IEdgeCost
{
    private const int StepsBetweenChecks = 1 << 10;
    private readonly WorkingMesh mesh;
    private readonly LoopSettings settings;
    private readonly CancellationToken cancellationToken;
    private readonly Action<int>? report;
    private TCost cost;
    private int stamp;
    private int steps;
    private int pendingEdge = -1;
    private Vector3D pendingPosition;
    private double pendingWeight;
    private double pendingCost;
    private double pendingMeanSquare;

    public CollapseLoop(
        WorkingMesh mesh, TCost cost, BucketQueue queue, LoopSettings settings, int stamp, Action<int>? report, CancellationToken cancellationToken)
    {
        this.mesh = mesh;
        this.cost = cost;
        this.settings = settings;
        this.stamp = stamp;
        this.report = report;
        this.cancellationToken = cancellationToken;
        Queue = queue;
    }

    public BucketQueue Queue { get; }

    /// <summary>The last number that marked vertices; it grows with every edge that is examined, and so serves as the time too.</summary>
    public int Stamp => stamp;

    public int FacesRemoved { get; private set; }

    public int Collapses { get; private set; }

    /// <summary>The largest cost per weight of a contraction, in working units squared.</summary>
    public double MaxMeanSquare { get; private set; }

    /// <summary>Empties the queue's buckets one after the other until so many faces are removed.</summary>
    public void Run(BucketScale scale, int facesToRemove)
    {
        for (int bucket = 0; bucket < scale.Count && FacesRemoved < facesToRemove; bucket++)
        {
            DrainOne(bucket, facesToRemove);
            cancellationToken.ThrowIfCancellationRequested();
        }
    }

    /// <summary>Empties a run of buckets.</summary>
    public void Drain(int firstBucket, int endBucket)
    {
        for (int bucket = firstBucket; bucket < endBucket && !cancellationToken.IsCancellationRequested; bucket++)
        {
            if (Queue.HasEntries(bucket))
                DrainOne(bucket, int.MaxValue);
        }
    }

    /// <summary>Contracts what is in one bucket, and what falls into it meanwhile.</summary>
    private void DrainOne(int bucket, int facesToRemove)
    {
        Queue.Current = bucket;
        while (FacesRemoved < facesToRemove)
        {
            if (Queue.HeapCount == 0)
            {
                if (!Queue.HasEntries(bucket))
                    return;
                Fill(bucket);
                continue;
            }
            if ((++steps & (StepsBetweenChecks - 1)) == 0)
            {
                if (cancellationToken.IsCancellationRequested)
                    return;
                report?.Invoke(FacesRemoved);
            }
            Step(Queue.Top);
        }
    }

    /// <summary>Moves a bucket's list into the heap; edges whose cost has grown out of the bucket go to a later one.</summary>
    private void Fill(int bucket)
    {
        UncheckedArray<byte> states = mesh.States;
        UncheckedArray<double> keys = mesh.Keys;
        for (int edge = Queue.TakeList(bucket), following; edge >= 0; edge = following)
        {
            following = Queue.NextInList(edge);
            if (states[edge] == EdgeState.Deleted)
                continue;
            if (cost.IsStale(edge))
            {
                double key = CostKey.Of(cost.Evaluate(edge, out _, out double weight), weight);
                keys[edge] = key;
                cost.MarkFresh(edge, stamp);
                Queue.InsertUnsorted(edge, key);
                continue;
            }
            Queue.Append(edge, keys[edge]);
        }
        Queue.Heapify();
    }

    private void Step(int edge)
    {
        if (mesh.States[edge] == EdgeState.Deleted)
        {
            Queue.Pop();
            return;
        }
        if (cost.IsStale(edge))
        {
            pendingCost = cost.Evaluate(edge, out pendingPosition, out pendingWeight);
            double key = CostKey.Of(pendingCost, pendingWeight);
            pendingEdge = edge;
            mesh.Keys[edge] = key;
            cost.MarkFresh(edge, stamp);
            Queue.ChangeTop(key);
            return;
        }
        Queue.Pop();
        byte refusal = Examine(edge);
        if (refusal == EdgeState.Clean)
            Contract(edge);
        else
            mesh.States[edge] = refusal;
    }

    /// <summary>Why the edge may not be contracted; <see cref="EdgeState.Clean"/> if it may, and then the pending position and weight are its own.</summary>
    private byte Examine(int edge)
    {
        int h = 2 * edge;
        if (mesh.Constraints is { } constraints && !constraints.Allow(mesh, h))
            return EdgeState.RefusedByConstraint;
        if (!mesh.LinkConditionHolds(h, ++stamp))
            return EdgeState.RefusedByTopology;
        if (pendingEdge != edge)
            pendingCost = cost.Evaluate(edge, out pendingPosition, out pendingWeight);
        pendingEdge = -1;
        TakeEndIfThere(h);
        pendingMeanSquare = cost.MeanSquare(edge, pendingPosition, pendingCost, pendingWeight);
        if (pendingMeanSquare > settings.MaxMeanSquare)
            return EdgeState.RefusedByError;
        if (!settings.AllowFlips && !(mesh.KeepsOrientation(h, pendingPosition) && mesh.KeepsOrientation(h ^ 1, pendingPosition)))
            return EdgeState.RefusedByFlip;
        return EdgeState.Clean;
    }

    /// <summary>An optimum that is an end but for rounding is that end: corners of the input stay to the bit.</summary>
    private void TakeEndIfThere(int h)
    {
        const double SamePlace = 1e-20;
        Vector3D source = mesh.Positions[mesh.Rows[h ^ 1].Target], target = mesh.Positions[mesh.Rows[h].Target];
        if (Vector3D.DistanceSquared(pendingPosition, target) < SamePlace)
            pendingPosition = target;
        else if (Vector3D.DistanceSquared(pendingPosition, source) < SamePlace)
            pendingPosition = source;
    }

    private void Contract(int edge)
    {
        UncheckedArray<HalfEdgeRow> rows = mesh.Rows;
        UncheckedArray<byte> states = mesh.States;
        int h = 2 * edge;
        int u = rows[h ^ 1].Target, v = rows[h].Target;
        FacesRemoved += (rows[h].Face >= 0 ? 1 : 0) + (rows[h ^ 1].Face >= 0 ? 1 : 0);
        Collapses++;
        MaxMeanSquare = Math.Max(MaxMeanSquare, pendingMeanSquare);

        Merges merges = mesh.ChooseMerges(h);
        // The edge goes for good, and the log is told the cost itself.
        mesh.Keys[edge] = pendingCost;
        settings.Log?.BeforeCollapse(mesh, h, pendingPosition, merges);
        int start = mesh.Collapse(h, pendingPosition, merges);
        mesh.Constraints?.VertexMerged(v, u);
        cost.VertexMerged(v, u, stamp);

        int g = start;
        do
        {
            if (rows[g].Face < 0)
                mesh.Outgoing[v] = g;
            cost.RingChanged(g, stamp);
            int changed = g >> 1;
            if (states[changed] >= EdgeState.Parked)
            {
                states[changed] = EdgeState.Clean;
                double key = cost.ReleaseKey(changed);
                mesh.Keys[changed] = key;
                Queue.Insert(changed, key);
            }
            else
            {
                cost.MarkStale(changed);
            }
            g = rows[g ^ 1].Next;
        }
        while (g != start);
    }
}
