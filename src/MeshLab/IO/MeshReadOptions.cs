using MeshLab.Structure;

namespace MeshLab.IO;

/// <summary>How a mesh is read.</summary>
public sealed record MeshReadOptions
{
    /// <summary>The format; null takes it from the file name's extension.</summary>
    public MeshFormat? Format { get; init; }

    /// <summary>Whether STL's vertices of exactly equal coordinates become one vertex. Otherwise every triangle has three of its own.</summary>
    public bool Weld { get; init; } = true;

    /// <summary>What to do with faces that do not make an oriented 2-manifold.</summary>
    public NonManifoldPolicy NonManifold { get; init; } = NonManifoldPolicy.Throw;

    /// <summary>The least number of bytes worth a thread of its own; tests make it small.</summary>
    internal int MinChunkBytes { get; init; } = 512 * 1024;

    /// <summary>The most threads; 0 for as many as the library may use.</summary>
    internal int MaxChunks { get; init; }
}
