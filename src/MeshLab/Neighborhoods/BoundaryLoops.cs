using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>A loop of the boundary (边界环): the rim of a hole, with the hole to the left.</summary>
/// <param name="Mesh">The mesh.</param>
/// <param name="HalfEdges">The boundary half-edges in order, from the one that leaves the loop's lowest vertex.</param>
/// <param name="Length">The sum of the edge lengths, in model units.</param>
public sealed record BoundaryLoop(Mesh Mesh, IReadOnlyList<HalfEdge> HalfEdges, double Length)
{
    /// <summary>The vertices in order, from the lowest.</summary>
    public IReadOnlyList<Vertex> Vertices => [.. HalfEdges.Select(h => h.Source)];

    /// <summary>The number of edges, and of vertices.</summary>
    public int Count => HalfEdges.Count;
}

/// <summary>§5.6 网格边界 (the boundary of the mesh): all loops, ordered, with length. An isolated vertex is not a loop.</summary>
public static class BoundaryLoops
{
    extension(Mesh mesh)
    {
        /// <summary>All loops, by their lowest vertex. O(H) to find them, most of it a scan of one column.</summary>
        public IReadOnlyList<BoundaryLoop> FindBoundaryLoops()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            var loops = new List<BoundaryLoop>();
            foreach (int start in LoopStarts(mesh))
                loops.Add(Loop(mesh, start));
            loops.Sort((a, b) => a.HalfEdges[0].Source.index.CompareTo(b.HalfEdges[0].Source.index));
            return loops;
        }

        /// <summary>The number of loops. O(H).</summary>
        public int BoundaryLoopCount
        {
            get
            {
                ArgumentNullException.ThrowIfNull(mesh);
                return LoopStarts(mesh).Count;
            }
        }

        /// <summary>The edges with a face on one side only, in index order. O(H).</summary>
        public Edge[] BoundaryEdges
        {
            get
            {
                ArgumentNullException.ThrowIfNull(mesh);
                var found = new List<int>();
                for (int h = NextBoundary(mesh, 0); h >= 0; h = NextBoundary(mesh, h + 1))
                    found.Add(h >> 1);
                return SortedElements.Edges(mesh, found);
            }
        }
    }

    /// <summary>One half-edge of each loop, the lowest.</summary>
    internal static List<int> LoopStarts(Mesh mesh)
    {
        var starts = new List<int>();
        var walked = new ulong[(mesh.HalfEdgeSlots + 63) / 64];
        int[] next = mesh.next;
        for (int h = NextBoundary(mesh, 0); h >= 0; h = NextBoundary(mesh, h + 1))
        {
            if ((walked[h >> 6] >> h & 1) != 0)
                continue;
            starts.Add(h);
            int g = h;
            do
            {
                walked[g >> 6] |= 1UL << g;
                g = next[g];
            }
            while (g != h);
        }
        return starts;
    }

    /// <summary>The first live boundary half-edge from an index on, or −1.</summary>
    private static int NextBoundary(Mesh mesh, int from)
    {
        ReadOnlySpan<int> faces = mesh.FaceOf, next = mesh.Next;
        while (from < faces.Length)
        {
            int step = faces[from..].IndexOf(-1);
            if (step < 0)
                return -1;
            from += step;
            if (next[from] >= 0)
                return from;
            from++;
        }
        return -1;
    }

    private static BoundaryLoop Loop(Mesh mesh, int start)
    {
        int[] next = mesh.next, target = mesh.target;
        Vector3D[] positions = mesh.positions;
        int first = start;
        for (int h = next[start]; h != start; h = next[h])
        {
            if (target[h ^ 1] < target[first ^ 1])
                first = h;
        }
        var halfEdges = new List<HalfEdge>();
        double length = 0;
        int g = first;
        do
        {
            halfEdges.Add(new(mesh, g));
            length += (positions[target[g]] - positions[target[g ^ 1]]).Length;
            g = next[g];
        }
        while (g != first);
        return new(mesh, halfEdges, length);
    }
}
