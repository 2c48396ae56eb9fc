using MeshLab.LinearAlgebra;
using MeshLab.Numerics;

namespace MeshLab.Tests.LinearAlgebra;

/// <summary>Matrices for the tests of the solvers.</summary>
internal static class Matrices
{
    /// <summary>The second difference: 2 on the diagonal, −1 beside it.</summary>
    public static SparseMatrix Path(int n) => SparseMatrix.FromEntries(
        n, Enumerable.Range(0, n).Select(i => (i, i, 2.0)).Concat(Enumerable.Range(0, Math.Max(0, n - 1)).Select(i => (i, i + 1, -1.0))));

    /// <summary>The graph Laplacian of several grids beside each other, plus a multiple of the identity.</summary>
    public static (SparseMatrix Matrix, Vector3D[] Positions) Grids(int width, int height, double shift, int copies = 1)
    {
        var entries = new List<(int, int, double)>();
        var positions = new List<Vector3D>();
        for (int c = 0; c < copies; c++)
        {
            for (int y = 0; y < height; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    int i = positions.Count;
                    positions.Add(new Vector3D(x + c * (width + 3), y, 0.1 * Math.Sin(x + y)));
                    entries.Add((i, i, shift));
                    if (x > 0)
                        AddEdge(i, i - 1);
                    if (y > 0)
                        AddEdge(i, i - width);
                    if (x > 0 && y > 0)
                        AddEdge(i, i - width - 1);
                }
            }
        }
        return (SparseMatrix.FromEntries(positions.Count, entries), [.. positions]);

        void AddEdge(int i, int j) => entries.AddRange([(i, i, 1), (j, j, 1), (i, j, -1)]);
    }

    /// <summary>Random entries, with a diagonal that makes the matrix positive definite.</summary>
    public static SparseMatrix RandomPositiveDefinite(int n, int entriesPerRow, int seed)
    {
        var random = new Random(seed);
        var entries = new List<(int, int, double)>();
        for (int i = 0; i < n; i++)
        {
            entries.Add((i, i, 0.1 + random.NextDouble()));
            for (int k = 0; k < entriesPerRow; k++)
            {
                int j = random.Next(n);
                if (j == i)
                    continue;
                double value = random.NextDouble() - 0.5;
                entries.AddRange([(i, j, value), (i, i, Math.Abs(value)), (j, j, Math.Abs(value))]);
            }
        }
        return SparseMatrix.FromEntries(n, entries);
    }

    public static double[] RandomVector(int n, int seed)
    {
        var random = new Random(seed);
        return [.. Enumerable.Range(0, n).Select(_ => random.NextDouble() - 0.5)];
    }

    /// <summary>|A x − b| / |b|.</summary>
    public static double Residual(SparseMatrix matrix, double[] x, double[] b) =>
        Math.Sqrt(matrix.Multiply(x).Zip(b, (p, q) => (p - q) * (p - q)).Sum() / b.Sum(q => q * q));

    public static long[] Bits(double[] x) => Array.ConvertAll(x, BitConverter.DoubleToInt64Bits);
}
