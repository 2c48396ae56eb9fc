using System.Runtime.CompilerServices;

namespace MeshLab.LinearAlgebra;

/// <summary>The two dense operations of a supernodal Cholesky factorization, on columns in memory one after the other.</summary>
/// <remarks>
/// <para>
/// Almost all the time goes into C −= A Aᵀ. It is done in tiles of two registers of rows by four columns: eight sums stay in registers while the
/// columns of A stream by, so that one multiplication is done per half a load. Every entry is c − (((a₀b₀) + a₁b₁) + …), each step a fused
/// multiply-add, whatever tile and register it falls in: the result has the same bits on all widths.
/// </para>
/// <para>Pointers, because the tiles reach over the end of a column into its padding, and since bounds checks would cost as much as the sums.</para>
/// </remarks>
/// <typeparam name="TVector">The register.</typeparam>
/// <typeparam name="TLanes">Its operations.</typeparam>
internal static unsafe class DenseKernels<TVector, TLanes>
    where TVector : unmanaged
    where TLanes : struct, ILanes<TVector>
{
    /// <summary>C[i, j] −= Σ_k A[i, k] A[j, k] for <paramref name="from"/> ≤ j &lt; <paramref name="to"/> and j ≤ i &lt; rows.</summary>
    /// <remarks>Rows are handled in eights that begin at multiples of 8, so up to 7 rows above the diagonal and after the end are overwritten as well.</remarks>
    /// <param name="c">C.</param>
    /// <param name="strideC">The distance of C's columns.</param>
    /// <param name="a">A.</param>
    /// <param name="strideA">The distance of A's columns.</param>
    /// <param name="rows">The rows of both.</param>
    /// <param name="from">The first column.</param>
    /// <param name="to">The column after the last.</param>
    /// <param name="depth">The columns of A.</param>
    /// <param name="padded">Whether C has columns up to the next multiple of four that may be overwritten.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void SubtractSquare(double* c, long strideC, double* a, long strideA, int rows, int from, int to, int depth, bool padded)
    {
        int end = (rows + 7) & ~7, j = from;
        for (; j + 4 <= to || (padded && j < to); j += 4)
        {
            double* column = c + j * strideC;
            int i = j & ~7;
            for (; i + 2 * TLanes.Count <= end; i += 2 * TLanes.Count)
                Subtract2By4(column + i, strideC, a + i, a + j, strideA, depth);
            for (; i < end; i += TLanes.Count)
                Subtract1By4(column + i, strideC, a + i, a + j, strideA, depth);
        }
        for (; j < to; j++)
        {
            for (int i = j & ~7; i < end; i += TLanes.Count)
                Subtract1By1(c + i + j * strideC, a + i, a + j, strideA, depth);
        }
    }

    /// <summary>Factors the first columns of a matrix of <paramref name="rows"/> rows in place: the top square into L Lᵀ, the rows below into their part of L.</summary>
    /// <param name="panel">The matrix; its strict upper triangle is neither read nor written.</param>
    /// <param name="stride">The distance of columns.</param>
    /// <param name="rows">The number of rows.</param>
    /// <param name="columns">The number of columns, at most the rows.</param>
    /// <param name="smallest">Per column the pivot that counts as zero.</param>
    /// <param name="acceptZero">Whether a pivot of at most that size becomes ∞, which makes its column and its unknown zero.</param>
    /// <param name="pivot">The failed pivot.</param>
    /// <returns>The column whose pivot failed, or −1.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static int FactorPanel(double* panel, long stride, int rows, int columns, double* smallest, bool acceptZero, out double pivot)
    {
        double* inverse = stackalloc double[4];
        for (int j = 0; j < columns; j += 4)
        {
            int width = Math.Min(4, columns - j);
            double* block = panel + j + j * stride;
            SubtractEarlierColumns(block, stride, panel + j, rows - j, width, j);
            int failed = FactorSquare(block, stride, width, smallest + j, acceptZero, inverse, out pivot);
            if (failed >= 0)
                return j + failed;

            int i = width;
            for (; i + TLanes.Count <= rows - j; i += TLanes.Count)
                SolveRows(block, stride, width, i, inverse);
            for (; i < rows - j; i++)
                DenseKernels<double, LanesScalar>.SolveRows(block, stride, width, i, inverse);
        }
        pivot = 0;
        return -1;
    }

    /// <summary>y += x · column.</summary>
    public static void AddMultiple(double x, double* column, double* y, int count)
    {
        TVector factor = TLanes.Broadcast(x);
        int i = 0;
        for (; i + TLanes.Count <= count; i += TLanes.Count)
            TLanes.Store(TLanes.MultiplyAdd(factor, TLanes.Load(column + i), TLanes.Load(y + i)), y + i);
        for (; i < count; i++)
            y[i] = Math.FusedMultiplyAdd(x, column[i], y[i]);
    }

    /// <summary>y += x.</summary>
    public static void Add(double* x, double* y, int count)
    {
        int i = 0;
        for (; i + TLanes.Count <= count; i += TLanes.Count)
            TLanes.Store(TLanes.Add(TLanes.Load(y + i), TLanes.Load(x + i)), y + i);
        for (; i < count; i++)
            y[i] += x[i];
    }

    private static void SubtractEarlierColumns(double* block, long stride, double* earlier, int rows, int width, int depth)
    {
        if (depth == 0)
            return;
        int i = 0;
        if (width == 4)
        {
            for (; i + 2 * TLanes.Count <= rows; i += 2 * TLanes.Count)
                Subtract2By4(block + i, stride, earlier + i, earlier, stride, depth);
            for (; i + TLanes.Count <= rows; i += TLanes.Count)
                Subtract1By4(block + i, stride, earlier + i, earlier, stride, depth);
            for (; i < rows; i++)
                DenseKernels<double, LanesScalar>.Subtract1By4(block + i, stride, earlier + i, earlier, stride, depth);
            return;
        }
        for (int q = 0; q < width; q++)
        {
            for (i = 0; i + TLanes.Count <= rows; i += TLanes.Count)
                Subtract1By1(block + i + q * stride, earlier + i, earlier + q, stride, depth);
            for (; i < rows; i++)
                DenseKernels<double, LanesScalar>.Subtract1By1(block + i + q * stride, earlier + i, earlier + q, stride, depth);
        }
    }

    private static int FactorSquare(
        double* block, long stride, int width, double* smallest, bool acceptZero, double* inverse, out double pivot)
    {
        for (int q = 0; q < width; q++)
        {
            double* column = block + q * stride;
            for (int p = 0; p < q; p++)
            {
                double* before = block + p * stride;
                for (int i = q; i < width; i++)
                    column[i] = Math.FusedMultiplyAdd(-before[q], before[i], column[i]);
            }

            pivot = column[q];
            if (pivot > smallest[q])
                column[q] = Math.Sqrt(pivot);
            else if (acceptZero && Math.Abs(pivot) <= smallest[q])
                column[q] = double.PositiveInfinity;
            else
                return q;
            inverse[q] = 1 / column[q];
            for (int i = q + 1; i < width; i++)
                column[i] *= inverse[q];
        }
        pivot = 0;
        return -1;
    }

    // One register of rows below a factored square of at most four columns.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SolveRows(double* block, long stride, int width, int row, double* inverse)
    {
        double* c0 = block, c1 = c0 + stride, c2 = c1 + stride, c3 = c2 + stride;
        TVector v0 = TLanes.Multiply(TLanes.Load(c0 + row), TLanes.Broadcast(inverse[0]));
        TLanes.Store(v0, c0 + row);
        if (width < 2)
            return;
        TVector v1 = TLanes.MultiplyAdd(TLanes.Broadcast(-c0[1]), v0, TLanes.Load(c1 + row));
        v1 = TLanes.Multiply(v1, TLanes.Broadcast(inverse[1]));
        TLanes.Store(v1, c1 + row);
        if (width < 3)
            return;
        TVector v2 = TLanes.MultiplyAdd(TLanes.Broadcast(-c0[2]), v0, TLanes.Load(c2 + row));
        v2 = TLanes.MultiplyAdd(TLanes.Broadcast(-c1[2]), v1, v2);
        v2 = TLanes.Multiply(v2, TLanes.Broadcast(inverse[2]));
        TLanes.Store(v2, c2 + row);
        if (width < 4)
            return;
        TVector v3 = TLanes.MultiplyAdd(TLanes.Broadcast(-c0[3]), v0, TLanes.Load(c3 + row));
        v3 = TLanes.MultiplyAdd(TLanes.Broadcast(-c1[3]), v1, v3);
        v3 = TLanes.MultiplyAdd(TLanes.Broadcast(-c2[3]), v2, v3);
        TLanes.Store(TLanes.Multiply(v3, TLanes.Broadcast(inverse[3])), c3 + row);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Subtract2By4(double* c, long strideC, double* a, double* b, long stride, int depth)
    {
        TVector s00 = default, s01 = default, s10 = default, s11 = default, s20 = default, s21 = default, s30 = default, s31 = default;
        for (int k = 0; k < depth; k++)
        {
            TVector a0 = TLanes.Load(a), a1 = TLanes.Load(a + TLanes.Count);
            TVector factor = TLanes.Broadcast(b[0]);
            s00 = TLanes.MultiplyAdd(a0, factor, s00);
            s01 = TLanes.MultiplyAdd(a1, factor, s01);
            factor = TLanes.Broadcast(b[1]);
            s10 = TLanes.MultiplyAdd(a0, factor, s10);
            s11 = TLanes.MultiplyAdd(a1, factor, s11);
            factor = TLanes.Broadcast(b[2]);
            s20 = TLanes.MultiplyAdd(a0, factor, s20);
            s21 = TLanes.MultiplyAdd(a1, factor, s21);
            factor = TLanes.Broadcast(b[3]);
            s30 = TLanes.MultiplyAdd(a0, factor, s30);
            s31 = TLanes.MultiplyAdd(a1, factor, s31);
            a += stride;
            b += stride;
        }
        SubtractTwo(c, s00, s01);
        SubtractTwo(c + strideC, s10, s11);
        SubtractTwo(c + 2 * strideC, s20, s21);
        SubtractTwo(c + 3 * strideC, s30, s31);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Subtract1By4(double* c, long strideC, double* a, double* b, long stride, int depth)
    {
        TVector s0 = default, s1 = default, s2 = default, s3 = default;
        for (int k = 0; k < depth; k++)
        {
            TVector a0 = TLanes.Load(a);
            s0 = TLanes.MultiplyAdd(a0, TLanes.Broadcast(b[0]), s0);
            s1 = TLanes.MultiplyAdd(a0, TLanes.Broadcast(b[1]), s1);
            s2 = TLanes.MultiplyAdd(a0, TLanes.Broadcast(b[2]), s2);
            s3 = TLanes.MultiplyAdd(a0, TLanes.Broadcast(b[3]), s3);
            a += stride;
            b += stride;
        }
        SubtractOne(c, s0);
        SubtractOne(c + strideC, s1);
        SubtractOne(c + 2 * strideC, s2);
        SubtractOne(c + 3 * strideC, s3);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Subtract1By1(double* c, double* a, double* b, long stride, int depth)
    {
        TVector s = default;
        for (int k = 0; k < depth; k++)
        {
            s = TLanes.MultiplyAdd(TLanes.Load(a), TLanes.Broadcast(*b), s);
            a += stride;
            b += stride;
        }
        SubtractOne(c, s);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SubtractOne(double* c, TVector sum) => TLanes.Store(TLanes.Subtract(TLanes.Load(c), sum), c);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SubtractTwo(double* c, TVector first, TVector second)
    {
        SubtractOne(c, first);
        SubtractOne(c + TLanes.Count, second);
    }
}
