namespace MeshLab.Structure;

/// <summary>What the builder does with faces that would not make an oriented 2-manifold.</summary>
public enum NonManifoldPolicy
{
    /// <summary>Throws and names the elements.</summary>
    Throw,

    /// <summary>Leaves out the later of two faces in conflict, and reports each.</summary>
    Skip,

    /// <summary>Keeps every face that is a polygon at all and gives faces in conflict vertices of their own, and reports each.</summary>
    Split,
}

/// <summary>What was done to an element of the input.</summary>
public enum RepairKind
{
    /// <summary>A face was left out.</summary>
    SkippedFace,

    /// <summary>A vertex was given a copy.</summary>
    SplitVertex,
}

/// <summary>One repair.</summary>
/// <param name="Kind">What was done.</param>
/// <param name="Element">The element of the input, as <c>f5</c> or <c>v12</c>.</param>
/// <param name="Message">Why, with the other elements by name.</param>
public sealed record Repair(RepairKind Kind, string Element, string Message);

/// <summary>What the builder did.</summary>
/// <param name="Repairs">Faces left out and vertices split, in index order; empty for a sound input.</param>
/// <param name="SourceFaces">Per face of the mesh, its number in the input; <see langword="null"/> if they are the same.</param>
/// <param name="SourceVertices">Per vertex of the mesh, its number in the input; <see langword="null"/> if they are the same.</param>
/// <param name="IsolatedVertices">How many vertices are in no face.</param>
public sealed record BuildReport(IReadOnlyList<Repair> Repairs, int[]? SourceFaces, int[]? SourceVertices, int IsolatedVertices);
