using System.Runtime.CompilerServices;

namespace MeshLab.Subdivision;

/// <summary>The pinned link columns of a mesh that is being written.</summary>
internal readonly unsafe struct LinkColumns(int* next, int* previous, int* face)
{
    /// <summary>Makes a triangle of three half-edges.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Triangle(int a, int b, int c, int child)
    {
        next[a] = b;
        next[b] = c;
        next[c] = a;
        previous[a] = c;
        previous[b] = a;
        previous[c] = b;
        face[a] = child;
        face[b] = child;
        face[c] = child;
    }
}
