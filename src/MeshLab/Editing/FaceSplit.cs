using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4 面分割 (face split): puts a vertex into a face and joins it to every corner, 1 → n.</summary>
/// <remarks>
/// <code>
///        c                  c
///      /   \              / │ \
///     /     \     ⟶      /  m  \
///    /       \          / /   \ \
///   a ─ h ─→ b         a ─ h ─→ b
/// </code>
/// The face keeps its index with the triangle at its first half-edge <c>h</c>; the other triangles follow counter-clockwise. Any live face can
/// be split, so there is nothing to refuse. Traits: the new faces get copies of the face's; <c>m</c> and its corners get blends of all corners,
/// one after the other with equal weight; the new edges the default. Cost: O(degree).
/// </remarks>
public static class FaceSplit
{
    extension(Face face)
    {
        /// <summary>Puts a vertex at the mean of the face's vertices.</summary>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Vertex Split()
        {
            face.ThrowIfDead();
            Vector3D sum = default;
            int degree = 0;
            HalfEdge h = face.HalfEdge;
            do
            {
                sum += h.Target.Position;
                degree++;
                h = h.Next;
            }
            while (h != face.HalfEdge);
            return Apply(face, sum / degree);
        }

        /// <summary>Puts a vertex into the face.</summary>
        /// <param name="position">Where.</param>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">The face is none or deleted, or the position is not finite.</exception>
        public Vertex Split(Vector3D position)
        {
            face.ThrowIfDead();
            position.ThrowIfNotFinite(nameof(position));
            return Apply(face, position);
        }
    }

    private static Vertex Apply(Face face, Vector3D position)
    {
        Mesh mesh = face.Mesh;
        using OperationScope operation = mesh.BeginOperation(OperationKind.FaceSplit, face.Index);
        Vertex m = mesh.NewVertex(position);
        int first = face.HalfEdge.Index, last = mesh.previous[first];
        int firstSpoke = mesh.NewEdge(mesh.target[last], m.Index);
        BlendCorners(mesh, new(mesh, first), m, new(mesh, firstSpoke));

        // Each side closes its triangle with the spoke from its end to m and the one from m back to its start.
        int side = first, before = last, fromStart = firstSpoke;
        do
        {
            int next = mesh.next[side];
            int fromEnd = side == last ? firstSpoke : NewSpoke(mesh, mesh.target[side], m.Index, firstSpoke);
            int triangle = side == first ? face.Index : NewFaceLike(mesh, face.Index);
            mesh.CopyTraits(ElementKind.HalfEdge, before, fromStart ^ 1);
            mesh.LinkTriangle(triangle, side, fromEnd, fromStart ^ 1);
            (before, side, fromStart) = (side, next, fromEnd);
        }
        while (side != first);
        mesh.SetOutgoing(m.Index, firstSpoke ^ 1);
        operation.Complete();
        return m;
    }

    private static int NewSpoke(Mesh mesh, int corner, int m, int like)
    {
        int spoke = mesh.NewEdge(corner, m);
        mesh.CopyTraits(ElementKind.HalfEdge, like, spoke);
        return spoke;
    }

    private static int NewFaceLike(Mesh mesh, int face)
    {
        Face f = mesh.NewFace();
        mesh.CopyTraits(ElementKind.Face, face, f.Index);
        return f.Index;
    }

    /// <summary>Gives m, and the first corner at it, the mean of all corners of the face, added one by one.</summary>
    private static void BlendCorners(Mesh mesh, HalfEdge first, Vertex m, HalfEdge spoke)
    {
        if (mesh.VertexTraits.Count + mesh.HalfEdgeTraits.Count == 0)
            return;
        mesh.CopyTraits(ElementKind.Vertex, first.Target.Index, m.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, first.Index, spoke.Index);
        int count = 1;
        for (HalfEdge h = first.Next; h != first; h = h.Next)
        {
            double weight = 1.0 / ++count;
            mesh.MixTraits(ElementKind.Vertex, m.Index, m.Index, h.Target.Index, weight);
            mesh.MixTraits(ElementKind.HalfEdge, spoke.Index, spoke.Index, h.Index, weight);
        }
    }
}
