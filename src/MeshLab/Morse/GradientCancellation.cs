using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>What a cancellation did.</summary>
/// <param name="Gradient">The simplified gradient; the given one is not changed.</param>
/// <param name="CancelledMinima">How many minimum–saddle pairs were cancelled.</param>
/// <param name="CancelledMaxima">How many saddle–maximum pairs were cancelled.</param>
/// <param name="Stuck">Pairs within the threshold that could not be reversed because the path ends elsewhere; 0 for gradients made from functions.</param>
public sealed record CancellationResult(DiscreteGradient Gradient, int CancelledMinima, int CancelledMaxima, int Stuck);

/// <summary>§12.6 莫斯简化: cancels pairs of critical cells whose persistence is at most a threshold, by reversing the one path between them.</summary>
/// <remarks>Minima ascending over the critical edges, then maxima the same way on the dual, descending; the edges used by the first are passed over by the second.
/// With the threshold ∞ a closed component of genus g keeps 1 minimum, 2g saddles, 1 maximum; one with b ≥ 1 boundary loops 1, 2g + b − 1, 0.
/// O(S log S + total length of the paths).</remarks>
public static class GradientCancellation
{
    /// <summary>Cancels pairs.</summary>
    /// <param name="gradient">The gradient of a function.</param>
    /// <param name="threshold">The largest persistence that is cancelled, 0 or more, also ∞.</param>
    /// <exception cref="ArgumentOutOfRangeException">The threshold is negative or NaN.</exception>
    public static CancellationResult Cancel(DiscreteGradient gradient, double threshold)
    {
        ArgumentNullException.ThrowIfNull(gradient);
        if (!(threshold >= 0))
            throw new ArgumentOutOfRangeException(nameof(threshold), threshold, "A persistence threshold is 0 or more.");
        DiscreteGradient result = gradient.Copy();
        int[] saddles = SortedCriticalEdges(result);
        var used = new bool[saddles.Length];
        int stuck = 0;
        int minima = CancelMinima(result, saddles, used, threshold, ref stuck);
        int maxima = CancelMaxima(result, saddles, used, threshold, ref stuck);
        return new CancellationResult(result, minima, maxima, stuck);
    }

    private static int[] SortedCriticalEdges(DiscreteGradient gradient)
    {
        MorseFunction function = gradient.Function;
        ReadOnlyMemory<int> edges = Enumerable.Range(0, gradient.IsCriticalEdge.Length).Where(e => gradient.IsCriticalEdge[e]).ToArray();
        int[] sorted = edges.ToArray();
        Array.Sort(sorted, (a, b) =>
        {
            int x = gradient.HighestOfEdge(a), y = gradient.HighestOfEdge(b);
            if (x == y)
            {
                x = Other(function.Mesh, a, x);
                y = Other(function.Mesh, b, y);
            }
            return x == y ? 0 : function.IsLower(x, y) ? -1 : 1;
        });
        return sorted;
    }

    private static int Other(Mesh mesh, int e, int end) => mesh.Target[2 * e] == end ? mesh.Target[2 * e + 1] : mesh.Target[2 * e];

    private static int CancelMinima(DiscreteGradient gradient, int[] saddles, bool[] used, double threshold, ref int stuck)
    {
        MorseFunction function = gradient.Function;
        Mesh mesh = function.Mesh;
        var sets = new DisjointSets(mesh.VertexSlots);
        int cancelled = 0;
        for (int i = 0; i < saddles.Length; i++)
        {
            int e = saddles[i], toEnd = 2 * e;
            int reachedA = gradient.Descend(mesh.Target[2 * e]), reachedB = gradient.Descend(mesh.Target[2 * e + 1]);
            int a = sets.Find(reachedA), b = sets.Find(reachedB);
            if (a == b)
                continue;
            // a is to be the younger one, at the end of the path that begins at the target of the half-edge "toEnd".
            if (function.IsLower(a, b))
            {
                (a, b) = (b, a);
                reachedA = reachedB;
                toEnd++;
            }
            sets.Attach(a, b);
            used[i] = true;
            if (function.Data[gradient.HighestOfEdge(e)] - function.Data[a] > threshold)
                continue;
            if (reachedA != a)
            {
                stuck++;
                continue;
            }
            ReverseDescent(gradient, toEnd);
            gradient.IsCriticalEdge[e] = false;
            cancelled++;
        }
        return cancelled;
    }

    /// <summary>Turns the arrows of the path from the target of a critical edge's half-edge down to its minimum, so that they lead over the saddle.</summary>
    private static void ReverseDescent(DiscreteGradient gradient, int halfEdge)
    {
        Mesh mesh = gradient.Function.Mesh;
        int arrow = halfEdge ^ 1, v = mesh.Target[halfEdge];
        while (true)
        {
            int old = gradient.VertexArrow[v];
            gradient.VertexArrow[v] = arrow;
            if (old < 0)
                return;
            v = mesh.Target[old];
            arrow = old ^ 1;
        }
    }

    private static int CancelMaxima(DiscreteGradient gradient, int[] saddles, bool[] used, double threshold, ref int stuck)
    {
        MorseFunction function = gradient.Function;
        Mesh mesh = function.Mesh;
        int infinity = mesh.FaceSlots;
        var sets = new DisjointSets(infinity + 1);
        int cancelled = 0;
        for (int i = saddles.Length - 1; i >= 0; i--)
        {
            if (used[i])
                continue;
            int e = saddles[i], towards = 2 * e;
            int reachedA = OrInfinity(gradient.Ascend(mesh.FaceOf[2 * e]), infinity), reachedB = OrInfinity(gradient.Ascend(mesh.FaceOf[2 * e + 1]), infinity);
            int a = sets.Find(reachedA), b = sets.Find(reachedB);
            if (a == b)
                continue;
            if (a == infinity || (b != infinity && IsLowerFace(gradient, b, a)))
            {
                (a, b) = (b, a);
                reachedA = reachedB;
                towards++;
            }
            sets.Attach(a, b);
            if (function.Data[gradient.HighestOfFace(a)] - function.Data[gradient.HighestOfEdge(e)] > threshold)
                continue;
            if (reachedA != a)
            {
                stuck++;
                continue;
            }
            ReverseAscent(gradient, towards);
            gradient.IsCriticalEdge[e] = false;
            cancelled++;
        }
        return cancelled;
    }

    private static int OrInfinity(int face, int infinity) => face < 0 ? infinity : face;

    private static bool IsLowerFace(DiscreteGradient gradient, int a, int b)
    {
        int x = gradient.HighestOfFace(a), y = gradient.HighestOfFace(b);
        return x != y && gradient.Function.IsLower(x, y);
    }

    /// <summary>Turns the arrows of the path from the face of a critical edge's half-edge up to its maximum.</summary>
    private static void ReverseAscent(DiscreteGradient gradient, int halfEdge)
    {
        Mesh mesh = gradient.Function.Mesh;
        int arrow = halfEdge, f = mesh.FaceOf[halfEdge];
        while (true)
        {
            int old = gradient.FaceArrow[f];
            gradient.FaceArrow[f] = arrow;
            if (old < 0)
                return;
            f = mesh.FaceOf[old ^ 1];
            arrow = old ^ 1;
        }
    }
}
