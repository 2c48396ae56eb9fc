using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why two boundary edges cannot be stitched, or two boundary vertices not merged.</summary>
public enum StitchRefusal
{
    /// <summary>They can.</summary>
    None,

    /// <summary>An element does not lie on a boundary, or both are the same.</summary>
    NotBoundary,

    /// <summary>Two vertices that would become one are joined by an edge: collapse it instead.</summary>
    Adjacent,

    /// <summary>Two vertices that would become one have a further neighbour or a face in common: two edges would join the same vertices.</summary>
    LinkCondition,

    /// <summary>The two vertices are not two steps apart along one hole: two fans of faces would touch in the merged vertex only.</summary>
    Pinch,
}

/// <summary>§4.8 缝合边界边 (stitch boundary edges), 合并边界顶点 (merge boundary vertices).</summary>
/// <remarks>
/// <code>
///    ─ d ←k─ c ─            │         │
///        hole       ⟶     ─ a ──g──→ b ─
///    ─ a ─g→ b ─            │         │
/// </code>
/// Stitching glues the boundary half-edge k to g in opposite directions: d becomes a, c becomes b, at the midpoints; g's edge stays. Where
/// this leaves a hole of two edges it is closed as well. Merging two vertices closes the hole between them: they must be the ends of two
/// consecutive boundary edges, which become one. Any other two boundary vertices would hang together in a vertex only.
/// Traits: merged vertices and edges get the even blend. Cost: O(sum of the valences of the four ends).
/// </remarks>
public static class BoundaryStitch
{
    extension(HalfEdge halfEdge)
    {
        /// <summary>Whether <c>Stitch</c> would succeed; the mesh is not touched.</summary>
        /// <param name="other">The boundary half-edge to glue to this one.</param>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">A half-edge is none, deleted, or of another mesh.</exception>
        public bool CanStitch(HalfEdge other, out StitchRefusal why) => (why = Examine(halfEdge, other)) == StitchRefusal.None;

        /// <summary>Stitches two boundary edges, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="other">The boundary half-edge to glue to this one.</param>
        /// <param name="why">The reason if they were not stitched.</param>
        /// <exception cref="ArgumentException">A half-edge is none, deleted, or of another mesh.</exception>
        public bool TryStitch(HalfEdge other, out StitchRefusal why)
        {
            why = Examine(halfEdge, other);
            if (why != StitchRefusal.None)
                return false;
            using OperationScope operation = halfEdge.Mesh.BeginOperation(OperationKind.StitchEdges, halfEdge.Edge.Index);
            Apply(halfEdge, other);
            operation.Complete();
            return true;
        }

        /// <summary>Stitches two boundary edges; this one stays.</summary>
        /// <param name="other">The boundary half-edge to glue to this one.</param>
        /// <exception cref="ArgumentException">A half-edge is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be stitched; the message names the half-edges and the reason.</exception>
        public void Stitch(HalfEdge other)
        {
            if (!halfEdge.TryStitch(other, out StitchRefusal why))
                throw new TopologyException($"{halfEdge} and {other} cannot be stitched: {why}.", halfEdge.ToString(), other.ToString());
        }
    }

    extension(Vertex vertex)
    {
        /// <summary>Whether <c>Merge</c> would succeed; the mesh is not touched.</summary>
        /// <param name="other">The vertex to merge into this one.</param>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        public bool CanMerge(Vertex other, out StitchRefusal why) => (why = Examine(vertex, other, out _)) == StitchRefusal.None;

        /// <summary>Merges two boundary vertices, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="other">The vertex to merge into this one.</param>
        /// <param name="why">The reason if they were not merged.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        public bool TryMerge(Vertex other, out StitchRefusal why)
        {
            why = Examine(vertex, other, out HalfEdge side);
            if (why != StitchRefusal.None)
                return false;
            using OperationScope operation = vertex.Mesh.BeginOperation(OperationKind.MergeVertices, vertex.Index);
            if (side.Source == vertex)
                Apply(side, side.Next);
            else
                Apply(side.Next, side);
            operation.Complete();
            return true;
        }

        /// <summary>Merges two boundary vertices; this one stays.</summary>
        /// <param name="other">The vertex to merge into this one.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be merged; the message names the vertices and the reason.</exception>
        public void Merge(Vertex other)
        {
            if (!vertex.TryMerge(other, out StitchRefusal why))
                throw new TopologyException($"{vertex} and {other} cannot be merged: {why}.", vertex.ToString(), other.ToString());
        }
    }

    private static StitchRefusal Examine(Vertex v, Vertex w, out HalfEdge side)
    {
        v.ThrowIfDead();
        v.Mesh.CheckOwn(w, nameof(w));
        side = default;
        if (!v.IsBoundary || !w.IsBoundary || v == w)
            return StitchRefusal.NotBoundary;
        if (v.IsNeighborOf(w))
            return StitchRefusal.Adjacent;
        if (v.Outgoing.Next.Target == w)
            side = v.Outgoing;
        else if (w.Outgoing.Next.Target == v)
            side = w.Outgoing;
        return side.IsNone ? StitchRefusal.Pinch : Examine(side, side.Next);
    }

    private static StitchRefusal Examine(HalfEdge g, HalfEdge k)
    {
        g.ThrowIfDead();
        g.Mesh.CheckOwn(k, nameof(k));
        if (!g.IsBoundary || !k.IsBoundary || g == k)
            return StitchRefusal.NotBoundary;
        Vertex a = g.Source, b = g.Target, c = k.Source, d = k.Target;
        if ((a != d && a.IsNeighborOf(d)) || (b != c && b.IsNeighborOf(c)))
            return StitchRefusal.Adjacent;
        // a–c or d–b beside a–b and d–c would join the merged ends twice.
        if (a != d && b != c && (a.IsNeighborOf(c) || d.IsNeighborOf(b)))
            return StitchRefusal.LinkCondition;
        bool collides = (a != d && Collide(a, d, g.Previous, k.Next, b == c ? b : default))
            || (b != c && Collide(b, c, k.Previous, g.Next, a == d ? a : default));
        return collides ? StitchRefusal.LinkCondition : StitchRefusal.None;
    }

    /// <summary>Whether two vertices to be merged have a neighbour in common, other than the one shared by both edges and the one across
    /// a hole of two edges that will be closed, or a face.</summary>
    private static bool Collide(Vertex v, Vertex w, HalfEdge into, HalfEdge outOf, Vertex shared)
    {
        // into ends at v or w, outOf leaves the other: if they meet at their far ends, they will be stitched too.
        Vertex closing = outOf.Next == into ? outOf.Target : default;
        var aroundV = new HashSet<Vertex>();
        var facesOfV = new HashSet<Face>();
        foreach (HalfEdge h in v.OutgoingHalfEdges)
        {
            aroundV.Add(h.Target);
            if (!h.IsBoundary)
                facesOfV.Add(h.Face);
        }
        foreach (HalfEdge h in w.OutgoingHalfEdges)
        {
            if (h.Target != shared && h.Target != closing && aroundV.Contains(h.Target))
                return true;
            if (!h.IsBoundary && facesOfV.Contains(h.Face))
                return true;
        }
        return false;
    }

    /// <summary>Glues k to g: first the ends, then the edges; then what became a hole of two edges.</summary>
    private static void Apply(HalfEdge g, HalfEdge k)
    {
        Mesh mesh = g.Mesh;
        Vertex a = g.Source, b = g.Target, c = k.Source, d = k.Target;
        HalfEdge beforeG = g.Previous, afterG = g.Next, beforeK = k.Previous, afterK = k.Next;
        bool closesAtA = a != d && afterK.Next == beforeG, closesAtB = b != c && afterG.Next == beforeK;
        if (a != d)
            mesh.SetNext(beforeG, afterK);
        if (b != c)
            mesh.SetNext(beforeK, afterG);
        TakePlaceOf(mesh, g, k.Twin);
        MergeInto(mesh, a, d, g);
        MergeInto(mesh, b, c, g.Twin);
        mesh.MixTraits(ElementKind.Edge, g.Edge.Index, g.Edge.Index, k.Edge.Index, 0.5);
        mesh.DeleteEdgeSlot(k.Edge.Index);
        mesh.AdjustOutgoing(a, g);
        mesh.AdjustOutgoing(b, g.Twin);
        if (closesAtA)
            Apply(beforeG, afterK);
        if (closesAtB)
            Apply(afterG, beforeK);
    }

    private static void TakePlaceOf(Mesh mesh, HalfEdge g, HalfEdge inner)
    {
        Face f = inner.Face;
        mesh.CopyTraits(ElementKind.HalfEdge, inner.Index, g.Index);
        mesh.SetNext(inner.Previous, g);
        mesh.SetNext(g, inner.Next);
        mesh.SetFace(g, f);
        if (f.HalfEdge == inner)
            mesh.SetHalfEdge(f, g);
    }

    /// <summary>Makes every half-edge into <paramref name="gone"/> point to <paramref name="kept"/>, at the middle of both. The fans are linked already;
    /// <paramref name="leaving"/> leaves the merged vertex.</summary>
    private static void MergeInto(Mesh mesh, Vertex kept, Vertex gone, HalfEdge leaving)
    {
        if (kept == gone)
            return;
        mesh.MixTraits(ElementKind.Vertex, kept.Index, kept.Index, gone.Index, 0.5);
        mesh.SetPosition(kept, (kept.Position + gone.Position) * 0.5);
        HalfEdge h = leaving;
        do
        {
            mesh.SetTarget(h.Twin, kept);
            h = h.Twin.Next;
        }
        while (h != leaving);
        mesh.DeleteVertexSlot(gone.Index);
    }
}
