using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why a vertex cannot be split.</summary>
public enum VertexSplitRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>One of the two vertices is not a neighbour of the vertex.</summary>
    NotNeighbor,

    /// <summary>Both neighbours are the same, or neither is given: there are no two sectors.</summary>
    OneSector,

    /// <summary>A neighbour is left out, which stands for the hole, but the vertex has no hole.</summary>
    NoHole,
}

/// <summary>§4.5 分割点 (vertex split): one vertex becomes two, joined by a new edge with a triangle on each side.</summary>
/// <remarks>
/// <code>
///      \   a   /              \   a   /
///        \ | /                  / \
///      ─── v ───      ⟶     ─ w ─── v ─
///        / | \                  \ /
///      /   b   \              /   b   \
/// </code>
/// Counter-clockwise around v, the new vertex w takes the sector from <c>a</c> to <c>b</c>, v keeps the sector from <c>b</c> to <c>a</c>; both keep
/// the two limiting spokes, those of v with their indices. New triangles: (v, a, w) and (w, b, v). +1 V, +3 E, +2 F.
/// A boundary vertex can also be split towards its hole: leave out <c>a</c> or <c>b</c> (<see langword="default"/>), then the new edge v–w
/// lies on the boundary and there is one triangle: +1 V, +2 E, +1 F.
/// Exact inverse of <see cref="EdgeCollapse"/>: collapsing the half-edge from w to v, with v put back in its place, gives the old connectivity again.
/// Traits: w and the new spokes, corners and faces get copies of what they were split from; the edge v–w the default. Cost: O(valence).
/// Hoppe 1996, §3.
/// </remarks>
public static class VertexSplit
{
    /// <summary>How far the default positions go from the vertex to the middle neighbour of each sector.</summary>
    private const double DefaultStep = 0.3;

    extension(Vertex vertex)
    {
        /// <summary>Whether a split would succeed; the mesh is not touched.</summary>
        /// <param name="a">Where the new vertex's sector begins, counter-clockwise; <see langword="default"/> for the hole.</param>
        /// <param name="b">Where it ends; <see langword="default"/> for the hole.</param>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">A vertex is deleted or of another mesh.</exception>
        public bool CanSplit(Vertex a, Vertex b, out VertexSplitRefusal why) =>
            (why = Examine(vertex, a, b, out _, out _)) == VertexSplitRefusal.None;

        /// <summary>Splits the vertex, or leaves the mesh exactly as it was and says why. Both positions are 0.7 of the vertex and 0.3 of the
        /// middle neighbour in each sector.</summary>
        /// <param name="a">Where the new vertex's sector begins, counter-clockwise; <see langword="default"/> for the hole.</param>
        /// <param name="b">Where it ends; <see langword="default"/> for the hole.</param>
        /// <param name="created">The new vertex.</param>
        /// <param name="why">The reason if it was not split.</param>
        /// <exception cref="ArgumentException">A vertex is deleted or of another mesh.</exception>
        public bool TrySplit(Vertex a, Vertex b, out Vertex created, out VertexSplitRefusal why)
        {
            created = default;
            why = Examine(vertex, a, b, out HalfEdge toA, out HalfEdge toB);
            if (why != VertexSplitRefusal.None)
                return false;
            Vector3D p = vertex.Position;
            Vector3D kept = Vector3D.Lerp(p, MiddleNeighbor(vertex, toB, toA).Position, DefaultStep);
            Vector3D moved = Vector3D.Lerp(p, MiddleNeighbor(vertex, toA, toB).Position, DefaultStep);
            created = Apply(vertex, toA, toB, kept, moved);
            return true;
        }

        /// <summary>Splits the vertex, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="a">Where the new vertex's sector begins, counter-clockwise; <see langword="default"/> for the hole.</param>
        /// <param name="b">Where it ends; <see langword="default"/> for the hole.</param>
        /// <param name="position">Where this vertex goes.</param>
        /// <param name="newPosition">Where the new vertex lies.</param>
        /// <param name="created">The new vertex.</param>
        /// <param name="why">The reason if it was not split.</param>
        /// <exception cref="ArgumentException">A vertex is deleted or of another mesh, or a position is not finite.</exception>
        public bool TrySplit(Vertex a, Vertex b, Vector3D position, Vector3D newPosition, out Vertex created, out VertexSplitRefusal why)
        {
            position.ThrowIfNotFinite(nameof(position));
            newPosition.ThrowIfNotFinite(nameof(newPosition));
            created = default;
            why = Examine(vertex, a, b, out HalfEdge toA, out HalfEdge toB);
            if (why != VertexSplitRefusal.None)
                return false;
            created = Apply(vertex, toA, toB, position, newPosition);
            return true;
        }

        /// <summary>Splits the vertex. Both positions are 0.7 of the vertex and 0.3 of the middle neighbour in each sector.</summary>
        /// <param name="a">Where the new vertex's sector begins, counter-clockwise; <see langword="default"/> for the hole.</param>
        /// <param name="b">Where it ends; <see langword="default"/> for the hole.</param>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">A vertex is deleted or of another mesh.</exception>
        /// <exception cref="TopologyException">It cannot be split; the message names the vertices and the reason.</exception>
        public Vertex Split(Vertex a, Vertex b) => vertex.TrySplit(a, b, out Vertex created, out VertexSplitRefusal why)
            ? created
            : throw Refused(vertex, a, b, why);

        /// <summary>Splits the vertex.</summary>
        /// <param name="a">Where the new vertex's sector begins, counter-clockwise; <see langword="default"/> for the hole.</param>
        /// <param name="b">Where it ends; <see langword="default"/> for the hole.</param>
        /// <param name="position">Where this vertex goes.</param>
        /// <param name="newPosition">Where the new vertex lies.</param>
        /// <returns>The new vertex.</returns>
        /// <exception cref="ArgumentException">A vertex is deleted or of another mesh, or a position is not finite.</exception>
        /// <exception cref="TopologyException">It cannot be split; the message names the vertices and the reason.</exception>
        public Vertex Split(Vertex a, Vertex b, Vector3D position, Vector3D newPosition) =>
            vertex.TrySplit(a, b, position, newPosition, out Vertex created, out VertexSplitRefusal why)
                ? created
                : throw Refused(vertex, a, b, why);
    }

    private static TopologyException Refused(Vertex v, Vertex a, Vertex b, VertexSplitRefusal why) =>
        new($"{v} cannot be split between {a} and {b}: {why}.", v.ToString(), a.ToString(), b.ToString());

    private static VertexSplitRefusal Examine(Vertex v, Vertex a, Vertex b, out HalfEdge toA, out HalfEdge toB)
    {
        v.ThrowIfDead();
        toA = toB = default;
        if (a == b)
            return VertexSplitRefusal.OneSector;
        if ((a.IsNone || b.IsNone) && !v.IsBoundary)
            return VertexSplitRefusal.NoHole;
        if (!a.IsNone)
            toA = v.Mesh.FindHalfEdge(v, a);
        if (!b.IsNone)
            toB = v.Mesh.FindHalfEdge(v, b);
        return (toA.IsNone && !a.IsNone) || (toB.IsNone && !b.IsNone) ? VertexSplitRefusal.NotNeighbor : VertexSplitRefusal.None;
    }

    /// <summary>The middle one of the neighbours counter-clockwise from one spoke to another, ends included; a missing end is the hole.</summary>
    private static Vertex MiddleNeighbor(Vertex v, HalfEdge from, HalfEdge to)
    {
        HalfEdge first = from.IsNone ? v.Outgoing.Previous.Twin : from, last = to.IsNone ? v.Outgoing : to;
        int steps = 0;
        for (HalfEdge h = first; h != last; h = h.Previous.Twin)
            steps++;
        for (int i = 0; i < (steps + 1) / 2; i++)
            first = first.Previous.Twin;
        return first.Target;
    }

    private static Vertex Apply(Vertex v, HalfEdge toA, HalfEdge toB, Vector3D position, Vector3D newPosition)
    {
        Mesh mesh = v.Mesh;
        using OperationScope operation = mesh.BeginOperation(OperationKind.VertexSplit, v.Index);
        Vertex w = mesh.NewVertex(newPosition);
        mesh.CopyTraits(ElementKind.Vertex, v.Index, w.Index);
        mesh.SetPosition(v, position);

        HalfEdge intoHole = v.Outgoing.Previous;
        MoveInnerSpokes(mesh, toA.IsNone ? intoHole.Twin : toA, toB.IsNone ? v.Outgoing : toB, includeFirst: toA.IsNone, includeLast: toB.IsNone, w);
        HalfEdge vw = mesh.NewEdge(v, w);
        if (!toA.IsNone)
            OpenAtA(mesh, toA, w, vw.Twin);
        if (!toB.IsNone)
            OpenAtB(mesh, toB, w, vw);
        LinkHole(mesh, toA, toB, v, vw, intoHole);
        mesh.AdjustOutgoing(w, vw.Twin);
        mesh.AdjustOutgoing(v, vw);
        operation.Complete();
        return w;
    }

    /// <summary>Gives the spokes between two limits to the new vertex.</summary>
    private static void MoveInnerSpokes(Mesh mesh, HalfEdge first, HalfEdge last, bool includeFirst, bool includeLast, Vertex w)
    {
        for (HalfEdge spoke = first; ; spoke = spoke.Previous.Twin)
        {
            bool isFirst = spoke == first, isLast = spoke == last;
            if ((includeFirst || !isFirst) && (includeLast || !isLast))
                mesh.SetTarget(spoke.Twin, w);
            if (isLast)
                return;
        }
    }

    /// <summary>A new spoke from w takes the place of v → a in the sector; the triangle (v, a, w) lies between the two.</summary>
    private static void OpenAtA(Mesh mesh, HalfEdge va, Vertex w, HalfEdge wv)
    {
        HalfEdge aw = mesh.NewEdge(va.Target, w), wa = aw.Twin;
        mesh.CopyTraits(ElementKind.Edge, va.Edge.Index, wa.Edge.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, va.Index, wa.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, va.IsBoundary ? va.Twin.Index : va.Previous.Index, aw.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, va.Twin.IsBoundary ? aw.Index : va.Twin.Index, wv.Index);
        Face triangle = NewFaceLike(mesh, va.IsBoundary ? va.Twin.Face : va.Face);
        TakePlace(mesh, va, wa);
        mesh.LinkTriangle(triangle, va, aw, wv);
    }

    /// <summary>A new spoke from w takes the place of v → b in the sector; the triangle (v, w, b) lies between the two.</summary>
    private static void OpenAtB(Mesh mesh, HalfEdge vb, Vertex w, HalfEdge vw)
    {
        HalfEdge bv = vb.Twin, bw = mesh.NewEdge(vb.Target, w), wb = bw.Twin;
        mesh.CopyTraits(ElementKind.Edge, vb.Edge.Index, bw.Edge.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, bv.Index, bw.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, bv.Index, vw.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, vb.IsBoundary ? bv.Previous.Index : vb.Index, wb.Index);
        Face triangle = NewFaceLike(mesh, bv.IsBoundary ? vb.Face : bv.Face);
        TakePlace(mesh, bv, bw);
        if (vb.Target.Outgoing == bv)
            mesh.SetOutgoing(vb.Target, bw);
        mesh.LinkTriangle(triangle, vw, wb, bv);
    }

    /// <summary>Puts one half-edge where another is along its face or hole.</summary>
    private static void TakePlace(Mesh mesh, HalfEdge old, HalfEdge taker)
    {
        Face f = old.Face;
        mesh.SetNext(old.Previous, taker);
        mesh.SetNext(taker, old.Next);
        mesh.SetFace(taker, f);
        if (!f.IsNone && f.HalfEdge == old)
            mesh.SetHalfEdge(f, taker);
    }

    /// <summary>Towards the hole, the side of the new edge without a triangle becomes part of the boundary loop.</summary>
    private static void LinkHole(Mesh mesh, HalfEdge toA, HalfEdge toB, Vertex v, HalfEdge vw, HalfEdge intoHole)
    {
        if (toA.IsNone)
        {
            HalfEdge hole = v.Outgoing;
            mesh.SetNext(hole.Previous, vw.Twin);
            mesh.SetNext(vw.Twin, hole);
        }
        else if (toB.IsNone)
        {
            mesh.SetNext(vw, intoHole.Next);
            mesh.SetNext(intoHole, vw);
        }
    }

    private static Face NewFaceLike(Mesh mesh, Face face)
    {
        Face f = mesh.NewFace();
        mesh.CopyTraits(ElementKind.Face, face.Index, f.Index);
        return f;
    }
}
