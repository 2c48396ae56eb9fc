using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>An undirected edge of a polygon soup and the faces at it.</summary>
/// <param name="Vertex0">The lower end.</param>
/// <param name="Vertex1">The higher end.</param>
/// <param name="Faces">The faces with a side there, in order; one that has two sides there comes twice.</param>
public sealed record SoupEdge(int Vertex0, int Vertex1, IReadOnlyList<int> Faces)
{
    /// <summary><c>v3–v7 (f0, f4, f9)</c>.</summary>
    public override string ToString() =>
        $"{ElementName.Vertex(Vertex0)}–{ElementName.Vertex(Vertex1)} ({string.Join(", ", Faces.Select(ElementName.Face))})";
}

/// <summary>What stands between polygons and an oriented 2-manifold. All lists are in index order.</summary>
/// <param name="DegenerateFaces">Faces with fewer than three vertices or a vertex twice; the other tests leave them out.</param>
/// <param name="NonManifoldEdges">Edges with more than two faces.</param>
/// <param name="NonManifoldVertices">Vertices whose faces are several fans that touch in the vertex only.</param>
/// <param name="MisorientedEdges">Edges that two faces run through in the same direction.</param>
/// <param name="FlippedFaces">The faces to turn so that all agree, the lowest of each connected part kept; empty if not orientable.</param>
/// <param name="UnorientableEdges">Edges at which a part's faces cannot be made to agree: a Möbius band (莫比乌斯带) runs across each. One per contradiction found.</param>
/// <param name="BoundaryEdges">The number of edges with one face.</param>
public sealed record SoupTopologyReport(
    IReadOnlyList<int> DegenerateFaces,
    IReadOnlyList<SoupEdge> NonManifoldEdges,
    IReadOnlyList<int> NonManifoldVertices,
    IReadOnlyList<SoupEdge> MisorientedEdges,
    IReadOnlyList<int> FlippedFaces,
    IReadOnlyList<SoupEdge> UnorientableEdges,
    int BoundaryEdges)
{
    /// <summary>Whether every edge has at most two faces and every vertex one fan (流形).</summary>
    public bool IsManifold => DegenerateFaces.Count == 0 && NonManifoldEdges.Count == 0 && NonManifoldVertices.Count == 0;

    /// <summary>Whether the faces can be turned to agree (可定向); faces are compared across edges with two faces.</summary>
    public bool IsOrientable => UnorientableEdges.Count == 0;

    /// <summary>Whether they agree as they are.</summary>
    public bool IsOriented => MisorientedEdges.Count == 0;

    /// <summary>Whether there is no edge with one face.</summary>
    public bool IsClosed => BoundaryEdges == 0;
}

/// <summary>§11 Tests of polygons before they become a mesh: are they a manifold, and can they be oriented?</summary>
/// <remarks>
/// Two faces at an edge agree if they run through it in opposite directions. A flood over the faces decides for each whether it must be turned; an edge where the
/// two decisions contradict each other proves that the part is not orientable. Orientation is not needed to tell fans apart. O(corners), by hashing.
/// </remarks>
public static class SoupTopology
{
    /// <summary>Examines polygons and names the offending elements.</summary>
    public static SoupTopologyReport Examine(PolygonSoup soup)
    {
        ArgumentNullException.ThrowIfNull(soup);
        List<int> degenerate = [.. Enumerable.Range(0, soup.FaceCount).Where(f => IsDegenerate(soup.Face(f)))];
        var skip = new bool[soup.FaceCount];
        foreach (int f in degenerate)
            skip[f] = true;
        List<Side[]> edges = SidesByEdge(soup, skip);
        (List<int> flipped, List<Side[]> contradictions) = Orient(soup, skip, edges);
        return new(
            degenerate,
            [.. edges.Where(sides => sides.Length > 2).Select(Name)],
            VerticesWithSeveralFans(soup, skip, edges),
            [.. edges.Where(sides => sides.Length == 2 && sides[0].Forward == sides[1].Forward).Select(Name)],
            flipped,
            [.. contradictions.Select(Name)],
            edges.Count(sides => sides.Length == 1));
    }

    /// <summary>The same polygons with the faces turned that <see cref="SoupTopologyReport.FlippedFaces"/> names.</summary>
    /// <exception cref="TopologyException">The polygons are not orientable; the faces at a contradiction are named.</exception>
    public static PolygonSoup MakeOriented(PolygonSoup soup)
    {
        SoupTopologyReport report = Examine(soup);
        if (!report.IsOrientable)
        {
            SoupEdge edge = report.UnorientableEdges[0];
            throw new TopologyException(
                $"The faces cannot be oriented: {edge} closes a Möbius band.",
                [ElementName.Vertex(edge.Vertex0), ElementName.Vertex(edge.Vertex1), .. edge.Faces.Select(ElementName.Face)]);
        }
        int[] corners = [.. soup.Corners];
        foreach (int f in report.FlippedFaces)
            Array.Reverse(corners, soup.FaceStart[f] + 1, soup.FaceStart[f + 1] - soup.FaceStart[f] - 1);
        return new(soup.Positions, soup.FaceStart, corners);
    }

    private static bool IsDegenerate(ReadOnlySpan<int> face) => face.Length < 3 || SoupDiagnosis.RepeatedVertex(face) >= 0;

    private static SoupEdge Name(Side[] sides) => new(sides[0].Low, sides[0].High, [.. sides.Select(s => s.Face)]);

    /// <summary>The sides of the faces, grouped by undirected edge, in order of the ends.</summary>
    private static List<Side[]> SidesByEdge(PolygonSoup soup, bool[] skip)
    {
        var byEdge = new Dictionary<(int, int), List<Side>>();
        for (int f = 0; f < soup.FaceCount; f++)
        {
            if (skip[f])
                continue;
            int first = soup.FaceStart[f], end = soup.FaceStart[f + 1];
            for (int c = first; c < end; c++)
            {
                int next = c + 1 == end ? first : c + 1, from = soup.Corners[c], to = soup.Corners[next];
                var side = new Side(f, c, next, Math.Min(from, to), Math.Max(from, to), from < to);
                if (!byEdge.TryGetValue((side.Low, side.High), out List<Side>? sides))
                    byEdge[(side.Low, side.High)] = sides = [];
                sides.Add(side);
            }
        }
        return [.. byEdge.OrderBy(pair => pair.Key).Select(pair => pair.Value.ToArray())];
    }

    /// <summary>Decides for every face whether it is turned, part by part from the lowest face.</summary>
    private static (List<int> Flipped, List<Side[]> Contradictions) Orient(PolygonSoup soup, bool[] skip, List<Side[]> edges)
    {
        var around = new List<Side[]>[soup.FaceCount];
        foreach (Side[] sides in edges)
        {
            if (sides.Length != 2)
                continue;
            foreach (Side side in sides)
                (around[side.Face] ??= []).Add(sides);
        }
        // 0 unknown, 1 as it is, −1 turned.
        var sense = new int[soup.FaceCount];
        var contradictions = new SortedDictionary<(int, int), Side[]>();
        var waiting = new Queue<int>();
        for (int seed = 0; seed < sense.Length; seed++)
        {
            if (skip[seed] || sense[seed] != 0)
                continue;
            sense[seed] = 1;
            waiting.Enqueue(seed);
            while (waiting.TryDequeue(out int f))
            {
                foreach (Side[] sides in around[f] ?? [])
                {
                    int other = sides[0].Face == f ? sides[1].Face : sides[0].Face;
                    int wanted = sides[0].Forward == sides[1].Forward ? -sense[f] : sense[f];
                    if (sense[other] == 0)
                    {
                        sense[other] = wanted;
                        waiting.Enqueue(other);
                    }
                    else if (sense[other] != wanted)
                    {
                        contradictions[(sides[0].Low, sides[0].High)] = sides;
                    }
                }
            }
        }
        List<int> flipped = contradictions.Count > 0 ? [] : [.. Enumerable.Range(0, sense.Length).Where(f => sense[f] < 0)];
        return (flipped, [.. contradictions.Values]);
    }

    /// <summary>Vertices whose corners are not all joined across edges with two faces.</summary>
    private static List<int> VerticesWithSeveralFans(PolygonSoup soup, bool[] skip, List<Side[]> edges)
    {
        int[] fan = [.. Enumerable.Range(0, soup.Corners.Length)];
        foreach (Side[] sides in edges)
        {
            if (sides.Length != 2)
                continue;
            foreach (int end in (ReadOnlySpan<int>)[sides[0].Low, sides[0].High])
                Join(fan, CornerAt(soup, sides[0], end), CornerAt(soup, sides[1], end));
        }
        var fans = new int[soup.VertexCount];
        for (int f = 0; f < soup.FaceCount; f++)
        {
            if (skip[f])
                continue;
            for (int c = soup.FaceStart[f]; c < soup.FaceStart[f + 1]; c++)
            {
                if (fan[c] == c)
                    fans[soup.Corners[c]]++;
            }
        }
        return [.. Enumerable.Range(0, fans.Length).Where(v => fans[v] > 1)];
    }

    private static int CornerAt(PolygonSoup soup, Side side, int vertex) => soup.Corners[side.Corner] == vertex ? side.Corner : side.NextCorner;

    private static void Join(int[] parent, int a, int b)
    {
        a = Root(parent, a);
        b = Root(parent, b);
        parent[Math.Max(a, b)] = Math.Min(a, b);
    }

    private static int Root(int[] parent, int c)
    {
        while (parent[c] != c)
            c = parent[c] = parent[parent[c]];
        return c;
    }

    /// <summary>A side of a face, from one corner to the next.</summary>
    private readonly record struct Side(int Face, int Corner, int NextCorner, int Low, int High, bool Forward);
}
