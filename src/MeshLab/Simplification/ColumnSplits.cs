using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Contracts an edge and splits the vertex again on a mesh's own columns, by record. Counts and traits are the caller's.</summary>
internal static class ColumnSplits
{
    /// <summary>What contracting a half-edge will need to be undone.</summary>
    public static SplitRecord Describe(Mesh mesh, int h, Merges merges)
    {
        int o = h ^ 1, u = mesh.target[o], v = mesh.target[h];
        return new(
            h,
            u,
            v,
            mesh.outgoing[u],
            mesh.outgoing[v],
            DescribeSide(mesh, h, (merges & Merges.LeftNextStays) != Merges.None),
            DescribeSide(mesh, o, (merges & Merges.RightNextStays) != Merges.None));
    }

    /// <summary>Contracts the edge.</summary>
    public static void Collapse(Mesh mesh, ref readonly SplitRecord record)
    {
        int h = record.HalfEdge, o = h ^ 1, v = record.Kept;
        Retarget(mesh, h, v);
        // A border first: the triangle's vanishing edge may lie on the same border.
        int leavingRight = record.Right.Face < 0 ? RemoveSide(mesh, record.Right) : -1;
        int leavingLeft = RemoveSide(mesh, record.Left);
        if (record.Right.Face >= 0)
            leavingRight = RemoveSide(mesh, record.Right);
        DeleteEdge(mesh, h);
        mesh.outgoing[record.Removed] = Mesh.DeletedVertexMark;
        int start = leavingRight >= 0 ? leavingRight : leavingLeft, g = start;
        mesh.outgoing[v] = start;
        do
        {
            if (mesh.face[g] < 0)
                mesh.outgoing[v] = g;
            g = mesh.next[g ^ 1];
        }
        while (g != start);
    }

    /// <summary>Splits the vertex.</summary>
    public static void Split(Mesh mesh, ref readonly SplitRecord record)
    {
        int h = record.HalfEdge, o = h ^ 1, u = record.Removed, v = record.Kept;
        if (record.Right.Face >= 0)
            RestoreSide(mesh, o, record.Right, u, v);
        RestoreSide(mesh, h, record.Left, v, u);
        if (record.Right.Face < 0)
            RestoreSide(mesh, o, record.Right, u, v);
        mesh.target[h] = v;
        mesh.outgoing[u] = record.RemovedOutgoing;
        mesh.outgoing[v] = record.KeptOutgoing;
        Retarget(mesh, h, u);
        mesh.target[o] = u;
    }

    private static SplitSide DescribeSide(Mesh mesh, int h, bool nextStays)
    {
        int f = mesh.face[h], next = mesh.next[h], previous = mesh.previous[h];
        if (f < 0)
            return new(-1, next, previous, true, -1, -1, -1, -1);
        (int kept, int gone) = nextStays ? (next, previous) : (previous, next);
        int outer = mesh.face[gone ^ 1], apex = mesh.target[next];
        return new(f, kept, gone, nextStays, mesh.halfEdgeOf[f], outer < 0 ? -1 : mesh.halfEdgeOf[outer], apex, mesh.outgoing[apex]);
    }

    /// <summary>Makes all half-edges into the source of a half-edge end in a vertex.</summary>
    private static void Retarget(Mesh mesh, int h, int vertex)
    {
        int g = h, left = mesh.HalfEdgeSlots;
        do
        {
            mesh.target[g ^ 1] = vertex;
            g = mesh.next[g ^ 1];
            if (--left < 0)
                throw new InvalidDataException($"The half-edges around h{h} do not close.");
        }
        while (g != h);
    }

    private static int RemoveSide(Mesh mesh, SplitSide side)
    {
        if (side.Face < 0)
        {
            mesh.next[side.Gone] = side.Kept;
            mesh.previous[side.Kept] = side.Gone;
            return -1;
        }
        int kept = side.Kept, twin = side.Gone ^ 1;
        int following = side.KeptIsNext ? kept : side.Gone, before = side.KeptIsNext ? side.Gone : kept;
        if (side.KeptIsNext && mesh.outgoing[side.Apex] == before)
            mesh.outgoing[side.Apex] = following ^ 1;
        if (!side.KeptIsNext && mesh.outgoing[side.Apex] == (following ^ 1))
            mesh.outgoing[side.Apex] = before;
        mesh.halfEdgeOf[side.Face] = -1;
        mesh.next[kept] = mesh.next[twin];
        mesh.previous[kept] = mesh.previous[twin];
        mesh.face[kept] = mesh.face[twin];
        mesh.previous[mesh.next[kept]] = kept;
        mesh.next[mesh.previous[kept]] = kept;
        if (mesh.face[kept] >= 0)
            mesh.halfEdgeOf[mesh.face[kept]] = kept;
        DeleteEdge(mesh, twin);
        return side.KeptIsNext ? kept : kept ^ 1;
    }

    /// <summary>Brings a triangle back, from the start to the end of its half-edge, or the half-edge back into its border.</summary>
    private static void RestoreSide(Mesh mesh, int h, SplitSide side, int end, int start)
    {
        if (side.Face < 0)
        {
            Link(mesh, side.Gone, h);
            Link(mesh, h, side.Kept);
            mesh.face[h] = -1;
            return;
        }
        int kept = side.Kept, gone = side.Gone, twin = gone ^ 1;
        Link(mesh, mesh.previous[kept], twin);
        Link(mesh, twin, mesh.next[kept]);
        mesh.face[twin] = mesh.face[kept];
        if (mesh.face[twin] >= 0)
            mesh.halfEdgeOf[mesh.face[twin]] = side.OuterHalfEdge;
        int next = side.KeptIsNext ? kept : gone, previous = side.KeptIsNext ? gone : kept;
        mesh.target[gone] = side.KeptIsNext ? start : side.Apex;
        mesh.target[twin] = side.KeptIsNext ? side.Apex : end;
        Link(mesh, h, next);
        Link(mesh, next, previous);
        Link(mesh, previous, h);
        mesh.face[h] = mesh.face[next] = mesh.face[previous] = side.Face;
        mesh.halfEdgeOf[side.Face] = side.FaceHalfEdge;
        mesh.outgoing[side.Apex] = side.ApexOutgoing;
    }

    private static void Link(Mesh mesh, int first, int second)
    {
        mesh.next[first] = second;
        mesh.previous[second] = first;
    }

    private static void DeleteEdge(Mesh mesh, int h)
    {
        foreach (int k in (ReadOnlySpan<int>)[h, h ^ 1])
            mesh.next[k] = mesh.previous[k] = mesh.target[k] = mesh.face[k] = -1;
    }
}
