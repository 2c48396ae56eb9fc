using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why a face cannot be cut along a diagonal.</summary>
public enum CutRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>A vertex is not a corner of the face.</summary>
    NotACorner,

    /// <summary>The two are the same or neighbours along the face.</summary>
    NoDiagonal,

    /// <summary>Another edge joins the two vertices already.</summary>
    EdgeExists,
}

/// <summary>§4 面剖分 (cut face): cuts a polygon in two along a diagonal. Inverse of <see cref="EdgeDissolve"/>.</summary>
/// <remarks>
/// <code>
///    d ── c ── f            d ── c ── f
///    │    F    │     ⟶      │  F │ G  │       F.Cut(b, c): the part left of b → c keeps the face's index
///    a ── b ── e            a ── b ── e
/// </code>
/// The new face gets the traits of the old one, the corners those at the same vertices, the edge the default. +1 E, +1 F. Cost: O(degree + valence).
/// </remarks>
public static class FaceCut
{
    extension(Face face)
    {
        /// <summary>Whether <c>Cut</c> would succeed; the mesh is not touched.</summary>
        /// <param name="from">One corner.</param>
        /// <param name="to">The other.</param>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">An element is none, deleted, or of another mesh.</exception>
        public bool CanCut(Vertex from, Vertex to, out CutRefusal why) => (why = Examine(face, from, to, out _, out _)) == CutRefusal.None;

        /// <summary>Cuts the face along a diagonal, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="from">One corner.</param>
        /// <param name="to">The other; the part left of the way from one to the other keeps the face's index.</param>
        /// <param name="diagonal">The new half-edge between them, in the old face.</param>
        /// <param name="why">The reason if it was not cut.</param>
        /// <exception cref="ArgumentException">An element is none, deleted, or of another mesh.</exception>
        public bool TryCut(Vertex from, Vertex to, out HalfEdge diagonal, out CutRefusal why)
        {
            diagonal = default;
            why = Examine(face, from, to, out HalfEdge intoFrom, out HalfEdge intoTo);
            if (why != CutRefusal.None)
                return false;
            diagonal = Apply(face, intoFrom, intoTo);
            return true;
        }

        /// <summary>Cuts the face along a diagonal.</summary>
        /// <param name="from">One corner.</param>
        /// <param name="to">The other; the part left of the way from one to the other keeps the face's index.</param>
        /// <returns>The new half-edge between them, in the old face; its twin lies in the new one.</returns>
        /// <exception cref="ArgumentException">An element is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">It cannot be cut; the message names the elements and the reason.</exception>
        public HalfEdge Cut(Vertex from, Vertex to) => face.TryCut(from, to, out HalfEdge diagonal, out CutRefusal why)
            ? diagonal
            : throw new TopologyException($"{face} cannot be cut from {from} to {to}: {why}.", face.ToString(), from.ToString(), to.ToString());
    }

    private static CutRefusal Examine(Face face, Vertex from, Vertex to, out HalfEdge intoFrom, out HalfEdge intoTo)
    {
        face.ThrowIfDead();
        face.Mesh.CheckOwn(from, nameof(from));
        face.Mesh.CheckOwn(to, nameof(to));
        intoFrom = intoTo = default;
        foreach (HalfEdge h in face.HalfEdges)
        {
            if (h.Target == from)
                intoFrom = h;
            if (h.Target == to)
                intoTo = h;
        }
        if (intoFrom.IsNone || intoTo.IsNone)
            return CutRefusal.NotACorner;
        if (from == to || intoFrom.Next == intoTo || intoTo.Next == intoFrom)
            return CutRefusal.NoDiagonal;
        return from.IsNeighborOf(to) ? CutRefusal.EdgeExists : CutRefusal.None;
    }

    private static HalfEdge Apply(Face face, HalfEdge intoFrom, HalfEdge intoTo)
    {
        Mesh mesh = face.Mesh;
        using OperationScope operation = mesh.BeginOperation(OperationKind.SplitFaceByDiagonal, face.Index);
        HalfEdge afterFrom = intoFrom.Next, afterTo = intoTo.Next;
        HalfEdge diagonal = mesh.NewEdge(intoFrom.Target, intoTo.Target), back = diagonal.Twin;
        Face cut = mesh.NewFace();
        mesh.CopyTraits(ElementKind.Face, face.Index, cut.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, intoTo.Index, diagonal.Index);
        mesh.CopyTraits(ElementKind.HalfEdge, intoFrom.Index, back.Index);

        mesh.SetNext(intoFrom, diagonal);
        mesh.SetNext(diagonal, afterTo);
        mesh.SetNext(intoTo, back);
        mesh.SetNext(back, afterFrom);
        mesh.SetFace(diagonal, face);
        for (HalfEdge h = back; ; h = h.Next)
        {
            if (face.HalfEdge == h)
                mesh.SetHalfEdge(face, diagonal);
            mesh.SetFace(h, cut);
            if (h == intoTo)
                break;
        }
        mesh.SetHalfEdge(cut, back);
        operation.Complete();
        return diagonal;
    }
}
