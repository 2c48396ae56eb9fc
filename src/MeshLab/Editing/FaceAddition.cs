using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>Why a face cannot be added.</summary>
public enum AddFaceRefusal
{
    /// <summary>It can.</summary>
    None,

    /// <summary>Fewer than three vertices.</summary>
    TooFewVertices,

    /// <summary>A vertex appears twice.</summary>
    RepeatedVertex,

    /// <summary>A vertex lies inside the surface: neither on a boundary nor isolated.</summary>
    InnerVertex,

    /// <summary>One of the half-edges has a face already: the edge would get a third face, or neighbours would be oriented against each other.</summary>
    EdgeTaken,

    /// <summary>The face would touch a part of the surface in a vertex only (蝴蝶结点, bow-tie).</summary>
    Pinch,

    /// <summary>The faces around a vertex would close while others are left outside the circle.</summary>
    FansDoNotJoin,
}

/// <summary>§4.1 添加面 (add face): joins live vertices, isolated or on a boundary, to a polygon.</summary>
/// <remarks>
/// <code>
///     c        d              c ────── d
///      \      /                \      /
///       \    /         ⟶        \ f  /         both edges were there: only the edge c–d is new
///        \  /                    \  /
///          v                       v
/// </code>
/// Edges that exist are used, missing ones are made. Atomic: a refused face changes nothing.
/// A single face must not leave a vertex where two fans of faces touch. Several faces may pass through such states, in any order, as long as the
/// last one ends them (<c>AddFaces</c>): when a face joins two fans of a vertex, their holes are linked anew.
/// Traits of the new elements are the defaults. Cost: O(sum of valences).
/// </remarks>
public static class FaceAddition
{
    extension(Mesh mesh)
    {
        /// <summary>Whether <c>AddFace</c> would succeed; the mesh is not touched.</summary>
        /// <param name="vertices">Counter-clockwise seen from outside.</param>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        public bool CanAddFace(ReadOnlySpan<Vertex> vertices, out AddFaceRefusal why)
        {
            why = Examine(mesh, vertices, nameof(vertices));
            if (why == AddFaceRefusal.None && LeavesPinch(mesh, vertices))
                why = AddFaceRefusal.Pinch;
            return why == AddFaceRefusal.None;
        }

        /// <summary>Adds a face, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="vertices">Counter-clockwise seen from outside.</param>
        /// <param name="face">The new face.</param>
        /// <param name="why">The reason if it was not added.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        public bool TryAddFace(ReadOnlySpan<Vertex> vertices, out Face face, out AddFaceRefusal why)
        {
            face = default;
            if (!mesh.CanAddFace(vertices, out why))
                return false;
            using OperationScope operation = mesh.BeginOperation(OperationKind.AddFace);
            face = Apply(mesh, vertices);
            operation.Complete();
            return true;
        }

        /// <summary>Adds a face.</summary>
        /// <param name="vertices">Counter-clockwise seen from outside.</param>
        /// <returns>The new face; its first vertex is the first one given.</returns>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">It cannot be added; the message names the vertices and the reason.</exception>
        public Face AddFace(params ReadOnlySpan<Vertex> vertices) => mesh.TryAddFace(vertices, out Face face, out AddFaceRefusal why)
            ? face
            : throw Refused(vertices, why);

        /// <summary>Adds several faces, all or none, in the order given; only the last state must be free of vertices where fans touch.</summary>
        /// <param name="faces">Vertices per face, counter-clockwise seen from outside.</param>
        /// <returns>The new faces.</returns>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">One cannot be added; the message names the vertices and the reason. The mesh is as before.</exception>
        public Face[] AddFaces(params IReadOnlyList<Vertex[]> faces)
        {
            ArgumentNullException.ThrowIfNull(faces);
            using OperationScope operation = mesh.BeginReversibleOperation(OperationKind.AddFace);
            var added = new Face[faces.Count];
            for (int i = 0; i < faces.Count; i++)
            {
                ArgumentNullException.ThrowIfNull(faces[i], nameof(faces));
                AddFaceRefusal why = Examine(mesh, faces[i], nameof(faces));
                if (why != AddFaceRefusal.None)
                    throw Refused(faces[i], why);
                added[i] = Apply(mesh, faces[i]);
            }
            foreach (Vertex[] face in faces)
            {
                foreach (Vertex v in face)
                {
                    if (HoleCount(v) > 1)
                        throw Refused(face, AddFaceRefusal.Pinch);
                }
            }
            operation.Complete();
            return added;
        }
    }

    private static TopologyException Refused(ReadOnlySpan<Vertex> vertices, AddFaceRefusal why)
    {
        var names = new string[vertices.Length];
        for (int i = 0; i < names.Length; i++)
            names[i] = vertices[i].ToString();
        return new($"The face {string.Join(' ', names)} cannot be added: {why}.", names);
    }

    private static AddFaceRefusal Examine(Mesh mesh, ReadOnlySpan<Vertex> vertices, string parameter)
    {
        foreach (Vertex v in vertices)
            mesh.CheckOwn(v, parameter);
        if (vertices.Length < 3)
            return AddFaceRefusal.TooFewVertices;
        if (HasRepetition(vertices))
            return AddFaceRefusal.RepeatedVertex;
        foreach (Vertex v in vertices)
        {
            if (!v.IsIsolated && !v.IsBoundary)
                return AddFaceRefusal.InnerVertex;
        }
        HalfEdge into = mesh.FindHalfEdge(vertices[^1], vertices[0]);
        for (int i = 0; i < vertices.Length; i++)
        {
            HalfEdge outOf = mesh.FindHalfEdge(vertices[i], vertices[(i + 1) % vertices.Length]);
            if (!outOf.IsNone && !outOf.IsBoundary)
                return AddFaceRefusal.EdgeTaken;
            if (!into.IsNone && !outOf.IsNone && into.IsBoundary && into.Next != outOf && GapBefore(outOf, into).IsNone)
                return AddFaceRefusal.FansDoNotJoin;
            into = outOf;
        }
        return AddFaceRefusal.None;
    }

    private static bool HasRepetition(ReadOnlySpan<Vertex> vertices)
    {
        const int Few = 24;
        if (vertices.Length > Few)
        {
            var seen = new HashSet<Vertex>(vertices.Length);
            foreach (Vertex v in vertices)
            {
                if (!seen.Add(v))
                    return true;
            }
            return false;
        }
        for (int i = 1; i < vertices.Length; i++)
        {
            if (vertices[..i].Contains(vertices[i]))
                return true;
        }
        return false;
    }

    /// <summary>Whether the face touches the fan of one of its vertices without an edge in common.</summary>
    private static bool LeavesPinch(Mesh mesh, ReadOnlySpan<Vertex> vertices)
    {
        bool isNewInto = mesh.FindHalfEdge(vertices[^1], vertices[0]).IsNone;
        for (int i = 0; i < vertices.Length; i++)
        {
            bool isNewOut = mesh.FindHalfEdge(vertices[i], vertices[(i + 1) % vertices.Length]).IsNone;
            if (isNewInto && isNewOut && !vertices[i].IsIsolated)
                return true;
            isNewInto = isNewOut;
        }
        return false;
    }

    private static Face Apply(Mesh mesh, ReadOnlySpan<Vertex> vertices)
    {
        int n = vertices.Length;
        HalfEdge[] sides = new HalfEdge[n];
        bool[] isNew = new bool[n];
        for (int i = 0; i < n; i++)
        {
            sides[i] = mesh.FindHalfEdge(vertices[i], vertices[(i + 1) % n]);
            isNew[i] = sides[i].IsNone;
            if (isNew[i])
                sides[i] = mesh.NewEdge(vertices[i], vertices[(i + 1) % n]);
        }
        for (int i = 0; i < n; i++)
        {
            int before = (i + n - 1) % n;
            LinkAround(mesh, vertices[i], sides[before], isNew[before], sides[i], isNew[i]);
        }
        Face face = mesh.NewFace();
        foreach (HalfEdge side in sides)
            mesh.SetFace(side, face);
        mesh.SetHalfEdge(face, sides[0]);
        for (int i = 0; i < n; i++)
            mesh.AdjustOutgoing(vertices[i], sides[i]);
        return face;
    }

    /// <summary>Links the two sides of the face at one vertex, and what lies around it outside the face.</summary>
    private static void LinkAround(Mesh mesh, Vertex v, HalfEdge into, bool isNewInto, HalfEdge outOf, bool isNewOut)
    {
        switch (isNewInto, isNewOut)
        {
            case (true, true) when v.IsIsolated:
                mesh.SetNext(outOf.Twin, into.Twin);
                break;
            case (true, true):
                HalfEdge hole = v.Outgoing;
                mesh.SetNext(hole.Previous, into.Twin);
                mesh.SetNext(outOf.Twin, hole);
                break;
            case (true, false):
                mesh.SetNext(outOf.Previous, into.Twin);
                break;
            case (false, true):
                mesh.SetNext(outOf.Twin, into.Next);
                break;
            case (false, false) when into.Next != outOf:
                JoinFans(mesh, into, outOf);
                break;
        }
        mesh.SetNext(into, outOf);
    }

    /// <summary>The new face joins two fans that were linked one after the other around the vertex: what lay between them goes to another hole.</summary>
    private static void JoinFans(Mesh mesh, HalfEdge into, HalfEdge outOf)
    {
        HalfEdge gap = GapBefore(outOf, into), afterGap = gap.Next;
        HalfEdge patchStart = into.Next, patchEnd = outOf.Previous;
        mesh.SetNext(gap, patchStart);
        mesh.SetNext(patchEnd, afterGap);
    }

    /// <summary>The boundary half-edge into the vertex, other than <paramref name="into"/>, found by turning from <paramref name="outOf"/> through its fan; none if there is none.</summary>
    private static HalfEdge GapBefore(HalfEdge outOf, HalfEdge into)
    {
        HalfEdge gap = outOf.Twin;
        do
        {
            gap = gap.Next.Twin;
        }
        while (!gap.IsBoundary);
        return gap == into ? default : gap;
    }

    private static int HoleCount(Vertex v)
    {
        int holes = 0;
        foreach (HalfEdge h in v.OutgoingHalfEdges)
            holes += h.IsBoundary ? 1 : 0;
        return holes;
    }
}
