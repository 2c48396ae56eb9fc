using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;
using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>The smallest eigenpairs of L x = λ M x by block Lanczos on (L + σ M)⁻¹ M.</summary>
internal sealed class ShiftInvertLanczos
{
    private readonly SparseMatrix laplacian, mass;
    private readonly SparseCholesky factor;
    private readonly EigenOptions options;
    private readonly Random random = new(20);

    // The basis, M-orthonormal; T = basisᵀ M (L + σ M)⁻¹ M basis, known for the vectors that were multiplied.
    private readonly List<double[]> basis = [];
    private double[,] projected;
    private int multiplied, solutions;

    private ShiftInvertLanczos(SparseMatrix laplacian, SparseMatrix mass, ReadOnlySpan<Vector3D> positions, EigenOptions options, CancellationToken cancellationToken)
    {
        this.laplacian = laplacian;
        this.mass = mass;
        this.options = options;
        // Of the size of the smallest eigenvalues: 4 π / area would be typical of the first one.
        double area = 0;
        foreach (double m in mass.Multiply(Ones(mass.Size)))
            area += m;
        SparseMatrix shifted = laplacian.ScaleAndAdd(1, mass.ScaleAndAdd(0.1 / area - 1, mass));
        factor = new SparseCholesky(shifted, positions, cancellationToken: cancellationToken);
        projected = new double[0, 0];
    }

    public static Eigenpairs Smallest(
        SparseMatrix laplacian, SparseMatrix mass, int count, ReadOnlySpan<Vector3D> positions, EigenOptions options,
        IProgress<double>? progress, CancellationToken cancellationToken) =>
        new ShiftInvertLanczos(laplacian, mass, positions, options, cancellationToken).Run(count, progress, cancellationToken);

    private Eigenpairs Run(int count, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        int n = laplacian.Size, block = Math.Min(options.BlockSize, n);
        int capacity = Math.Min(n, Math.Max(2 * count + 4 * block, count + 40));
        if (n < 2 * capacity)
            capacity = n;
        projected = new double[capacity + block, capacity + block];
        for (int i = 0; i < block; i++)
            AddOrthonormal(null, -1);

        while (true)
        {
            cancellationToken.ThrowIfCancellationRequested();
            double[,] remainder = MultiplyBlock();
            (double[] ritz, Matrix<double> vectors) = Decompose();
            int converged = CountConverged(ritz, vectors, remainder, count);
            progress?.Report(Math.Min(1, (double)converged / count));
            if (converged >= count || multiplied >= n)
                return Finish(count, vectors);
            if (solutions > options.MaxSolutions)
                throw new ArithmeticException($"{converged} of {count} eigenpairs converged in {solutions} solutions.");
            if (capacity < n && basis.Count + block > capacity)
                Restart(Math.Min(multiplied, count + block), vectors);
        }
    }

    // Applies the operator to the vectors that were not multiplied yet, and takes from the results what the basis does not hold yet.
    // Returns how much of each new vector (row) is in the result of each vector of the block (column).
    private double[,] MultiplyBlock()
    {
        int first = multiplied, size = basis.Count - first;
        double[][] products = new double[size][];
        for (int j = 0; j < size; j++)
            products[j] = mass.Multiply(basis[first + j]);
        products = factor.Solve(products);
        solutions += size;
        multiplied = basis.Count;

        var remainder = new double[size, size];
        for (int j = 0; j < size; j++)
        {
            AddOrthonormal(products[j], first + j);
            for (int i = multiplied; i < basis.Count; i++)
                remainder[i - multiplied, j] = projected[i, first + j];
        }
        return remainder;
    }

    // Orthogonalizes w against the basis, twice, and appends the rest. The coefficients are column `column` of the projected matrix.
    private void AddOrthonormal(double[]? w, int column)
    {
        double before = 0;
        if (w is null)
            w = RandomVector();
        else
            before = MassNorm(w);
        for (int pass = 0; pass < 2; pass++)
        {
            double[] weighted = mass.Multiply(w);
            var coefficients = new double[basis.Count];
            Parallelism.ForBlocks(basis.Count, 1, (i, _) => coefficients[i] = Dot(basis[i], weighted));
            Subtract(w, coefficients);
            if (column < 0)
                continue;
            for (int i = 0; i < coefficients.Length; i++)
            {
                projected[i, column] += coefficients[i];
                if (i < multiplied && i < column)
                    projected[column, i] = projected[i, column];
            }
        }

        double norm = MassNorm(w);
        if (norm <= 1e-14 * before || norm == 0)
        {
            // Nothing new: the basis holds an invariant subspace. A random direction goes on, unless the basis is complete.
            if (basis.Count < laplacian.Size)
                AddOrthonormal(null, -1);
            return;
        }
        if (column >= 0)
            projected[basis.Count, column] = norm;
        for (int i = 0; i < w.Length; i++)
            w[i] /= norm;
        basis.Add(w);
    }

    private (double[] Values, Matrix<double> Vectors) Decompose()
    {
        int m = multiplied;
        Matrix<double> t = Matrix<double>.Build.Dense(m, m, (i, j) => 0.5 * (projected[i, j] + projected[j, i]));
        Evd<double> evd = t.Evd(Symmetricity.Symmetric);
        // Largest first.
        double[] values = new double[m];
        Matrix<double> vectors = Matrix<double>.Build.Dense(m, m);
        for (int k = 0; k < m; k++)
        {
            values[k] = evd.EigenValues[m - 1 - k].Real;
            vectors.SetColumn(k, evd.EigenVectors.Column(m - 1 - k));
        }
        return (values, vectors);
    }

    private int CountConverged(double[] ritz, Matrix<double> vectors, double[,] remainder, int count)
    {
        int size = remainder.GetLength(0), converged = 0;
        for (; converged < Math.Min(count, ritz.Length); converged++)
        {
            double sum = 0;
            for (int i = 0; i < size; i++)
            {
                double part = 0;
                for (int j = 0; j < size; j++)
                    part += remainder[i, j] * vectors[multiplied - size + j, converged];
                sum += part * part;
            }
            if (Math.Sqrt(sum) > options.Tolerance * ritz[converged])
                break;
        }
        return converged;
    }

    // Keeps the best vectors of the basis and the block that was not multiplied yet.
    private void Restart(int keep, Matrix<double> vectors)
    {
        double[][] kept = Combine(keep, vectors);
        List<double[]> rest = basis[multiplied..];
        double[] ritz = new double[keep];
        for (int k = 0; k < keep; k++)
        {
            for (int i = 0; i < multiplied; i++)
            {
                for (int j = 0; j < multiplied; j++)
                    ritz[k] += vectors[i, k] * 0.5 * (projected[i, j] + projected[j, i]) * vectors[j, k];
            }
        }
        basis.Clear();
        basis.AddRange(kept);
        basis.AddRange(rest);
        Array.Clear(projected);
        for (int k = 0; k < keep; k++)
            projected[k, k] = ritz[k];
        multiplied = keep;
    }

    private Eigenpairs Finish(int count, Matrix<double> vectors)
    {
        double[][] x = Combine(count, vectors);
        var values = new double[count];
        for (int k = 0; k < count; k++)
        {
            double norm = MassNorm(x[k]);
            int largest = 0;
            for (int i = 1; i < x[k].Length; i++)
            {
                // Of entries equal up to rounding the first decides, so that symmetric shapes do not leave the sign to chance.
                if (Math.Abs(x[k][i]) > Math.Abs(x[k][largest]) * (1 + 1e-6))
                    largest = i;
            }
            double scale = (x[k][largest] < 0 ? -1 : 1) / norm;
            for (int i = 0; i < x[k].Length; i++)
                x[k][i] *= scale;
            values[k] = laplacian.QuadraticForm(x[k]);
        }
        int[] order = [.. Enumerable.Range(0, count).OrderBy(k => values[k])];
        return new Eigenpairs([.. order.Select(k => values[k])], [.. order.Select(k => x[k])], solutions);
    }

    private double[][] Combine(int count, Matrix<double> vectors)
    {
        var x = new double[count][];
        for (int k = 0; k < count; k++)
            x[k] = new double[laplacian.Size];
        Parallelism.ForBlocks(laplacian.Size, (from, to) =>
        {
            for (int k = 0; k < count; k++)
            {
                for (int j = 0; j < multiplied; j++)
                {
                    double c = vectors[j, k];
                    double[] v = basis[j], sum = x[k];
                    for (int i = from; i < to; i++)
                        sum[i] += c * v[i];
                }
            }
        });
        return x;
    }

    private void Subtract(double[] w, double[] coefficients) => Parallelism.ForBlocks(w.Length, (from, to) =>
    {
        for (int j = 0; j < coefficients.Length; j++)
        {
            double c = coefficients[j];
            double[] v = basis[j];
            for (int i = from; i < to; i++)
                w[i] -= c * v[i];
        }
    });

    private double MassNorm(double[] w) => Math.Sqrt(mass.QuadraticForm(w));

    private double[] RandomVector() => Array.ConvertAll(new double[laplacian.Size], _ => random.NextDouble() - 0.5);

    private static double[] Ones(int n)
    {
        var ones = new double[n];
        Array.Fill(ones, 1);
        return ones;
    }

    private static double Dot(double[] a, double[] b)
    {
        double sum = 0;
        for (int i = 0; i < a.Length; i++)
            sum += a[i] * b[i];
        return sum;
    }
}
