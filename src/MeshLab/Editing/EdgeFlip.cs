using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why an edge cannot be flipped.</summary>
public enum FlipRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>The edge has a face on one side only (边界边).</summary>
    Boundary,

    /// <summary>A face beside the edge is not a triangle.</summary>
    NotTriangles,

    /// <summary>The two opposite vertices are joined by an edge already, or are one vertex.</summary>
    DiagonalExists,

    /// <summary>An inner end has only three edges and would be left with two. Its third face is a polygon: were it a triangle, the diagonal would exist.</summary>
    EndOfValenceThree,
}

/// <summary>§4.7 切换边 (edge flip): gives the two triangles beside an edge the other diagonal.</summary>
/// <remarks>
/// <code>
///        c                  c
///      /   \              / | \
///    a ─ h→ b     ⟶     a   h   b
///      \   /              \ | /
///        d                  d
/// </code>
/// The edge and both faces keep their indices; <c>a</c> and <c>b</c> lose one neighbour, <c>c</c> and <c>d</c> gain one. The half-edge <c>h</c>
/// now goes from <c>d</c> to <c>c</c>. Nothing moves, so the surface changes only where the quadrilateral is not flat: see
/// <see cref="FlipGeometry"/> for the test of folds.
/// Traits stay with their elements; the corners at <c>c</c> and <c>d</c> that the flip opens get the values of the corners there.
/// Cost: O(valence of c) to look for the diagonal, O(1) to flip. Hoppe, DeRose, Duchamp, McDonald, Stuetzle 1993, §3.2 ("edge swap").
/// </remarks>
public static class EdgeFlip
{
    extension(Edge edge)
    {
        /// <summary>Whether <see cref="Flip"/> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool CanFlip(out FlipRefusal why) => (why = Examine(edge)) == FlipRefusal.None;

        /// <summary>Flips the edge, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not flipped.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public bool TryFlip(out FlipRefusal why)
        {
            why = Examine(edge);
            if (why != FlipRefusal.None)
                return false;
            Apply(edge);
            return true;
        }

        /// <summary>Flips the edge.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be flipped; the message names the edge and the reason.</exception>
        public void Flip()
        {
            if (!edge.TryFlip(out FlipRefusal why))
                throw new TopologyException($"{edge} cannot be flipped: {why}.", edge.ToString());
        }
    }

    // Flips are the commonest operation, so these two go down to the columns; the names are those of the drawing.
    private static FlipRefusal Examine(Edge edge)
    {
        edge.ThrowIfDead();
        Mesh mesh = edge.Mesh;
        int[] next = mesh.next, target = mesh.target, face = mesh.face;
        int h = 2 * edge.index, t = h + 1;
        if (face[h] < 0 || face[t] < 0)
            return FlipRefusal.Boundary;

        int bc = next[h], ca = next[bc], ad = next[t], db = next[ad];
        if (next[ca] != h || next[db] != t)
            return FlipRefusal.NotTriangles;

        int a = target[t], b = target[h], c = target[bc], d = target[ad];
        // c = d is a pair of triangles glued along two edges; joining c to itself would leave the manifold.
        if (c == d || mesh.FindHalfEdge(c, d) >= 0)
            return FlipRefusal.DiagonalExists;

        // With three spokes, the one after a → c is a → d.
        int[] previous = mesh.previous;
        bool threeAtA = previous[ca ^ 1] == (ad ^ 1) && face[mesh.outgoing[a]] >= 0;
        bool threeAtB = previous[db ^ 1] == (bc ^ 1) && face[mesh.outgoing[b]] >= 0;
        return threeAtA || threeAtB ? FlipRefusal.EndOfValenceThree : FlipRefusal.None;
    }

    private static void Apply(Edge edge)
    {
        Mesh mesh = edge.Mesh;
        int h = 2 * edge.index, t = h + 1;
        int bc = mesh.next[h], ca = mesh.next[bc], ad = mesh.next[t], db = mesh.next[ad];
        int a = mesh.target[t], b = mesh.target[h], c = mesh.target[bc], d = mesh.target[ad];

        using OperationScope operation = mesh.BeginOperation(OperationKind.EdgeFlip, edge.index);
        mesh.CopyTraits(ElementKind.HalfEdge, bc, h);
        mesh.CopyTraits(ElementKind.HalfEdge, ad, t);
        mesh.SetTarget(h, c);
        mesh.SetTarget(t, d);
        mesh.LinkTriangle(mesh.face[h], h, ca, ad);
        mesh.LinkTriangle(mesh.face[t], t, db, bc);
        // An inner vertex may have any outgoing half-edge; a boundary vertex's is neither h nor t.
        if (mesh.outgoing[a] == h)
            mesh.SetOutgoing(a, ad);
        if (mesh.outgoing[b] == t)
            mesh.SetOutgoing(b, bc);
        operation.Complete();
    }
}
