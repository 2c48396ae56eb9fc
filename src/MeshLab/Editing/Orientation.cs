using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.8 反转方向 (reverse orientation): turns the surface inside out.</summary>
/// <remarks>
/// In place: every element keeps its index, every face its first vertex. A half-edge now runs the other way in the same face. Traits stay with
/// their elements, corner traits with their corners; the textbook's normals (<see cref="TraitNames.Normal"/>) change sign, as they must. O(V + H + F).
/// </remarks>
public static class Orientation
{
    extension(Mesh mesh)
    {
        /// <summary>Turns every face around, so that what was outside is inside.</summary>
        /// <exception cref="InvalidOperationException">The operations are being recorded; reverse again to take it back.</exception>
        public void ReverseOrientation()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            if (mesh.Listener is not null)
                throw new InvalidOperationException("The orientation cannot be reversed while operations are recorded.");
            int[] previous = mesh.Previous.ToArray();
            MoveCorners(mesh);
            TurnLinks(mesh, previous);
            TurnNormals(mesh);
        }
    }

    /// <summary>The corner at a half-edge's old source is the one at its new target: it was the previous half-edge's.</summary>
    private static void MoveCorners(Mesh mesh)
    {
        if (mesh.HalfEdgeTraits.Count == 0)
            return;
        var newPlace = new int[mesh.HalfEdgeSlots];
        for (int h = 0; h < newPlace.Length; h++)
            newPlace[h] = mesh.next[h] >= 0 ? mesh.next[h] : h;
        foreach (Trait trait in mesh.HalfEdgeTraits)
            trait.Permute(newPlace);
    }

    private static void TurnLinks(Mesh mesh, int[] oldPrevious)
    {
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            // The half-edge before the outgoing one arrived at the vertex along the same hole or face; now it leaves.
            if (mesh.outgoing[v] >= 0)
                mesh.outgoing[v] = oldPrevious[mesh.outgoing[v]];
        }
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            if (mesh.halfEdgeOf[f] >= 0)
                mesh.halfEdgeOf[f] = oldPrevious[mesh.halfEdgeOf[f]];
        }
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
            (mesh.next[h], mesh.previous[h]) = (mesh.previous[h], mesh.next[h]);
        for (int h = 0; h < mesh.HalfEdgeSlots; h += 2)
            (mesh.target[h], mesh.target[h + 1]) = (mesh.target[h + 1], mesh.target[h]);
    }

    private static void TurnNormals(Mesh mesh)
    {
        foreach (Trait trait in mesh.VertexTraits.Concat(mesh.HalfEdgeTraits).Concat(mesh.FaceTraits))
        {
            if (trait is not Trait<Vector3D> { Name: TraitNames.Normal } normals)
                continue;
            foreach (ref Vector3D n in normals.Values)
                n = -n;
        }
    }
}
