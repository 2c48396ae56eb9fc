using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>Chooses where the vertex that an edge becomes lies.</summary>
/// <param name="mesh">The mesh.</param>
/// <param name="placement">What is asked for.</param>
internal readonly struct Placement(WorkingMesh mesh, VertexPlacement placement)
{
    private readonly bool anywhere = placement == VertexPlacement.Optimal && mesh.Constraints is null;

    /// <summary>The best position for a quadric, and its cost there, never negative.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Choose(ref readonly Quadric quadric, int edge, int u, int v, out Vector3D position)
    {
        if (anywhere && quadric.TryMinimize(out position, out double cost))
            return cost > 0 ? cost : 0;
        return ChooseWithCare(in quadric, edge, u, v, out position);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private double ChooseWithCare(ref readonly Quadric quadric, int edge, int u, int v, out Vector3D position)
    {
        Vector3D a = mesh.Positions[u], b = mesh.Positions[v];
        Freedom freedom = mesh.Constraints?.FreedomOf(edge, u, v) ?? Freedom.Anywhere;
        double cost;
        if (freedom is Freedom.AtSource or Freedom.AtTarget)
        {
            position = freedom == Freedom.AtSource ? a : b;
            cost = quadric.At(position);
        }
        else if (placement == VertexPlacement.Endpoint)
        {
            double costA = quadric.At(a), costB = quadric.At(b);
            (position, cost) = costA < costB - Noise(in quadric) ? (a, costA) : (b, costB);
        }
        else if (placement == VertexPlacement.Segment || freedom == Freedom.OnSegment)
        {
            double t = quadric.MinimizeOnSegment(a, b);
            position = t == 0 ? a : t == 1 ? b : Vector3D.Lerp(a, b, t);
            cost = quadric.At(position);
        }
        else if (!quadric.TryMinimize(out position, out cost))
        {
            cost = BestOnEdge(in quadric, a, b, out position);
        }
        return cost > 0 ? cost : 0;
    }

    /// <summary>The best of the midpoint, the ends and the point in between, where the quadric has no unique minimum.</summary>
    private static double BestOnEdge(ref readonly Quadric quadric, Vector3D a, Vector3D b, out Vector3D position)
    {
        position = (a + b) * 0.5;
        double cost = quadric.At(position), costA = quadric.At(a), costB = quadric.At(b);
        double noise = Noise(in quadric);
        if (costA < cost - noise)
            (cost, position) = (costA, a);
        if (costB < cost - noise)
            (cost, position) = (costB, b);
        // Where planes meet in a line, a point along the edge may be better still.
        Vector3D along = Vector3D.Lerp(a, b, quadric.MinimizeOnSegment(a, b));
        double costAlong = quadric.At(along);
        if (costAlong < cost - noise)
            (cost, position) = (costAlong, along);
        return cost;
    }

    /// <summary>By less than this no place is better than another: the midpoint is taken before the ends, and the target before the source.</summary>
    private static double Noise(ref readonly Quadric quadric) => CostKey.Noise * quadric.Weight;
}

/// <summary>Where the constraints let the vertex of a contracted edge lie.</summary>
internal enum Freedom : byte
{
    /// <summary>Anywhere.</summary>
    Anywhere,

    /// <summary>On the edge.</summary>
    OnSegment,

    /// <summary>Where the edge's half-edge 0 starts.</summary>
    AtSource,

    /// <summary>Where the edge's half-edge 0 ends.</summary>
    AtTarget,
}
