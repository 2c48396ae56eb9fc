namespace MeshLab.LinearAlgebra;

/// <summary>The factorization A = L D Lᵀ of a sparse symmetric matrix in one page: row by row, no reordering, no square roots, no blocks.</summary>
/// <remarks>
/// <para>
/// Read this one first. Row i of L solves L' (D' l) = a, where L' and D' are what was computed before and a is row i of A left of the diagonal.
/// It is a triangular system with a sparse right-hand side: only those columns j can be non-zero that are reached from the entries of a by
/// climbing the elimination tree, and they are worked off from the bottom up ("up-looking").
/// </para>
/// <para>
/// <see cref="SparseCholesky"/> computes the same numbers many times faster; the tests hold the two against each other. Without a good order of
/// the rows L fills up: pass one, such as <see cref="NestedDissection.Order"/>. Davis 2005, "LDL: a concise sparse Cholesky package", ACM TOMS 31(4).
/// </para>
/// </remarks>
public sealed class SimpleLdl
{
    private readonly int[] order;
    private readonly double[] d;
    private readonly List<int>[] rowsOfColumn;
    private readonly List<double>[] valuesOfColumn;

    /// <summary>Factors a matrix.</summary>
    /// <param name="matrix">The matrix.</param>
    /// <param name="order">The rows in the order of elimination; null for the order they have.</param>
    /// <exception cref="NotPositiveDefiniteException">A pivot is not positive.</exception>
    public SimpleLdl(SparseMatrix matrix, int[]? order = null)
    {
        ArgumentNullException.ThrowIfNull(matrix);
        int n = matrix.Size;
        this.order = order ?? [.. Enumerable.Range(0, n)];
        var rank = new int[n];
        for (int i = 0; i < n; i++)
            rank[this.order[i]] = i;

        d = new double[n];
        rowsOfColumn = new List<int>[n];
        valuesOfColumn = new List<double>[n];
        var parent = new int[n];
        var visited = new int[n];
        var y = new double[n];
        var reach = new Stack<int>();
        var climb = new Stack<int>();
        for (int i = 0; i < n; i++)
        {
            (rowsOfColumn[i], valuesOfColumn[i], parent[i], visited[i]) = ([], [], -1, i);
            int row = this.order[i];
            d[i] = matrix.Diagonal[row];

            // Which columns can be non-zero in row i, each after those below it in the tree.
            for (int k = matrix.RowStart[row]; k < matrix.RowStart[row + 1]; k++)
            {
                int j = rank[matrix.Columns[k]];
                if (j >= i)
                    continue;
                y[j] = matrix.Values[k];
                for (; visited[j] != i; j = parent[j])
                {
                    visited[j] = i;
                    climb.Push(j);
                    if (parent[j] < 0)
                        parent[j] = i;
                }
                while (climb.TryPop(out int c))
                    reach.Push(c);
            }

            // Solve for row i of L, and take it off the pivot.
            while (reach.TryPop(out int j))
            {
                double yj = y[j];
                y[j] = 0;
                for (int k = 0; k < rowsOfColumn[j].Count; k++)
                    y[rowsOfColumn[j][k]] -= valuesOfColumn[j][k] * yj;
                double l = yj / d[j];
                d[i] -= l * yj;
                rowsOfColumn[j].Add(i);
                valuesOfColumn[j].Add(l);
            }
            if (!(d[i] > 0))
                throw new NotPositiveDefiniteException(row, d[i]);
        }
    }

    /// <summary>The number of entries of L, the diagonal of ones included.</summary>
    public long FactorEntries => d.Length + rowsOfColumn.Sum(rows => (long)rows.Count);

    /// <summary>Solves A x = b: L z = b, D y = z, Lᵀ x = y.</summary>
    /// <param name="b">The right-hand side; not changed.</param>
    public double[] Solve(double[] b)
    {
        ArgumentNullException.ThrowIfNull(b);
        int n = d.Length;
        if (b.Length != n)
            throw new ArgumentException($"A right-hand side of {b.Length} numbers does not fit a matrix of {n} rows.", nameof(b));
        double[] x = Array.ConvertAll(order, row => b[row]);
        for (int j = 0; j < n; j++)
        {
            for (int k = 0; k < rowsOfColumn[j].Count; k++)
                x[rowsOfColumn[j][k]] -= valuesOfColumn[j][k] * x[j];
        }
        for (int j = 0; j < n; j++)
            x[j] /= d[j];
        for (int j = n - 1; j >= 0; j--)
        {
            for (int k = 0; k < rowsOfColumn[j].Count; k++)
                x[j] -= valuesOfColumn[j][k] * x[rowsOfColumn[j][k]];
        }

        var solution = new double[n];
        for (int i = 0; i < n; i++)
            solution[order[i]] = x[i];
        return solution;
    }
}
