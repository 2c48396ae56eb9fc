namespace MeshLab.IO;

/// <summary>What a writer could not keep, because the format has no place for it: nothing is left out without being counted here.</summary>
public sealed record MeshWriteReport
{
    /// <summary>The format that was written.</summary>
    public required MeshFormat Format { get; init; }

    /// <summary>Text or binary, and the order of bytes.</summary>
    public required MeshEncoding Encoding { get; init; }

    /// <summary>What the file does not hold, in words such as <c>labels of material</c> or <c>unused vertices</c>, and of how many elements.</summary>
    public IReadOnlyDictionary<string, int> LeftOut { get; init; } = new Dictionary<string, int>(StringComparer.Ordinal);

    /// <summary>Faces of four and more corners that were cut into triangles.</summary>
    public int TriangulatedFaces { get; init; }

    /// <summary>Vertices whose coordinates were rounded to single precision.</summary>
    public int RoundedVertices { get; init; }
}
