using System.Runtime.ExceptionServices;

namespace MeshLab.Numerics;

/// <summary>Loops over fixed blocks on several threads: the result has the same bits on every number of threads.</summary>
/// <remarks>
/// Work is cut into blocks whose borders depend on the number of elements alone. Threads take blocks as they come free, so only <em>when</em> a
/// block is done differs from run to run. Sums are kept per block and added in block order.
/// </remarks>
public static class Parallelism
{
    /// <summary>The number of elements in a block unless told otherwise.</summary>
    public const int BlockSize = 4096;

    private static int maxThreads = Environment.ProcessorCount;

    /// <summary>How many threads the library uses at most; the number of processors unless set. Results do not depend on it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 1.</exception>
    public static int MaxThreads
    {
        get => Volatile.Read(ref maxThreads);
        set
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            Volatile.Write(ref maxThreads, value);
        }
    }

    /// <summary>Calls <paramref name="body"/>(from, to) for every block of [0, <paramref name="count"/>).</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="body">Handles the elements from (included) to (excluded); must not write what another block reads or writes.</param>
    /// <param name="blockSize">The number of elements in a block.</param>
    public static void ForBlocks(int count, Action<int, int> body, int blockSize = BlockSize)
    {
        ArgumentNullException.ThrowIfNull(body);
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfLessThan(blockSize, 1);
        int blocks = (int)(((long)count + blockSize - 1) / blockSize);
        ForEach(blocks, block =>
        {
            int from = block * blockSize;
            body(from, Math.Min(count, from + Math.Min(blockSize, count - from)));
        });
    }

    /// <summary>The sum over [0, <paramref name="count"/>), block by block in block order.</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="blockSum">The sum of the elements from (included) to (excluded).</param>
    public static double SumBlocks(int count, Func<int, int, double> blockSum)
    {
        ArgumentNullException.ThrowIfNull(blockSum);
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        var sums = new double[(count + (BlockSize - 1L)) / BlockSize];
        ForBlocks(count, (from, to) => sums[from / BlockSize] = blockSum(from, to));
        double total = 0;
        foreach (double sum in sums)
            total += sum;
        return total;
    }

    /// <summary>Calls <paramref name="job"/>(i) for every i in [0, <paramref name="count"/>), in order of i as threads come free.</summary>
    /// <param name="count">The number of jobs.</param>
    /// <param name="job">One job; must not write what another job reads or writes. Of several that throw, the lowest one's exception is thrown here.</param>
    public static void ForEach(int count, Action<int> job)
    {
        ArgumentNullException.ThrowIfNull(job);
        int threads = Math.Min(MaxThreads, count);
        if (threads <= 1)
        {
            for (int i = 0; i < count; i++)
                job(i);
            return;
        }

        int next = -1;
        var gate = new Lock();
        int failedJob = int.MaxValue;
        ExceptionDispatchInfo? failure = null;

        var helpers = new Task[threads - 1];
        for (int t = 0; t < helpers.Length; t++)
            helpers[t] = Task.Run(Worker);
        Worker();
        Task.WaitAll(helpers);
        failure?.Throw();

        void Worker()
        {
            for (int i = Interlocked.Increment(ref next); i < count && i < Volatile.Read(ref failedJob); i = Interlocked.Increment(ref next))
            {
                try
                {
                    job(i);
                }
                catch (Exception exception) when (Remember(i, exception))
                {
                    return;
                }
            }
        }

        bool Remember(int i, Exception exception)
        {
            lock (gate)
            {
                if (i < failedJob)
                {
                    failedJob = i;
                    failure = ExceptionDispatchInfo.Capture(exception);
                }
            }
            return true;
        }
    }
}
