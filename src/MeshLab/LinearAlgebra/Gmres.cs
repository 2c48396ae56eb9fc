using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>Generalized minimal residuals (GMRES) for a matrix that is not symmetric, preconditioned by one close to it that can be solved with.</summary>
/// <remarks>
/// Builds an orthonormal basis of b, A P⁻¹ b, (A P⁻¹)² b, … and takes the combination that leaves the smallest residual, found by rotating the
/// Hessenberg matrix of the basis into a triangle. Saad, Schultz 1986, SIAM J. Sci. Stat. Comput. 7(3). The closer P is to A, the fewer steps.
/// </remarks>
internal static class Gmres
{
    private const int BasisSize = 60;
    private const int MostRestarts = 20;

    /// <summary>Solves A x = b.</summary>
    /// <param name="matrix">A.</param>
    /// <param name="precondition">y ↦ P⁻¹ y.</param>
    /// <param name="b">The right-hand side.</param>
    /// <param name="tolerance">The residual over |b| that is good enough.</param>
    /// <exception cref="ArithmeticException">The residual does not fall.</exception>
    public static double[] Solve(SparseMatrix matrix, Func<double[], double[]> precondition, double[] b, double tolerance = 1e-13)
    {
        int n = matrix.Size;
        var x = new double[n];
        double target = tolerance * Norm(b), last = double.PositiveInfinity;
        for (int restart = 0; restart < MostRestarts; restart++)
        {
            double[] residual = Difference(b, matrix.Multiply(x));
            double norm = Norm(residual);
            // A residual that no longer halves has reached rounding.
            if (norm <= target || (norm > 0.5 * last && norm <= 1e3 * target))
                return x;
            last = norm;
            Improve(matrix, precondition, residual, norm, target, x);
        }
        throw new ArithmeticException($"The residual stays at {last / Norm(b):R} of the right-hand side; faces may be too degenerate for these weights.");
    }

    private static void Improve(SparseMatrix matrix, Func<double[], double[]> precondition, double[] residual, double norm, double target, double[] x)
    {
        int steps = Math.Min(BasisSize, matrix.Size);
        var basis = new double[steps + 1][];
        var h = new double[steps + 1, steps];
        var cosine = new double[steps];
        var sine = new double[steps];
        var g = new double[steps + 1];
        basis[0] = Scaled(residual, 1 / norm);
        g[0] = norm;
        int k = 0;
        while (k < steps && Math.Abs(g[k]) > 0.5 * target)
        {
            double[] w = matrix.Multiply(precondition(basis[k]));
            for (int pass = 0; pass < 2; pass++)
            {
                for (int i = 0; i <= k; i++)
                {
                    double projection = Dot(w, basis[i]);
                    h[i, k] += projection;
                    Add(w, -projection, basis[i]);
                }
            }
            double length = Norm(w);
            for (int i = 0; i < k; i++)
                (h[i, k], h[i + 1, k]) = (cosine[i] * h[i, k] + sine[i] * h[i + 1, k], cosine[i] * h[i + 1, k] - sine[i] * h[i, k]);
            double radius = Math.Sqrt(h[k, k] * h[k, k] + length * length);
            if (radius == 0)
                break;
            (cosine[k], sine[k], h[k, k]) = (h[k, k] / radius, length / radius, radius);
            (g[k], g[k + 1]) = (cosine[k] * g[k], -sine[k] * g[k]);
            k++;
            if (length <= 1e-300)
                break;
            basis[k] = Scaled(w, 1 / length);
        }

        // Back substitution for the combination, then x += P⁻¹ (basis · y).
        var sum = new double[matrix.Size];
        for (int i = k - 1; i >= 0; i--)
        {
            for (int j = i + 1; j < k; j++)
                g[i] -= h[i, j] * g[j];
            g[i] /= h[i, i];
            Add(sum, g[i], basis[i]);
        }
        Add(x, 1, precondition(sum));
    }

    private static double Dot(double[] a, double[] b) => Parallelism.SumBlocks(a.Length, (from, to) =>
    {
        double sum = 0;
        for (int i = from; i < to; i++)
            sum += a[i] * b[i];
        return sum;
    });

    private static double Norm(double[] a) => Math.Sqrt(Dot(a, a));

    private static void Add(double[] y, double factor, double[] x)
    {
        for (int i = 0; i < y.Length; i++)
            y[i] += factor * x[i];
    }

    private static double[] Scaled(double[] x, double factor) => Array.ConvertAll(x, value => factor * value);

    private static double[] Difference(double[] a, double[] b)
    {
        var difference = new double[a.Length];
        for (int i = 0; i < a.Length; i++)
            difference[i] = a[i] - b[i];
        return difference;
    }
}
