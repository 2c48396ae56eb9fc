using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Dual;

/// <summary>The dual of face centres alone, boundary cells omitted: its columns are those of the primal, read crosswise.</summary>
internal static class PureDual
{
    /// <summary>Makes the dual of a mesh without deleted elements.</summary>
    public static DualResult Make(Mesh mesh, Vector3D[] centers)
    {
        bool[]? hasCell = mesh.IsClosed ? null : VerticesWithCell(mesh);
        int[]? dualEdge = hasCell is null ? null : NumberEdges(mesh, hasCell);
        RefuseDoubleEdges(mesh, dualEdge);
        int[] cells = Cells(mesh, hasCell);
        Mesh? dual = Connect(mesh, centers, cells, hasCell, dualEdge);
        int[] faces = [.. Enumerable.Range(0, centers.Length)];
        return dual is not null
            ? new(dual, faces, cells)
            : Apart(mesh, centers, cells);
    }

    private static bool[] VerticesWithCell(Mesh mesh)
    {
        var hasCell = new bool[mesh.VertexSlots];
        for (int v = 0; v < hasCell.Length; v++)
            hasCell[v] = mesh.outgoing[v] >= 0 && mesh.face[mesh.outgoing[v]] >= 0;
        return hasCell;
    }

    /// <summary>Per primal edge the number of its dual, −1 if no cell has it.</summary>
    private static int[] NumberEdges(Mesh mesh, bool[] hasCell)
    {
        var number = new int[mesh.EdgeSlots];
        int count = 0;
        for (int e = 0; e < number.Length; e++)
            number[e] = hasCell[mesh.target[2 * e]] || hasCell[mesh.target[2 * e + 1]] ? count++ : -1;
        return number;
    }

    private static int[] Cells(Mesh mesh, bool[]? hasCell)
    {
        var cells = new List<int>(mesh.VertexSlots);
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (hasCell is null ? mesh.outgoing[v] >= 0 : hasCell[v])
                cells.Add(v);
        }
        return [.. cells];
    }

    /// <summary>Throws if two faces share two edges that both have a dual.</summary>
    public static void RefuseDoubleEdges(Mesh mesh, int[]? dualEdge)
    {
        int[] face = mesh.face, next = mesh.next, halfEdgeOf = mesh.halfEdgeOf;
        var seen = new int[mesh.FaceSlots];
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            int first = halfEdgeOf[f], h = first;
            do
            {
                int across = face[h ^ 1];
                if (across >= 0 && (dualEdge is null || dualEdge[h >> 1] >= 0))
                {
                    if (seen[across] == f + 1)
                    {
                        throw new TopologyException(
                            $"{mesh.Faces[f]} and {mesh.Faces[across]} share more than one edge: their dual would be two edges between the same two vertices. The form with edge midpoints can hold them.",
                            mesh.Faces[f].ToString(), mesh.Faces[across].ToString());
                    }
                    seen[across] = f + 1;
                }
                h = next[h];
            }
            while (h != first);
        }
    }

    /// <summary>Reads the columns crosswise, or returns null if two cells touch in a vertex alone.</summary>
    private static Mesh? Connect(Mesh mesh, Vector3D[] centers, int[] cells, bool[]? hasCell, int[]? dualEdge)
    {
        int[] face = mesh.face, next = mesh.next, previous = mesh.previous, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
        int primalHalfEdges = mesh.HalfEdgeSlots, edges = 0;
        for (int e = 0; e < primalHalfEdges / 2; e++)
            edges += dualEdge is null || dualEdge[e] >= 0 ? 1 : 0;

        var cellOf = new int[mesh.VertexSlots];
        Array.Fill(cellOf, -1);
        for (int c = 0; c < cells.Length; c++)
            cellOf[cells[c]] = c;

        int[] newNext = new int[2 * edges], newPrevious = new int[2 * edges], newTarget = new int[2 * edges], newFace = new int[2 * edges];
        Parallelism.ForBlocks(primalHalfEdges / 2, 16384, (from, to) =>
        {
            for (int h = 2 * from; h < 2 * to; h++)
            {
                int d = DualOf(h, dualEdge);
                if (d < 0)
                    continue;
                int cell = cellOf[target[h ^ 1]];
                newTarget[d] = face[h];
                newFace[d] = cell;
                if (cell >= 0)
                {
                    newNext[d] = DualOf(previous[h] ^ 1, dualEdge);
                    newPrevious[d] = DualOf(next[h ^ 1], dualEdge);
                }
            }
        });

        var newOutgoing = new int[centers.Length];
        for (int f = 0; f < newOutgoing.Length; f++)
            newOutgoing[f] = dualEdge is null ? halfEdgeOf[f] ^ 1 : AnySpoke(f);
        var newHalfEdgeOf = new int[cells.Length];
        for (int c = 0; c < cells.Length; c++)
            newHalfEdgeOf[c] = DualOf(mesh.outgoing[cells[c]], dualEdge);

        if (dualEdge is not null && !LinkRims())
            return null;
        return new Mesh([.. centers], newNext, newPrevious, newTarget, newFace, newOutgoing, newHalfEdgeOf);

        int AnySpoke(int f)
        {
            int h = halfEdgeOf[f];
            do
            {
                int d = DualOf(h ^ 1, dualEdge);
                if (d >= 0)
                    return d;
                h = next[h];
            }
            while (h != halfEdgeOf[f]);
            return Mesh.Isolated;
        }

        // Where a cell is missing the dual has a boundary; turning through the cells finds its next edge.
        bool LinkRims()
        {
            var leaving = new int[centers.Length];
            for (int d = 0; d < newFace.Length; d++)
            {
                if (newFace[d] >= 0)
                    continue;
                int g = d ^ 1;
                do
                {
                    g = newPrevious[g] ^ 1;
                }
                while (newFace[g] >= 0);
                newNext[d] = g;
                newPrevious[g] = d;
                newOutgoing[newTarget[d]] = g;
                if (++leaving[newTarget[d]] > 1)
                    return false;
            }
            return true;
        }
    }

    private static int DualOf(int h, int[]? dualEdge)
    {
        if (dualEdge is null)
            return h;
        int e = dualEdge[h >> 1];
        return e < 0 ? -1 : 2 * e + (h & 1);
    }

    /// <summary>Cells that touch in one vertex alone get a vertex each.</summary>
    private static DualResult Apart(Mesh mesh, Vector3D[] centers, int[] cells)
    {
        int[][] polygons = Array.ConvertAll(cells, v => mesh.Vertices[v].Faces.Select(f => f.Index).ToArray());
        Mesh dual = MeshBuilder.FromPolygons(PolygonSoup.From(centers, polygons), NonManifoldPolicy.Split, out BuildReport report);
        int[] source = [.. Enumerable.Range(0, dual.VertexSlots)];
        if (report.SourceVertices is { } sources)
            source = [.. sources];
        return new(dual, source, cells);
    }
}
