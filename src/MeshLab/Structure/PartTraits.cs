namespace MeshLab.Structure;

/// <summary>The traits of a part: copied with what was kept, blended along the edges that were cut, default on what is new.</summary>
internal static class PartTraits
{
    public static void Derive(Mesh source, Mesh part, int[] sourceVertex, int[] sourceFace, int[]? cutHalfEdge, double[]? parameter)
    {
        if (source.VertexTraits.Count > 0)
            DeriveVertices(source, part, sourceVertex, cutHalfEdge, parameter);
        if (source.FaceTraits.Count > 0)
            part.DeriveTraits(source, ElementKind.Face, sourceFace);
        if (source.EdgeTraits.Count > 0)
            part.DeriveTraits(source, ElementKind.Edge, [.. part.Edges.Select(e => SourceEdge(source, e, sourceVertex, cutHalfEdge))]);
        if (source.HalfEdgeTraits.Count > 0)
            DeriveCorners(source, part, sourceVertex, sourceFace, cutHalfEdge, parameter);
    }

    private static void DeriveVertices(Mesh source, Mesh part, int[] sourceVertex, int[]? cutHalfEdge, double[]? parameter)
    {
        int[] first = [.. sourceVertex];
        int[]? second = null;
        if (cutHalfEdge is not null)
        {
            second = new int[first.Length];
            for (int v = 0; v < first.Length; v++)
            {
                int h = cutHalfEdge[v];
                second[v] = h < 0 ? -1 : source.target[h];
                if (h >= 0)
                    first[v] = source.target[h ^ 1];
            }
        }
        part.DeriveTraits(source, ElementKind.Vertex, first, second, parameter);
    }

    /// <summary>The old edge that an edge of the part is, or lies on; −1 if it crosses a face.</summary>
    private static int SourceEdge(Mesh source, Edge edge, int[] sourceVertex, int[]? cutHalfEdge)
    {
        int a = edge.Vertex0.Index, b = edge.Vertex1.Index;
        int cutA = cutHalfEdge?[a] ?? -1, cutB = cutHalfEdge?[b] ?? -1;
        if (cutA < 0 && cutB < 0)
        {
            if (sourceVertex[a] < 0 || sourceVertex[b] < 0)
                return -1;
            int h = source.FindHalfEdge(sourceVertex[a], sourceVertex[b]);
            return h < 0 ? -1 : h >> 1;
        }
        if (cutA >= 0 && cutB >= 0)
            return cutA >> 1 == cutB >> 1 ? cutA >> 1 : -1;
        int cut = Math.Max(cutA, cutB), end = sourceVertex[cutA < 0 ? a : b];
        return source.target[cut] == end || source.target[cut ^ 1] == end ? cut >> 1 : -1;
    }

    private static void DeriveCorners(Mesh source, Mesh part, int[] sourceVertex, int[] sourceFace, int[]? cutHalfEdge, double[]? parameter)
    {
        int n = part.HalfEdgeSlots;
        int[] first = new int[n], second = new int[n];
        var t = new double[n];
        Array.Fill(first, -1);
        Array.Fill(second, -1);
        for (int h = 0; h < n; h++)
        {
            int f = part.face[h], v = part.target[h];
            if (f < 0 || sourceFace[f] < 0)
                continue;
            int cut = cutHalfEdge?[v] ?? -1;
            if (cut < 0)
            {
                first[h] = Corner(source, sourceFace[f], sourceVertex[v]);
                continue;
            }
            first[h] = Corner(source, sourceFace[f], source.target[cut ^ 1]);
            second[h] = Corner(source, sourceFace[f], source.target[cut]);
            t[h] = parameter![v];
        }
        part.DeriveTraits(source, ElementKind.HalfEdge, first, second, t);
    }

    /// <summary>The half-edge of a face that points to a vertex, or −1.</summary>
    private static int Corner(Mesh mesh, int face, int vertex)
    {
        int first = mesh.halfEdgeOf[face], h = first;
        do
        {
            if (mesh.target[h] == vertex)
                return h;
            h = mesh.next[h];
        }
        while (h != first);
        return -1;
    }
}
