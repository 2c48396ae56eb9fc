namespace MeshLab.Structure;

/// <summary>Finds for every corner the half-edge that leaves it, so that the two sides of an edge are twins.</summary>
/// <remarks>
/// Edges are kept in a linked list per smaller vertex: fastest on real meshes. Where lists grow long (a vertex with thousands of edges) the walk
/// would be quadratic, so it has a budget of steps; when that is spent, a counting sort by smaller vertex and a stamp per larger one take over,
/// which is linear on every input. Both number edges by first appearance, so the result is the same.
/// </remarks>
internal static class EdgeMatching
{
    private const byte SeenForward = 1;
    private const byte SeenBackward = 2;
    private const byte BornSwapped = 4;

    /// <summary>Per corner the half-edge to the face's next corner, or null if an edge is used twice in one direction (or by three faces).</summary>
    public static int[]? Match(PolygonSoup soup, out int edges)
    {
        var halfEdge = GC.AllocateUninitializedArray<int>(soup.Corners.Length);
        long budget = 8L * soup.Corners.Length + 1024;
        edges = ByLists(soup, halfEdge, budget, out bool spent);
        if (spent)
            edges = ByCounting(soup, halfEdge);
        return edges < 0 ? null : halfEdge;
    }

    internal static int ByLists(PolygonSoup soup, int[] halfEdge, long budget, out bool spent)
    {
        int[] corners = soup.Corners, start = soup.FaceStart;
        var head = new int[soup.VertexCount];
        var records = GC.AllocateUninitializedArray<(int Link, int Larger)>(corners.Length);
        var state = GC.AllocateUninitializedArray<byte>(corners.Length);
        int edges = 0;
        spent = false;
        for (int f = 0; f + 1 < start.Length; f++)
        {
            int first = start[f], end = start[f + 1];
            for (int c = first; c < end; c++)
            {
                int from = corners[c], to = corners[c + 1 == end ? first : c + 1];
                bool swapped = from > to;
                int smaller = swapped ? to : from, larger = swapped ? from : to;
                // Entries hold edge + 1, so that a fresh array of zeros means "none".
                int entry = head[smaller];
                while (entry != 0 && records[entry - 1].Larger != larger)
                {
                    entry = records[entry - 1].Link;
                    if (--budget < 0)
                    {
                        spent = true;
                        return -1;
                    }
                }
                if (entry == 0)
                {
                    records[edges] = (head[smaller], larger);
                    state[edges] = swapped ? (byte)(SeenForward | BornSwapped) : SeenForward;
                    halfEdge[c] = 2 * edges;
                    head[smaller] = ++edges;
                }
                else
                {
                    int e = entry - 1;
                    bool sameDirection = (state[e] & BornSwapped) != 0 == swapped;
                    if (sameDirection || (state[e] & SeenBackward) != 0)
                        return -1;
                    state[e] |= SeenBackward;
                    halfEdge[c] = 2 * e + 1;
                }
            }
        }
        return edges;
    }

    internal static int ByCounting(PolygonSoup soup, int[] halfEdge)
    {
        int[] corners = soup.Corners, start = soup.FaceStart;
        int[] offset = CountBySmaller(soup);
        var bucket = new (int Corner, int Larger, bool Swapped)[corners.Length];
        for (int f = 0; f + 1 < start.Length; f++)
        {
            int first = start[f], end = start[f + 1];
            for (int c = first; c < end; c++)
            {
                int from = corners[c], to = corners[c + 1 == end ? first : c + 1];
                bucket[offset[Math.Min(from, to)]++] = (c, Math.Max(from, to), from > to);
            }
        }

        // First every corner learns the first corner of its edge; offset[v] is now the end of v's bucket.
        var stamp = new int[soup.VertexCount];
        var firstUse = new (int Corner, bool Swapped, bool Twice)[soup.VertexCount];
        Array.Fill(stamp, -1);
        var partner = GC.AllocateUninitializedArray<int>(corners.Length);
        int j = 0;
        for (int v = 0; v < soup.VertexCount; v++)
        {
            for (; j < offset[v]; j++)
            {
                var (c, larger, swapped) = bucket[j];
                if (stamp[larger] != v)
                {
                    stamp[larger] = v;
                    firstUse[larger] = (c, swapped, false);
                    partner[c] = -1;
                    continue;
                }
                ref var use = ref firstUse[larger];
                if (use.Twice || use.Swapped == swapped)
                    return -1;
                use.Twice = true;
                partner[c] = use.Corner;
            }
        }

        // Then edges are numbered in the order of the corners.
        int edges = 0;
        for (int c = 0; c < corners.Length; c++)
            halfEdge[c] = partner[c] < 0 ? 2 * edges++ : halfEdge[partner[c]] | 1;
        return edges;
    }

    private static int[] CountBySmaller(PolygonSoup soup)
    {
        int[] corners = soup.Corners, start = soup.FaceStart;
        var offset = new int[soup.VertexCount];
        for (int f = 0; f + 1 < start.Length; f++)
        {
            int first = start[f], end = start[f + 1];
            if (first == end)
                continue;
            int before = corners[end - 1];
            for (int c = first; c < end; c++)
            {
                offset[Math.Min(before, corners[c])]++;
                before = corners[c];
            }
        }
        int sum = 0;
        for (int v = 0; v < offset.Length; v++)
        {
            int count = offset[v];
            offset[v] = sum;
            sum += count;
        }
        return offset;
    }
}
