using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>Two trees that share no edge (树–余树分解): one over the vertices, one over the faces. The edges in neither are 2g per component.</summary>
/// <remarks>
/// Eppstein 2003. Each boundary loop counts as one more face, as if it were filled, so that a surface with holes has the generators of its
/// closed form. Between holes the second tree crosses boundary edges.
/// </remarks>
internal sealed class TreeCotree
{
    private readonly Mesh mesh;

    /// <summary>Per vertex the half-edge that comes from its parent; −1 at roots.</summary>
    private readonly int[] fromParent;

    /// <summary>Per vertex its distance from the root along the tree.</summary>
    private readonly double[] distance;

    private readonly bool[] isUsed;

    /// <summary>Per half-edge the face or hole to its left, and the half-edges over which the cotree goes down from it, parents first.</summary>
    private int[] nodes = [];
    private readonly List<int> downCotree = [];

    /// <summary>Grows both trees.</summary>
    /// <param name="mesh">A mesh.</param>
    /// <param name="shortest">Shortest-path tree and longest cotree (Erickson, Whittlesey 2005), else breadth first.</param>
    public TreeCotree(Mesh mesh, bool shortest)
    {
        this.mesh = mesh;
        fromParent = new int[mesh.VertexSlots];
        distance = new double[mesh.VertexSlots];
        isUsed = new bool[mesh.EdgeSlots];
        Array.Fill(fromParent, -1);
        if (shortest)
            GrowShortestPaths();
        else
            GrowBreadthFirst();
        for (int v = 0; v < fromParent.Length; v++)
        {
            if (fromParent[v] >= 0)
                isUsed[fromParent[v] >> 1] = true;
        }
        GrowCotree(shortest);
    }

    /// <summary>The edges in neither tree, in index order.</summary>
    public IEnumerable<int> RemainingEdges => Enumerable.Range(0, mesh.EdgeSlots).Where(e => !isUsed[e] && !mesh.IsDeletedEdge(e));

    /// <summary>The edge closed to a loop by the tree: from its lower common ancestor down, across the edge, and back up. Simple by construction.</summary>
    public List<HalfEdge> LoopThrough(int edge)
    {
        int across = 2 * edge;
        // The edge goes from a to b; the loop from the ancestor down to a, over the edge, and from b up again.
        List<int> toA = PathFromRoot(mesh.target[across ^ 1]), toB = PathFromRoot(mesh.target[across]);
        int common = 0;
        while (common < toA.Count && common < toB.Count && toA[common] == toB[common])
            common++;
        List<HalfEdge> loop = [.. toA.Skip(common).Select(h => new HalfEdge(mesh, h)), new(mesh, across)];
        for (int i = toB.Count - 1; i >= common; i--)
            loop.Add(new(mesh, toB[i] ^ 1));
        return loop;
    }

    /// <summary>A loop as a sum of the loops through the remaining edges: how often each of them is in it, up to boundaries of faces and holes.</summary>
    /// <remarks>
    /// The edge i and the cotree close one path of faces, which crosses the loop through i once and no other of those loops. So the number is how
    /// often that path crosses the given loop, from one side less from the other. O(V + E).
    /// </remarks>
    public long[] Coordinates(IEnumerable<HalfEdge> loop)
    {
        if (downCotree.Count == 0)
            WalkCotree();
        var passes = new int[mesh.EdgeSlots];
        foreach (HalfEdge h in loop)
            passes[h.index >> 1] += Sign(h.index);
        // Crossings on the way from the cotree's root.
        var crossed = new long[mesh.FaceSlots + mesh.HalfEdgeSlots];
        foreach (int h in downCotree)
            crossed[nodes[h ^ 1]] = crossed[nodes[h]] + passes[h >> 1] * Sign(h);
        return [.. RemainingEdges.Select(e => passes[e] + crossed[nodes[2 * e]] - crossed[nodes[2 * e + 1]])];

        static int Sign(int h) => 1 - 2 * (h & 1);
    }

    /// <summary>Puts the half-edges that the cotree crosses in order, breadth first from the lowest face or hole of each component.</summary>
    private void WalkCotree()
    {
        var isRemaining = new bool[mesh.EdgeSlots];
        foreach (int e in RemainingEdges)
            isRemaining[e] = true;
        var seen = new bool[mesh.FaceSlots + mesh.HalfEdgeSlots];
        var waiting = new Queue<int>();
        for (int root = 0; root < nodes.Length; root++)
        {
            if (nodes[root] < 0 || seen[nodes[root]])
                continue;
            seen[nodes[root]] = true;
            waiting.Enqueue(root);
            while (waiting.TryDequeue(out int first))
            {
                int h = first;
                do
                {
                    bool isInTree = fromParent[mesh.target[h]] == h || fromParent[mesh.target[h ^ 1]] == (h ^ 1);
                    if (!isInTree && !isRemaining[h >> 1] && !seen[nodes[h ^ 1]])
                    {
                        seen[nodes[h ^ 1]] = true;
                        downCotree.Add(h);
                        waiting.Enqueue(h ^ 1);
                    }
                    h = mesh.next[h];
                }
                while (h != first);
            }
        }
    }

    private List<int> PathFromRoot(int v)
    {
        var path = new List<int>();
        for (int h = fromParent[v]; h >= 0; h = fromParent[mesh.target[h ^ 1]])
            path.Add(h);
        path.Reverse();
        return path;
    }

    private void GrowBreadthFirst()
    {
        var seen = new bool[mesh.VertexSlots];
        var waiting = new Queue<int>();
        for (int root = 0; root < seen.Length; root++)
        {
            if (seen[root] || mesh.outgoing[root] < 0)
                continue;
            seen[root] = true;
            waiting.Enqueue(root);
            while (waiting.TryDequeue(out int v))
            {
                int first = mesh.outgoing[v], h = first;
                do
                {
                    int p = mesh.target[h];
                    if (!seen[p])
                    {
                        seen[p] = true;
                        fromParent[p] = h;
                        waiting.Enqueue(p);
                    }
                    h = mesh.next[h ^ 1];
                }
                while (h != first);
            }
        }
    }

    /// <summary>Dijkstra from the lowest vertex of each component; ties by vertex.</summary>
    private void GrowShortestPaths()
    {
        Array.Fill(distance, double.PositiveInfinity);
        var done = new bool[mesh.VertexSlots];
        var front = new PriorityQueue<int, (double, int)>();
        Vector3D[] positions = mesh.positions;
        for (int root = 0; root < done.Length; root++)
        {
            if (done[root] || mesh.outgoing[root] < 0)
                continue;
            distance[root] = 0;
            front.Enqueue(root, (0, root));
            while (front.TryDequeue(out int v, out _))
            {
                if (done[v])
                    continue;
                done[v] = true;
                int first = mesh.outgoing[v], h = first;
                do
                {
                    int p = mesh.target[h];
                    double through = distance[v] + (positions[p] - positions[v]).Length;
                    if (!done[p] && through < distance[p])
                    {
                        distance[p] = through;
                        fromParent[p] = h;
                        front.Enqueue(p, (through, p));
                    }
                    h = mesh.next[h ^ 1];
                }
                while (h != first);
            }
        }
    }

    /// <summary>A spanning tree of the faces and filled holes over the edges that the first tree left; the edges whose loops are longest go first.</summary>
    private void GrowCotree(bool longestFirst)
    {
        int[] edges = [.. RemainingEdges];
        if (longestFirst)
        {
            double[] key = Array.ConvertAll(edges, e => -LoopLength(e));
            // Equal loops in order of edges: the keys are made unique by a stable sort over indices.
            int[] order = [.. Enumerable.Range(0, edges.Length)];
            Array.Sort(order, (i, j) => key[i] != key[j] ? key[i].CompareTo(key[j]) : edges[i].CompareTo(edges[j]));
            edges = Array.ConvertAll(order, i => edges[i]);
        }
        nodes = FacesAndHoles();
        int[] parent = [.. Enumerable.Range(0, mesh.FaceSlots + mesh.HalfEdgeSlots)];
        foreach (int e in edges)
        {
            int a = Root(parent, nodes[2 * e]), b = Root(parent, nodes[(2 * e) + 1]);
            if (a == b)
                continue;
            parent[Math.Max(a, b)] = Math.Min(a, b);
            isUsed[e] = true;
        }
    }

    /// <summary>Per half-edge the face to its left, or a number for the hole there.</summary>
    private int[] FacesAndHoles()
    {
        var nodes = new int[mesh.HalfEdgeSlots];
        Array.Fill(nodes, -1);
        for (int h = 0; h < nodes.Length; h++)
        {
            if (nodes[h] >= 0 || mesh.next[h] < 0)
                continue;
            int node = mesh.face[h] >= 0 ? mesh.face[h] : mesh.FaceSlots + h;
            int g = h;
            do
            {
                nodes[g] = node;
                g = mesh.next[g];
            }
            while (g != h);
        }
        return nodes;
    }

    private double LoopLength(int e)
    {
        int a = mesh.target[2 * e], b = mesh.target[(2 * e) + 1];
        return distance[a] + distance[b] + (mesh.positions[a] - mesh.positions[b]).Length;
    }

    private static int Root(int[] parent, int v)
    {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    }
}
