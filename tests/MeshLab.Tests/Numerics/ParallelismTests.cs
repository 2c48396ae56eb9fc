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

    [Fact]
    public void ForBlocks_NearTheLargestInteger_DoesNotOverflow()
    {
        var blocks = new System.Collections.Concurrent.ConcurrentBag<(int, int)>();
        Parallelism.ForBlocks(int.MaxValue, int.MaxValue - 5, (from, to) => blocks.Add((from, to)));
        Assert.Equal([(0, int.MaxValue - 5), (int.MaxValue - 5, int.MaxValue)], blocks.Order());
    }

    [Fact]
    public void ForEach_HigherJobFailsLater_ThrowsTheLowestOnesException()
    {
        int threads = Parallelism.MaxThreads;
        using var second = new ManualResetEventSlim();
        using var failing = new ManualResetEventSlim();
        try
        {
            Parallelism.MaxThreads = 2;
            var error = Assert.Throws<InvalidOperationException>(() => Parallelism.ForEach(2, job =>
            {
                if (job == 0)
                {
                    second.Wait();
                    failing.Set();
                    throw new InvalidOperationException("0");
                }
                second.Set();
                failing.Wait();
                Thread.Sleep(100);
                throw new InvalidOperationException("1");
            }));
            Assert.Equal("0", error.Message);
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void ForEach_AfterAFailure_BeginsNoHigherJob()
    {
        int threads = Parallelism.MaxThreads, begun = 0;
        const int Jobs = 1000;
        try
        {
            Parallelism.MaxThreads = 2;
            Assert.Throws<InvalidOperationException>(() => Parallelism.ForEach(Jobs, job =>
            {
                Interlocked.Increment(ref begun);
                if (job == 0)
                    throw new InvalidOperationException();
                Thread.Sleep(1);
            }));
            Assert.InRange(begun, 1, Jobs - 1);
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }
}
