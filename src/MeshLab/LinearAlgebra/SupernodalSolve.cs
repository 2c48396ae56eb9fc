using System.Runtime.Intrinsics;
using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>The two triangular systems L y = b and Lᵀ x = y with a factor made of supernodes, for a few right-hand sides at once.</summary>
/// <remarks>
/// Forward, every supernode solves its own columns and takes them off its further rows; backward the other way round. Subtrees are worked on in
/// parallel: what a subtree takes off rows above it is kept apart and added in the order of the subtrees. The time is that of reading the
/// factor twice from memory, however many right-hand sides there are.
/// </remarks>
/// <typeparam name="TVector">The vector register.</typeparam>
/// <typeparam name="TLanes">Its operations.</typeparam>
internal sealed unsafe class SupernodalSolve<TVector, TLanes>
    where TVector : unmanaged
    where TLanes : struct, ILanes<TVector>
{
    private readonly Supernodes nodes;
    private readonly SubtreeSchedule schedule;
    private readonly int largestHeight;
    private readonly double* factor;

    // The right-hand sides and then the solutions, one after the other, in the order of elimination.
    private readonly double* x;
    private readonly int size, sides;

    // Per subtree and right-hand side, what it takes off the columns of the supernodes at the top.
    private readonly double[][] above;

    public SupernodalSolve(CholeskyAnalysis analysis, double* factor, double* x, int sides)
    {
        nodes = analysis.Nodes;
        schedule = analysis.Schedule;
        largestHeight = analysis.LargestRowCount + analysis.LargestColumnCount;
        this.factor = factor;
        this.x = x;
        this.sides = sides;
        size = analysis.Size;
        above = new double[schedule.SubtreeRoots.Length][];
    }

    public void Run()
    {
        Parallelism.ForBlocks(above.Length, 1, (t, _) => ForwardSubtree(t));
        for (int t = 0; t < above.Length; t++)
            AddAbove(t);

        var buffer = new double[largestHeight * sides];
        fixed (double* b = buffer)
        {
            foreach (int s in schedule.Top)
                Forward(s, b, size, null);
            for (int i = schedule.Top.Length - 1; i >= 0; i--)
                Backward(schedule.Top[i], b);
        }
        Parallelism.ForBlocks(above.Length, 1, (t, _) => BackwardSubtree(t));
    }

    private void ForwardSubtree(int t)
    {
        int root = schedule.SubtreeRoots[t];
        above[t] = new double[schedule.TopColumnCount * sides];
        var buffer = new double[largestHeight * sides];
        fixed (double* b = buffer, aboveRoot = above[t])
        {
            for (int s = schedule.SubtreeFirst[t]; s <= root; s++)
                Forward(s, b, nodes.First[root + 1], aboveRoot);
        }
    }

    private void BackwardSubtree(int t)
    {
        var buffer = new double[largestHeight * sides];
        fixed (double* b = buffer)
        {
            for (int s = schedule.SubtreeRoots[t]; s >= schedule.SubtreeFirst[t]; s--)
                Backward(s, b);
        }
    }

    private void AddAbove(int t)
    {
        foreach (int row in RowsOf(schedule.SubtreeRoots[t]))
        {
            for (int q = 0; q < sides; q++)
                x[(long)q * size + row] += above[t][q * schedule.TopColumnCount + schedule.TopPlace[row]];
        }
    }

    private ReadOnlySpan<int> RowsOf(int s) => nodes.Rows.AsSpan((int)nodes.RowsStart[s], nodes.RowCount(s));

    // Solves for the columns of s and takes them off the further rows: those before `end` in x, the others in `aboveRoot`.
    private void Forward(int s, double* buffer, int end, double* aboveRoot)
    {
        int first = nodes.First[s], columns = nodes.ColumnCount(s), height = columns + nodes.RowCount(s), stride = nodes.PanelStride(s);
        double* panel = factor + nodes.PanelStart[s];
        for (int q = 0; q < sides; q++)
        {
            new ReadOnlySpan<double>(x + (long)q * size + first, columns).CopyTo(new Span<double>(buffer + q * height, columns));
            new Span<double>(buffer + q * height + columns, height - columns).Clear();
        }
        for (int j = 0; j < columns; j++)
        {
            double* column = panel + (long)j * stride;
            for (int q = 0; q < sides; q++)
            {
                double* b = buffer + q * height;
                b[j] /= column[j];
                DenseKernels<TVector, TLanes>.AddMultiple(-b[j], column + j + 1, b + j + 1, height - j - 1);
            }
        }

        ReadOnlySpan<int> rows = RowsOf(s);
        for (int q = 0; q < sides; q++)
        {
            double* b = buffer + q * height, y = x + (long)q * size;
            new ReadOnlySpan<double>(b, columns).CopyTo(new Span<double>(y + first, columns));
            b += columns;
            int k = 0;
            for (; k < rows.Length && rows[k] < end; k++)
                y[rows[k]] += b[k];
            for (; k < rows.Length; k++)
                aboveRoot[q * schedule.TopColumnCount + schedule.TopPlace[rows[k]]] += b[k];
        }
    }

    private void Backward(int s, double* buffer)
    {
        int first = nodes.First[s], columns = nodes.ColumnCount(s), height = columns + nodes.RowCount(s), stride = nodes.PanelStride(s);
        double* panel = factor + nodes.PanelStart[s];
        ReadOnlySpan<int> rows = RowsOf(s);
        for (int q = 0; q < sides; q++)
        {
            double* b = buffer + q * height, y = x + (long)q * size;
            new ReadOnlySpan<double>(y + first, columns).CopyTo(new Span<double>(b, columns));
            for (int k = 0; k < rows.Length; k++)
                b[columns + k] = y[rows[k]];
        }
        for (int j = columns - 1; j >= 0; j--)
        {
            double* column = panel + (long)j * stride;
            for (int q = 0; q < sides; q++)
            {
                double* b = buffer + q * height;
                b[j] = (b[j] - TLanes.Dot(column + j + 1, b + j + 1, height - j - 1)) / column[j];
            }
        }
        for (int q = 0; q < sides; q++)
            new ReadOnlySpan<double>(buffer + q * height, columns).CopyTo(new Span<double>(x + (long)q * size + first, columns));
    }
}

/// <summary>Chooses the widest vector registers that the machine has.</summary>
internal static unsafe class SupernodalSolve
{
    public static void Run(CholeskyAnalysis analysis, double* factor, double* x, int sides)
    {
        if (Vector512.IsHardwareAccelerated)
            new SupernodalSolve<Vector512<double>, Lanes512>(analysis, factor, x, sides).Run();
        else if (Vector256.IsHardwareAccelerated)
            new SupernodalSolve<Vector256<double>, Lanes256>(analysis, factor, x, sides).Run();
        else
            new SupernodalSolve<double, LanesScalar>(analysis, factor, x, sides).Run();
    }
}
