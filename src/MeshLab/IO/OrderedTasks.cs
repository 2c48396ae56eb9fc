using System.Runtime.ExceptionServices;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Runs a few pieces of work at once and fails as if they had run one after the other.</summary>
internal static class OrderedTasks
{
    /// <summary>Runs the work for every index; of those that failed, the error of the smallest index is thrown after all have ended.</summary>
    public static void Run(int count, Action<int> work)
    {
        Exception?[] errors = new Exception?[count];
        try
        {
            Parallelism.ForBlocks(count, 1, (i, _) =>
            {
                try
                {
                    work(i);
                }
                catch (MeshFormatException error)
                {
                    errors[i] = error;
                }
                catch (IOException error)
                {
                    errors[i] = error;
                }
            });
        }
        catch (AggregateException several) when (several.InnerExceptions.FirstOrDefault(e => e is OperationCanceledException) is { } cancelled)
        {
            ExceptionDispatchInfo.Throw(cancelled);
        }

        if (Array.Find(errors, e => e is not null) is { } first)
            ExceptionDispatchInfo.Throw(first);
    }
}
