namespace MeshLab.Numerics;

/// <summary>A priority queue of small integers (堆): the item with the least key first, the lower item on a tie. A key can be changed and an item taken
/// out in O(log n), because every item knows its place in the heap.</summary>
public sealed class IndexedHeap
{
    private readonly double[] keys;
    private readonly int[] places;
    private readonly int[] heap;

    /// <summary>An empty heap for the items 0 … capacity − 1.</summary>
    /// <param name="capacity">The number of possible items.</param>
    public IndexedHeap(int capacity)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(capacity);
        keys = new double[capacity];
        places = new int[capacity];
        heap = new int[capacity];
        Array.Fill(places, -1);
    }

    /// <summary>The number of items in the heap.</summary>
    public int Count { get; private set; }

    /// <summary>The item with the least key.</summary>
    /// <exception cref="InvalidOperationException">The heap is empty.</exception>
    public int Top => Count > 0 ? heap[0] : throw new InvalidOperationException("The heap is empty.");

    /// <summary>Whether an item is in the heap.</summary>
    public bool Contains(int item) => places[item] >= 0;

    /// <summary>The key of an item in the heap.</summary>
    public double KeyOf(int item) => keys[item];

    /// <summary>Puts an item in, or gives it another key. O(log n).</summary>
    public void Set(int item, double key)
    {
        if (double.IsNaN(key))
            throw new ArgumentException("A key is a number.", nameof(key));
        keys[item] = key;
        int place = places[item];
        if (place < 0)
        {
            place = Count++;
            Put(item, place);
        }
        SiftDown(SiftUp(place));
    }

    /// <summary>Takes an item out, if it is in. O(log n).</summary>
    /// <returns>Whether it was in.</returns>
    public bool Remove(int item)
    {
        int place = places[item];
        if (place < 0)
            return false;
        places[item] = -1;
        int last = heap[--Count];
        if (last != item)
        {
            Put(last, place);
            SiftDown(SiftUp(place));
        }
        return true;
    }

    /// <summary>Takes the item with the least key out. O(log n).</summary>
    public int Pop()
    {
        int top = Top;
        Remove(top);
        return top;
    }

    private bool Before(int a, int b) => keys[a] < keys[b] || (keys[a] == keys[b] && a < b);

    private void Put(int item, int place)
    {
        heap[place] = item;
        places[item] = place;
    }

    private int SiftUp(int place)
    {
        int item = heap[place];
        while (place > 0 && Before(item, heap[(place - 1) / 2]))
        {
            Put(heap[(place - 1) / 2], place);
            place = (place - 1) / 2;
        }
        Put(item, place);
        return place;
    }

    private void SiftDown(int place)
    {
        int item = heap[place];
        while (true)
        {
            int child = 2 * place + 1;
            if (child >= Count)
                break;
            if (child + 1 < Count && Before(heap[child + 1], heap[child]))
                child++;
            if (!Before(heap[child], item))
                break;
            Put(heap[child], place);
            place = child;
        }
        Put(item, place);
    }
}
