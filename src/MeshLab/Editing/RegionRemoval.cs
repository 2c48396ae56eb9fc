using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>What all deletions share: takes a set of faces out of the mesh.</summary>
internal static class RegionRemoval
{
    /// <summary>Whether some vertex would be left with two fans of faces that touch in it only.</summary>
    public static RemovalRefusal Examine(Mesh mesh, IReadOnlyCollection<int> faces)
    {
        var doomed = new HashSet<int>(faces);
        foreach (int v in VerticesOf(mesh, faces))
        {
            if (FansLeft(mesh, v, doomed) > 1)
                return RemovalRefusal.Pinch;
        }
        return RemovalRefusal.None;
    }

    /// <summary>Deletes the faces, the edges that lose both faces and, if wanted, the vertices that lose all; splits the vertices that would be bow-ties.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="faces">Live faces of it, each once.</param>
    /// <param name="options">What becomes of orphans and bow-ties.</param>
    /// <param name="copies">Gets, per new vertex, the one of which it is a copy.</param>
    public static void Remove(Mesh mesh, IReadOnlyCollection<int> faces, RemovalOptions options, List<int>? copies = null)
    {
        List<int> vertices = VerticesOf(mesh, faces);
        var edges = new List<int>();
        foreach (int f in faces)
        {
            int h = mesh.halfEdgeOf[f];
            do
            {
                mesh.SetFace(h, -1);
                if (mesh.face[h ^ 1] < 0)
                    edges.Add(h >> 1);
                h = mesh.next[h];
            }
            while (h != mesh.halfEdgeOf[f]);
            mesh.DeleteFaceSlot(f);
        }
        foreach (int e in edges)
            RemoveBareEdge(mesh, e);
        foreach (int v in vertices)
        {
            int before = mesh.VertexSlots;
            Settle(mesh, v, options);
            copies?.AddRange(Enumerable.Repeat(v, mesh.VertexSlots - before));
        }
    }

    /// <summary>Takes an edge without faces out of the loops on both sides.</summary>
    private static void RemoveBareEdge(Mesh mesh, int e)
    {
        int h = 2 * e, t = h + 1, start = mesh.target[t], end = mesh.target[h];
        int hNext = mesh.next[h], hPrevious = mesh.previous[h], tNext = mesh.next[t], tPrevious = mesh.previous[t];
        if (hNext == t)
            mesh.SetOutgoing(end, Mesh.Isolated);
        else
            Bypass(mesh, end, t, tPrevious, hNext);
        if (tNext == h)
            mesh.SetOutgoing(start, Mesh.Isolated);
        else
            Bypass(mesh, start, h, hPrevious, tNext);
        mesh.DeleteEdgeSlot(e);
    }

    private static void Bypass(Mesh mesh, int v, int leaving, int before, int after)
    {
        mesh.SetNext(before, after);
        if (mesh.outgoing[v] == leaving)
            mesh.SetOutgoing(v, after);
    }

    /// <summary>Puts one vertex of a removed face in order: deleted, isolated, or with a boundary half-edge and a single fan.</summary>
    private static void Settle(Mesh mesh, int v, RemovalOptions options)
    {
        int start = mesh.outgoing[v];
        if (start < 0)
        {
            if (start == Mesh.Isolated && options.DeleteOrphans)
                mesh.DeleteVertexSlot(v);
            return;
        }
        mesh.AdjustOutgoing(v, start);
        if (options.SplitPinched)
            SplitFans(mesh, v);
    }

    /// <summary>Gives each fan of faces around a vertex but the first a vertex of its own.</summary>
    private static void SplitFans(Mesh mesh, int v)
    {
        // Clockwise from a boundary half-edge: each further boundary half-edge begins another fan.
        int hole = mesh.outgoing[v], h = mesh.next[hole ^ 1];
        while (h != hole)
        {
            if (mesh.face[h] >= 0)
            {
                h = mesh.next[h ^ 1];
                continue;
            }
            h = DetachFan(mesh, v, h);
        }
    }

    /// <summary>Moves the fan that begins clockwise with a boundary half-edge to a new vertex; returns the half-edge after it around the old vertex.</summary>
    private static int DetachFan(Mesh mesh, int v, int first)
    {
        Vertex copy = mesh.NewVertex(mesh.positions[v]);
        mesh.CopyTraits(ElementKind.Vertex, v, copy.Index);
        int into = mesh.previous[first], last = first;
        mesh.SetTarget(first ^ 1, copy.Index);
        while (mesh.face[last ^ 1] >= 0)
        {
            last = mesh.next[last ^ 1];
            mesh.SetTarget(last ^ 1, copy.Index);
        }
        int after = mesh.next[last ^ 1];
        mesh.SetNext(into, after);
        mesh.SetNext(last ^ 1, first);
        mesh.SetOutgoing(copy.Index, first);
        return after;
    }

    private static int FansLeft(Mesh mesh, int v, HashSet<int> doomed)
    {
        bool Stays(int h) => mesh.face[h] >= 0 && !doomed.Contains(mesh.face[h]);
        int fans = 0, start = mesh.outgoing[v], h = start;
        do
        {
            // A fan begins at a face that stays whose clockwise neighbour does not.
            if (Stays(h) && !Stays(h ^ 1))
                fans++;
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        return fans;
    }

    /// <summary>The corners of the faces, each once, in order of appearance.</summary>
    private static List<int> VerticesOf(Mesh mesh, IReadOnlyCollection<int> faces)
    {
        var found = new List<int>();
        var seen = new HashSet<int>();
        foreach (int f in faces)
        {
            int h = mesh.halfEdgeOf[f];
            do
            {
                if (seen.Add(mesh.target[h]))
                    found.Add(mesh.target[h]);
                h = mesh.next[h];
            }
            while (h != mesh.halfEdgeOf[f]);
        }
        return found;
    }
}
