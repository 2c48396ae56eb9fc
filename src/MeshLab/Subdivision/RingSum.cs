using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Subdivision;

/// <summary>The sum of a vertex's neighbours, which every averaging rule for old vertices starts from.</summary>
internal static class RingSum
{
    /// <summary>Adds up the neighbours once around, from a spoke clockwise. O(valence).</summary>
    /// <param name="next">The column of next half-edges.</param>
    /// <param name="target">The column of targets.</param>
    /// <param name="positions">The positions.</param>
    /// <param name="start">A half-edge that leaves the vertex.</param>
    /// <param name="valence">The number of neighbours.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Vector3D Around(int* next, int* target, Vector3D* positions, int start, out int valence)
    {
        double x = 0, y = 0, z = 0;
        int count = 0, h = start;
        do
        {
            Vector3D* neighbor = positions + target[h];
            x += neighbor->X;
            y += neighbor->Y;
            z += neighbor->Z;
            count++;
            h = next[h ^ 1];
        }
        while (h != start);
        valence = count;
        return new Vector3D(x, y, z);
    }
}
