using System.Text.Json;
using MathNet.Numerics.LinearAlgebra;
using MeshLab.IO;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.1")]
public class LaplacianSpectrumTests
{
    [Theory]
    [InlineData("tetrahedron", 4)]
    [InlineData("octahedron", 6)]
    [InlineData("bumpy-sphere", 20)]
    [InlineData("torus", 30)]
    [InlineData("grid", 56)]
    [InlineData("components", 12)]
    [InlineData("isolated-vertices", 4)]
    public void ComputeSmallestEigenpairs_SmallMesh_AgreesWithADenseSolver(string name, int count)
    {
        Mesh mesh = Models.Create(name);
        double[] expected = DenseEigenvalues(mesh);

        Eigenpairs pairs = mesh.ComputeSmallestEigenpairs(count);

        Assert.All(expected.Zip(pairs.Values), pair => Assert.Equal(pair.First, pair.Second, 1e-10 * expected[^1]));
        AssertEigenpairs(mesh, pairs);
    }

    [Fact]
    public void ComputeSmallestEigenpairs_FullMass_AgreesWithADenseSolver()
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        SparseMatrix l = mesh.ComputeLaplacian(), m = mesh.ComputeMassMatrix(MassKind.Full);
        Matrix<double> dense = Matrix<double>.Build.Dense(m.Size, m.Size, (i, j) => m[i, j]);
        double[] expected = [.. dense.Cholesky().Solve(Matrix<double>.Build.Dense(l.Size, l.Size, (i, j) => l[i, j])).Evd().EigenValues.Select(v => v.Real).Order()];

        Eigenpairs pairs = mesh.ComputeSmallestEigenpairs(15, new EigenOptions { Mass = MassKind.Full });

        Assert.All(expected.Take(15).Zip(pairs.Values), pair => Assert.Equal(pair.First, pair.Second, 1e-9));
    }

    [Fact]
    public void ComputeSmallestEigenpairs_Spheres_ConvergeToTheExactOnesWithTheirMultiplicities()
    {
        // On the unit sphere the eigenvalues are l (l + 1), each 2 l + 1 times.
        double[] exact = [.. Enumerable.Range(0, 5).SelectMany(l => Enumerable.Repeat(l * (l + 1.0), 2 * l + 1))];
        double coarse = Error(16), fine = Error(32);

        Assert.InRange(fine, 0, 0.02);
        // Second order: half the edge length, a quarter of the error.
        Assert.InRange(coarse / fine, 3.3, 4.7);

        double Error(int rings)
        {
            double[] values = Models.Sphere(rings - 1, 2 * rings).ComputeSmallestEigenpairs(exact.Length).Values;
            return values.Zip(exact, (own, e) => Math.Abs(own - e) / Math.Max(1, e)).Max();
        }
    }

    [Fact]
    public void ComputeSmallestEigenpairs_RepeatedAndThreaded_GivesTheSameBits()
    {
        Mesh mesh = Models.Create("torus");
        Eigenpairs first = mesh.ComputeSmallestEigenpairs(10);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            Eigenpairs second = mesh.ComputeSmallestEigenpairs(10);
            Assert.Equal(Matrices.Bits(first.Values), Matrices.Bits(second.Values));
            for (int k = 0; k < 10; k++)
                Assert.Equal(Matrices.Bits(first.Vectors[k]), Matrices.Bits(second.Vectors[k]));
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void ComputeSmallestEigenpairs_BadArguments_Throws()
    {
        Mesh mesh = Models.Tetrahedron();
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.ComputeSmallestEigenpairs(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.ComputeSmallestEigenpairs(5));
        Assert.Throws<ArgumentOutOfRangeException>(() => new EigenOptions { BlockSize = 0 });
        Assert.Throws<ArgumentException>(() => mesh.ComputeSmallestEigenpairs(2, new EigenOptions { Weights = LaplacianWeights.MeanValue }));
        Assert.Throws<OperationCanceledException>(() => mesh.ComputeSmallestEigenpairs(2, cancellationToken: new CancellationToken(true)));
    }

    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("bunny_closed")]
    [InlineData("fandisk")]
    [InlineData("three_holes")]
    [InlineData("reference_annulus")]
    [InlineData("box_assembly")]
    [InlineData("featuretype")]
    [InlineData("rocker_arm")]
    [InlineData("camelhead")]
    [InlineData("stanford_bunny")]
    public void ComputeSmallestEigenpairs_ReferenceModel_GivesTheReferenceValues(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        JsonElement spectrum = ReferenceData.Json(name, "extras").RootElement.GetProperty("laplace_spectrum");
        double[] expected = ReferenceData.Numbers(spectrum.GetProperty("eigenvalues"));

        Eigenpairs pairs = mesh.ComputeSmallestEigenpairs(expected.Length);

        Assert.All(expected.Zip(pairs.Values), pair => Assert.Equal(pair.First, pair.Second, 1e-9 * expected[^1]));
        AssertEigenpairs(mesh, pairs);
    }

    private static void AssertEigenpairs(Mesh mesh, Eigenpairs pairs)
    {
        SparseMatrix l = mesh.ComputeLaplacian(), m = mesh.ComputeMassMatrix();
        double largest = pairs.Values[^1];
        double[][] x = Array.ConvertAll(pairs.Vectors, v => Array.ConvertAll(v, value => double.IsNaN(value) ? 0 : value));
        for (int k = 0; k < x.Length; k++)
        {
            double[] lx = l.Multiply(x[k]), mx = m.Multiply(x[k]);
            double residual = 0;
            for (int i = 0; i < lx.Length; i++)
            {
                double r = lx[i] - pairs.Values[k] * mx[i];
                residual += m.Diagonal[i] > 0 ? r * r / m.Diagonal[i] : 0;
            }
            Assert.InRange(Math.Sqrt(residual), 0, 1e-6 * largest);
            for (int j = 0; j <= k; j++)
                Assert.Equal(j == k ? 1 : 0, x[j].Zip(mx, (a, b) => a * b).Sum(), 1e-10);
        }
    }

    private static double[] DenseEigenvalues(Mesh mesh)
    {
        SparseMatrix l = mesh.ComputeLaplacian();
        double[] mass = mesh.ComputeLumpedMasses();
        int[] rows = [.. Enumerable.Range(0, l.Size).Where(i => mass[i] > 0)];
        Matrix<double> a = Matrix<double>.Build.Dense(rows.Length, rows.Length, (i, j) => l[rows[i], rows[j]] / Math.Sqrt(mass[rows[i]] * mass[rows[j]]));
        return [.. a.Evd(Symmetricity.Symmetric).EigenValues.Select(v => v.Real).Order()];
    }
}
