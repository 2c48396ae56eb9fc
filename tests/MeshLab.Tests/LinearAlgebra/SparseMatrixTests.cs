using MeshLab.LinearAlgebra;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class SparseMatrixTests
{
    // ⎡ 4 −1  0⎤
    // ⎢−1  5  2⎥
    // ⎣ 0  2  6⎦
    private static SparseMatrix Small() => SparseMatrix.FromEntries(3, [(0, 0, 4), (1, 0, -1), (1, 1, 5), (1, 2, 2), (2, 2, 6)]);

    [Fact]
    public void FromEntries_OneTriangle_StoresBoth()
    {
        SparseMatrix a = Small();

        Assert.Equal(7, a.NonZeros);
        Assert.Equal(-1, a[0, 1]);
        Assert.Equal(-1, a[1, 0]);
        Assert.Equal(2, a[2, 1]);
        Assert.Equal(0, a[0, 2]);
        Assert.Equal(6, a[2, 2]);
    }

    [Fact]
    public void FromEntries_SamePlaceTwice_AddsThem()
    {
        SparseMatrix a = SparseMatrix.FromEntries(2, [(0, 1, 1.5), (1, 0, 2), (0, 0, 1), (0, 0, 3)]);

        Assert.Equal(3.5, a[0, 1]);
        Assert.Equal(3.5, a[1, 0]);
        Assert.Equal(4, a[0, 0]);
        Assert.Equal(0, a[1, 1]);
    }

    [Fact]
    public void FromEntries_IndexOutside_Throws() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => SparseMatrix.FromEntries(2, [(0, 2, 1)]));

    [Fact]
    public void Multiply_SmallMatrix_GivesTheProduct()
    {
        Assert.Equal([2, 15, 22], Small().Multiply([1, 2, 3]));
        Assert.Equal(2 + 30 + 66, Small().QuadraticForm([1, 2, 3]));
    }

    [Fact]
    public void Multiply_WrongLengthOrSameArray_Throws()
    {
        var x = new double[3];
        Assert.Throws<ArgumentException>(() => Small().Multiply(new double[2]));
        Assert.Throws<ArgumentException>(() => Small().Multiply(x, x));
    }

    [Fact]
    public void ScaleAndAdd_OtherPlaces_UnitesThem()
    {
        SparseMatrix sum = Small().ScaleAndAdd(2, SparseMatrix.FromEntries(3, [(0, 2, 7), (0, 1, 1), (1, 1, 1)]));

        Assert.Equal([8, 11, 12], sum.Diagonal.ToArray());
        Assert.Equal(-1, sum[0, 1]);
        Assert.Equal(-1, sum[1, 0]);
        Assert.Equal(7, sum[2, 0]);
        Assert.Equal(4, sum[1, 2]);
    }

    [Fact]
    public void ScaleAndAdd_Diagonal_KeepsThePlaces()
    {
        SparseMatrix sum = Small().ScaleAndAdd(1, SparseMatrix.FromDiagonal([10, 20, 30]));

        Assert.Equal(Small().Columns.ToArray(), sum.Columns.ToArray());
        Assert.Equal([14, 25, 36], sum.Diagonal.ToArray());
    }

    [Fact]
    public void Principal_MiddleRowLeftOut_KeepsTheOthers()
    {
        SparseMatrix part = Small().Principal([0, -1, 1], 2);

        Assert.Equal([4, 6], part.Diagonal.ToArray());
        Assert.Equal(2, part.NonZeros);
        Assert.Throws<ArgumentException>(() => Small().Principal([1, -1, 0], 2));
    }
}
