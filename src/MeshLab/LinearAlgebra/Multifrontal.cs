using System.Runtime.Intrinsics;
using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>The numbers of the Cholesky factor, by the multifrontal method (多波前法).</summary>
/// <remarks>
/// <para>
/// Each supernode has a <em>front</em>, the dense matrix over its columns and its further rows. Into it go the matrix's own entries and the update
/// matrices of the supernode's children; then its columns are factored, and what they do to the further rows is the supernode's own update
/// matrix, which waits for the parent.
/// </para>
/// <code>
///        columns   rows
///      ┌─────────┐
///      │ L       │              the panel (L above, B below) stays: it is the factor
///      ├─────────┼──────┐
///      │ B       │  U   │       the update matrix U −= B Bᵀ goes to the parent
///      └─────────┴──────┘
/// </code>
/// <para>Duff, Reid 1983, ACM TOMS 9(3); Liu 1992, SIAM Review 34(1). All sums are taken in an order fixed by the tree.</para>
/// </remarks>
/// <typeparam name="TVector">The vector register.</typeparam>
/// <typeparam name="TLanes">Its operations.</typeparam>
internal sealed unsafe class Multifrontal<TVector, TLanes>
    where TVector : unmanaged
    where TLanes : struct, ILanes<TVector>
{
    /// <summary>Columns factored at a time before the rest of the front is updated: a tile's columns of A then stay in the cache.</summary>
    private const int BlockColumns = 64;

    private readonly CholeskyAnalysis analysis;
    private readonly EliminationTree tree;
    private readonly Supernodes nodes;
    private readonly SparseMatrix matrix;
    private readonly double* factor;
    private readonly PivotRule rule;

    // Update matrices that outlive their thread's stack: those of subtree roots and of the supernodes above.
    private readonly PinnedArray?[] keptUpdates;
    private readonly double*[] updates;

    private readonly Lock gate = new();
    private int failedColumn = int.MaxValue;
    private double failedPivot;

    public Multifrontal(CholeskyAnalysis analysis, SparseMatrix matrix, double* factor, PivotRule rule)
    {
        this.analysis = analysis;
        tree = analysis.Tree;
        nodes = analysis.Nodes;
        this.matrix = matrix;
        this.factor = factor;
        this.rule = rule;
        keptUpdates = new PinnedArray?[nodes.Count];
        updates = new double*[nodes.Count];
    }

    /// <summary>Fills the factor.</summary>
    /// <exception cref="NotPositiveDefiniteException">A pivot failed; of several, the first in the order of elimination is named.</exception>
    public void Run(CancellationToken cancellationToken)
    {
        try
        {
            FactorSubtrees(cancellationToken);
            cancellationToken.ThrowIfCancellationRequested();
            using var top = new Front(this, default);
            foreach (int s in analysis.Schedule.Top)
            {
                cancellationToken.ThrowIfCancellationRequested();
                if (nodes.First[s] < failedColumn)
                    top.Process(s, isKept: true, isTop: true);
            }
        }
        finally
        {
            // All are released by their parents, unless the work ended early.
            foreach (PinnedArray? kept in keptUpdates)
                kept?.Dispose();
        }
        if (failedColumn != int.MaxValue)
            throw new NotPositiveDefiniteException(tree.Order[failedColumn], failedPivot);
    }

    private void FactorSubtrees(CancellationToken cancellationToken)
    {
        SubtreeSchedule schedule = analysis.Schedule;
        int threads = Math.Min(Parallelism.Threads, schedule.SubtreeRoots.Length);
        int next = -1;
        Parallelism.ForBlocks(threads, 1, (_, _) =>
        {
            int i = Interlocked.Increment(ref next);
            if (i >= schedule.SubtreeRoots.Length)
                return;
            using var front = new Front(this, analysis.StackSize);
            for (; i < schedule.SubtreeRoots.Length && !cancellationToken.IsCancellationRequested; i = Interlocked.Increment(ref next))
            {
                front.Clear();
                for (int s = schedule.SubtreeFirst[i]; s <= schedule.SubtreeRoots[i] && nodes.First[s] < Volatile.Read(ref failedColumn); s++)
                    front.Process(s, isKept: s == schedule.SubtreeRoots[i], isTop: false);
            }
        });
    }

    private void Fail(int column, double pivot)
    {
        lock (gate)
        {
            if (column < failedColumn)
                (failedColumn, failedPivot) = (column, pivot);
        }
    }

    // One thread's scratch space, and the steps on one supernode.
    private sealed class Front : IDisposable
    {
        private readonly Multifrontal<TVector, TLanes> owner;

        // Update matrices wait on two stacks, by the parity of the depth in the tree: a supernode's goes on one while its children's are still
        // at the end of the other.
        private readonly PinnedArray evenStack, oddStack;
        private long evenTop, oddTop;

        // Per row its place in the current front; per row of a child its place in the parent's front.
        private readonly int[] place;
        private readonly int[] childPlace;
        private readonly double[] smallest;

        public Front(Multifrontal<TVector, TLanes> owner, (long Even, long Odd) stackSize)
        {
            this.owner = owner;
            evenStack = new PinnedArray(stackSize.Even);
            oddStack = new PinnedArray(stackSize.Odd);
            place = GC.AllocateUninitializedArray<int>(owner.matrix.Size);
            childPlace = GC.AllocateUninitializedArray<int>(owner.analysis.LargestRowCount);
            smallest = new double[owner.analysis.LargestColumnCount + 4];
        }

        public void Dispose()
        {
            evenStack.Dispose();
            oddStack.Dispose();
        }

        // A subtree given up after a failed pivot leaves its update matrices behind.
        public void Clear() => evenTop = oddTop = 0;

        public void Process(int s, bool isKept, bool isTop)
        {
            fixed (int* placePointer = place, childPointer = childPlace, rows = owner.nodes.Rows)
            fixed (double* smallestPointer = smallest)
            {
                double* panel = owner.factor + owner.nodes.PanelStart[s];
                TakeEntries(s, panel, placePointer, rows, smallestPointer);
                double* update = TakeUpdateMatrix(s, isKept);
                for (int child = owner.nodes.FirstChild[s]; child >= 0; child = owner.nodes.NextSibling[child])
                    AddChild(s, child, panel, update, placePointer, childPointer, rows);
                for (int child = owner.nodes.FirstChild[s]; child >= 0; child = owner.nodes.NextSibling[child])
                    Release(child);
                Factor(s, panel, update, smallestPointer, isTop);
            }
        }

        // The entries of the matrix in the columns of s.
        private void TakeEntries(int s, double* panel, int* placeOf, int* allRows, double* smallestPivot)
        {
            Supernodes nodes = owner.nodes;
            EliminationTree tree = owner.tree;
            int first = nodes.First[s], columns = nodes.ColumnCount(s), rowCount = nodes.RowCount(s), stride = nodes.PanelStride(s);
            int* rows = allRows + nodes.RowsStart[s];
            new Span<double>(panel, checked(stride * columns)).Clear();
            for (int j = 0; j < columns; j++)
                placeOf[first + j] = j;
            for (int k = 0; k < rowCount; k++)
                placeOf[rows[k]] = columns + k;

            int[] matrixStart = owner.matrix.RowStartArray;
            double[] diagonal = owner.matrix.DiagonalArray;
            ReadOnlySpan<double> values = owner.matrix.ValueArray;
            ReadOnlySpan<int> ranks = tree.Columns;
            for (int j = 0; j < columns; j++)
            {
                int rank = first + j, row = tree.Order[rank];
                int from = tree.RowStart[rank], count = tree.RowStart[rank + 1] - from;
                ReadOnlySpan<int> rowRanks = ranks.Slice(from, count);
                ReadOnlySpan<double> rowValues = values.Slice(matrixStart[row], count);
                double* column = panel + (long)j * stride;
                column[j] = diagonal[row];
                smallestPivot[j] = owner.rule.RelativeZero * Math.Abs(diagonal[row]);
                for (int k = 0; k < rowRanks.Length; k++)
                {
                    if (rowRanks[k] > rank)
                        column[placeOf[rowRanks[k]]] += rowValues[k];
                }
            }
        }

        // Room for the update matrix of s, all zeros.
        private double* TakeUpdateMatrix(int s, bool isKept)
        {
            int rowCount = owner.nodes.RowCount(s);
            if (rowCount == 0)
                return null;
            long size = CholeskyAnalysis.UpdateSize(rowCount);
            double* update;
            if (isKept)
            {
                owner.keptUpdates[s] = new PinnedArray(size);
                update = owner.keptUpdates[s]!.Pointer;
            }
            else if ((owner.analysis.Depth[s] & 1) == 0)
            {
                update = evenStack.Pointer + evenTop;
                evenTop += size;
            }
            else
            {
                update = oddStack.Pointer + oddTop;
                oddTop += size;
            }
            new Span<double>(update, (int)size).Clear();
            owner.updates[s] = update;
            return update;
        }

        private void Release(int child)
        {
            if (owner.updates[child] == null)
                return;
            if (owner.keptUpdates[child] is { } kept)
            {
                kept.Dispose();
                owner.keptUpdates[child] = null;
            }
            else if ((owner.analysis.Depth[child] & 1) == 0)
                evenTop -= CholeskyAnalysis.UpdateSize(owner.nodes.RowCount(child));
            else
                oddTop -= CholeskyAnalysis.UpdateSize(owner.nodes.RowCount(child));
            owner.updates[child] = null;
        }

        // "Extend–add": every entry of the child's update matrix goes to the place of its row and column in the parent's front.
        private void AddChild(int s, int child, double* panel, double* update, int* placeOf, int* to, int* allRows)
        {
            Supernodes nodes = owner.nodes;
            double* source = owner.updates[child];
            if (source == null)
                return;
            int columns = nodes.ColumnCount(s), stride = nodes.PanelStride(s), updateStride = CholeskyAnalysis.UpdateStride(nodes.RowCount(s));
            int count = nodes.RowCount(child), childStride = CholeskyAnalysis.UpdateStride(count);
            int* rows = allRows + nodes.RowsStart[child];
            int inPanel = 0;
            for (int k = 0; k < count; k++)
            {
                to[k] = placeOf[rows[k]];
                if (to[k] < columns)
                    inPanel = k + 1;
            }

            for (int j = 0; j < inPanel; j++)
            {
                double* column = panel + (long)to[j] * stride;
                double* from = source + (long)j * childStride;
                for (int i = j; i < count; i++)
                    column[to[i]] += from[i];
            }
            for (int j = inPanel; j < count; j++)
            {
                double* column = update + (long)(to[j] - columns) * updateStride - columns;
                double* from = source + (long)j * childStride;
                if (to[count - 1] - to[j] == count - 1 - j)
                {
                    // From here on the child's rows follow one another in the parent as well.
                    DenseKernels<TVector, TLanes>.Add(from + j, column + to[j], count - j);
                    continue;
                }
                for (int i = j; i < count; i++)
                    column[to[i]] += from[i];
            }
        }

        private void Factor(int s, double* panel, double* update, double* smallestPivot, bool isTop)
        {
            int columns = owner.nodes.ColumnCount(s), rowCount = owner.nodes.RowCount(s), stride = owner.nodes.PanelStride(s);
            int updateStride = CholeskyAnalysis.UpdateStride(rowCount), height = columns + rowCount;
            for (int j = 0; j < columns; j += BlockColumns)
            {
                int width = Math.Min(BlockColumns, columns - j), next = j + width;
                double* block = panel + j + (long)j * stride;
                int failed = DenseKernels<TVector, TLanes>.FactorPanel(
                    block, stride, height - j, width, smallestPivot + j, owner.rule.AcceptZero, out double pivot);
                if (failed >= 0)
                {
                    owner.Fail(owner.nodes.First[s] + j + failed, pivot);
                    return;
                }
                double* below = panel + next + (long)j * stride;
                if (next < columns)
                    Subtract(panel + next + (long)next * stride, stride, below, stride, height - next, columns - next, width, false, isTop);
                if (rowCount > 0)
                    Subtract(update, updateStride, panel + columns + (long)j * stride, stride, rowCount, rowCount, width, true, isTop);
            }
        }

        private static void Subtract(
            double* c, long strideC, double* a, long strideA, int rows, int columns, int depth, bool padded, bool isTop)
        {
            const int chunk = 64;
            if (!isTop || (double)rows * columns * depth < 2e6)
            {
                DenseKernels<TVector, TLanes>.SubtractSquare(c, strideC, a, strideA, rows, 0, columns, depth, padded);
                return;
            }
            // Chunks of a multiple of four columns never share one.
            Parallelism.ForBlocks(columns, chunk, (from, to) => DenseKernels<TVector, TLanes>.SubtractSquare(
                c, strideC, a, strideA, rows, from, to, depth, padded));
        }
    }
}

/// <summary>Chooses the widest vector registers that the machine has.</summary>
internal static unsafe class Multifrontal
{
    public static void Run(CholeskyAnalysis analysis, SparseMatrix matrix, double* factor, PivotRule rule, CancellationToken cancellationToken)
    {
        if (Vector512.IsHardwareAccelerated)
            new Multifrontal<Vector512<double>, Lanes512>(analysis, matrix, factor, rule).Run(cancellationToken);
        else if (Vector256.IsHardwareAccelerated)
            new Multifrontal<Vector256<double>, Lanes256>(analysis, matrix, factor, rule).Run(cancellationToken);
        else
            new Multifrontal<double, LanesScalar>(analysis, matrix, factor, rule).Run(cancellationToken);
    }
}

/// <summary>When a pivot counts as zero, and what then.</summary>
/// <param name="RelativeZero">The pivot divided by the diagonal entry, below which it counts as zero.</param>
/// <param name="AcceptZero">Whether a zero pivot sets its unknown to zero instead of failing.</param>
internal readonly record struct PivotRule(double RelativeZero, bool AcceptZero);
