using System.Runtime.CompilerServices;

namespace MeshLab.Numerics;

/// <summary>
/// Exact sums of doubles: a number is a list of components that do not overlap, smallest first, without zeros.
/// </summary>
/// <remarks>
/// Shewchuk 1997, <em>Adaptive precision floating-point arithmetic and fast robust geometric predicates</em>, §2. Exact as long as
/// nothing over- or underflows; <see cref="ExactPredicates"/> sees to that. A number with no components is zero.
/// </remarks>
internal static class Expansion
{
    /// <summary>a + b = sum + error, exactly (Knuth's two-sum).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double TwoSum(double a, double b, out double error)
    {
        double sum = a + b;
        double bVirtual = sum - a;
        error = (a - (sum - bVirtual)) + (b - bVirtual);
        return sum;
    }

    /// <summary>a · b = product + error, exactly.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double TwoProduct(double a, double b, out double error)
    {
        double product = a * b;
        // The fused operation is part of IEEE 754: the same bits with and without hardware for it.
        error = Math.FusedMultiplyAdd(a, b, -product);
        return product;
    }

    /// <summary>Writes a − b, at most two components.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Difference(double a, double b, Span<double> result)
    {
        double head = TwoSum(a, -b, out double tail);
        int n = 0;
        if (tail != 0)
            result[n++] = tail;
        if (head != 0)
            result[n++] = head;
        return n;
    }

    /// <summary>Writes e + f, at most as many components as both have together ("linear" in Shewchuk's words, by insertion).</summary>
    public static int Sum(ReadOnlySpan<double> e, ReadOnlySpan<double> f, Span<double> result)
    {
        int i = 0, j = 0, n = 0;
        double q = 0;
        // Merge by magnitude; the carry q runs ahead, its error stays behind. Fast-expansion-sum with the general two-sum
        // keeps the components non-overlapping under round-to-even.
        while (i < e.Length || j < f.Length)
        {
            double next = j == f.Length || (i < e.Length && Math.Abs(e[i]) < Math.Abs(f[j])) ? e[i++] : f[j++];
            q = TwoSum(q, next, out double error);
            if (error != 0)
                result[n++] = error;
        }
        if (q != 0)
            result[n++] = q;
        return n;
    }

    /// <summary>Writes e · b, at most twice as many components.</summary>
    public static int Scale(ReadOnlySpan<double> e, double b, Span<double> result)
    {
        if (e.IsEmpty || b == 0)
            return 0;
        int n = 0;
        double q = TwoProduct(e[0], b, out double error);
        if (error != 0)
            result[n++] = error;
        for (int i = 1; i < e.Length; i++)
        {
            double high = TwoProduct(e[i], b, out double low);
            double sum = TwoSum(q, low, out error);
            if (error != 0)
                result[n++] = error;
            q = TwoSum(high, sum, out error);
            if (error != 0)
                result[n++] = error;
        }
        if (q != 0)
            result[n++] = q;
        return n;
    }

    /// <summary>Writes e · f for an f of at most two components, at most 4 times as many as e has.</summary>
    /// <param name="e">The first factor.</param>
    /// <param name="f">The second factor, at most two components.</param>
    /// <param name="result">Where the product goes.</param>
    /// <param name="scratch">Room for both partial products.</param>
    public static int Multiply(ReadOnlySpan<double> e, ReadOnlySpan<double> f, Span<double> result, Span<double> scratch)
    {
        if (f.Length == 0)
            return 0;
        if (f.Length == 1)
            return Scale(e, f[0], result);
        int low = Scale(e, f[0], scratch);
        int high = Scale(e, f[1], scratch[low..]);
        return Sum(scratch[..low], scratch.Slice(low, high), result);
    }

    /// <summary>The sign: that of the largest component.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Sign(ReadOnlySpan<double> e) => e.IsEmpty ? 0 : e[^1] > 0 ? 1 : -1;
}
