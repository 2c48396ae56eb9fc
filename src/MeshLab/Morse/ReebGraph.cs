using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>An arc of a Reeb graph: a tube of level curves between two critical levels.</summary>
/// <param name="Lower">The vertex at its lower end.</param>
/// <param name="Upper">The vertex at its upper end.</param>
public readonly record struct ReebArc(Vertex Lower, Vertex Upper);

/// <summary>§12.6 Reeb 图: what is left of a surface when every connected piece of a level curve is drawn together to a point (Reeb 1946).</summary>
/// <remarks>
/// The level curve through every saddle is traced across the faces, as far as it is connected with the saddle. These curves cut the surface into tubes,
/// one per arc. An edge crossed k times is k + 1 segments; in a face a &lt; b &lt; c the segments of the long edge ac are, in order, those of ab and bc,
/// with one more cut at b if the curve through b passes. So union–find over segments finds the tubes (after the idea of cylinders of Doraiswamy and
/// Natarajan 2012). On a closed orientable surface of genus g the graph of every function has g independent loops.
/// On the boundary, a vertex where a piece of level curve ends, begins, splits or joins is a node too.
/// O(F + length of the curves, counted in faces + S log S).
/// </remarks>
public sealed class ReebGraph
{
    private ReebGraph(IReadOnlyList<Vertex> nodes, IReadOnlyList<ReebArc> arcs)
    {
        Nodes = nodes;
        Arcs = arcs;
        LoopCount = arcs.Count - nodes.Count + CountComponents();
    }

    /// <summary>The nodes: vertices at which the level curves change, in index order.</summary>
    public IReadOnlyList<Vertex> Nodes { get; }

    /// <summary>The arcs, by lower and then upper end.</summary>
    public IReadOnlyList<ReebArc> Arcs { get; }

    /// <summary>The number of independent loops: arcs − nodes + components.</summary>
    public int LoopCount { get; }

    /// <summary>Builds the graph of a function.</summary>
    public static ReebGraph Of(MorseFunction function)
    {
        ArgumentNullException.ThrowIfNull(function);
        List<int> nodes = FindNodes(function);
        (int[] crossStart, int[] crossing) = TraceLevels(function, nodes);
        DisjointSets tubes = JoinSegments(function, crossStart, crossing);
        return Collect(function, nodes, crossStart, tubes);
    }

    /// <summary>Vertices without exactly one lower and one upper wedge, from lowest to highest.</summary>
    private static List<int> FindNodes(MorseFunction function)
    {
        var nodes = new List<int>();
        foreach (Vertex v in function.Mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            (int changes, bool allAlike) = CountChanges(function, v);
            if (allAlike || changes != (v.IsBoundary ? 1 : 2))
                nodes.Add(v.Index);
        }
        nodes.Sort((a, b) => a == b ? 0 : function.IsLower(a, b) ? -1 : 1);
        return nodes;
    }

    private static (int Changes, bool AllAlike) CountChanges(MorseFunction function, Vertex v)
    {
        int changes = 0;
        bool? first = null, last = null;
        foreach (Vertex w in v.Neighbors)
        {
            bool lower = function.IsLower(w.Index, v.Index);
            if (last is not null && lower != last)
                changes++;
            first ??= lower;
            last = lower;
        }
        if (!v.IsBoundary && first != last)
            changes++;
        return (changes, changes == 0);
    }

    /// <summary>Per edge the nodes whose level curve crosses it, from lowest to highest.</summary>
    private static (int[] Start, int[] Crossing) TraceLevels(MorseFunction function, List<int> nodes)
    {
        Mesh mesh = function.Mesh;
        var hits = new List<(int Edge, int Node)>();
        var stamp = new int[mesh.EdgeSlots];
        Array.Fill(stamp, -1);
        foreach (int node in nodes)
        {
            foreach (HalfEdge spoke in mesh.Vertices[node].OutgoingHalfEdges)
            {
                if (!spoke.IsBoundary)
                    Trace(function, node, spoke.Next.Index, stamp, hits);
            }
        }
        // The nodes came in ascending order, so a stable count by edge leaves each edge's list sorted.
        var start = new int[mesh.EdgeSlots + 1];
        foreach ((int edge, _) in hits)
            start[edge + 1]++;
        for (int e = 0; e < mesh.EdgeSlots; e++)
            start[e + 1] += start[e];
        var place = (int[])start.Clone();
        var crossing = new int[hits.Count];
        foreach ((int edge, int node) in hits)
            crossing[place[edge]++] = node;
        return (start, crossing);
    }

    /// <summary>Follows the level curve of a vertex from the opposite edge of one of its faces until it comes back to the vertex or ends at the boundary.</summary>
    private static void Trace(MorseFunction function, int node, int h, int[] stamp, List<(int Edge, int Node)> hits)
    {
        Mesh mesh = function.Mesh;
        while (Straddles(function, node, h) && stamp[h >> 1] != node)
        {
            stamp[h >> 1] = node;
            hits.Add((h >> 1, node));
            int across = h ^ 1;
            if (mesh.FaceOf[across] < 0)
                return;
            int left = mesh.Next[across], right = mesh.Previous[across];
            if (mesh.Target[left] == node)
                return;
            h = Straddles(function, node, left) ? left : right;
        }
    }

    private static bool Straddles(MorseFunction function, int node, int h)
    {
        int a = function.Mesh.Target[h], b = function.Mesh.Target[h ^ 1];
        return a != node && b != node && function.IsLower(a, node) != function.IsLower(b, node);
    }

    /// <summary>Joins the segments of edges that lie on the same tube. Segment i of edge e has the number e + start[e] + i.</summary>
    private static DisjointSets JoinSegments(MorseFunction function, int[] start, int[] crossing)
    {
        Mesh mesh = function.Mesh;
        var tubes = new DisjointSets(mesh.EdgeSlots + crossing.Length);
        foreach (Face f in mesh.Faces)
        {
            (int ab, int bc, int ac) = SortEdges(function, f);
            int onAb = start[ab + 1] - start[ab], onBc = start[bc + 1] - start[bc], onAc = start[ac + 1] - start[ac];
            for (int i = 0; i <= onAb; i++)
                Join(tubes, ac + start[ac] + i, ab + start[ab] + i);
            for (int i = 0; i <= onBc; i++)
                Join(tubes, ac + start[ac] + (onAc - onBc) + i, bc + start[bc] + i);
        }
        return tubes;
    }

    private static void Join(DisjointSets sets, int a, int b)
    {
        a = sets.Find(a);
        b = sets.Find(b);
        if (a != b)
            sets.Attach(Math.Max(a, b), Math.Min(a, b));
    }

    private static (int AB, int BC, int AC) SortEdges(MorseFunction function, Face f)
    {
        HalfEdge h = f.HalfEdge;
        // Turn the face until h leaves its lowest vertex.
        while (function.IsLower(h.Target.Index, h.Source.Index) || function.IsLower(h.Next.Target.Index, h.Source.Index))
            h = h.Next;
        return function.IsLower(h.Target.Index, h.Next.Target.Index)
            ? (h.Edge.Index, h.Next.Edge.Index, h.Previous.Edge.Index)
            : (h.Previous.Edge.Index, h.Next.Edge.Index, h.Edge.Index);
    }

    private static ReebGraph Collect(MorseFunction function, List<int> nodes, int[] start, DisjointSets tubes)
    {
        Mesh mesh = function.Mesh;
        var lower = new Dictionary<int, int>();
        var upper = new Dictionary<int, int>();
        foreach (int node in nodes)
        {
            foreach (HalfEdge spoke in mesh.Vertices[node].OutgoingHalfEdges)
            {
                int e = spoke.Edge.Index;
                if (function.IsLower(node, spoke.Target.Index))
                    lower[tubes.Find(e + start[e])] = node;
                else
                    upper[tubes.Find(e + start[e + 1])] = node;
            }
        }
        var arcs = new List<ReebArc>();
        foreach ((int tube, int low) in lower)
            arcs.Add(new(mesh.Vertices[low], mesh.Vertices[upper[tube]]));
        arcs.Sort((x, y) => x.Lower != y.Lower ? x.Lower.CompareTo(y.Lower) : x.Upper.CompareTo(y.Upper));
        return new ReebGraph([.. nodes.Order().Select(v => mesh.Vertices[v])], arcs);
    }

    private int CountComponents()
    {
        var number = new Dictionary<Vertex, int>();
        foreach (Vertex v in Nodes)
            number[v] = number.Count;
        var sets = new DisjointSets(Nodes.Count);
        int components = Nodes.Count;
        foreach (ReebArc arc in Arcs)
        {
            int a = sets.Find(number[arc.Lower]), b = sets.Find(number[arc.Upper]);
            if (a == b)
                continue;
            sets.Attach(a, b);
            components--;
        }
        return components;
    }
}
