namespace MeshLab.IO;

/// <summary>Runs a few pieces of work at once and fails as if they had run one after the other.</summary>
internal static class OrderedTasks
{
    /// <summary>Runs the work for every index; the exception of the smallest index that failed is thrown after all have ended.</summary>
    public static void Run(int count, Action<int> work)
    {
        if (count == 1)
        {
            work(0);
            return;
        }

        Task[] tasks = new Task[count];
        for (int i = 0; i < count; i++)
        {
            int index = i;
            tasks[i] = Task.Run(() => work(index));
        }

        // Waiting for "all, whatever became of them" does not throw; then the first failure in order does.
        Task.WhenAny(Task.WhenAll(tasks)).Wait();
        foreach (Task task in tasks)
            task.GetAwaiter().GetResult();
    }
}
