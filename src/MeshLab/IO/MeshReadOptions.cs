namespace MeshLab.IO;

/// <summary>How a mesh is read.</summary>
public sealed record MeshReadOptions
{
    private readonly int threads;

    /// <summary>The format; null takes it from the file name's extension.</summary>
    public MeshFormat? Format { get; init; }

    /// <summary>Whether STL's vertices of exactly equal coordinates become one vertex. Otherwise every triangle has three of its own.</summary>
    public bool Weld { get; init; } = true;

    /// <summary>How many threads may read; 0 for one per processor. The result does not depend on it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is negative.</exception>
    public int Threads
    {
        get => threads;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            threads = value;
        }
    }

    /// <summary>The least number of bytes worth a thread of its own; tests make it small.</summary>
    internal int MinChunkBytes { get; init; } = 512 * 1024;
}
