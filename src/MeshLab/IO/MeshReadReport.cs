using MeshLab.Structure;

namespace MeshLab.IO;

/// <summary>What a reader found in a file beside the mesh, and what it left out: nothing is dropped without being counted here.</summary>
public sealed record MeshReadReport
{
    /// <summary>The format that was read.</summary>
    public required MeshFormat Format { get; init; }

    /// <summary>Text or binary, and the order of bytes.</summary>
    public required MeshEncoding Encoding { get; init; }

    /// <summary>Vertices of the file, used or not.</summary>
    public required int VertexCount { get; init; }

    /// <summary>Faces of the file.</summary>
    public required int FaceCount { get; init; }

    /// <summary>The material libraries that an OBJ names (<c>mtllib</c>); give them to <see cref="MeshWriteOptions"/> to keep them.</summary>
    public IReadOnlyList<string> MaterialLibraries { get; init; } = [];

    /// <summary>Lines, properties and elements that the library does not read: their keyword, and how often each occurred.</summary>
    public IReadOnlyDictionary<string, int> Ignored { get; init; } = new Dictionary<string, int>(StringComparer.Ordinal);

    /// <summary>The number of lines that were ignored; comments and blank lines do not count.</summary>
    public long IgnoredLines { get; init; }

    /// <summary>Vertex weights other than 1 (the fourth coordinate of OBJ), which polygons have no use for.</summary>
    public long IgnoredWeights { get; init; }

    /// <summary>Numbers of colours, normals and texture coordinates that were not finite: colours became white, the others 0.</summary>
    public long ReplacedAttributes { get; init; }

    /// <summary>Bytes of padding behind the end of binary data, too few or too empty to be more of it.</summary>
    public long TrailingBytes { get; init; }

    /// <summary>How many vertices of an STL were joined with an earlier one.</summary>
    public int WeldedVertices { get; init; }

    /// <summary>What the builder did with faces that do not make a manifold; null if only the data were read.</summary>
    public BuildReport? Build { get; init; }
}
