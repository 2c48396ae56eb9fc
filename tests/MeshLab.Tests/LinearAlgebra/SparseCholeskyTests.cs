using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using MathNet.Numerics.LinearAlgebra;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class SparseCholeskyTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(50)]
    [InlineData(1000)]
    public void Solve_SecondDifference_GivesTheParabola(int n)
    {
        // −u'' = 2 with u = 0 at both ends has the solution i (n + 1 − i), which the second difference meets exactly.
        double[] x = new SparseCholesky(Matrices.Path(n)).Solve([.. Enumerable.Repeat(2.0, n)]);

        for (int i = 0; i < n; i++)
            Assert.Equal((i + 1.0) * (n - i), x[i], 1e-12 * n * n * n);
    }

    [Fact]
    public void Solve_EmptyMatrix_GivesNothing() =>
        Assert.Empty(new SparseCholesky(SparseMatrix.FromEntries(0, [])).Solve(Array.Empty<double>()));

    [Theory]
    [InlineData(5, 2)]
    [InlineData(40, 1)]
    [InlineData(60, 3)]
    [InlineData(90, 20)]
    [InlineData(200, 2)]
    public void Solve_RandomMatrix_AgreesWithADenseSolver(int n, int entriesPerRow)
    {
        for (int seed = 0; seed < 5; seed++)
        {
            SparseMatrix a = Matrices.RandomPositiveDefinite(n, entriesPerRow, seed);
            double[] b = Matrices.RandomVector(n, seed + 100);
            Matrix<double> dense = Matrix<double>.Build.Dense(n, n, (i, j) => a[i, j]);

            double[] x = new SparseCholesky(a).Solve(b);

            double[] expected = dense.Cholesky().Solve(Vector<double>.Build.DenseOfArray(b)).ToArray();
            Assert.All(expected.Zip(x), pair => Assert.Equal(pair.First, pair.Second, 1e-11));
        }
    }

    [Theory]
    [InlineData(30, 30, 1)]
    [InlineData(90, 70, 1)]
    [InlineData(25, 20, 7)]
    public void Solve_Grids_AgreesWithSimpleLdl(int width, int height, int copies)
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(width, height, 0.01, copies);
        double[] b = Matrices.RandomVector(a.Size, 1);
        var cholesky = new SparseCholesky(a, positions);
        var simple = new SimpleLdl(a, [.. cholesky.Analysis.Order]);

        double[] x = cholesky.Solve(b);

        Assert.All(simple.Solve(b).Zip(x), pair => Assert.Equal(pair.First, pair.Second, 1e-11));
        Assert.InRange(Matrices.Residual(a, x, b), 0, 1e-13);
        Assert.Equal(simple.FactorEntries, cholesky.Analysis.FactorEntries);
    }

    [Fact]
    public void Solve_SeveralSides_GivesTheBitsOfOneByOne()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(60, 50, 0.1);
        var cholesky = new SparseCholesky(a, positions);
        double[][] b = [.. Enumerable.Range(0, 7).Select(seed => Matrices.RandomVector(a.Size, seed))];

        double[][] x = cholesky.Solve(b);

        for (int q = 0; q < b.Length; q++)
            Assert.Equal(Matrices.Bits(cholesky.Solve(b[q])), Matrices.Bits(x[q]));
    }

    [Fact]
    public void Solve_OneThreadAndMany_GiveTheSameBits()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(150, 130, 0.001);
        double[] b = Matrices.RandomVector(a.Size, 5);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            long[] one = Matrices.Bits(new SparseCholesky(a, positions).Solve(b));
            foreach (int many in new[] { 2, 3, 8 })
            {
                Parallelism.MaxThreads = many;
                Assert.Equal(one, Matrices.Bits(new SparseCholesky(a, positions).Solve(b)));
            }
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void Solve_AllWidthsOfRegisters_GiveTheSameBits()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(70, 65, 0.001);
        CholeskyAnalysis analysis = CholeskyAnalysis.Of(a, positions);
        double[] b = Matrices.RandomVector(a.Size, 5);

        long[] scalar = Matrices.Bits(Run<double, LanesScalar>(a, analysis, b));

        Assert.Equal(scalar, Matrices.Bits(Run<Vector256<double>, Lanes256>(a, analysis, b)));
        Assert.Equal(scalar, Matrices.Bits(Run<Vector512<double>, Lanes512>(a, analysis, b)));
    }

    [Fact]
    public void Factor_AnotherMatrixOfTheSamePlaces_ReplacesTheFactor()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(40, 30, 0.1);
        (SparseMatrix other, _) = Matrices.Grids(40, 30, 5);
        double[] b = Matrices.RandomVector(a.Size, 5);
        var cholesky = new SparseCholesky(a, positions);

        cholesky.Factor(other);

        Assert.Equal(Matrices.Bits(new SparseCholesky(other, positions).Solve(b)), Matrices.Bits(cholesky.Solve(b)));
        Assert.Throws<ArgumentException>(() => cholesky.Factor(Matrices.Path(a.Size)));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(617)]
    [InlineData(1199)]
    public void Factor_NegativeDiagonal_NamesThatRow(int row)
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(40, 30, 0.1);
        a.Diagonal[row] = -1;

        var e = Assert.Throws<NotPositiveDefiniteException>(() => new SparseCholesky(a, positions));

        Assert.Equal(row, e.Row);
        Assert.True(e.Pivot <= -1);
        Assert.Contains($"row {row} ", e.Message, StringComparison.Ordinal);
        Assert.Equal(row, Assert.Throws<NotPositiveDefiniteException>(() => new SimpleLdl(a, NestedDissection.Order(a, positions))).Row);
    }

    [Fact]
    public void Factor_SeveralBadRows_NamesTheSameRowOnEveryNumberOfThreads()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(100, 90, 0.1);
        for (int i = 50; i < a.Size; i += 700)
            a.Diagonal[i] = -1;
        CholeskyAnalysis analysis = CholeskyAnalysis.Of(a, positions);
        int first = Enumerable.Range(0, a.Size).First(k => a.Diagonal[analysis.Order[k]] < 0);

        for (int round = 0; round < 5; round++)
            Assert.Equal(analysis.Order[first], Assert.Throws<NotPositiveDefiniteException>(() => new SparseCholesky(a, analysis)).Row);
    }

    [Fact]
    public void Factor_SingularLaplacian_ThrowsUnlessAllowed()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(30, 20, 0, copies: 3);

        Assert.Throws<NotPositiveDefiniteException>(() => new SparseCholesky(a, positions));

        var cholesky = new SparseCholesky(a, positions, new CholeskyOptions { AllowSemidefinite = true });
        Assert.Equal([0, 1, 2], cholesky.FixedRows.Select(row => row / 600));

        // A right-hand side that sums to 0 over each component has a solution.
        double[] b = a.Multiply(Matrices.RandomVector(a.Size, 3));
        double[] x = cholesky.Solve(b);
        Assert.InRange(Matrices.Residual(a, x, b), 0, 1e-12);
        Assert.All(cholesky.FixedRows, row => Assert.Equal(0, x[row]));
    }

    [Fact]
    public void Factor_ZeroRows_AreFixedAtZero()
    {
        var cholesky = new SparseCholesky(SparseMatrix.FromDiagonal([4, 0, 16]), options: new CholeskyOptions { AllowSemidefinite = true });

        Assert.Equal([1], cholesky.FixedRows);
        Assert.Equal([1.5, 0, 0.25], cholesky.Solve([6, 5, 4]));
    }

    [Fact]
    public void Factor_NotANumber_Throws()
    {
        SparseMatrix a = Matrices.Path(20);
        a.Values[7] = double.NaN;
        Assert.Throws<NotPositiveDefiniteException>(() => new SparseCholesky(a));
    }

    [Fact]
    public void Factor_Failed_RefusesToSolve()
    {
        SparseMatrix a = Matrices.Path(20);
        var cholesky = new SparseCholesky(a);
        a.Diagonal[3] = -1;
        Assert.Throws<NotPositiveDefiniteException>(() => cholesky.Factor(a));

        Assert.Throws<InvalidOperationException>(() => cholesky.Solve(new double[20]));
    }

    [Fact]
    public void Factor_AfterFailureOrCancellation_CanBeUsedAgain()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(60, 50, 0.1);
        (SparseMatrix bad, _) = Matrices.Grids(60, 50, 0.1);
        bad.Diagonal[1700] = -1;
        double[] b = Matrices.RandomVector(a.Size, 2);
        var cholesky = new SparseCholesky(a, positions);
        long[] expected = Matrices.Bits(cholesky.Solve(b));

        Assert.Throws<NotPositiveDefiniteException>(() => cholesky.Factor(bad));
        cholesky.Factor(a);
        Assert.Equal(expected, Matrices.Bits(cholesky.Solve(b)));

        Assert.Throws<OperationCanceledException>(() => cholesky.Factor(a, new CancellationToken(canceled: true)));
        Assert.Throws<InvalidOperationException>(() => cholesky.Solve(b));
        cholesky.Factor(a);
        Assert.Equal(expected, Matrices.Bits(cholesky.Solve(b)));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(40)]
    [InlineData(2950)]
    public void Factor_DoneFailedOrCancelled_LeavesNothingPinned(int badColumn)
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(60, 50, 0.1);
        CholeskyAnalysis analysis = CholeskyAnalysis.Of(a, positions);
        (SparseMatrix matrix, _) = Matrices.Grids(60, 50, 0.1);
        if (badColumn >= 0)
            matrix.Diagonal[analysis.Order[badColumn]] = -1;
        var cholesky = new SparseCholesky(a, analysis);
        const int Rounds = 300;

        long before = PinnedObjects();
        for (int round = 0; round < Rounds; round++)
        {
            // Not disposed of: another thread may yet cancel it.
            var source = new CancellationTokenSource();
            if (round % 3 == 1)
                source.Cancel();
            if (round % 3 == 2)
                ThreadPool.UnsafeQueueUserWorkItem(static s => s.Cancel(), source, preferLocal: false);
            try
            {
                cholesky.Factor(matrix, source.Token);
            }
            catch (Exception e) when (e is NotPositiveDefiniteException or OperationCanceledException)
            {
                // Both are meant to happen.
            }
        }

        // Others may pin a few objects meanwhile; one forgotten array per round would be a hundred and more.
        Assert.InRange(PinnedObjects() - before, long.MinValue, Rounds / 6);

        static long PinnedObjects()
        {
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: true, compacting: false);
            return GC.GetGCMemoryInfo(GCKind.FullBlocking).PinnedObjectsCount;
        }
    }

    [Fact]
    public unsafe void Factor_CancelledBefore_TouchesNothing()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(60, 50, 0.1);
        CholeskyAnalysis analysis = CholeskyAnalysis.Of(a, positions);
        var storage = new double[analysis.Nodes.PanelStart[^1] + 64];
        fixed (double* factor = storage)
        {
            try
            {
                Multifrontal.Run(analysis, a, factor, new PivotRule(0, false), new CancellationToken(canceled: true));
                Assert.Fail("It was not cancelled.");
            }
            catch (OperationCanceledException)
            {
                Assert.All(storage, x => Assert.Equal(0, x));
            }
        }
    }

    [Fact]
    public void FixedRows_OfAnyOrder_Rise()
    {
        SparseMatrix a = SparseMatrix.FromDiagonal([0, 4, 0]);
        var cholesky = new SparseCholesky(a, CholeskyAnalysis.Of(a, [2, 1, 0]), new CholeskyOptions { AllowSemidefinite = true });
        Assert.Equal([0, 2], cholesky.FixedRows);
    }

    [Fact]
    public void Factor_EveryRowBad_NamesTheFirstOfTheOrder()
    {
        (SparseMatrix a, Vector3D[] positions) = Matrices.Grids(100, 90, 0.1);
        for (int i = 0; i < a.Size; i++)
            a.Diagonal[i] = -1 - i;
        CholeskyAnalysis analysis = CholeskyAnalysis.Of(a, positions);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 4;
            for (int round = 0; round < 60; round++)
                Assert.Equal(analysis.Order[0], Assert.Throws<NotPositiveDefiniteException>(() => new SparseCholesky(a, analysis)).Row);
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void Factor_Cancelled_Throws() => Assert.Throws<OperationCanceledException>(
        () => new SparseCholesky(Matrices.Path(20), cancellationToken: new CancellationToken(canceled: true)));

    [Fact]
    public void Solve_WrongLength_Throws() => Assert.Throws<ArgumentException>(() => new SparseCholesky(Matrices.Path(20)).Solve(new double[19]));

    [Fact]
    public void Analysis_NotAPermutation_Throws()
    {
        Assert.Throws<ArgumentException>(() => CholeskyAnalysis.Of(Matrices.Path(3), [0, 1, 1]));
        Assert.Throws<ArgumentException>(() => CholeskyAnalysis.Of(Matrices.Path(3), [0, 1]));
        Assert.Throws<ArgumentException>(() => CholeskyAnalysis.Of(Matrices.Path(3), [0, 1, 3]));
    }

    private static unsafe double[] Run<TVector, TLanes>(SparseMatrix a, CholeskyAnalysis analysis, double[] b)
        where TVector : unmanaged
        where TLanes : struct, ILanes<TVector>
    {
        double[] storage = GC.AllocateArray<double>((int)analysis.Nodes.PanelStart[^1] + 64, pinned: true);
        double[] x = GC.AllocateArray<double>(b.Length, pinned: true);
        for (int i = 0; i < x.Length; i++)
            x[i] = b[analysis.Order[i]];
        var factor = (double*)Unsafe.AsPointer(ref storage[0]);
        new Multifrontal<TVector, TLanes>(analysis, a, factor, new PivotRule(0, false)).Run(default);
        new SupernodalSolve<TVector, TLanes>(analysis, factor, (double*)Unsafe.AsPointer(ref x[0]), 1).Run();
        GC.KeepAlive(storage);
        return x;
    }
}
