using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>A cost from the faces as they are now (Lindstrom and Turk 1998, "memoryless"), with a tenth of the summed quadrics, which remember the original.
/// Sums of quadrics count a plane up to three times and keep planes that are long gone; near the end of a simplification that costs accuracy.</summary>
internal readonly struct MemorylessQuadrics : IEdgeCost
{
    private const double HistoryWeight = 0.1;
    private readonly WorkingMesh mesh;
    private readonly UncheckedArray<HalfEdgeRow> rows;
    private readonly VertexQuadrics planes;
    private readonly Placement placement;
    private readonly UncheckedArray<Quadric> history;
    private readonly UncheckedArray<Quadric> current;
    private readonly UncheckedArray<bool> isOld;
    private readonly UncheckedArray<int> changedAt;
    private readonly UncheckedArray<int> evaluatedAt;

    /// <summary>Starts from the mesh as it is.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="planes">The planes around a vertex.</param>
    /// <param name="placement">Where new vertices go.</param>
    /// <param name="history">The sums so far; they are added to.</param>
    public MemorylessQuadrics(WorkingMesh mesh, VertexQuadrics planes, Placement placement, UncheckedArray<Quadric> history)
    {
        this.mesh = mesh;
        this.planes = planes;
        this.placement = placement;
        this.history = history;
        rows = mesh.Rows;
        current = planes.GatherAll();
        isOld = new bool[mesh.Positions.Length];
        changedAt = new int[mesh.Positions.Length];
        evaluatedAt = new int[mesh.EdgeSlots];
    }

    public double Evaluate(int edge, out Vector3D position, out double weight)
    {
        int h = 2 * edge, u = rows[h + 1].Target, v = rows[h].Target;
        Refresh(u);
        Refresh(v);
        Quadric sum = current[u];
        sum.Add(in current[v]);
        sum.Add(in history[u], HistoryWeight);
        sum.Add(in history[v], HistoryWeight);
        // The faces beside the edge are in both sums, and will be gone.
        if (rows[h].Face >= 0)
            planes.AddFace(ref sum, u, v, rows[rows[h].Next].Target, -1);
        if (rows[h + 1].Face >= 0)
            planes.AddFace(ref sum, v, u, rows[rows[h + 1].Next].Target, -1);
        weight = sum.Weight;
        return placement.Choose(in sum, edge, u, v, out position);
    }

    public double MeanSquare(int edge, Vector3D position, double value, double weight)
    {
        Quadric sum = history[rows[2 * edge].Target];
        sum.Add(in history[rows[2 * edge + 1].Target]);
        return sum.Weight > 0 ? Math.Max(0, sum.At(position)) / sum.Weight : 0;
    }

    public bool IsStale(int edge) =>
        evaluatedAt[edge] < Math.Max(changedAt[rows[2 * edge].Target], changedAt[rows[2 * edge + 1].Target]);

    public void MarkFresh(int edge, int time) => evaluatedAt[edge] = time;

    public void VertexMerged(int kept, int removed, int time)
    {
        history[kept].Add(in history[removed]);
        Touch(kept, time);
    }

    public void RingChanged(int halfEdge, int time) => Touch(rows[halfEdge].Target, time);

    public void MarkStale(int edge)
    {
        // Staleness is read off the ends: the edges of all ring vertices changed, too many to mark one by one.
    }

    public double ReleaseKey(int edge) => mesh.Keys[edge];

    private void Touch(int vertex, int time)
    {
        isOld[vertex] = true;
        changedAt[vertex] = time;
    }

    private void Refresh(int vertex)
    {
        if (!isOld[vertex])
            return;
        planes.Gather(vertex, out current[vertex]);
        isOld[vertex] = false;
    }
}
