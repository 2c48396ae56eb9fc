using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.3 删除边 (delete edge): deletes an edge with the faces beside it, so that their place becomes a hole.</summary>
/// <remarks>
/// <code>
///        c                  c
///      /   \              /   \
///    a ──e── b     ⟶     a  hole b
///      \   /              \   /
///        d                  d
/// </code>
/// To join the two faces instead, see <see cref="EdgeDissolve"/>. Refusals and options as for <see cref="FaceRemoval"/>.
/// </remarks>
public static class EdgeRemoval
{
    extension(Edge edge)
    {
        /// <summary>Whether <c>Delete</c> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool CanDelete(out RemovalRefusal why) => (why = RegionRemoval.Examine(edge.Mesh, FacesBeside(edge))) == RemovalRefusal.None;

        /// <summary>Deletes the edge and its faces, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not deleted.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool TryDelete(out RemovalRefusal why, RemovalOptions? options = null)
        {
            options ??= RemovalOptions.Default;
            int[] faces = FacesBeside(edge);
            why = options.SplitPinched ? RemovalRefusal.None : RegionRemoval.Examine(edge.Mesh, faces);
            if (why != RemovalRefusal.None)
                return false;
            using OperationScope operation = edge.Mesh.BeginOperation(OperationKind.DeleteEdge, edge.Index);
            RegionRemoval.Remove(edge.Mesh, faces, options);
            operation.Complete();
            return true;
        }

        /// <summary>Deletes the edge and its faces.</summary>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be deleted; the message names the edge and the reason.</exception>
        public void Delete(RemovalOptions? options = null)
        {
            if (!edge.TryDelete(out RemovalRefusal why, options))
                throw new TopologyException($"{edge} cannot be deleted: {why}.", edge.ToString());
        }
    }

    private static int[] FacesBeside(Edge edge)
    {
        edge.ThrowIfDead();
        return (edge.Face0.IsNone, edge.Face1.IsNone) switch
        {
            (true, _) => [edge.Face1.Index],
            (_, true) => [edge.Face0.Index],
            _ when edge.Face0 == edge.Face1 => [edge.Face0.Index],
            _ => [edge.Face0.Index, edge.Face1.Index],
        };
    }
}
