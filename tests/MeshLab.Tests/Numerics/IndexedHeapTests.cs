using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

public class IndexedHeapTests
{
    [Fact]
    public void Pop_AfterRandomChanges_GivesTheLeastKeyAndTheLowestItemOnATie()
    {
        var random = new Random(7);
        var heap = new IndexedHeap(200);
        var expected = new Dictionary<int, double>();
        for (int i = 0; i < 3000; i++)
        {
            int item = random.Next(200);
            if (random.Next(3) == 0)
            {
                Assert.Equal(expected.Remove(item), heap.Remove(item));
            }
            else
            {
                double key = random.Next(20);
                expected[item] = key;
                heap.Set(item, key);
            }
            Assert.Equal(expected.Count, heap.Count);
            Assert.Equal(expected.ContainsKey(item), heap.Contains(item));
        }
        foreach ((int item, double _) in expected.OrderBy(p => p.Value).ThenBy(p => p.Key))
            Assert.Equal(item, heap.Pop());
        Assert.Throws<InvalidOperationException>(() => heap.Top);
    }

    [Fact]
    public void Set_NaN_IsRefused() => Assert.Throws<ArgumentException>(() => new IndexedHeap(1).Set(0, double.NaN));
}
