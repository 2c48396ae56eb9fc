using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why two faces cannot be joined across an edge.</summary>
public enum JoinRefusal
{
    /// <summary>They can.</summary>
    None,

    /// <summary>The edge has a face on one side only.</summary>
    Boundary,

    /// <summary>The two faces have no edge in common.</summary>
    NoCommonEdge,

    /// <summary>The two faces have a further vertex in common: the joined face would have it twice, or enclose something.</summary>
    SharesMoreThanTheEdge,
}

/// <summary>§4.3 消去边, 合并面 (dissolve edge, join faces): the two faces of an edge become one polygon. Inverse of <see cref="FaceCut"/>.</summary>
/// <remarks>
/// <code>
///    d ── c ── f            d ── c ── f
///    │  F h  G │     ⟶      │    F    │
///    a ── b ── e            a ── b ── e
/// </code>
/// The face F to the left of the edge's first half-edge keeps its index and traits. −1 E, −1 F. Cost: O(degree of both, plus valences of F's vertices).
/// </remarks>
public static class EdgeDissolve
{
    extension(Edge edge)
    {
        /// <summary>Whether <c>Dissolve</c> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool CanDissolve(out JoinRefusal why) => (why = Examine(edge)) == JoinRefusal.None;

        /// <summary>Joins the two faces of the edge, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not dissolved.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool TryDissolve(out JoinRefusal why)
        {
            why = Examine(edge);
            if (why != JoinRefusal.None)
                return false;
            Apply(edge.HalfEdge0, OperationKind.DissolveEdge);
            return true;
        }

        /// <summary>Joins the two faces of the edge.</summary>
        /// <returns>The joined face.</returns>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        /// <exception cref="TopologyException">They cannot be joined; the message names the edge and the reason.</exception>
        public Face Dissolve()
        {
            Face joined = edge.IsNone ? default : edge.Face0;
            if (!edge.TryDissolve(out JoinRefusal why))
                throw new TopologyException($"{edge} cannot be dissolved: {why}.", edge.ToString());
            return joined;
        }
    }

    extension(Face face)
    {
        /// <summary>Joins the face with a neighbour, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="other">The neighbour; it is deleted.</param>
        /// <param name="why">The reason if they were not joined.</param>
        /// <exception cref="ArgumentException">A face is none, deleted, or of another mesh.</exception>
        public bool TryJoin(Face other, out JoinRefusal why)
        {
            face.ThrowIfDead();
            face.Mesh.CheckOwn(other, nameof(other));
            foreach (HalfEdge h in face.HalfEdges)
            {
                if (face == other || h.Twin.Face != other)
                    continue;
                why = Examine(h.Edge);
                if (why == JoinRefusal.None)
                    Apply(h, OperationKind.JoinFaces);
                return why == JoinRefusal.None;
            }
            why = JoinRefusal.NoCommonEdge;
            return false;
        }

        /// <summary>Joins the face with a neighbour; the face keeps its index and traits.</summary>
        /// <param name="other">The neighbour; it is deleted.</param>
        /// <exception cref="ArgumentException">A face is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be joined; the message names the faces and the reason.</exception>
        public void Join(Face other)
        {
            if (!face.TryJoin(other, out JoinRefusal why))
                throw new TopologyException($"{face} and {other} cannot be joined: {why}.", face.ToString(), other.ToString());
        }
    }

    private static JoinRefusal Examine(Edge edge)
    {
        edge.ThrowIfDead();
        if (edge.IsBoundary)
            return JoinRefusal.Boundary;
        // Every vertex of the left face that has the right face too must be an end of the edge.
        HalfEdge h = edge.HalfEdge0;
        Face right = h.Twin.Face;
        for (HalfEdge k = h.Next; k != h.Previous; k = k.Next)
        {
            foreach (Face f in k.Target.Faces)
            {
                if (f == right)
                    return JoinRefusal.SharesMoreThanTheEdge;
            }
        }
        return right == h.Face ? JoinRefusal.SharesMoreThanTheEdge : JoinRefusal.None;
    }

    private static void Apply(HalfEdge h, OperationKind kind)
    {
        Mesh mesh = h.Mesh;
        HalfEdge t = h.Twin;
        Face left = h.Face, right = t.Face;
        using OperationScope operation = mesh.BeginOperation(kind, kind == OperationKind.JoinFaces ? left.Index : h.Edge.Index);
        for (HalfEdge k = t.Next; k != t; k = k.Next)
            mesh.SetFace(k, left);
        if (left.HalfEdge == h)
            mesh.SetHalfEdge(left, t.Next);
        // An inner vertex may have any outgoing half-edge; a boundary vertex's is not one with a face.
        if (t.Target.Outgoing == h)
            mesh.SetOutgoing(t.Target, t.Next);
        if (h.Target.Outgoing == t)
            mesh.SetOutgoing(h.Target, h.Next);
        mesh.SetNext(h.Previous, t.Next);
        mesh.SetNext(t.Previous, h.Next);
        mesh.DeleteFaceSlot(right.Index);
        mesh.DeleteEdgeSlot(h.Edge.Index);
        operation.Complete();
    }
}
