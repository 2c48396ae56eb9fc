using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>Garland and Heckbert's cost: every vertex carries the sum of the quadrics of all vertices that went into it.</summary>
internal readonly struct SummedQuadrics(WorkingMesh mesh, UncheckedArray<Quadric> quadrics, Placement placement) : IEdgeCost
{
    private readonly UncheckedArray<HalfEdgeRow> rows = mesh.Rows;
    private readonly UncheckedArray<byte> states = mesh.States;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Evaluate(int edge, out Vector3D position, out double weight)
    {
        int h = 2 * edge, u = rows[h + 1].Target, v = rows[h].Target;
        Quadric sum = quadrics[u];
        sum.Add(in quadrics[v]);
        weight = sum.Weight;
        return placement.Choose(in sum, edge, u, v, out position);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double MeanSquare(int edge, Vector3D position, double value, double weight) => weight > 0 ? value / weight : 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsStale(int edge) => states[edge] == EdgeState.Stale;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MarkFresh(int edge, int time) => states[edge] = EdgeState.Clean;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void VertexMerged(int kept, int removed, int time) => quadrics[kept].Add(in quadrics[removed]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void RingChanged(int halfEdge, int time)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MarkStale(int edge) => states[edge] = EdgeState.Stale;

    public double ReleaseKey(int edge) => CostKey.Of(Evaluate(edge, out _, out double weight), weight);
}
