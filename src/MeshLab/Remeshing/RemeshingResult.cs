using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>Why remeshing ended.</summary>
public enum RemeshingStop
{
    /// <summary>All passes asked for were done.</summary>
    PassesDone,

    /// <summary>The mesh has no faces, or no length: there was nothing to remesh.</summary>
    NothingToDo,
}

/// <summary>What remeshing made.</summary>
/// <param name="Mesh">The new mesh, with the traits of the input by place.</param>
/// <param name="StopReason">Why it ended.</param>
/// <param name="EdgeLength">The edge length that was asked for.</param>
/// <param name="Passes">Passes done.</param>
/// <param name="Splits">Edges split.</param>
/// <param name="Collapses">Edges contracted.</param>
/// <param name="Flips">Edges flipped.</param>
/// <param name="FeatureEdges">Edges of the input that were kept as features, boundaries not counted.</param>
/// <param name="Corners">Vertices that were not moved: ends, crossings and sharp turns of features and boundaries.</param>
public sealed record RemeshingResult(
    Mesh Mesh, RemeshingStop StopReason, double EdgeLength, int Passes, int Splits, int Collapses, int Flips, int FeatureEdges, int Corners);
