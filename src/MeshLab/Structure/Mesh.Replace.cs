using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Replacing a mesh by a part of it that an algorithm worked out on its own copy.</summary>
public sealed partial class Mesh
{
    /// <summary>Takes over columns without deleted elements; traits move along the maps.</summary>
    /// <exception cref="InvalidOperationException">The operations are being recorded.</exception>
    internal void ReplaceConnectivity(
        Vector3D[] newPositions, int[] newNext, int[] newPrevious, int[] newTarget, int[] newFace, int[] newOutgoing, int[] newHalfEdgeOf, CompactionMaps maps)
    {
        if (Listener is not null)
            throw new InvalidOperationException("A mesh cannot be replaced while operations are recorded.");
        (positions, outgoing, halfEdgeOf) = (newPositions, newOutgoing, newHalfEdgeOf);
        (next, previous, target, face) = (newNext, newPrevious, newTarget, newFace);
        vertexCount = vertexSlots = newPositions.Length;
        halfEdgeSlots = newNext.Length;
        edgeCount = halfEdgeSlots / 2;
        faceCount = faceSlots = newHalfEdgeOf.Length;
        CompactTraits(maps);
    }
}
