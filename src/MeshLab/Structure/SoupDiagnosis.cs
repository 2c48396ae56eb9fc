namespace MeshLab.Structure;

/// <summary>Says why polygons do not make an oriented 2-manifold, with the elements by name.</summary>
internal static class SoupDiagnosis
{
    /// <summary>How many elements one message names.</summary>
    private const int MostNamed = 64;

    /// <summary>The error for the first kind of defect that is found, in the order: faces, edges, vertices.</summary>
    public static TopologyException Explain(PolygonSoup soup)
    {
        List<string> elements = [];
        string? message = ExplainFaces(soup, elements) ?? ExplainEdges(soup, elements) ?? ExplainVertices(soup, elements);
        return new TopologyException(message ?? "The faces do not make an oriented 2-manifold.", elements);
    }

    /// <summary>The place of the first vertex that appears twice in a face, or −1.</summary>
    public static int RepeatedVertex(ReadOnlySpan<int> face)
    {
        if (face.Length <= 64)
        {
            for (int i = 1; i < face.Length; i++)
            {
                if (face[..i].Contains(face[i]))
                    return i;
            }
            return -1;
        }
        var seen = new HashSet<int>();
        for (int i = 0; i < face.Length; i++)
        {
            if (!seen.Add(face[i]))
                return i;
        }
        return -1;
    }

    private static string? ExplainFaces(PolygonSoup soup, List<string> elements)
    {
        string? message = null;
        for (int f = 0; f < soup.FaceCount && elements.Count < MostNamed; f++)
        {
            ReadOnlySpan<int> face = soup.Face(f);
            int repeated = RepeatedVertex(face);
            if (face.Length >= 3 && repeated < 0)
                continue;
            AddNew(elements, repeated >= 0 ? [ElementName.Face(f), ElementName.Vertex(face[repeated])] : [ElementName.Face(f)]);
            message ??= repeated >= 0
                ? $"f{f} has v{face[repeated]} twice."
                : $"f{f} has {face.Length} vertices; a face has at least 3.";
        }
        return message;
    }

    private static string? ExplainEdges(PolygonSoup soup, List<string> elements)
    {
        string? message = null;
        var byEdge = new Dictionary<(int, int), List<int>>();
        ForEachEdge(soup, (f, from, to) =>
        {
            (int, int) key = from < to ? (from, to) : (to, from);
            if (!byEdge.TryGetValue(key, out List<int>? faces))
                byEdge[key] = faces = [];
            faces.Add(from < to ? f : ~f);
        });
        foreach (var ((a, b), faces) in byEdge)
        {
            if (faces.Count < 2 || (faces.Count == 2 && faces[0] >= 0 != faces[1] >= 0) || elements.Count >= MostNamed)
                continue;
            List<string> names = faces.ConvertAll(f => ElementName.Face(f < 0 ? ~f : f));
            message ??= faces.Count > 2
                ? $"The edge v{a}–v{b} belongs to {faces.Count} faces: {string.Join(", ", names.Take(8))}."
                : $"{names[0]} and {names[1]} run along the edge v{a}–v{b} in the same direction: they are oriented against each other.";
            AddNew(elements, [ElementName.Vertex(a), ElementName.Vertex(b), .. names]);
        }
        return message;
    }

    private static string? ExplainVertices(PolygonSoup soup, List<string> elements)
    {
        string? message = null;
        int[] fan = FansOfCorners(soup, out int[] fansAtVertex);
        for (int v = 0; v < fansAtVertex.Length && elements.Count < MostNamed; v++)
        {
            if (fansAtVertex[v] < 2)
                continue;
            var firstFaces = new List<string>();
            var seen = new HashSet<int>();
            for (int f = 0; message is null && f < soup.FaceCount; f++)
            {
                for (int c = soup.FaceStart[f]; c < soup.FaceStart[f + 1]; c++)
                {
                    if (soup.Corners[c] == v && seen.Add(fan[c]))
                        firstFaces.Add(ElementName.Face(f));
                }
            }
            message ??= $"The faces at v{v} are {fansAtVertex[v]} fans that touch in the vertex only: {string.Join(", ", firstFaces.Take(8))}.";
            AddNew(elements, [ElementName.Vertex(v), .. firstFaces]);
        }
        return message;
    }

    /// <summary>Groups the corners at each vertex by fans of faces joined across edges. An edge used more than twice, or twice in one direction, joins nothing.</summary>
    /// <returns>Per corner the first corner of its fan.</returns>
    public static int[] FansOfCorners(PolygonSoup soup, out int[] fansAtVertex)
    {
        var fan = new int[soup.Corners.Length];
        for (int c = 0; c < fan.Length; c++)
            fan[c] = c;
        int[] following = Following(soup);
        foreach (var (forward, backward) in ProperEdges(soup, following))
        {
            Join(fan, forward, following[backward]);
            Join(fan, backward, following[forward]);
        }

        fansAtVertex = new int[soup.VertexCount];
        for (int c = 0; c < fan.Length; c++)
        {
            fan[c] = Root(fan, c);
            if (fan[c] == c)
                fansAtVertex[soup.Corners[c]]++;
        }
        return fan;
    }

    /// <summary>The edges that are used once in either direction, as the two corners that they leave.</summary>
    private static IEnumerable<(int Forward, int Backward)> ProperEdges(PolygonSoup soup, int[] following)
    {
        var edges = new EdgeTable(soup.Corners.Length);
        // Corners plus one: zero says "none".
        var uses = new (int Forward, int Backward, int Count)[soup.Corners.Length];
        for (int c = 0; c < following.Length; c++)
        {
            int from = soup.Corners[c], to = soup.Corners[following[c]];
            ref var use = ref uses[edges.NumberOf(Math.Min(from, to), Math.Max(from, to))];
            if (from < to)
                use.Forward = c + 1;
            else
                use.Backward = c + 1;
            use.Count++;
        }
        for (int e = 0; e < edges.Count; e++)
        {
            var (forward, backward, count) = uses[e];
            if (count == 2 && forward > 0 && backward > 0)
                yield return (forward - 1, backward - 1);
        }
    }

    private static int[] Following(PolygonSoup soup)
    {
        var following = new int[soup.Corners.Length];
        for (int f = 0; f < soup.FaceCount; f++)
        {
            int first = soup.FaceStart[f], end = soup.FaceStart[f + 1];
            for (int c = first; c < end; c++)
                following[c] = c + 1 == end ? first : c + 1;
        }
        return following;
    }

    private static void ForEachEdge(PolygonSoup soup, Action<int, int, int> visit)
    {
        for (int f = 0; f < soup.FaceCount; f++)
        {
            ReadOnlySpan<int> face = soup.Face(f);
            for (int i = 0; i < face.Length; i++)
                visit(f, face[i], face[(i + 1) % face.Length]);
        }
    }

    private static void Join(int[] parent, int a, int b)
    {
        a = Root(parent, a);
        b = Root(parent, b);
        // The smaller corner stays the root, so that the result does not depend on the order.
        parent[Math.Max(a, b)] = Math.Min(a, b);
    }

    private static int Root(int[] parent, int c)
    {
        while (parent[c] != c)
        {
            parent[c] = parent[parent[c]];
            c = parent[c];
        }
        return c;
    }

    private static void AddNew(List<string> elements, IEnumerable<string> names)
    {
        foreach (string name in names)
        {
            if (!elements.Contains(name) && elements.Count < MostNamed)
                elements.Add(name);
        }
    }
}
