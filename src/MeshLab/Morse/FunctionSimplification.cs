using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>A function with fewer critical points.</summary>
/// <param name="Function">The new values with their order; plateaus are told apart by the order, which therefore belongs to the result.</param>
/// <param name="LargestChange">The largest difference to the old values; at most the threshold.</param>
/// <param name="Changed">How many vertices have a new value.</param>
/// <param name="Floods">How many sweeps it took.</param>
public sealed record SimplifiedFunction(MorseFunction Function, double LargestChange, int Changed, int Floods);

/// <summary>§12.6 函数简化: the function nearest by that has exactly the extrema whose persistence is above a threshold.</summary>
/// <remarks>
/// Tierny and Pascucci 2012: flood upwards from the minima that stay, always at the lowest shore; what is below the flood's level is lifted to it, which
/// fills the basins of the others. Then downwards from the maxima that stay; repeat until no other extremum is left (two or three sweeps). The order in
/// which the flood takes the vertices is the new order, so that filled basins are no plateaus. Values move by at most the threshold. O(V log V) per sweep.
/// Maxima here are those of the mesh as it is: on an open mesh a boundary vertex above all its neighbours counts as one.
/// </remarks>
public static class FunctionSimplification
{
    private const int MostFloods = 64;

    /// <summary>Simplifies a function.</summary>
    /// <param name="function">The function; it is not changed.</param>
    /// <param name="threshold">Extrema of at most this persistence go; 0 or more, also ∞.</param>
    /// <exception cref="ArgumentOutOfRangeException">The threshold is negative or NaN.</exception>
    public static SimplifiedFunction Simplify(MorseFunction function, double threshold)
    {
        ArgumentNullException.ThrowIfNull(function);
        if (!(threshold >= 0))
            throw new ArgumentOutOfRangeException(nameof(threshold), threshold, "A persistence threshold is 0 or more.");
        Mesh mesh = function.Mesh;
        int[] rank = RanksOf(function);
        bool[] keptMinima = KeptMinima(mesh, function.Data, rank, threshold, sign: 1);
        bool[] keptMaxima = KeptMinima(mesh, function.Data, rank, threshold, sign: -1);

        double[] values = [.. function.Data];
        int floods = 0;
        while (true)
        {
            if (floods == MostFloods)
                throw new InvalidOperationException($"The function is not simple after {floods} floods.");
            if (!OnlyKeptAreMinimal(mesh, rank, keptMinima, sign: 1))
                rank = Flood(mesh, values, rank, keptMinima, sign: 1);
            else if (!OnlyKeptAreMinimal(mesh, rank, keptMaxima, sign: -1))
                rank = Flood(mesh, values, rank, keptMaxima, sign: -1);
            else
                break;
            floods++;
        }

        double largest = 0;
        int changed = 0;
        for (int v = 0; v < values.Length; v++)
        {
            if (mesh.Outgoing[v] < 0 || values[v] == function.Data[v])
                continue;
            largest = Math.Max(largest, Math.Abs(values[v] - function.Data[v]));
            changed++;
        }
        return new SimplifiedFunction(new MorseFunction(mesh, values, rank), largest, changed, floods);
    }

    private static int[] RanksOf(MorseFunction function)
    {
        int[] sorted = function.Sorted();
        var rank = new int[function.Mesh.VertexSlots];
        Array.Fill(rank, -1);
        for (int i = 0; i < sorted.Length; i++)
            rank[sorted[i]] = i;
        return rank;
    }

    /// <summary>The minima of the function (of its negative for sign −1) above the threshold; the lowest of each component always.</summary>
    private static bool[] KeptMinima(Mesh mesh, double[] values, int[] rank, double threshold, int sign)
    {
        double[] turned = Array.ConvertAll(values, value => sign * value);
        int[] turnedRank = Array.ConvertAll(rank, r => sign * r);
        PersistencePairs pairs = PersistencePairs.Of(new MorseFunction(mesh, turned, turnedRank));
        var kept = new bool[values.Length];
        foreach (Vertex v in pairs.Critical.Minima)
            kept[v.Index] = true;
        foreach (PersistencePair pair in pairs.Pairs)
        {
            if (pair.Kind == PairKind.MinimumSaddle && pair.Persistence <= threshold)
                kept[pair.Birth.Index] = false;
        }
        return kept;
    }

    private static bool OnlyKeptAreMinimal(Mesh mesh, int[] rank, bool[] kept, int sign)
    {
        ReadOnlySpan<int> outgoing = mesh.Outgoing, next = mesh.Next, target = mesh.Target;
        for (int v = 0; v < outgoing.Length; v++)
        {
            int start = outgoing[v];
            if (start < 0 || kept[v])
                continue;
            bool minimal = true;
            int h = start;
            do
            {
                minimal &= sign * rank[target[h]] > sign * rank[v];
                h = next[h ^ 1];
            }
            while (minimal && h != start);
            if (minimal)
                return false;
        }
        return true;
    }

    /// <summary>One flood from the kept extrema; writes the values and returns the new order.</summary>
    private static int[] Flood(Mesh mesh, double[] values, int[] rank, bool[] kept, int sign)
    {
        ReadOnlySpan<int> outgoing = mesh.Outgoing, next = mesh.Next, target = mesh.Target;
        var shore = new PriorityQueue<int, (double Value, int Rank)>();
        var seen = new bool[values.Length];
        var order = new int[values.Length];
        Array.Fill(order, -1);
        int used = 0;
        for (int v = 0; v < values.Length; v++)
        {
            if (outgoing[v] >= 0)
                used++;
            if (!kept[v])
                continue;
            seen[v] = true;
            shore.Enqueue(v, (sign * values[v], sign * rank[v]));
        }
        int taken = 0;
        double level = double.NegativeInfinity;
        while (shore.TryDequeue(out int v, out var key))
        {
            level = Math.Max(level, key.Value);
            values[v] = sign * level;
            order[v] = sign > 0 ? taken : used - 1 - taken;
            taken++;
            int h = outgoing[v];
            do
            {
                int w = target[h];
                if (!seen[w])
                {
                    seen[w] = true;
                    shore.Enqueue(w, (sign * values[w], sign * rank[w]));
                }
                h = next[h ^ 1];
            }
            while (h != outgoing[v]);
        }
        return order;
    }
}
