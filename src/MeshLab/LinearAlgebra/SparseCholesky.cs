using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>What a factorization accepts.</summary>
public sealed record CholeskyOptions
{
    private readonly double relativeZero = 1e-13;

    /// <summary>A pivot of at most this part of its diagonal entry counts as zero; 1e-13 unless set. 0 accepts every positive pivot.</summary>
    public double RelativeZero
    {
        get => relativeZero;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(value, 1);
            relativeZero = value;
        }
    }

    /// <summary>
    /// Whether a positive <em>semi</em>definite matrix is accepted. Every zero pivot then fixes its unknown at 0: on a Laplacian, one vertex per
    /// component. Where the system has a solution (the right-hand side sums to 0 over each component) this is one of them.
    /// </summary>
    public bool AllowSemidefinite { get; init; }
}

/// <summary>§12.5 The Cholesky factor (乔列斯基分解) P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix, to solve A x = b directly.</summary>
/// <remarks>
/// <para>
/// Order by nested dissection, supernodes, multifrontal factorization: see <c>docs/solvers.md</c>. For a surface of n vertices the factor has about
/// 30 n entries, the factorization costs O(n^1.5) and each solution O(n log n). The factor can be used for any number of right-hand sides, at
/// the same time from several threads, and refilled for another matrix with entries in the same places.
/// </para>
/// <para>The result has the same bits on every number of threads and every width of vector registers.</para>
/// </remarks>
public sealed unsafe class SparseCholesky
{
    private const int SidesAtOnce = 4;

    private readonly double[] storage;

    // Where the first panel begins. Should the collector ever move the array, the panels lose their alignment only.
    private readonly int aligned;
    private readonly PivotRule rule;
    private bool isFactored;

    /// <summary>Analyses and factors a matrix.</summary>
    /// <param name="matrix">The matrix.</param>
    /// <param name="positions">A point per row that tells which rows lie near each other, as vertices do. Empty: taken from the matrix's graph.</param>
    /// <param name="options">What is accepted.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="NotPositiveDefiniteException">A pivot is not positive.</exception>
    public SparseCholesky(
        SparseMatrix matrix, ReadOnlySpan<Vector3D> positions = default, CholeskyOptions? options = null, CancellationToken cancellationToken = default)
        : this(matrix, CholeskyAnalysis.Of(matrix, positions), options, cancellationToken)
    {
    }

    /// <summary>Factors a matrix that was analysed before.</summary>
    /// <param name="matrix">The matrix.</param>
    /// <param name="analysis">Of this matrix, or of one with entries in the same places.</param>
    /// <param name="options">What is accepted.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="NotPositiveDefiniteException">A pivot is not positive.</exception>
    public SparseCholesky(
        SparseMatrix matrix, CholeskyAnalysis analysis, CholeskyOptions? options = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(analysis);
        options ??= new CholeskyOptions();
        Analysis = analysis;
        rule = new PivotRule(options.RelativeZero, options.AllowSemidefinite);
        // 7 numbers to begin at a cache line, 64 for the reads beyond the last panel.
        storage = GC.AllocateUninitializedArray<double>((int)analysis.Nodes.PanelStart[^1] + 7 + 64);
        fixed (double* start = storage)
            aligned = (int)((((nuint)start + 63) & ~(nuint)63) - (nuint)start) / sizeof(double);
        Factor(matrix, cancellationToken);
    }

    /// <summary>The order, the elimination tree and the supernodes, to be used for other matrices with entries in the same places.</summary>
    public CholeskyAnalysis Analysis { get; }

    /// <summary>The number of rows of the matrix.</summary>
    public int Size => Analysis.Size;

    /// <summary>The rows whose unknown was fixed at 0 because their pivot is zero; empty unless <see cref="CholeskyOptions.AllowSemidefinite"/>.</summary>
    public IReadOnlyList<int> FixedRows { get; private set; } = [];

    /// <summary>Replaces the factor by that of another matrix with entries in the same places.</summary>
    /// <param name="matrix">The matrix.</param>
    /// <param name="cancellationToken">Stops the work; the factor is then unusable.</param>
    /// <exception cref="ArgumentException">The matrix has entries in other places.</exception>
    /// <exception cref="NotPositiveDefiniteException">A pivot is not positive; the factor is then unusable.</exception>
    public void Factor(SparseMatrix matrix, CancellationToken cancellationToken = default)
    {
        Analysis.ThrowIfOtherPattern(matrix, nameof(matrix));
        isFactored = false;
        fixed (double* start = storage)
            Multifrontal.Run(Analysis, matrix, start + aligned, rule, cancellationToken);
        FixedRows = rule.AcceptZero ? FindFixedRows() : [];
        isFactored = true;
    }

    /// <summary>Solves A x = b.</summary>
    /// <param name="b">The right-hand side; not changed.</param>
    /// <returns>x.</returns>
    public double[] Solve(double[] b) => Solve([b])[0];

    /// <summary>Solves A x = b for several right-hand sides, four of them in each pass over the factor.</summary>
    /// <param name="b">The right-hand sides; not changed.</param>
    /// <returns>The solutions: the same bits as one by one.</returns>
    /// <exception cref="InvalidOperationException">The last factorization failed.</exception>
    public double[][] Solve(params double[][] b)
    {
        ArgumentNullException.ThrowIfNull(b);
        if (!isFactored)
            throw new InvalidOperationException("The last factorization failed: there is no factor to solve with.");
        foreach (double[] side in b)
        {
            if (side is null || side.Length != Size)
                throw new ArgumentException($"A right-hand side of {side?.Length ?? 0} numbers does not fit a matrix of {Size} rows.", nameof(b));
        }

        var solutions = new double[b.Length][];
        for (int from = 0; from < b.Length; from += SidesAtOnce)
            SolveSome(b.AsSpan(from, Math.Min(SidesAtOnce, b.Length - from)), solutions.AsSpan(from));
        return solutions;
    }

    /// <summary>Solves A x = b for each coordinate of points.</summary>
    /// <param name="b">The right-hand sides.</param>
    public Vector3D[] Solve(ReadOnlySpan<Vector3D> b)
    {
        double[][] sides = [new double[b.Length], new double[b.Length], new double[b.Length]];
        for (int i = 0; i < b.Length; i++)
            (sides[0][i], sides[1][i], sides[2][i]) = b[i];
        sides = Solve(sides);
        var x = new Vector3D[b.Length];
        for (int i = 0; i < x.Length; i++)
            x[i] = new Vector3D(sides[0][i], sides[1][i], sides[2][i]);
        return x;
    }

    private void SolveSome(ReadOnlySpan<double[]> b, Span<double[]> solutions)
    {
        int n = Size;
        int[] order = Analysis.Tree.Order;
        var x = GC.AllocateUninitializedArray<double>(checked(n * b.Length + 1));
        for (int q = 0; q < b.Length; q++)
        {
            ReadOnlySpan<double> side = b[q];
            Span<double> ordered = x.AsSpan(q * n, n);
            for (int i = 0; i < ordered.Length; i++)
                ordered[i] = side[order[i]];
        }
        fixed (double* start = storage, sides = x)
            SupernodalSolve.Run(Analysis, start + aligned, sides, b.Length);
        for (int q = 0; q < b.Length; q++)
        {
            solutions[q] = new double[n];
            Span<double> solution = solutions[q], ordered = x.AsSpan(q * n, n);
            for (int i = 0; i < ordered.Length; i++)
                solution[order[i]] = ordered[i];
        }
    }

    private List<int> FindFixedRows()
    {
        var rows = new List<int>();
        Supernodes nodes = Analysis.Nodes;
        for (int s = 0; s < nodes.Count; s++)
        {
            for (int j = 0; j < nodes.ColumnCount(s); j++)
            {
                if (double.IsPositiveInfinity(storage[aligned + nodes.PanelStart[s] + (long)j * (nodes.PanelStride(s) + 1)]))
                    rows.Add(Analysis.Tree.Order[nodes.First[s] + j]);
            }
        }
        rows.Sort();
        return rows;
    }
}
