using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Dual;

/// <summary>The forms of the dual that need more vertices than face centres: edge midpoints, and boundary vertices that close their own cell.</summary>
internal static class DualCells
{
    /// <summary>Makes the dual of a mesh without deleted elements.</summary>
    public static DualResult Make(Mesh mesh, Vector3D[] centers, DualOptions options)
    {
        bool pure = options.Form == DualForm.Pure, closed = options.Boundary == DualBoundary.Closed;
        if (pure)
            PureDual.RefuseDoubleEdges(mesh, null);
        var positions = new List<Vector3D>(centers);
        int[] midpoint = AddMidpoints(mesh, positions, boundaryOnly: pure);
        int[] own = closed ? AddBoundaryVertices(mesh, positions) : [];

        var cells = new List<int>();
        var start = new List<int> { 0 };
        var corners = new List<int>();
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated || (v.IsBoundary && !closed))
                continue;
            if (v.IsBoundary)
            {
                corners.Add(own[v.Index]);
                corners.Add(midpoint[v.Outgoing.Previous.Edge.Index]);
            }
            // Counter-clockwise: the spoke, the face to its left, and so on.
            HalfEdge first = v.IsBoundary ? v.Outgoing.Previous.Twin : v.Outgoing, h = first;
            do
            {
                if (!pure && !(v.IsBoundary && h == first))
                    corners.Add(midpoint[h.Edge.Index]);
                if (!h.IsBoundary)
                    corners.Add(h.Face.Index);
                else if (pure)
                    corners.Add(midpoint[h.Edge.Index]);
                h = h.Previous.Twin;
            }
            while (h != first);
            cells.Add(v.Index);
            start.Add(corners.Count);
        }

        NonManifoldPolicy policy = closed ? NonManifoldPolicy.Throw : NonManifoldPolicy.Split;
        Mesh dual = MeshBuilder.FromPolygons(new PolygonSoup([.. positions], [.. start], [.. corners]), policy, out BuildReport report);
        var source = new int[dual.VertexSlots];
        for (int v = 0; v < source.Length; v++)
        {
            int from = report.SourceVertices?[v] ?? v;
            source[v] = from < centers.Length ? from : -1;
        }
        return new(dual, source, [.. cells]);
    }

    private static int[] AddMidpoints(Mesh mesh, List<Vector3D> positions, bool boundaryOnly)
    {
        var number = new int[mesh.EdgeSlots];
        foreach (Edge e in mesh.Edges)
        {
            number[e.Index] = -1;
            if (boundaryOnly && !e.IsBoundary)
                continue;
            number[e.Index] = positions.Count;
            positions.Add(Vector3D.Lerp(e.Vertex0.Position, e.Vertex1.Position, 0.5));
        }
        return number;
    }

    private static int[] AddBoundaryVertices(Mesh mesh, List<Vector3D> positions)
    {
        var number = new int[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            number[v.Index] = -1;
            if (!v.IsBoundary || v.IsIsolated)
                continue;
            number[v.Index] = positions.Count;
            positions.Add(v.Position);
        }
        return number;
    }
}
