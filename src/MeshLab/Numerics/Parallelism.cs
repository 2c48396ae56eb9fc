namespace MeshLab.Numerics;

/// <summary>Loops over fixed blocks on several threads. The blocks, and the order in which their results are joined, do not depend on the number of
/// threads; so neither do the results, to the last bit.</summary>
public static class Parallelism
{
    /// <summary>Block length for light work per element.</summary>
    public const int DefaultBlock = 4096;

    /// <summary>The most threads that the library uses; 0, the default, for as many as there are processors.</summary>
    public static int MaxThreads
    {
        get;
        set
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            field = value;
        }
    }

    /// <summary>The number of threads in force.</summary>
    public static int Threads => MaxThreads == 0 ? Environment.ProcessorCount : MaxThreads;

    internal static ParallelOptions Options => new() { MaxDegreeOfParallelism = MaxThreads == 0 ? -1 : MaxThreads };

    /// <summary>Calls the body with the bounds of each block of 0 … count.</summary>
    public static void ForBlocks(int count, Action<int, int> body) => ForBlocks(count, DefaultBlock, body);

    /// <summary>Calls the body with the bounds of each block of 0 … count.</summary>
    /// <param name="count">The number of elements.</param>
    /// <param name="blockSize">Elements per block.</param>
    /// <param name="body">Gets the first index of the block and the index after its last.</param>
    public static void ForBlocks(int count, int blockSize, Action<int, int> body)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(blockSize);
        ArgumentNullException.ThrowIfNull(body);
        int blocks = (int)(((long)count + blockSize - 1) / blockSize);
        if (blocks <= 1 || Threads == 1)
        {
            for (int b = 0; b < blocks; b++)
                body(b * blockSize, (int)Math.Min(count, (b + 1L) * blockSize));
            return;
        }
        Parallel.For(0, blocks, Options, b => body(b * blockSize, (int)Math.Min(count, (b + 1L) * blockSize)));
    }

    /// <summary>Adds what the body returns for each block, in the order of the blocks.</summary>
    public static double SumBlocks(int count, int blockSize, Func<int, int, double> body)
    {
        var sums = new double[(int)(((long)count + blockSize - 1) / blockSize)];
        ForBlocks(count, blockSize, (first, end) => sums[first / blockSize] = body(first, end));
        double sum = 0;
        foreach (double s in sums)
            sum += s;
        return sum;
    }

    /// <summary>Runs the actions, at once if there are threads.</summary>
    public static void Invoke(params Action[] actions)
    {
        ArgumentNullException.ThrowIfNull(actions);
        if (Threads == 1)
        {
            foreach (Action action in actions)
                action();
            return;
        }
        Parallel.Invoke(Options, actions);
    }
}
