using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class NestedDissectionTests
{
    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 1)]
    [InlineData(4, 4)]
    [InlineData(17, 60)]
    [InlineData(120, 110)]
    public void Order_Grid_IsAPermutation(int width, int height)
    {
        (SparseMatrix matrix, Vector3D[] positions) = Matrices.Grids(width, height, 0);

        Assert.Equal(Enumerable.Range(0, matrix.Size), NestedDissection.Order(matrix, positions).Order());
        Assert.Equal(Enumerable.Range(0, matrix.Size), NestedDissection.Order(matrix).Order());
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(3)]
    public void Order_UselessPositions_IsStillAPermutation(double coordinate)
    {
        (SparseMatrix matrix, Vector3D[] positions) = Matrices.Grids(50, 50, 0);
        Array.Fill(positions, new Vector3D(coordinate, coordinate, coordinate));

        Assert.Equal(Enumerable.Range(0, matrix.Size), NestedDissection.Order(matrix, positions).Order());
    }

    [Fact]
    public void Order_Grid_FillsLittle()
    {
        (SparseMatrix matrix, Vector3D[] positions) = Matrices.Grids(100, 100, 0);
        int n = matrix.Size;

        Assert.InRange(CholeskyAnalysis.Of(matrix, positions).FactorEntries, n, 35L * n);
        Assert.InRange(CholeskyAnalysis.Of(matrix).FactorEntries, n, 45L * n);
        // For comparison, row by row: half of n · width.
        Assert.InRange(CholeskyAnalysis.Of(matrix, [.. Enumerable.Range(0, n)]).FactorEntries, 90L * n, 102L * n);
    }

    [Fact]
    public void Order_OneThreadAndTwo_AreTheSame()
    {
        (SparseMatrix matrix, Vector3D[] positions) = Matrices.Grids(150, 120, 0);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            int[] one = NestedDissection.Order(matrix, positions);
            Parallelism.MaxThreads = 4;
            Assert.Equal(one, NestedDissection.Order(matrix, positions));
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void Order_WrongNumberOfPositions_Throws() =>
        Assert.Throws<ArgumentException>(() => NestedDissection.Order(Matrices.Path(3), new Vector3D[2]));
}
