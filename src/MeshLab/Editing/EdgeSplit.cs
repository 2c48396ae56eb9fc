using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why an edge cannot be split.</summary>
public enum EdgeSplitRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>The triangles on both sides have the same third vertex: the new vertex would be joined to it twice.</summary>
    SameApex,
}

/// <summary>§4.8 边分割 (edge split): puts a vertex on an edge. Triangles beside it become two; polygons only get the vertex.</summary>
/// <remarks>
/// <code>
///        c                  c
///      /   \              / | \
///    a ─ h→ b     ⟶     a ─h→m─n→ b
///      \   /              \ | /
///        d                  d
/// </code>
/// The edge keeps its index with the part at <c>a</c>, its faces keep theirs with the triangles at <c>a</c>. New: <c>m</c>, the edge <c>m–b</c>,
/// and for each triangle one more edge and one more face. Outer edges too. Refused only where the two triangles have the same apex.
/// Traits: <c>m</c> and its corners get blends of those at <c>a</c> and <c>b</c>, by where the point lies along the edge; the new part of
/// the edge and the new faces get copies; the edges to <c>c</c> and <c>d</c> the default. Cost: O(1).
/// </remarks>
public static class EdgeSplit
{
    extension(Edge edge)
    {
        /// <summary>Whether <c>Split</c> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool CanSplit(out EdgeSplitRefusal why) => (why = Examine(edge)) == EdgeSplitRefusal.None;

        /// <summary>Puts a vertex on the edge, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="position">Where it lies; it need not be on the straight line.</param>
        /// <param name="created">The new vertex.</param>
        /// <param name="why">The reason if the edge was not split.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted, or the position is not finite.</exception>
        public bool TrySplit(Vector3D position, out Vertex created, out EdgeSplitRefusal why)
        {
            position.ThrowIfNotFinite(nameof(position));
            why = Examine(edge);
            created = default;
            if (why != EdgeSplitRefusal.None)
                return false;
            created = Apply(edge, position, position.ParameterBetween(edge.Vertex0.Position, edge.Vertex1.Position));
            return true;
        }

        /// <summary>Puts a vertex on the middle of the edge.</summary>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be split; the message names the edge and the reason.</exception>
        public Vertex Split()
        {
            ThrowIfRefused(edge);
            return Apply(edge, (edge.Vertex0.Position + edge.Vertex1.Position) * 0.5, 0.5);
        }

        /// <summary>Puts a vertex on the edge.</summary>
        /// <param name="position">Where it lies; it need not be on the straight line.</param>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">The edge is none or deleted, or the position is not finite.</exception>
        /// <exception cref="TopologyException">It cannot be split; the message names the edge and the reason.</exception>
        public Vertex Split(Vector3D position)
        {
            position.ThrowIfNotFinite(nameof(position));
            ThrowIfRefused(edge);
            return Apply(edge, position, position.ParameterBetween(edge.Vertex0.Position, edge.Vertex1.Position));
        }
    }

    private static EdgeSplitRefusal Examine(Edge edge)
    {
        edge.ThrowIfDead();
        HalfEdge h = edge.HalfEdge0, back = h.Twin;
        bool twoTriangles = !h.IsBoundary && !back.IsBoundary && h.Next.Next.Next == h && back.Next.Next.Next == back;
        return twoTriangles && h.Next.Target == back.Next.Target ? EdgeSplitRefusal.SameApex : EdgeSplitRefusal.None;
    }

    private static void ThrowIfRefused(Edge edge)
    {
        EdgeSplitRefusal why = Examine(edge);
        if (why != EdgeSplitRefusal.None)
            throw new TopologyException($"{edge} cannot be split: {why}.", edge.ToString());
    }

    private static Vertex Apply(Edge edge, Vector3D position, double t)
    {
        Mesh mesh = edge.Mesh;
        using OperationScope operation = mesh.BeginOperation(OperationKind.EdgeSplit, edge.Index);

        HalfEdge h = edge.HalfEdge0, back = h.Twin;
        Vertex a = back.Target, b = h.Target;
        Face left = h.Face, right = back.Face;
        HalfEdge bc = h.Next, db = back.Previous;

        Vertex m = mesh.NewVertex(position);
        HalfEdge n = mesh.NewEdge(m, b), nBack = n.Twin;
        mesh.MixTraits(ElementKind.Vertex, m.Index, a.Index, b.Index, t);
        mesh.CopyTraits(ElementKind.Edge, edge.Index, n.Edge.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, h.Index, n.Index);
        mesh.MixTraits(ElementKind.HalfEdge, h.Index, h.Previous.Index, h.Index, t);
        mesh.MixTraits(ElementKind.HalfEdge, nBack.Index, back.Index, db.Index, t);

        mesh.SetTarget(h, m);
        mesh.SetNext(n, bc);
        mesh.SetNext(h, n);
        mesh.SetNext(db, nBack);
        mesh.SetNext(nBack, back);
        mesh.SetFace(n, left);
        mesh.SetFace(nBack, right);
        mesh.SetOutgoing(m, right.IsNone ? back : n);
        if (b.Outgoing == back)
            mesh.SetOutgoing(b, nBack);

        // A triangle has become a quad a → m → b → c; the diagonal from m makes it two triangles.
        if (!left.IsNone && bc.Next.Next == h)
            CutOff(mesh, left, n, bc);
        if (!right.IsNone && back.Next.Next == db)
            CutOff(mesh, right, db, nBack);
        operation.Complete();
        return m;
    }

    /// <summary>Makes the two half-edges a triangle of their own, closed by a new edge; the rest stays with the face.</summary>
    private static void CutOff(Mesh mesh, Face face, HalfEdge first, HalfEdge second)
    {
        HalfEdge before = first.Previous, after = second.Next;
        Face cut = mesh.NewFace();
        HalfEdge inner = mesh.NewEdge(second.Target, before.Target), outer = inner.Twin;
        mesh.CopyTraits(ElementKind.Face, face.Index, cut.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, before.Index, inner.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, second.Index, outer.Index);

        mesh.SetNext(before, outer);
        mesh.SetNext(outer, after);
        mesh.SetFace(outer, face);
        if (face.HalfEdge == first || face.HalfEdge == second)
            mesh.SetHalfEdge(face, before);
        mesh.LinkTriangle(cut, first, second, inner);
    }
}
