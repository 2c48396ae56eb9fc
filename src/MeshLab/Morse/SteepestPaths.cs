using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>The book's drawing: steepest paths both ways along edges of the mesh, and where they cross.</summary>
/// <param name="Descending">From each saddle one path per lower wedge, as vertices.</param>
/// <param name="Ascending">From each saddle one path per upper wedge, as vertices; on the boundary it goes on to the highest neighbour.</param>
/// <param name="Crossings">Regular vertices where an ascending path passes from one side of a descending one to the other.</param>
public sealed record SteepestPathsResult(IReadOnlyList<IReadOnlyList<int>> Descending, IReadOnlyList<IReadOnlyList<int>> Ascending, IReadOnlyList<int> Crossings);

/// <summary>§12.4 最陡路径: from every saddle the path of steepest descent per lower wedge and of steepest ascent per upper wedge, on mesh edges.</summary>
/// <remarks>Two descending paths merge when they meet, and so do two ascending ones; but nothing keeps an ascending path from crossing a descending one, and on
/// real models some do. <see cref="MorseComplex"/> draws ascending arcs on the dual instead, where they cannot. O(V + length of the paths).</remarks>
public static class SteepestPaths
{
    /// <summary>Traces the paths.</summary>
    public static SteepestPathsResult Of(CriticalPoints critical)
    {
        ArgumentNullException.ThrowIfNull(critical);
        MorseFunction function = critical.Function;
        int[] up = [.. critical.Highest];
        for (int v = 0; v < up.Length; v++)
        {
            if (up[v] < 0)
                up[v] = HighestAround(function, v);
        }
        List<IReadOnlyList<int>> descending = [], ascending = [];
        foreach (Vertex saddle in critical.Saddles)
        {
            foreach (LinkRun run in LinkRuns.Of(function, saddle.Index, lower: true))
                descending.Add(Follow(saddle.Index, run.Steepest, critical.Lowest));
            foreach (LinkRun run in LinkRuns.Of(function, saddle.Index, lower: false))
                ascending.Add(Follow(saddle.Index, run.Steepest, up));
        }
        return new SteepestPathsResult(descending, ascending, Crossings(critical, descending, ascending));
    }

    private static int HighestAround(MorseFunction function, int v)
    {
        int highest = v;
        foreach (Vertex w in function.Mesh.Vertices[v].Neighbors)
        {
            if (function.IsLower(highest, w.Index))
                highest = w.Index;
        }
        return highest;
    }

    private static List<int> Follow(int saddle, int first, int[] pointer)
    {
        List<int> path = [saddle, first];
        while (pointer[path[^1]] != path[^1])
            path.Add(pointer[path[^1]]);
        return path;
    }

    private static List<int> Crossings(CriticalPoints critical, List<IReadOnlyList<int>> descending, List<IReadOnlyList<int>> ascending)
    {
        Dictionary<int, List<(int In, int Out)>> down = Passages(descending), up = Passages(ascending);
        var crossings = new List<int>();
        foreach ((int v, List<(int In, int Out)> passages) in down)
        {
            if (critical.KindOf(v) == CriticalKind.Regular && up.TryGetValue(v, out List<(int In, int Out)>? others) && AnyCross(critical.Function.Mesh, v, passages, others))
                crossings.Add(v);
        }
        crossings.Sort();
        return crossings;
    }

    /// <summary>Per inner vertex of the paths, where they come from and go to.</summary>
    private static Dictionary<int, List<(int In, int Out)>> Passages(List<IReadOnlyList<int>> paths)
    {
        var passages = new Dictionary<int, List<(int, int)>>();
        foreach (IReadOnlyList<int> path in paths)
        {
            for (int i = 1; i + 1 < path.Count; i++)
            {
                if (!passages.TryGetValue(path[i], out List<(int, int)>? list))
                    passages[path[i]] = list = [];
                if (!list.Contains((path[i - 1], path[i + 1])))
                    list.Add((path[i - 1], path[i + 1]));
            }
        }
        return passages;
    }

    private static bool AnyCross(Mesh mesh, int v, List<(int In, int Out)> down, List<(int In, int Out)> up)
    {
        var place = new Dictionary<int, int>();
        foreach (Vertex w in mesh.Vertices[v].Neighbors)
            place[w.Index] = place.Count;
        foreach ((int a, int b) in down)
        {
            foreach ((int p, int q) in up)
            {
                // Paths that share an edge at v run beside each other there; only four different spokes can cross.
                if (p != a && p != b && q != a && q != b && IsBetween(place[p], place[a], place[b]) != IsBetween(place[q], place[a], place[b]))
                    return true;
            }
        }
        return false;
    }

    private static bool IsBetween(int x, int a, int b) => a < b ? x > a && x < b : x > a || x < b;
}
