namespace MeshLab.Topology;

/// <summary>Exchanges loops of a basis of the first homology group for shorter ones, so that it stays a basis.</summary>
/// <remarks>
/// A loop is a whole-number sum of the basis, c = Σ aᵢ bᵢ (up to boundaries). It can take the place of bᵢ if and only if aᵢ = ±1: then bᵢ is a whole-number sum
/// of c and the others. Only longer loops give way, the longest first, so that in order of length every loop of the new basis is at most as long as
/// that of the old. Each exchange shortens the sum, so it ends. O(n²) per exchange.
/// </remarks>
internal static class LoopExchange
{
    // Coordinates beyond this end the exchanges: they could overflow.
    private const long Largest = 1 << 30;

    /// <summary>Exchanges as long as something gets shorter.</summary>
    /// <param name="basis">The basis; changed.</param>
    /// <param name="others">Loops that may come in; in their place is afterwards what went out.</param>
    /// <param name="coordinates">A loop as a sum of the basis.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    public static void Shorten(MeshLoop[] basis, MeshLoop[] others, Func<MeshLoop, long[]> coordinates, CancellationToken cancellationToken)
    {
        Array.Sort([.. others.Select((loop, i) => (loop.Length, i))], others);
        long[][] sums = Array.ConvertAll(others, loop =>
        {
            cancellationToken.ThrowIfCancellationRequested();
            return coordinates(loop);
        });
        bool changed = true;
        while (changed)
        {
            changed = false;
            for (int j = 0; j < others.Length; j++)
            {
                cancellationToken.ThrowIfCancellationRequested();
                int i = LongestToGo(basis, others[j], sums[j]);
                if (i < 0)
                    continue;
                (basis[i], others[j]) = (others[j], basis[i]);
                if (!Exchange(sums, i, j))
                    return;
                changed = true;
            }
        }
    }

    /// <summary>The longest loop of the basis that a loop can replace, or −1 if none is clearly longer.</summary>
    private static int LongestToGo(MeshLoop[] basis, MeshLoop loop, long[] sum)
    {
        int longest = -1;
        double length = loop.Length * (1 + 1e-12);
        for (int i = 0; i < basis.Length; i++)
        {
            if (sum[i] is 1 or -1 && basis[i].Length > length)
                (longest, length) = (i, basis[i].Length);
        }
        return longest;
    }

    /// <summary>Rewrites all sums after loop j took the place of i in the basis. False if numbers get too large to go on.</summary>
    private static bool Exchange(long[][] sums, int i, int j)
    {
        // c = Σ aₖ bₖ with aᵢ = ±1, so bᵢ = aᵢ c − Σ aᵢ aₖ bₖ; the sum of c becomes that of bᵢ, and is put for bᵢ in the others.
        long[] gone = sums[j];
        long sign = gone[i];
        for (int k = 0; k < gone.Length; k++)
            gone[k] = k == i ? sign : -sign * gone[k];
        bool isSmall = true;
        for (int r = 0; r < sums.Length; r++)
        {
            long times = sums[r][i];
            if (r == j || times == 0)
                continue;
            sums[r][i] = 0;
            for (int k = 0; k < gone.Length; k++)
            {
                sums[r][k] += times * gone[k];
                isSmall &= Math.Abs(sums[r][k]) < Largest;
            }
        }
        return isSmall;
    }
}
