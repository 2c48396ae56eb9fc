using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>§11.6 切割图 (cut graph): edges along which each component is cut open into one disk.</summary>
/// <remarks>
/// A spanning tree of the faces, glued together across its edges, is a disk; the edges not crossed hold its rim. Dangling branches are pruned
/// until every end is on the boundary or in a loop. O(V + E). A closed component of genus 0 has an empty graph then: it is cut along two edges at
/// its lowest vertex, the least that opens it. A component that is a disk already needs nothing.
/// </remarks>
public static class CutGraph
{
    extension(Mesh mesh)
    {
        /// <summary>The interior edges to cut along, in index order.</summary>
        public Edge[] FindCutGraph()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            var isCut = new bool[mesh.EdgeSlots];
            foreach (Edge e in mesh.Edges)
                isCut[e.index] = true;
            GlueFaces(mesh, isCut);
            Prune(mesh, isCut);
            OpenSpheres(mesh, isCut);
            return [.. mesh.Edges.Where(e => isCut[e.index] && !e.IsBoundary)];
        }
    }

    /// <summary>Takes out the edges that a breadth-first tree of the faces crosses.</summary>
    private static void GlueFaces(Mesh mesh, bool[] isCut)
    {
        var seen = new bool[mesh.FaceSlots];
        var waiting = new Queue<int>();
        for (int seed = 0; seed < seen.Length; seed++)
        {
            if (seen[seed] || mesh.IsDeletedFace(seed))
                continue;
            seen[seed] = true;
            waiting.Enqueue(seed);
            while (waiting.TryDequeue(out int f))
            {
                int first = mesh.halfEdgeOf[f], h = first;
                do
                {
                    int across = mesh.face[h ^ 1];
                    if (across >= 0 && !seen[across])
                    {
                        seen[across] = true;
                        isCut[h >> 1] = false;
                        waiting.Enqueue(across);
                    }
                    h = mesh.next[h];
                }
                while (h != first);
            }
        }
    }

    /// <summary>Takes out edges at vertices with no other cut edge, again and again.</summary>
    private static void Prune(Mesh mesh, bool[] isCut)
    {
        var degree = new int[mesh.VertexSlots];
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
        {
            if (isCut[h >> 1])
                degree[mesh.target[h]]++;
        }
        var waiting = new Stack<int>();
        for (int v = degree.Length - 1; v >= 0; v--)
        {
            if (degree[v] == 1)
                waiting.Push(v);
        }
        while (waiting.TryPop(out int v))
        {
            if (degree[v] != 1)
                continue;
            int h = mesh.outgoing[v];
            while (!isCut[h >> 1])
                h = mesh.next[h ^ 1];
            isCut[h >> 1] = false;
            degree[v]--;
            if (--degree[mesh.target[h]] == 1)
                waiting.Push(mesh.target[h]);
        }
    }

    /// <summary>A closed component without any cut edge is a sphere.</summary>
    private static void OpenSpheres(Mesh mesh, bool[] isCut)
    {
        MeshComponents components = mesh.FindComponents();
        var isOpen = new bool[components.Count];
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
        {
            if (isCut[h >> 1])
                isOpen[components.VertexLabels[mesh.target[h]]] = true;
        }
        for (int v = 0; v < components.VertexLabels.Length; v++)
        {
            int label = components.VertexLabels[v];
            if (label < 0 || isOpen[label])
                continue;
            isOpen[label] = true;
            int h = mesh.outgoing[v];
            isCut[h >> 1] = true;
            isCut[mesh.next[h ^ 1] >> 1] = true;
        }
    }
}
