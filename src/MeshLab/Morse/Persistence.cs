using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>What a pair of critical points is born and dies as.</summary>
public enum PairKind
{
    /// <summary>A component of the sublevel set: born at a minimum, dies at a saddle where it meets an older one.</summary>
    MinimumSaddle,

    /// <summary>A loop of the sublevel set: born at a saddle, dies at the maximum that fills it.</summary>
    SaddleMaximum,
}

/// <summary>A pair of critical points that cancel each other.</summary>
/// <param name="Kind">Minimum and saddle, or saddle and maximum.</param>
/// <param name="Birth">The lower of the two.</param>
/// <param name="Death">The higher of the two.</param>
/// <param name="Persistence">The difference of their values, 0 or more.</param>
public readonly record struct PersistencePair(PairKind Kind, Vertex Birth, Vertex Death, double Persistence);

/// <summary>§12.6 持续性: which critical points cancel each other, and how long each lives (Edelsbrunner, Letscher, Zomorodian 2002).</summary>
/// <remarks>
/// The sublevel sets grow; a component is born at a minimum and dies at the saddle that joins it with one of a lower minimum (elder rule). That is a
/// union–find over the minima, at the saddles in ascending order; which minimum a wedge belongs to is found by following steepest descent, so only the
/// saddles are sorted. Saddles and maxima pair the same way upside down. Boundary vertices ascend to one point at infinity, which caps every hole, so that
/// the pairs are those of the surface with its boundary. What is left over is essential: per component its lowest minimum, per closed component its highest
/// maximum, and 2g + b − 1 (b ≥ 1) or 2g (b = 0) saddles. O(V + S log S).
/// </remarks>
public sealed class PersistencePairs
{
    private PersistencePairs(CriticalPoints critical, List<PersistencePair> pairs)
    {
        Critical = critical;
        Pairs = pairs;
        FindEssential();
    }

    /// <summary>The critical points that were paired.</summary>
    public CriticalPoints Critical { get; }

    /// <summary>First minimum–saddle pairs in ascending order of their saddles, then saddle–maximum pairs in descending order of theirs.</summary>
    public IReadOnlyList<PersistencePair> Pairs { get; }

    /// <summary>Minima that never die: the lowest of each component.</summary>
    public IReadOnlyList<Vertex> EssentialMinima { get; private set; } = [];

    /// <summary>Saddles left over, with repetition if several of a multiple saddle are.</summary>
    public IReadOnlyList<Vertex> EssentialSaddles { get; private set; } = [];

    /// <summary>Maxima left over: the highest of each closed component.</summary>
    public IReadOnlyList<Vertex> EssentialMaxima { get; private set; } = [];

    /// <summary>Pairs the critical points of a function.</summary>
    public static PersistencePairs Of(CriticalPoints critical)
    {
        ArgumentNullException.ThrowIfNull(critical);
        MorseFunction function = critical.Function;
        int[] saddles = SortedSaddles(critical);
        var pairs = new List<PersistencePair>();
        int n = function.Mesh.VertexSlots;
        PairMinima(function, saddles, Basins.Labels(critical.Lowest, n), pairs);
        PairMaxima(function, saddles, Basins.Labels(critical.Highest, n), pairs);
        return new PersistencePairs(critical, pairs);
    }

    /// <inheritdoc cref="Of(CriticalPoints)"/>
    public static PersistencePairs Of(MorseFunction function) => Of(CriticalPoints.Of(function));

    private static int[] SortedSaddles(CriticalPoints critical)
    {
        MorseFunction function = critical.Function;
        int[] saddles = [.. critical.Saddles.Select(v => v.Index)];
        Array.Sort(saddles, (a, b) => a == b ? 0 : function.IsLower(a, b) ? -1 : 1);
        return saddles;
    }

    /// <summary>Ascending: where several components meet, all but the one with the lowest minimum die.</summary>
    private static void PairMinima(MorseFunction function, int[] saddles, int[] basin, List<PersistencePair> pairs)
    {
        Mesh mesh = function.Mesh;
        var sets = new DisjointSets(mesh.VertexSlots);
        foreach (int saddle in saddles)
        {
            int elder = -1;
            foreach (LinkRun run in LinkRuns.Of(function, saddle, lower: true))
            {
                int other = sets.Find(basin[run.Steepest]);
                if (elder < 0)
                {
                    elder = other;
                    continue;
                }
                if (other == elder)
                    continue;
                if (function.IsLower(other, elder))
                    (other, elder) = (elder, other);
                pairs.Add(Pair(function, PairKind.MinimumSaddle, other, saddle));
                sets.Attach(other, elder);
            }
        }
    }

    /// <summary>Descending: where several hills meet, all but the one with the highest maximum die; the point at infinity never does.</summary>
    private static void PairMaxima(MorseFunction function, int[] saddles, int[] hill, List<PersistencePair> pairs)
    {
        Mesh mesh = function.Mesh;
        int infinity = mesh.VertexSlots;
        var sets = new DisjointSets(infinity + 1);
        for (int i = saddles.Length - 1; i >= 0; i--)
        {
            int saddle = saddles[i];
            int elder = mesh.FaceOf[mesh.Outgoing[saddle]] < 0 ? sets.Find(infinity) : -1;
            foreach (LinkRun run in LinkRuns.Of(function, saddle, lower: false))
            {
                int other = sets.Find(hill[run.Steepest]);
                if (elder < 0)
                {
                    elder = other;
                    continue;
                }
                if (other == elder)
                    continue;
                if (other == infinity || (elder != infinity && function.IsLower(elder, other)))
                    (other, elder) = (elder, other);
                pairs.Add(Pair(function, PairKind.SaddleMaximum, saddle, other));
                sets.Attach(other, elder);
            }
        }
    }

    private static PersistencePair Pair(MorseFunction function, PairKind kind, int birth, int death) => new(
        kind, function.Mesh.Vertices[birth], function.Mesh.Vertices[death], function.Data[death] - function.Data[birth]);

    private void FindEssential()
    {
        var left = new Dictionary<Vertex, int>();
        foreach (CriticalPoint point in Critical.Points)
            left[point.Vertex] = point.Multiplicity;
        foreach (PersistencePair pair in Pairs)
        {
            left[pair.Birth]--;
            left[pair.Death]--;
        }
        EssentialMinima = [.. Critical.Minima.Where(v => left[v] > 0)];
        EssentialMaxima = [.. Critical.Maxima.Where(v => left[v] > 0)];
        EssentialSaddles = [.. Critical.Saddles.SelectMany(v => Enumerable.Repeat(v, left[v]))];
    }
}

/// <summary>Which extremum every vertex flows to.</summary>
internal static class Basins
{
    /// <summary>Follows the pointers to their ends. A pointer of −1 leads to the point at infinity, which is labelled <paramref name="infinity"/>.</summary>
    public static int[] Labels(int[] pointer, int infinity)
    {
        // Labels are kept plus one, so that 0 means "not known yet"; every path is walked twice: to find its end, and to write it.
        var label = new int[pointer.Length];
        for (int v = 0; v < pointer.Length; v++)
        {
            int x = v, end;
            while (true)
            {
                if (label[x] != 0)
                {
                    end = label[x];
                    break;
                }
                int p = pointer[x];
                if (p < 0)
                {
                    end = infinity + 1;
                    break;
                }
                if (p == x)
                {
                    end = x + 1;
                    break;
                }
                x = p;
            }
            x = v;
            while (label[x] == 0)
            {
                label[x] = end;
                if (pointer[x] < 0 || pointer[x] == x)
                    break;
                x = pointer[x];
            }
        }
        for (int v = 0; v < label.Length; v++)
            label[v]--;
        return label;
    }
}

/// <summary>Disjoint sets with a representative that the caller chooses.</summary>
internal sealed class DisjointSets
{
    private readonly int[] parent;

    public DisjointSets(int count)
    {
        parent = new int[count];
        for (int i = 0; i < count; i++)
            parent[i] = i;
    }

    public int Find(int x)
    {
        while (parent[x] != x)
        {
            parent[x] = parent[parent[x]];
            x = parent[x];
        }
        return x;
    }

    /// <summary>Puts the set with this representative under another one.</summary>
    public void Attach(int representative, int elder) => parent[representative] = elder;
}
