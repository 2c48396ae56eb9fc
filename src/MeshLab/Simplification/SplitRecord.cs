using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>One side of a contracted edge: the triangle that vanished, or the place of the half-edge along its border.</summary>
/// <param name="Face">The triangle; −1 on a border.</param>
/// <param name="Kept">Of the triangle's other two half-edges, the one whose edge stayed; on a border the next half-edge along it.</param>
/// <param name="Gone">The one whose edge vanished; on a border the previous half-edge along it.</param>
/// <param name="KeptIsNext">Whether <paramref name="Kept"/> follows the contracted half-edge.</param>
/// <param name="FaceHalfEdge">The triangle's first half-edge.</param>
/// <param name="OuterHalfEdge">The first half-edge of the face beyond the vanished edge.</param>
/// <param name="Apex">The third vertex.</param>
/// <param name="ApexOutgoing">Its outgoing half-edge before.</param>
internal readonly record struct SplitSide(
    int Face, int Kept, int Gone, bool KeptIsNext, int FaceHalfEdge, int OuterHalfEdge, int Apex, int ApexOutgoing);

/// <summary>All that is needed to contract an edge and to split the vertex again, exactly.</summary>
/// <param name="HalfEdge">The half-edge from the vanished vertex to the kept one.</param>
/// <param name="Removed">The vanished vertex.</param>
/// <param name="Kept">The kept vertex.</param>
/// <param name="RemovedOutgoing">The vanished vertex's outgoing half-edge before.</param>
/// <param name="KeptOutgoing">The kept vertex's outgoing half-edge before.</param>
/// <param name="Left">The side of the half-edge.</param>
/// <param name="Right">The side of its twin.</param>
internal readonly record struct SplitRecord(
    int HalfEdge, int Removed, int Kept, int RemovedOutgoing, int KeptOutgoing, SplitSide Left, SplitSide Right)
{
    /// <summary>How many faces the contraction removes.</summary>
    public int Faces => (Left.Face >= 0 ? 1 : 0) + (Right.Face >= 0 ? 1 : 0);
}
