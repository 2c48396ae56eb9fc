namespace MeshLab.IO;

/// <summary>How a mesh is written.</summary>
public sealed record MeshWriteOptions
{
    /// <summary>The format; null takes it from the file name's extension.</summary>
    public MeshFormat? Format { get; init; }

    /// <summary>Text or binary. A format that cannot be written so is an error.</summary>
    public MeshEncoding Encoding { get; init; }

    /// <summary>Material libraries for an OBJ to name (<c>mtllib</c>), as <see cref="MeshReadReport.MaterialLibraries"/> gives them.</summary>
    public IReadOnlyList<string> MaterialLibraries { get; init; } = [];
}
