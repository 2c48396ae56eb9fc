using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;

namespace MeshLab.Numerics;

/// <summary>Loops over fixed blocks on several threads: the result has the same bits on every number of threads.</summary>
/// <remarks>
/// Work is cut into blocks whose borders depend on the number of elements alone. Threads take blocks as they come free, so only <em>when</em> a
/// block is done differs from run to run. Sums are kept per block and added in block order.
/// </remarks>
// The methods that call a job are optimized once and for all: with a profile the compiler would take the job seen most often into them, where
// its loops find no registers left.
public static class Parallelism
{
    /// <summary>The number of elements in a block unless told otherwise: right for light work per element.</summary>
    public const int BlockSize = 4096;

    /// <summary>As <see cref="BlockSize"/>.</summary>
    public const int DefaultBlock = BlockSize;

    private static int maxThreads;

    /// <summary>The most threads that the library uses: the number of processors unless set. Setting 0 goes back to that. Results do not depend on it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 0.</exception>
    public static int MaxThreads
    {
        get => Volatile.Read(ref maxThreads) is var set && set == 0 ? Environment.ProcessorCount : set;
        set
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            Volatile.Write(ref maxThreads, value);
        }
    }

    /// <summary>The number of threads in force.</summary>
    public static int Threads => MaxThreads;

    /// <summary>Calls <paramref name="body"/>(from, to) for every block of [0, <paramref name="count"/>).</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="body">Handles the elements from (included) to (excluded); must not write what another block reads or writes.</param>
    public static void ForBlocks(int count, Action<int, int> body) => ForBlocks(count, BlockSize, body);

    /// <summary>Calls <paramref name="body"/>(from, to) for every block of [0, <paramref name="count"/>).</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="blockSize">The number of elements in a block.</param>
    /// <param name="body">Handles the elements from (included) to (excluded); must not write what another block reads or writes.</param>
    public static void ForBlocks(int count, int blockSize, Action<int, int> body)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfLessThan(blockSize, 1);
        ArgumentNullException.ThrowIfNull(body);
        ForEach(
            BlockCount(count, blockSize),
            [MethodImpl(MethodImplOptions.AggressiveOptimization)] (block) => body(block * blockSize, (int)Math.Min(count, (block + 1L) * blockSize)));
    }

    /// <summary>As <see cref="ForBlocks(int, int, Action{int, int})"/>.</summary>
    public static void ForBlocks(int count, Action<int, int> body, int blockSize) => ForBlocks(count, blockSize, body);

    /// <summary>The sum over [0, <paramref name="count"/>), block by block in block order.</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="blockSum">The sum of the elements from (included) to (excluded).</param>
    public static double SumBlocks(int count, Func<int, int, double> blockSum) => SumBlocks(count, BlockSize, blockSum);

    /// <summary>The sum over [0, <paramref name="count"/>), block by block in block order.</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="blockSize">The number of elements in a block.</param>
    /// <param name="blockSum">The sum of the elements from (included) to (excluded).</param>
    public static double SumBlocks(int count, int blockSize, Func<int, int, double> blockSum)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfLessThan(blockSize, 1);
        ArgumentNullException.ThrowIfNull(blockSum);
        var sums = new double[BlockCount(count, blockSize)];
        ForBlocks(count, blockSize, (from, to) => sums[from / blockSize] = blockSum(from, to));
        double total = 0;
        foreach (double sum in sums)
            total += sum;
        return total;
    }

    /// <summary>Runs the actions, at once if there are threads.</summary>
    public static void Invoke(params Action[] actions)
    {
        ArgumentNullException.ThrowIfNull(actions);
        ForEach(actions.Length, i => actions[i]());
    }

    /// <summary>Calls <paramref name="job"/>(i) for every i in [0, <paramref name="count"/>), in order of i as threads come free.</summary>
    /// <param name="count">The number of jobs.</param>
    /// <param name="job">One job; must not write what another job reads or writes. Of several that throw, the lowest one's exception is thrown here.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
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

        [MethodImpl(MethodImplOptions.AggressiveOptimization)]
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

    private static int BlockCount(int count, int blockSize) => (int)((count + (blockSize - 1L)) / blockSize);
}
