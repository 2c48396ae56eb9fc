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
        int[] nodes = FacesAndHoles();
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
