namespace MeshLab.Spatial;

/// <summary>Runs work over an index range in fixed blocks, on as many threads as allowed.</summary>
internal static class Blocks
{
    private const int Size = 1024;

    /// <summary>Calls the body for blocks of the range 0 … count.</summary>
    public static void Run(int count, int maxThreads, Action<int, int> body)
    {
        if (maxThreads == 1 || count <= Size)
            body(0, count);
        else
            RunEach((count + Size - 1) / Size, maxThreads, b => body(b * Size, Math.Min(count, (b + 1) * Size)));
    }

    /// <summary>Calls the body for every index.</summary>
    public static void RunEach(int count, int maxThreads, Action<int> body)
    {
        if (maxThreads == 1)
        {
            for (int i = 0; i < count; i++)
                body(i);
        }
        else
        {
            Parallel.For(0, count, Options(maxThreads), body);
        }
    }

    /// <summary>Calls the actions, possibly at once.</summary>
    public static void Run(Action[] actions, int maxThreads) => RunEach(actions.Length, maxThreads, i => actions[i]());

    private static ParallelOptions Options(int maxThreads) => new() { MaxDegreeOfParallelism = maxThreads == 0 ? Numerics.Parallelism.Threads : maxThreads };
}
