using MeshLab.Morse;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>Which regions of a function become segments.</summary>
public enum WatershedForm
{
    /// <summary>The basins of the persistent minima (上升流形): everything that flows down to one.</summary>
    Basins,

    /// <summary>The hills of the persistent maxima (下降流形): everything that flows up to one.</summary>
    Hills,

    /// <summary>Limbs and body: the part of each persistent hill above the saddle where it meets another one; all the rest is the body, segment 0.</summary>
    Limbs,
}

/// <summary>How a watershed segments.</summary>
public sealed record WatershedOptions
{
    /// <summary>Which regions become segments.</summary>
    public WatershedForm Form { get; init; } = WatershedForm.Limbs;

    /// <summary>Extrema of at most this persistence make no segment of their own. Not used if <see cref="Segments"/> is given.</summary>
    public double Persistence
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A persistence threshold is 0 or more.");
    }

    /// <summary>The number of segments wanted: the persistence is chosen for it. The most persistent extrema stay; fewer if there are not so many.</summary>
    public int? Segments
    {
        get;
        init => field = value is null or >= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is at least one segment.");
    }
}

/// <summary>§13 分水岭: segments by the Morse regions of a function, with persistence against over-segmentation.</summary>
/// <remarks>A face belongs where its vertices belong: to the region of its lowest vertex for basins, of its highest for hills and limbs. O(V log V).</remarks>
public static class Watershed
{
    /// <summary>Segments the faces.</summary>
    /// <exception cref="ArgumentNullException">The function is null.</exception>
    public static FaceSegmentation Segment(MorseFunction function, WatershedOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(function);
        options ??= new WatershedOptions();
        int[] vertexLabels = options.Form == WatershedForm.Limbs ? Limbs(function, options) : Regions(function, options);
        Mesh mesh = function.Mesh;
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        foreach (Face f in mesh.Faces)
        {
            int deciding = -1;
            foreach (Vertex v in f.Vertices)
            {
                if (deciding < 0 || function.IsLower(v.Index, deciding) == (options.Form == WatershedForm.Basins))
                    deciding = v.Index;
            }
            labels[f.Index] = vertexLabels[deciding];
        }
        int count = Relabeling.Compact(labels, keepsZero: options.Form == WatershedForm.Limbs);
        return new FaceSegmentation(labels, count, double.NaN, 0, SegmentationStop.Complete);
    }

    /// <summary>Per vertex its minimum (for hills: its maximum) after simplification.</summary>
    private static int[] Regions(MorseFunction function, WatershedOptions options)
    {
        MorseFunction downward = options.Form == WatershedForm.Basins
            ? function
            : new MorseFunction(function.Mesh, [.. function.Values.Select(x => -x)], function.Ranks is null ? ReversedRanks(function) : Array.ConvertAll(function.Ranks, r => -r));
        double threshold = options.Segments is null
            ? options.Persistence
            : ThresholdFor(PersistencePairs.Of(downward), PairKind.MinimumSaddle, options.Segments.Value - PersistencePairs.Of(downward).EssentialMinima.Count);
        MorseFunction simplified = FunctionSimplification.Simplify(downward, threshold).Function;
        return [.. MorseComplex.Of(simplified).MinimumOf];
    }

    /// <summary>Upside down, ties too must be decided the other way.</summary>
    private static int[] ReversedRanks(MorseFunction function)
    {
        int[] sorted = function.Sorted();
        var ranks = new int[function.Mesh.VertexSlots];
        for (int i = 0; i < sorted.Length; i++)
            ranks[sorted[i]] = -i;
        return ranks;
    }

    /// <summary>The smallest threshold that leaves at most so many pairs of a kind.</summary>
    private static double ThresholdFor(PersistencePairs pairs, PairKind kind, int kept)
    {
        double[] sorted = [.. pairs.Pairs.Where(p => p.Kind == kind).Select(p => p.Persistence).OrderDescending()];
        return Math.Max(0, kept) < sorted.Length ? sorted[Math.Max(0, kept)] : 0;
    }

    /// <summary>Sweeps downwards; where two hills meet that both rise above the threshold, each that is no part of the body yet is cut off as a limb.</summary>
    private static int[] Limbs(MorseFunction function, WatershedOptions options)
    {
        Mesh mesh = function.Mesh;
        // With k limbs there are k − 1 meetings of persistent hills on a connected model, and one segment more for the body.
        double threshold = options.Segments is null ? options.Persistence : LimbThreshold(function, options.Segments.Value);
        int[] sorted = function.Sorted();
        var labels = new int[mesh.VertexSlots];
        var sets = new DisjointSets(mesh.VertexSlots);
        var reached = new bool[mesh.VertexSlots];
        var peak = new double[mesh.VertexSlots];
        var isBody = new bool[mesh.VertexSlots];
        var members = new List<int>?[mesh.VertexSlots];
        int limbs = 0;
        for (int i = sorted.Length - 1; i >= 0; i--)
        {
            int v = sorted[i];
            reached[v] = true;
            peak[v] = function.Data[v];
            members[v] = [v];
            int own = v;
            foreach (Vertex w in mesh.Vertices[v].Neighbors)
            {
                if (!reached[w.Index])
                    continue;
                int other = sets.Find(w.Index);
                if (other == own)
                    continue;
                if (own == v)
                {
                    own = Join(other, v);
                    continue;
                }
                bool meet = peak[own] - function.Data[v] > threshold && peak[other] - function.Data[v] > threshold;
                if (meet)
                {
                    CutOff(own);
                    CutOff(other);
                }
                own = Join(own, other);
            }
        }
        return labels;

        int Join(int a, int b)
        {
            // The larger list takes the smaller one over.
            if (members[a]!.Count < members[b]!.Count)
                (a, b) = (b, a);
            members[a]!.AddRange(members[b]!);
            members[b] = null;
            peak[a] = Math.Max(peak[a], peak[b]);
            isBody[a] |= isBody[b];
            sets.Attach(b, a);
            return a;
        }

        void CutOff(int hill)
        {
            if (!isBody[hill])
            {
                limbs++;
                foreach (int u in members[hill]!)
                    labels[u] = limbs;
            }
            isBody[hill] = true;
        }
    }

    private static double LimbThreshold(MorseFunction function, int segments)
    {
        MorseFunction upsideDown = new(function.Mesh, [.. function.Values.Select(x => -x)], ReversedRanks(function));
        PersistencePairs pairs = PersistencePairs.Of(upsideDown);
        return ThresholdFor(pairs, PairKind.MinimumSaddle, segments - 1 - pairs.EssentialMinima.Count);
    }
}
