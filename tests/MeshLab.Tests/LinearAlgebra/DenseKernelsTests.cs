using System.Runtime.Intrinsics;
using MeshLab.LinearAlgebra;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

/// <summary>The kernels of all widths give the same bits, and the right numbers.</summary>
[Trait("Section", "12.5")]
public unsafe class DenseKernelsTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(5, 3)]
    [InlineData(8, 8)]
    [InlineData(37, 14)]
    [InlineData(70, 64)]
    public void FactorPanel_AllWidths_GiveTheSameBits(int rows, int columns)
    {
        double[] wide = Factor<Vector512<double>, Lanes512>(rows, columns);
        double[] half = Factor<Vector256<double>, Lanes256>(rows, columns);
        double[] scalar = Factor<double, LanesScalar>(rows, columns);

        Assert.Equal(Matrices.Bits(scalar), Matrices.Bits(half));
        Assert.Equal(Matrices.Bits(scalar), Matrices.Bits(wide));

        // L Lᵀ is the matrix again.
        int stride = (rows + 7) & ~7;
        double[] original = Matrix(rows, columns);
        for (int j = 0; j < columns; j++)
        {
            for (int i = j; i < rows; i++)
            {
                double sum = 0;
                for (int k = 0; k <= j; k++)
                    sum += scalar[i + k * stride] * scalar[j + k * stride];
                Assert.Equal(original[i + j * stride], sum, 1e-11);
            }
        }
    }

    [Fact]
    public void FactorPanel_NegativePivot_NamesItsColumn()
    {
        double[] matrix = Matrix(10, 7);
        matrix[5 + 5 * 16] = -3;
        var smallest = new double[8];
        fixed (double* p = matrix, s = smallest)
        {
            Assert.Equal(5, DenseKernels<double, LanesScalar>.FactorPanel(p, 16, 10, 7, s, false, out double pivot));
            Assert.True(pivot < -3);
        }
    }

    [Theory]
    [InlineData(3, 2)]
    [InlineData(8, 16)]
    [InlineData(29, 7)]
    [InlineData(64, 64)]
    public void SubtractSquare_AllWidths_GiveTheSameBits(int rows, int depth)
    {
        double[] wide = Subtract<Vector512<double>, Lanes512>(rows, depth);
        double[] half = Subtract<Vector256<double>, Lanes256>(rows, depth);
        double[] scalar = Subtract<double, LanesScalar>(rows, depth);

        Assert.Equal(Matrices.Bits(scalar), Matrices.Bits(half));
        Assert.Equal(Matrices.Bits(scalar), Matrices.Bits(wide));
        int stride = (rows + 7) & ~7;
        double[] a = Values(stride * depth + 64, 1);
        for (int j = 0; j < rows; j++)
        {
            for (int i = j; i < rows; i++)
            {
                double sum = 0;
                for (int k = 0; k < depth; k++)
                    sum += a[i + k * stride] * a[j + k * stride];
                Assert.Equal(10 - sum, scalar[j * rows + i], 1e-12);
            }
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    [InlineData(8)]
    [InlineData(100)]
    public void Dot_AllWidths_GiveTheSameBits(int count)
    {
        double[] x = Values(count + 1, 2), y = Values(count + 1, 3);
        fixed (double* p = x, q = y)
        {
            double expected = LanesScalar.Dot(p, q, count);
            Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(Lanes256.Dot(p, q, count)));
            Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(Lanes512.Dot(p, q, count)));
            Assert.Equal(x.Take(count).Zip(y, (a, b) => a * b).Sum(), expected, 1e-13);
        }
    }

    private static double[] Values(int count, int seed) => Matrices.RandomVector(count, seed);

    private static double[] Matrix(int rows, int columns)
    {
        int stride = (rows + 7) & ~7;
        double[] matrix = Values(stride * columns, 4);
        for (int j = 0; j < columns; j++)
            matrix[j + j * stride] = rows;
        return matrix;
    }

    // The part on and below the diagonal; what lies above it is nobody's business.
    private static double[] Factor<TVector, TLanes>(int rows, int columns)
        where TVector : unmanaged
        where TLanes : struct, ILanes<TVector>
    {
        int stride = (rows + 7) & ~7;
        double[] matrix = Matrix(rows, columns);
        var smallest = new double[columns + 4];
        fixed (double* p = matrix, s = smallest)
            Assert.Equal(-1, DenseKernels<TVector, TLanes>.FactorPanel(p, stride, rows, columns, s, false, out _));
        for (int j = 0; j < columns; j++)
        {
            for (int i = 0; i < stride; i++)
                matrix[i + j * stride] = i < j || i >= rows ? 0 : matrix[i + j * stride];
        }
        return matrix;
    }

    private static double[] Subtract<TVector, TLanes>(int rows, int depth)
        where TVector : unmanaged
        where TLanes : struct, ILanes<TVector>
    {
        int stride = (rows + 7) & ~7;
        double[] a = Values(stride * depth + 64, 1);
        var c = new double[stride * (rows + 4) + 64];
        Array.Fill(c, 10);
        fixed (double* p = c, q = a)
            DenseKernels<TVector, TLanes>.SubtractSquare(p, stride, q, stride, rows, 0, rows, depth, padded: true);
        var triangle = new double[rows * rows];
        for (int j = 0; j < rows; j++)
        {
            for (int i = j; i < rows; i++)
                triangle[j * rows + i] = c[i + j * stride];
        }
        return triangle;
    }
}
