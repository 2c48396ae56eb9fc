using MeshLab.Simplification;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class BucketQueueTests
{
    [Fact]
    public void BucketOf_GrowingCosts_NeverFalls()
    {
        var scale = new BucketScale(1);
        double[] costs = [0, 1e-300, 1e-17, 1e-10, 0.5, 0.99, 1, 1.24, 1.25, 2, 1e6, 1e9, double.MaxValue, double.PositiveInfinity];

        int[] buckets = [.. costs.Select(scale.BucketOf)];

        Assert.Equal(buckets.Order(), buckets);
        Assert.Equal(0, buckets[0]);
        Assert.Equal(scale.Count - 1, buckets[^1]);
        // Four buckets per factor of two.
        Assert.Equal(scale.BucketOf(1) + 4, scale.BucketOf(2));
        Assert.Equal(scale.BucketOf(1) + 1, scale.BucketOf(1.25));
        Assert.Equal(scale.BucketOf(1), scale.BucketOf(1.2499));
    }

    [Theory]
    [InlineData(1, 2)]
    [InlineData(3, 5)]
    [InlineData(700, 4)]
    [InlineData(3000, 1_000_000)]
    public void Pop_Everything_ComesByKeyAndThenByIndex(int count, int keys)
    {
        var random = new Random(count);
        double[] key = [.. Enumerable.Range(0, count).Select(_ => 1e-3 * random.Next(1, keys))];
        var scale = new BucketScale(key.Max());
        var queue = new BucketQueue(scale, new int[count]);
        foreach (int edge in Enumerable.Range(0, count).OrderBy(_ => random.Next()))
            queue.Insert(edge, key[edge]);

        Assert.Equal(Enumerable.Range(0, count).OrderBy(e => key[e]).ThenBy(e => e), Drain(queue, scale, key, _ => { }));
    }

    /// <summary>What the loop does meanwhile: raises the first key, and puts edges back that are not in the queue.</summary>
    [Fact]
    public void ChangeTop_AndInsertWhileItEmpties_KeepTheOrder()
    {
        const int Count = 2000;
        var random = new Random(7);
        double[] key = [.. Enumerable.Range(0, Count).Select(_ => 1e-4 * random.Next(1, 20_000))];
        var scale = new BucketScale(key.Max());
        var queue = new BucketQueue(scale, new int[Count]);
        for (int edge = 0; edge < Count; edge += 2)
            queue.Insert(edge, key[edge]);
        int next = 1, raised = 0;
        var expected = new HashSet<int>();

        List<int> order = Drain(queue, scale, key, top =>
        {
            if (next < Count && random.Next(2) == 0)
            {
                // Never before what came out already.
                key[next] = Math.Max(key[next], key[top]);
                queue.Insert(next, key[next]);
                next += 2;
            }
            if (raised < 500 && expected.Add(queue.Top))
            {
                raised++;
                int changed = queue.Top;
                key[changed] *= 1 + random.NextDouble() * (raised % 3 == 0 ? 1 : 1e-3);
                queue.ChangeTop(key[changed]);
            }
        });

        Assert.Equal(500, raised);
        Assert.Equal(order.Count, order.Distinct().Count());
        Assert.Equal(Count / 2 + next / 2, order.Count);
        Assert.Equal(order.Select(e => key[e]).Order(), order.Select(e => key[e]));
        for (int i = 1; i < order.Count; i++)
            Assert.True(key[order[i - 1]] < key[order[i]] || order[i - 1] < order[i] || order[i] % 2 == 1, $"{order[i - 1]} before {order[i]}");
    }

    /// <summary>Bucket by bucket, as the loop does; edges that are inserted into the front bucket go into its heap.</summary>
    private static List<int> Drain(BucketQueue queue, BucketScale scale, double[] key, Action<int> look)
    {
        var order = new List<int>();
        for (int bucket = 0; bucket < scale.Count; bucket++)
        {
            queue.Current = bucket;
            while (queue.HeapCount > 0 || queue.HasEntries(bucket))
            {
                if (queue.HeapCount == 0)
                {
                    for (int edge = queue.TakeList(bucket), following; edge >= 0; edge = following)
                    {
                        following = queue.NextInList(edge);
                        queue.Append(edge, key[edge]);
                    }
                    queue.Heapify();
                }
                look(queue.Top);
                if (queue.HeapCount == 0)
                    continue;
                order.Add(queue.Top);
                Assert.Equal(bucket, scale.BucketOf(key[queue.Top]));
                queue.Pop();
            }
        }
        return order;
    }
}
