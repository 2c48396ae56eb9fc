using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Box = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>Selection of the k-th record along an axis (Hoare's quickselect), without branches that the processor would guess wrong.</summary>
internal static class MedianSelection
{
    /// <summary>Reorders the records so that none before <paramref name="k"/> has a larger doubled centroid along the axis than any from there on.</summary>
    /// <remarks>Expected linear time; equal keys, sorted and reversed orders included. The result depends on the input order alone.</remarks>
    public static void Select(Span<Box> records, int k, int axis)
    {
        int start = 0, end = records.Length;
        uint state = 0x9E3779B9;
        while (end - start > 1)
        {
            float pivot = Pivot(records[start..end], axis, ref state);
            int middle = start + Partition(records[start..end], axis, pivot, orEqual: false);
            if (k < middle)
            {
                end = middle;
                continue;
            }
            if (middle == start)
            {
                // The pivot is the smallest key: take all equal ones away, or the range would not shrink.
                middle = start + Partition(records[start..end], axis, pivot, orEqual: true);
                if (k < middle)
                    return;
            }
            start = middle;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Key(ref Box record, int axis)
    {
        ref float first = ref Unsafe.As<Box, float>(ref record);
        return Unsafe.Add(ref first, axis) - Unsafe.Add(ref first, axis + 4);
    }

    // The median of three for short ranges, the median of a pseudo-random sample for long ones.
    private static float Pivot(Span<Box> records, int axis, ref uint state)
    {
        if (records.Length < 64)
        {
            float a = Key(ref records[0], axis), b = Key(ref records[records.Length / 2], axis), c = Key(ref records[^1], axis);
            return Math.Max(Math.Min(a, b), Math.Min(Math.Max(a, b), c));
        }
        Span<float> sample = stackalloc float[records.Length < 2048 ? 9 : 65];
        for (int i = 0; i < sample.Length; i++)
        {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            sample[i] = Key(ref records[(int)(((ulong)state * (ulong)records.Length) >> 32)], axis);
        }
        sample.Sort();
        return sample[sample.Length / 2];
    }

    // Puts the keys below the pivot first. Every step exchanges two records and moves the border by the comparison's result.
    private static int Partition(Span<Box> records, int axis, float pivot, bool orEqual)
    {
        ref Box first = ref MemoryMarshal.GetReference(records);
        int border = 0;
        if (orEqual)
            pivot = MathF.BitIncrement(pivot);
        for (int i = 0; i < records.Length; i++)
        {
            ref Box at = ref Unsafe.Add(ref first, i);
            ref Box limit = ref Unsafe.Add(ref first, border);
            bool below = Key(ref at, axis) < pivot;
            Box record = at;
            at = limit;
            limit = record;
            border += Unsafe.As<bool, byte>(ref below);
        }
        return border;
    }
}
