namespace MeshLab.Simplification;

/// <summary>Why a simplification ended.</summary>
public enum StopReason
{
    /// <summary>The number of faces was reached, exactly or within one face.</summary>
    TargetReached,

    /// <summary>Every further contraction would exceed the largest error.</summary>
    MaxErrorReached,

    /// <summary>No edge is left that may be contracted; <see cref="SimplificationResult.Refusals"/> says why not.</summary>
    NothingCollapsible,

    /// <summary>Clustering: every cell with vertices has one.</summary>
    CellsDone,
}

/// <summary>How many edges were refused at the end, by the first reason that forbids each.</summary>
/// <param name="Topology">The link condition fails: the contraction would change the topology.</param>
/// <param name="Constraint">A locked boundary, a feature or a seam forbids it.</param>
/// <param name="Flip">A face would turn over.</param>
/// <param name="Error">The error would be too large.</param>
public readonly record struct RefusalCounts(int Topology, int Constraint, int Flip, int Error)
{
    /// <summary>All refused edges.</summary>
    public int Total => Topology + Constraint + Flip + Error;
}

/// <summary>What a simplification did.</summary>
/// <param name="StopReason">Why it ended.</param>
/// <param name="FacesBefore">Faces of the input.</param>
/// <param name="FacesAfter">Faces of the result.</param>
/// <param name="Collapses">Edges contracted.</param>
/// <param name="MaxError">The largest error of a contraction, in model units (see <see cref="QuadricOptions.MaxError"/>); of clustering, the longest edge contracted.</param>
/// <param name="Refusals">Edges that were waiting as refused when it ended.</param>
public sealed record SimplificationResult(
    StopReason StopReason, int FacesBefore, int FacesAfter, int Collapses, double MaxError, RefusalCounts Refusals);
