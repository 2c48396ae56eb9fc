using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

[Trait("Section", "1")]
public class ParallelismTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(Parallelism.BlockSize)]
    [InlineData(3 * Parallelism.BlockSize + 1)]
    public void ForBlocks_AnyCount_VisitsEveryElementOnce(int count)
    {
        var visits = new int[count];

        Parallelism.ForBlocks(count, (from, to) =>
        {
            for (int i = from; i < to; i++)
                visits[i]++;
        });

        Assert.All(visits, v => Assert.Equal(1, v));
    }

    [Fact]
    public void SumBlocks_NumbersOfManySizes_AddsInBlockOrder()
    {
        const int count = 5 * Parallelism.BlockSize;
        static double Block(int from, int to)
        {
            double sum = 0;
            for (int i = from; i < to; i++)
                sum += 1.0 / (i + 1);
            return sum;
        }

        double expected = 0;
        for (int b = 0; b < 5; b++)
            expected += Block(b * Parallelism.BlockSize, (b + 1) * Parallelism.BlockSize);

        Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(Parallelism.SumBlocks(count, Block)));
    }

    [Fact]
    public void ForEach_SeveralJobsThrow_TheLowestOneIsReported()
    {
        for (int round = 0; round < 20; round++)
        {
            var e = Assert.Throws<InvalidOperationException>(() => Parallelism.ForEach(100, i =>
            {
                if (i >= 7)
                    throw new InvalidOperationException($"job {i}");
            }));
            Assert.Equal("job 7", e.Message);
        }
    }

    [Fact]
    public void MaxThreads_Negative_IsRefused() => Assert.Throws<ArgumentOutOfRangeException>(() => Parallelism.MaxThreads = -1);

    [Fact]
    public void MaxThreads_Zero_IsTheNumberOfProcessors()
    {
        Parallelism.MaxThreads = 0;
        Assert.Equal(Environment.ProcessorCount, Parallelism.MaxThreads);
    }
}
