using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>Something that is summed over the corners at a vertex.</summary>
internal interface ICornerSum
{
    /// <summary>Adds a corner between two spokes, counter-clockwise from <paramref name="u"/> to <paramref name="w"/>.</summary>
    void Add(Vector3D u, Vector3D w);
}

/// <summary>The walk around a vertex that all sums over corners share: every spoke is read once.</summary>
internal static class CornerSum
{
    /// <summary>Adds all corners at a vertex that is not isolated. Returns whether the vertex lies on the boundary.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Around<TSum>(int[] next, int[] target, Vector3D[] positions, Vector3D center, int outgoing, bool isBoundary, ref TSum sum)
        where TSum : struct, ICornerSum
    {
        int h = outgoing;
        Vector3D w = positions[target[h]] - center;
        do
        {
            h = next[h ^ 1];
            // Turning clockwise from the hole, the last corner is the hole itself.
            if (h == outgoing && isBoundary)
                break;
            Vector3D u = positions[target[h]] - center;
            sum.Add(u, w);
            w = u;
        }
        while (h != outgoing);
        return isBoundary;
    }
}
