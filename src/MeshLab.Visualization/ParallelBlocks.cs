namespace MeshLab.Visualization;

/// <summary>Loops over fixed blocks, so that every number of threads does the same arithmetic.</summary>
internal static class ParallelBlocks
{
    /// <summary>Calls <paramref name="body"/> with the bounds of each block of the range 0 … count.</summary>
    public static void For(int count, int blockSize, int maxThreads, Action<int, int> body)
    {
        int blocks = (count + blockSize - 1) / blockSize;
        Parallel.For(0, blocks, new ParallelOptions { MaxDegreeOfParallelism = maxThreads }, block =>
            body(block * blockSize, Math.Min((block + 1) * blockSize, count)));
    }
}
