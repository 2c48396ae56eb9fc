using System.Buffers;
using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why an edge cannot be collapsed; the first that holds, in this order.</summary>
public enum CollapseRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>The ends have a common neighbour that is not the apex of a triangle beside the edge, or lie in a common face elsewhere:
    /// two edges would join the same vertices (link condition, Dey, Edelsbrunner, Guha, Nekhayev 1999).</summary>
    LinkCondition,

    /// <summary>An inner edge between two boundary vertices: two parts of the surface would hang together in one vertex only.</summary>
    Pinch,

    /// <summary>A boundary edge of a hole, or of a component's rim, with only three edges: two would be left.</summary>
    LastBoundaryTriangle,

    /// <summary>The component is a tetrahedron: two triangles back to back would be left.</summary>
    Tetrahedron,

    /// <summary>The two other sides of a triangle beside the edge have the same face across them: the sides would become an edge with one face on both sides.</summary>
    TwoGon,
}

/// <summary>§4.6 合并边 (edge collapse): contracts an edge to one vertex; triangles beside it vanish, polygons lose a corner.</summary>
/// <remarks>
/// <code>
///         c                     c
///       / | \                   |
///   ── u ─h→ v ──     ⟶     ─── v ───
///       \ | /                   |
///         d                     d
/// </code>
/// <c>h.Collapse</c> keeps the target <c>v</c> and removes the source <c>u</c>; of the sides <c>u–c</c> and <c>v–c</c> (and <c>u–d</c>, <c>v–d</c>)
/// those at <c>v</c> stay. −1 V, −3 E, −2 F inside, −1, −2, −1 on the boundary. Exact inverse of <see cref="VertexSplit"/>.
/// Whether faces turn over is a separate question: <see cref="CollapseGeometry"/>.
/// Traits: <c>v</c> gets the blend of both ends by where the new position lies between them; each merged edge the even blend of its two;
/// a corner where a triangle vanished the value from the face outside it.
/// Cost: O(valence of u + valence of v), more by a logarithm above 64.
/// </remarks>
public static class EdgeCollapse
{
    private const int SmallValence = 64;

    extension(HalfEdge halfEdge)
    {
        /// <summary>Whether the half-edge can be collapsed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The half-edge is none or deleted.</exception>
        public bool CanCollapse(out CollapseRefusal why) => (why = Examine(halfEdge)) == CollapseRefusal.None;

        /// <summary>Collapses the half-edge to its target, at the midpoint of the edge, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not collapsed.</param>
        /// <exception cref="ArgumentException">The half-edge is none or deleted.</exception>
        public bool TryCollapse(out CollapseRefusal why)
        {
            why = Examine(halfEdge);
            if (why != CollapseRefusal.None)
                return false;
            Apply(halfEdge, (halfEdge.Source.Position + halfEdge.Target.Position) * 0.5);
            return true;
        }

        /// <summary>Collapses the half-edge to its target, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="position">Where the target goes.</param>
        /// <param name="why">The reason if it was not collapsed.</param>
        /// <exception cref="ArgumentException">The half-edge is none or deleted, or the position is not finite.</exception>
        public bool TryCollapse(Vector3D position, out CollapseRefusal why)
        {
            position.ThrowIfNotFinite(nameof(position));
            why = Examine(halfEdge);
            if (why != CollapseRefusal.None)
                return false;
            Apply(halfEdge, position);
            return true;
        }

        /// <summary>Collapses the half-edge to its target, at the midpoint of the edge.</summary>
        /// <returns>The target, which stays.</returns>
        /// <exception cref="ArgumentException">The half-edge is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be collapsed; the message names the edge and the reason.</exception>
        public Vertex Collapse()
        {
            halfEdge.ThrowIfDead();
            return halfEdge.Collapse((halfEdge.Source.Position + halfEdge.Target.Position) * 0.5);
        }

        /// <summary>Collapses the half-edge to its target.</summary>
        /// <param name="position">Where the target goes.</param>
        /// <returns>The target, which stays.</returns>
        /// <exception cref="ArgumentException">The half-edge is none or deleted, or the position is not finite.</exception>
        /// <exception cref="TopologyException">It cannot be collapsed; the message names the edge and the reason.</exception>
        public Vertex Collapse(Vector3D position)
        {
            Vertex survivor = halfEdge.IsNone ? default : halfEdge.Target;
            if (!halfEdge.TryCollapse(position, out CollapseRefusal why))
                throw new TopologyException($"{halfEdge.Edge} cannot be collapsed: {why}.", halfEdge.Edge.ToString());
            return survivor;
        }
    }

    private static CollapseRefusal Examine(HalfEdge halfEdge)
    {
        halfEdge.ThrowIfDead();
        Mesh mesh = halfEdge.Mesh;
        int[] next = mesh.next, target = mesh.target, face = mesh.face;
        int h = halfEdge.Index, t = h ^ 1, u = target[t], v = target[h];

        // The third corner of a loop of three edges; that of a hole counts too, so that it is refused for what it is.
        int c = next[next[next[h]]] == h ? target[next[h]] : -1;
        int d = next[next[next[t]]] == t ? target[next[t]] : -1;
        if (ViolatesLinkCondition(mesh, h, c, d))
            return CollapseRefusal.LinkCondition;

        bool isInner = face[h] >= 0 && face[t] >= 0;
        bool uOnBoundary = face[mesh.outgoing[u]] < 0, vOnBoundary = face[mesh.outgoing[v]] < 0;
        if (isInner && uOnBoundary && vOnBoundary)
            return CollapseRefusal.Pinch;
        if ((face[h] < 0 && c >= 0) || (face[t] < 0 && d >= 0))
            return CollapseRefusal.LastBoundaryTriangle;
        if (c >= 0 && d >= 0 && c != d && IsTetrahedron(mesh, h))
            return CollapseRefusal.Tetrahedron;
        if ((c >= 0 && HasOneFaceAcross(mesh, h)) || (d >= 0 && HasOneFaceAcross(mesh, t)))
            return CollapseRefusal.TwoGon;
        return CollapseRefusal.None;
    }

    /// <summary>Whether u and v have a neighbour in common besides c and d, or a polygon not beside the edge.</summary>
    [SkipLocalsInit]
    private static bool ViolatesLinkCondition(Mesh mesh, int h, int c, int d)
    {
        int[] next = mesh.next, target = mesh.target, face = mesh.face;
        int t = h ^ 1, v = target[h], leftFace = face[h], rightFace = face[t];
        Span<int> others = stackalloc int[SmallValence];
        int count = 0;
        // Clockwise around u, from the spoke after h back to it.
        for (int spoke = next[t]; spoke != h; spoke = next[spoke ^ 1])
        {
            int w = target[spoke], f = face[spoke];
            if (f >= 0 && f != leftFace && f != rightFace && next[next[next[spoke]]] != spoke && HasCorner(mesh, spoke, v))
                return true;
            if (w == c || w == d)
                continue;
            if (count < SmallValence)
                others[count] = w;
            count++;
        }
        if (count == 0)
            return false;
        if (count > SmallValence)
            return HaveNeighborInCommonAtHub(mesh, target[t], v, c, d);

        others = others[..count];
        for (int spoke = next[h]; spoke != t; spoke = next[spoke ^ 1])
        {
            if (others.Contains(target[spoke]))
                return true;
        }
        return false;
    }

    private static bool HasCorner(Mesh mesh, int halfEdge, int v)
    {
        int k = halfEdge;
        do
        {
            if (mesh.target[k] == v)
                return true;
            k = mesh.next[k];
        }
        while (k != halfEdge);
        return false;
    }

    /// <summary>For hubs: one end's neighbours are sorted, so that the time does not grow with the product of the valences.</summary>
    private static bool HaveNeighborInCommonAtHub(Mesh mesh, int u, int v, int c, int d)
    {
        int[] ofV = ArrayPool<int>.Shared.Rent(new Vertex(mesh, v).Valence);
        int count = 0;
        foreach (Vertex w in new Vertex(mesh, v).Neighbors)
            ofV[count++] = w.Index;
        Array.Sort(ofV, 0, count);
        bool found = false;
        foreach (Vertex w in new Vertex(mesh, u).Neighbors)
            found |= w.Index != c && w.Index != d && Array.BinarySearch(ofV, 0, count, w.Index) >= 0;
        ArrayPool<int>.Shared.Return(ofV);
        return found;
    }

    private static bool IsTetrahedron(Mesh mesh, int h)
    {
        int[] next = mesh.next, previous = mesh.previous, face = mesh.face;
        // Across the sides u–c and v–c there must be triangles that meet again in the spokes to d.
        int uc = previous[h] ^ 1, cv = next[h] ^ 1;
        int vd = previous[h ^ 1] ^ 1, du = next[h ^ 1] ^ 1;
        return face[uc] >= 0 && face[cv] >= 0
            && next[next[next[uc]]] == uc && next[next[next[cv]]] == cv
            && previous[uc] == du && next[cv] == vd;
    }

    /// <summary>Whether the two sides of the triangle other than h have the same face, or the same hole, across them.</summary>
    private static bool HasOneFaceAcross(Mesh mesh, int h) =>
        mesh.face[h] >= 0 && mesh.face[mesh.next[h] ^ 1] == mesh.face[mesh.previous[h] ^ 1];

    internal static void Apply(HalfEdge halfEdge, Vector3D position)
    {
        Mesh mesh = halfEdge.Mesh;
        int h = halfEdge.Index, t = h ^ 1, u = mesh.target[t], v = mesh.target[h];
        using OperationScope operation = mesh.BeginOperation(OperationKind.EdgeCollapse, h >> 1);

        BlendTraits(mesh, h, u, v, position);
        mesh.SetPosition(new Vertex(mesh, v), position);
        int uStart = mesh.outgoing[u], uHole = mesh.face[uStart] < 0 ? uStart : -1;
        PointAllTo(mesh, u, v);
        int hNext = mesh.next[h], hPrevious = mesh.previous[h], tNext = mesh.next[t], tPrevious = mesh.previous[t];
        TakeOut(mesh, h, hPrevious, hNext);
        TakeOut(mesh, t, tPrevious, tNext);

        // The side kept of each vanishing triangle is the one at v.
        if (mesh.face[h] >= 0 && mesh.next[hNext] == hPrevious)
            CloseTwoGon(mesh, hNext, hPrevious);
        if (mesh.face[t] >= 0 && mesh.next[tNext] == tPrevious)
            CloseTwoGon(mesh, tPrevious, tNext);

        int outgoing = mesh.face[h] < 0 ? hNext
            : mesh.face[t] < 0 ? tNext
            : uHole >= 0 ? uHole
            : mesh.outgoing[v] == t ? hNext
            : mesh.outgoing[v];
        // The side u → c may be gone; the one kept in its place is v → c.
        if (outgoing == (hPrevious ^ 1) && mesh.IsDeletedEdge(hPrevious >> 1))
            outgoing = hNext;
        if (mesh.outgoing[v] != outgoing)
            mesh.SetOutgoing(v, outgoing);
        mesh.DeleteVertexSlot(u);
        mesh.DeleteEdgeSlot(h >> 1);
        operation.Complete();
    }

    private static void PointAllTo(Mesh mesh, int u, int v)
    {
        int start = mesh.outgoing[u], k = start;
        do
        {
            mesh.SetTarget(k ^ 1, v);
            k = mesh.next[k ^ 1];
        }
        while (k != start);
    }

    private static void TakeOut(Mesh mesh, int h, int before, int after)
    {
        mesh.SetNext(before, after);
        int f = mesh.face[h];
        if (f >= 0 && mesh.halfEdgeOf[f] == h)
            mesh.SetHalfEdge(f, after);
    }

    /// <summary>A face of the two half-edges <paramref name="kept"/> and <paramref name="gone"/> vanishes: the kept one takes the place of the other's twin.</summary>
    private static void CloseTwoGon(Mesh mesh, int kept, int gone)
    {
        int outer = gone ^ 1, f = mesh.face[kept], outside = mesh.face[outer];
        mesh.CopyTraits(ElementKind.HalfEdge, outer, kept);
        mesh.MixTraits(ElementKind.Edge, kept >> 1, kept >> 1, gone >> 1, 0.5);

        mesh.SetNext(mesh.previous[outer], kept);
        mesh.SetNext(kept, mesh.next[outer]);
        mesh.SetFace(kept, outside);
        if (outside >= 0 && mesh.halfEdgeOf[outside] == outer)
            mesh.SetHalfEdge(outside, kept);

        // kept and outer run the same way, gone the other.
        int start = mesh.target[gone], end = mesh.target[kept];
        if (mesh.outgoing[start] == outer)
            mesh.SetOutgoing(start, kept);
        if (mesh.outgoing[end] == gone)
            mesh.SetOutgoing(end, kept ^ 1);
        mesh.DeleteFaceSlot(f);
        mesh.DeleteEdgeSlot(gone >> 1);
    }

    private static void BlendTraits(Mesh mesh, int h, int u, int v, Vector3D position)
    {
        if (mesh.VertexTraits.Count + mesh.HalfEdgeTraits.Count == 0)
            return;
        double s = position.ParameterBetween(mesh.positions[v], mesh.positions[u]);
        mesh.MixTraits(ElementKind.Vertex, v, v, u, s);
        // Where a polygon stays, the two corners at the edge become one.
        int t = h ^ 1, beforeH = mesh.previous[h], beforeT = mesh.previous[t];
        mesh.MixTraits(ElementKind.HalfEdge, beforeH, h, beforeH, s);
        mesh.MixTraits(ElementKind.HalfEdge, beforeT, beforeT, t, s);
    }
}
