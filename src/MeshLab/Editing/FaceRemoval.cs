using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.2 删除面 (delete face): a face becomes a hole, or part of the hole beside it.</summary>
/// <remarks>
/// <code>
///    a ──── b ──── c            a ──── b ──── c
///    │  f   │  g   │            │  f   │             the edge b–e has f on one side now;
///    │      │      │     ⟶      │      │             c was left without faces and is deleted,
///    d ──── e ──── ┘            d ──── e             or stays isolated
/// </code>
/// Edges that lose both faces are deleted. A face that touches a boundary only in a vertex cannot be deleted without leaving a bow-tie:
/// refused, or that vertex is split (<see cref="RemovalOptions.SplitPinched"/>); the first fan, counter-clockwise from the old boundary or from
/// the first remaining face, keeps the vertex, the others get copies with its traits.
/// Cost: O(sum of the valences of its vertices).
/// </remarks>
public static class FaceRemoval
{
    extension(Face face)
    {
        /// <summary>Whether <c>Delete</c> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public bool CanDelete(out RemovalRefusal why)
        {
            face.ThrowIfDead();
            return (why = Examine(face)) == RemovalRefusal.None;
        }

        /// <summary>Deletes the face, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not deleted.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public bool TryDelete(out RemovalRefusal why, RemovalOptions? options = null)
        {
            face.ThrowIfDead();
            options ??= RemovalOptions.Default;
            why = options.SplitPinched ? RemovalRefusal.None : Examine(face);
            if (why != RemovalRefusal.None)
                return false;
            Mesh mesh = face.Mesh;
            using OperationScope operation = mesh.BeginOperation(OperationKind.DeleteFace, face.Index);
            RegionRemoval.Remove(mesh, [face.Index], options);
            operation.Complete();
            return true;
        }

        /// <summary>Deletes the face.</summary>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be deleted; the message names the face and the reason.</exception>
        public void Delete(RemovalOptions? options = null)
        {
            if (!face.TryDelete(out RemovalRefusal why, options))
                throw new TopologyException($"{face} cannot be deleted: {why}.", face.ToString());
        }
    }

    /// <summary>At a boundary vertex, the face must lie beside the hole already, or the vertex would have two.</summary>
    private static RemovalRefusal Examine(Face face)
    {
        foreach (HalfEdge h in face.HalfEdges)
        {
            if (h.Target.IsBoundary && !h.Twin.IsBoundary && !h.Next.Twin.IsBoundary)
                return RemovalRefusal.Pinch;
        }
        return RemovalRefusal.None;
    }
}
