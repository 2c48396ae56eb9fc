using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geodesics;

/// <summary>§12.1 边测地距离 (edge distance): the length of the shortest path along edges, exactly.</summary>
/// <remarks>
/// Never shorter than the distance over the surface; on a regular triangulation up to 15 % longer, however fine it is, since paths must follow the
/// edges. Dijkstra 1959. Ties by vertex index. O(E log V).
/// </remarks>
public static class EdgeDistance
{
    extension(Mesh mesh)
    {
        /// <summary>The distance along edges from the nearest of some vertices.</summary>
        /// <param name="sources">The vertices at distance 0.</param>
        /// <returns>The distance per vertex slot; +∞ where no path leads, NaN at deleted vertices.</returns>
        /// <exception cref="ArgumentException">There is no source, or one is not a live vertex of the mesh.</exception>
        public double[] ComputeEdgeDistances(params ReadOnlySpan<Vertex> sources)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            SourceVertices.Check(mesh, sources);
            return Search(mesh, sources);
        }
    }

    private static double[] Search(Mesh mesh, ReadOnlySpan<Vertex> sources)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, outgoing = mesh.Outgoing;
        ReadOnlySpan<Vector3D> position = mesh.Positions;
        var distance = new double[mesh.VertexSlots];
        for (int v = 0; v < distance.Length; v++)
            distance[v] = mesh.IsDeletedVertex(v) ? double.NaN : double.PositiveInfinity;

        var front = new DistanceHeap(distance);
        foreach (Vertex source in sources)
        {
            distance[source.Index] = 0;
            front.AddOrRaise(source.Index);
        }
        while (front.TryTake(out int v))
        {
            int first = outgoing[v];
            if (first < 0)
                continue;
            int h = first;
            do
            {
                int u = target[h];
                double through = distance[v] + Vector3D.Distance(position[v], position[u]);
                if (through < distance[u])
                {
                    distance[u] = through;
                    front.AddOrRaise(u);
                }
                h = next[h ^ 1];
            }
            while (h != first);
        }
        return distance;
    }
}

/// <summary>The checks of a set of source vertices.</summary>
internal static class SourceVertices
{
    public static void Check(Mesh mesh, ReadOnlySpan<Vertex> sources)
    {
        if (sources.IsEmpty)
            throw new ArgumentException("There is no source to measure from.", nameof(sources));
        foreach (Vertex v in sources)
        {
            if (v.IsNone || v.Mesh != mesh)
                throw new ArgumentException($"{v} is not a vertex of this mesh.", nameof(sources));
            v.ThrowIfDead();
        }
    }
}

/// <summary>A heap of vertices by (distance, index), with the place of each, so that a vertex whose distance falls can rise.</summary>
internal sealed class DistanceHeap(double[] distance)
{
    private readonly List<int> heap = [];
    private readonly int[] place = NoPlaces(distance.Length);

    public void AddOrRaise(int vertex)
    {
        int at = place[vertex];
        if (at < 0)
        {
            at = heap.Count;
            heap.Add(vertex);
        }
        while (at > 0)
        {
            int parent = (at - 1) / 2;
            if (!IsBefore(vertex, heap[parent]))
                break;
            Put(at, heap[parent]);
            at = parent;
        }
        Put(at, vertex);
    }

    public bool TryTake(out int vertex)
    {
        if (heap.Count == 0)
        {
            vertex = -1;
            return false;
        }
        vertex = heap[0];
        place[vertex] = -1;
        int last = heap[^1];
        heap.RemoveAt(heap.Count - 1);
        if (heap.Count == 0)
            return true;

        int at = 0;
        while (2 * at + 1 < heap.Count)
        {
            int child = 2 * at + 1;
            if (child + 1 < heap.Count && IsBefore(heap[child + 1], heap[child]))
                child++;
            if (!IsBefore(heap[child], last))
                break;
            Put(at, heap[child]);
            at = child;
        }
        Put(at, last);
        return true;
    }

    private static int[] NoPlaces(int count)
    {
        var places = new int[count];
        Array.Fill(places, -1);
        return places;
    }

    private bool IsBefore(int a, int b) => distance[a] < distance[b] || (distance[a] == distance[b] && a < b);

    private void Put(int at, int vertex)
    {
        heap[at] = vertex;
        place[vertex] = at;
    }
}
