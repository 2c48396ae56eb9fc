using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>Vertices by their distance in edges from a set, ring after ring, touching nothing farther away.</summary>
internal static class BreadthFirst
{
    public static Vertex[] Ring(Mesh mesh, IReadOnlyCollection<int> start, int k)
    {
        List<int> found = Walk(mesh, start, k, out int lastRing);
        return SortedElements.Vertices(mesh, found.GetRange(lastRing, found.Count - lastRing));
    }

    public static Vertex[] Disk(Mesh mesh, IReadOnlyCollection<int> start, int k) => SortedElements.Vertices(mesh, Walk(mesh, start, k, out _));

    /// <summary>All vertices that edges join to the start.</summary>
    public static List<int> Reachable(Mesh mesh, IReadOnlyCollection<int> start) => Walk(mesh, start, int.MaxValue, out _);

    /// <summary>The vertices within k edges in the order in which they are found; those at exactly k begin at <paramref name="lastRing"/>.</summary>
    private static List<int> Walk(Mesh mesh, IReadOnlyCollection<int> start, int k, out int lastRing)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(k);
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing;
        var seen = new HashSet<int>(start);
        List<int> found = [.. start];
        lastRing = 0;
        for (int ring = 0; ring < k && lastRing < found.Count; ring++)
        {
            int end = found.Count;
            for (int i = lastRing; i < end; i++)
            {
                int first = outgoing[found[i]], h = first;
                if (h < 0)
                    continue;
                do
                {
                    int p = target[h];
                    if (seen.Add(p))
                        found.Add(p);
                    h = next[h ^ 1];
                }
                while (h != first);
            }
            lastRing = end;
        }
        return found;
    }
}
