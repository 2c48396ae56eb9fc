using MeshLab.LinearAlgebra;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class SimpleLdlTests
{
    [Fact]
    public void Solve_SmallMatrix_GivesTheSolution()
    {
        SparseMatrix a = SparseMatrix.FromEntries(3, [(0, 0, 4), (0, 1, -1), (1, 1, 5), (1, 2, 2), (2, 2, 6)]);

        double[] x = new SimpleLdl(a).Solve([2, 15, 22]);

        Assert.Equal([1, 2, 3], x.Select(v => Math.Round(v, 13)));
    }

    [Fact]
    public void Solve_RandomMatrices_LeaveNoResidual()
    {
        for (int seed = 0; seed < 10; seed++)
        {
            SparseMatrix a = Matrices.RandomPositiveDefinite(120, 3, seed);
            double[] b = Matrices.RandomVector(120, seed);

            Assert.InRange(Matrices.Residual(a, new SimpleLdl(a).Solve(b), b), 0, 1e-13);
            Assert.InRange(Matrices.Residual(a, new SimpleLdl(a, NestedDissection.Order(a)).Solve(b), b), 0, 1e-13);
        }
    }

    [Fact]
    public void Constructor_Indefinite_NamesTheRow()
    {
        // The leading 2 × 2 block has the determinant 1 · 1 − 2 · 2 < 0.
        SparseMatrix a = SparseMatrix.FromEntries(3, [(0, 0, 1), (0, 1, 2), (1, 1, 1), (2, 2, 1)]);

        var e = Assert.Throws<NotPositiveDefiniteException>(() => new SimpleLdl(a));

        Assert.Equal(1, e.Row);
        Assert.Equal(-3, e.Pivot);
    }
}
