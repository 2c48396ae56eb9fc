using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>Greedy shortening of a closed path of edges: at every vertex the path may go around its fan on either side instead, if that is shorter.</summary>
/// <remarks>
/// <code>
///         ●───●
///        / \ / \           p → v → q  becomes  p → … → q along the link, on the left or on the right:
///       p───v───q          the two bound a disk of faces, so the loop stays in its class
///        \ / \ /
///         ●───●
/// </code>
/// The path stays simple: a detour over a vertex of the loop is not taken. Every step makes it shorter, so it ends.
/// </remarks>
internal static class LoopShortening
{
    public static void Shorten(List<HalfEdge> loop)
    {
        var onLoop = new HashSet<int>(loop.Select(h => h.Source.index));
        // A step is worth it only if it is clearly shorter: rounding must not make it go back and forth.
        double least = 1e-12 * loop.Sum(h => h.Edge.Length);
        int unchanged = 0;
        for (int i = 0; unchanged <= loop.Count && loop.Count > 3; i = (i + 1) % loop.Count)
        {
            unchanged++;
            int j = (i + 1) % loop.Count;
            HalfEdge arrive = loop[i], leave = loop[j];
            List<HalfEdge>? detour = Better(Left(arrive, leave), Right(arrive, leave));
            double old = arrive.Edge.Length + leave.Edge.Length;
            if (detour is null || loop.Count - 2 + detour.Count < 3 || Length(detour) > old - least || Touches(detour, onLoop))
                continue;
            onLoop.Remove(arrive.Target.index);
            foreach (HalfEdge h in detour.Skip(1))
                onLoop.Add(h.Source.index);
            Replace(loop, i, j, detour);
            unchanged = 0;
            i = Math.Max(-1, Math.Min(i, loop.Count - 1) - 2);
        }
    }

    /// <summary>The way around the target on the left of the path; null if a hole is there.</summary>
    private static List<HalfEdge>? Left(HalfEdge arrive, HalfEdge leave)
    {
        var path = new List<HalfEdge>();
        // Spokes counter-clockwise from the one we leave by; each face between gives its sides opposite the vertex.
        HalfEdge spoke = leave;
        while (spoke != arrive.Twin)
        {
            if (spoke.IsBoundary)
                return null;
            for (HalfEdge h = spoke.Next; h != spoke.Previous; h = h.Next)
                path.Add(h.Twin);
            spoke = spoke.Previous.Twin;
        }
        // Collected from q to p, each side turned: put it in the direction of the path.
        path.Reverse();
        return path.Count == 0 ? null : path;
    }

    /// <summary>The way around the target on the right of the path; null if a hole is there.</summary>
    private static List<HalfEdge>? Right(HalfEdge arrive, HalfEdge leave)
    {
        var path = new List<HalfEdge>();
        HalfEdge spoke = arrive.Twin;
        while (spoke != leave)
        {
            if (spoke.IsBoundary)
                return null;
            for (HalfEdge h = spoke.Next; h != spoke.Previous; h = h.Next)
                path.Add(h);
            spoke = spoke.Previous.Twin;
        }
        return path.Count == 0 ? null : path;
    }

    private static List<HalfEdge>? Better(List<HalfEdge>? left, List<HalfEdge>? right)
    {
        if (left is null || right is null)
            return left ?? right;
        return Length(left) <= Length(right) ? left : right;
    }

    private static bool Touches(List<HalfEdge> detour, HashSet<int> onLoop)
    {
        var own = new HashSet<int>();
        foreach (HalfEdge h in detour.Skip(1))
        {
            if (onLoop.Contains(h.Source.index) || !own.Add(h.Source.index))
                return true;
        }
        return false;
    }

    private static double Length(List<HalfEdge> path) => path.Sum(h => h.Edge.Length);

    private static void Replace(List<HalfEdge> loop, int i, int j, List<HalfEdge> detour)
    {
        if (j > i)
        {
            loop.RemoveRange(i, 2);
            loop.InsertRange(i, detour);
            return;
        }
        loop.RemoveAt(i);
        loop.RemoveAt(0);
        loop.AddRange(detour);
    }
}
