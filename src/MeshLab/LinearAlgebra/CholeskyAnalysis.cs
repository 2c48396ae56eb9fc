using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>What can be said about the Cholesky factor of a matrix before any number is computed (符号分解, symbolic factorization).</summary>
/// <remarks>
/// It depends on the places of the entries only, takes about half the time of a whole solution, and serves every matrix with the same places:
/// Laplacians of a mesh that moves, shifted by any multiple of the mass matrix.
/// </remarks>
public sealed class CholeskyAnalysis
{
    private readonly int[] rowStart;
    private readonly int[] columns;

    private CholeskyAnalysis(SparseMatrix matrix, EliminationTree tree, Supernodes nodes)
    {
        rowStart = matrix.RowStartArray;
        columns = matrix.ColumnArray;
        Tree = tree;
        Nodes = nodes;
        Schedule = new SubtreeSchedule(nodes);
        Depth = Depths(nodes);
        StackSize = Schedule.SubtreeRoots.Length == 0 ? default : LargestStacks();
        for (int s = 0; s < nodes.Count; s++)
        {
            LargestRowCount = Math.Max(LargestRowCount, nodes.RowCount(s));
            LargestColumnCount = Math.Max(LargestColumnCount, nodes.ColumnCount(s));
        }
        foreach (int count in tree.ColumnCounts)
        {
            FactorEntries += count;
            Operations += (double)count * count;
        }
    }

    /// <summary>The number of rows of the matrix.</summary>
    public int Size => Tree.Order.Length;

    /// <summary>The number of entries of the factor that need not be zero.</summary>
    public long FactorEntries { get; }

    /// <summary>The number of multiplications and additions of the factorization.</summary>
    public double Operations { get; }

    /// <summary>The number of supernodes, the dense panels of which the factor is made.</summary>
    public int SupernodeCount => Nodes.Count;

    /// <summary>The order of elimination: entry k is the row eliminated k-th.</summary>
    public ReadOnlySpan<int> Order => Tree.Order;

    internal EliminationTree Tree { get; }

    internal Supernodes Nodes { get; }

    internal SubtreeSchedule Schedule { get; }

    internal int[] Depth { get; }

    internal (long Even, long Odd) StackSize { get; }

    internal int LargestRowCount { get; }

    internal int LargestColumnCount { get; }

    /// <summary>Analyses a matrix: order by <see cref="NestedDissection"/>, elimination tree, lengths of the columns, supernodes.</summary>
    /// <param name="matrix">The matrix; only the places of its entries matter.</param>
    /// <param name="positions">A point per row that tells which rows lie near each other, as vertices do. Empty: taken from the matrix's graph.</param>
    public static CholeskyAnalysis Of(SparseMatrix matrix, ReadOnlySpan<Vector3D> positions = default) =>
        Of(matrix, NestedDissection.Order(matrix, positions));

    /// <summary>Analyses a matrix for a given order of elimination.</summary>
    /// <param name="matrix">The matrix; only the places of its entries matter.</param>
    /// <param name="order">Each row once; it is refined to a postorder of the elimination tree, which keeps the fill-in.</param>
    /// <exception cref="ArgumentException">The order is not a permutation of the rows.</exception>
    public static CholeskyAnalysis Of(SparseMatrix matrix, int[] order)
    {
        ArgumentNullException.ThrowIfNull(matrix);
        ArgumentNullException.ThrowIfNull(order);
        var seen = new bool[matrix.Size];
        if (order.Length != matrix.Size)
            throw new ArgumentException($"An order of {order.Length} rows does not fit a matrix of {matrix.Size}.", nameof(order));
        foreach (int row in order)
        {
            if ((uint)row >= (uint)seen.Length || seen[row])
                throw new ArgumentException($"The order names row {row} twice, or there is no such row.", nameof(order));
            seen[row] = true;
        }
        EliminationTree tree = EliminationTree.Of(matrix, order);
        return new CholeskyAnalysis(matrix, tree, Supernodes.Of(tree));
    }

    internal static int UpdateStride(int rows) => (rows + 7) & ~7;

    /// <summary>The numbers of an update matrix, with the padding that <see cref="DenseKernels{TVector, TLanes}.SubtractSquare"/> writes over.</summary>
    internal static long UpdateSize(int rows) => (long)UpdateStride(rows) * ((rows + 3) & ~3) + 16;

    internal void ThrowIfOtherPattern(SparseMatrix matrix, string name)
    {
        ArgumentNullException.ThrowIfNull(matrix, name);
        if (!matrix.IsSymmetric)
            throw new ArgumentException("Only symmetric matrices have a Cholesky factor.", name);
        if (!matrix.HasPatternOf(rowStart, columns))
            throw new ArgumentException("The matrix has entries in other places than the one that was analysed.", name);
    }

    private static int[] Depths(Supernodes nodes)
    {
        var depth = new int[nodes.Count];
        for (int s = nodes.Count - 1; s >= 0; s--)
            depth[s] = nodes.Parent[s] < 0 ? 0 : depth[nodes.Parent[s]] + 1;
        return depth;
    }

    // Goes through the motions of every subtree to see how high its two stacks grow; the root's own update matrix is kept elsewhere.
    private (long Even, long Odd) LargestStacks()
    {
        long largestEven = 0, largestOdd = 0;
        for (int t = 0; t < Schedule.SubtreeRoots.Length; t++)
        {
            long even = 0, odd = 0;
            for (int s = Schedule.SubtreeFirst[t]; s <= Schedule.SubtreeRoots[t]; s++)
            {
                if (s < Schedule.SubtreeRoots[t] && Nodes.RowCount(s) > 0)
                    (Depth[s] % 2 == 0 ? ref even : ref odd) += UpdateSize(Nodes.RowCount(s));
                largestEven = Math.Max(largestEven, even);
                largestOdd = Math.Max(largestOdd, odd);
                for (int child = Nodes.FirstChild[s]; child >= 0; child = Nodes.NextSibling[child])
                {
                    if (Nodes.RowCount(child) > 0)
                        (Depth[child] % 2 == 0 ? ref even : ref odd) -= UpdateSize(Nodes.RowCount(child));
                }
            }
        }
        return (largestEven + 1, largestOdd + 1);
    }
}
