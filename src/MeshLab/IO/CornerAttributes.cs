using System.Runtime.InteropServices;

namespace MeshLab.IO;

/// <summary>Decides whether an attribute that a file gives per corner belongs to the vertices or really differs between the corners of a vertex.</summary>
internal static class CornerAttributes
{
    /// <summary>Turns a pool of values and an index per corner into values per vertex, if every vertex has one value only, or else per corner.</summary>
    /// <param name="pool">The values.</param>
    /// <param name="indices">Per corner, an index into the pool or <see cref="ObjChunk.Missing"/>; a missing value becomes zero.</param>
    /// <param name="corners">Per corner, its vertex.</param>
    /// <param name="vertices">The number of vertices.</param>
    public static (T[]? PerVertex, T[]? PerCorner) Distribute<T>(T[] pool, int[] indices, int[] corners, int vertices)
        where T : unmanaged
    {
        if (pool.Length == vertices && indices.AsSpan().SequenceEqual(corners))
            return (pool, null);
        if (indices.AsSpan().IndexOfAnyExcept(ObjChunk.Missing) < 0)
            return (null, null);

        T[] perCorner = new T[indices.Length];
        for (int c = 0; c < indices.Length; c++)
        {
            if (indices[c] != ObjChunk.Missing)
                perCorner[c] = pool[indices[c]];
        }

        return TryGather(perCorner, corners, vertices, out T[] perVertex) ? (perVertex, null) : (null, perCorner);
    }

    private static bool TryGather<T>(T[] perCorner, int[] corners, int vertices, out T[] perVertex)
        where T : unmanaged
    {
        perVertex = new T[vertices];
        bool[] isSet = new bool[vertices];
        for (int c = 0; c < corners.Length; c++)
        {
            int vertex = corners[c];
            if (!isSet[vertex])
            {
                isSet[vertex] = true;
                perVertex[vertex] = perCorner[c];
            }
            else if (!AreSameBits(in perVertex[vertex], in perCorner[c]))
            {
                return false;
            }
        }

        return true;
    }

    // Bits, not values: 0 and −0 are equal, but writing one for the other would change the file.
    private static bool AreSameBits<T>(in T a, in T b)
        where T : unmanaged =>
        MemoryMarshal.AsBytes(new ReadOnlySpan<T>(in a)).SequenceEqual(MemoryMarshal.AsBytes(new ReadOnlySpan<T>(in b)));
}
