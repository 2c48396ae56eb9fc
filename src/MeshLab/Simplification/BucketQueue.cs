using System.Runtime.CompilerServices;

namespace MeshLab.Simplification;

/// <summary>Which bucket a cost belongs to: the leading bits of a double that is not negative order as the double does. Four buckets per factor of two.</summary>
internal readonly struct BucketScale
{
    private const int Shift = 50;
    private readonly int lowest;

    /// <summary>A scale for costs up to about a million times the largest at the start; what is outside goes into the outermost buckets.</summary>
    public BucketScale(double largestCost)
    {
        lowest = Leading(largestCost * 1e-16);
        Count = Leading(largestCost * 1e6 + 1e-300) - lowest + 2;
    }

    public int Count { get; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BucketOf(double cost)
    {
        int bucket = Leading(cost) - lowest;
        return bucket < 0 ? 0 : bucket >= Count ? Count - 1 : bucket;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Leading(double cost) => (int)(BitConverter.DoubleToInt64Bits(cost) >> Shift);
}

/// <summary>Edges by (key, index): lists per bucket, linked through one number per edge, and a small heap of four branches for the bucket at the front.</summary>
/// <remarks>Every live edge that is not parked has exactly one entry. Filling a list costs nothing, so only what comes to the front is ever sorted.</remarks>
internal sealed class BucketQueue
{
    private const int Branches = 4;
    private readonly BucketScale scale;
    private readonly UncheckedArray<int> heads;
    private readonly UncheckedArray<int> links;
    private UncheckedArray<Entry> heap = new Entry[256];

    public BucketQueue(BucketScale scale, UncheckedArray<int> links)
    {
        this.scale = scale;
        this.links = links;
        heads = new int[scale.Count];
        Array.Fill(heads.Items, -1);
    }

    /// <summary>The bucket at the front.</summary>
    public int Current { get; set; } = -1;

    /// <summary>Entries of the front bucket.</summary>
    public int HeapCount { get; private set; }

    public int Top => heap[0].Edge;

    public bool HasEntries(int bucket) => heads[bucket] >= 0;

    /// <summary>Puts an edge into its list, or into the heap if it belongs to the front.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Insert(int edge, double key)
    {
        int bucket = scale.BucketOf(key);
        if (bucket > Current)
            Link(edge, bucket);
        else
            Push(edge, key);
    }

    /// <summary>As <see cref="Insert"/>, but leaves the heap without order; <see cref="Heapify"/> sorts.</summary>
    public void InsertUnsorted(int edge, double key)
    {
        int bucket = scale.BucketOf(key);
        if (bucket > Current)
            Link(edge, bucket);
        else
            Append(edge, key);
    }

    /// <summary>Gives the heap's first edge a new key.</summary>
    public void ChangeTop(double key)
    {
        int edge = heap[0].Edge, bucket = scale.BucketOf(key);
        if (bucket <= Current)
        {
            SiftDown(0, new Entry(key, edge));
            return;
        }
        Pop();
        Link(edge, bucket);
    }

    public void Pop()
    {
        HeapCount--;
        if (HeapCount > 0)
            SiftDown(0, heap[HeapCount]);
    }

    /// <summary>Takes the list of a bucket away.</summary>
    /// <returns>Its first edge; <see cref="NextInList"/> goes on.</returns>
    public int TakeList(int bucket)
    {
        int first = heads[bucket];
        heads[bucket] = -1;
        return first;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int NextInList(int edge) => links[edge];

    /// <summary>Adds to the heap without order; <see cref="Heapify"/> sorts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Append(int edge, double key)
    {
        EnsureRoom();
        heap[HeapCount++] = new Entry(key, edge);
    }

    public void Heapify()
    {
        for (int i = (HeapCount - 2) / Branches; i >= 0; i--)
            SiftDown(i, heap[i]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Link(int edge, int bucket)
    {
        links[edge] = heads[bucket];
        heads[bucket] = edge;
    }

    private void Push(int edge, double key)
    {
        EnsureRoom();
        var entry = new Entry(key, edge);
        int i = HeapCount++;
        while (i > 0)
        {
            int parent = (i - 1) / Branches;
            if (!entry.Before(in heap[parent]))
                break;
            heap[i] = heap[parent];
            i = parent;
        }
        heap[i] = entry;
    }

    private void EnsureRoom()
    {
        if (HeapCount < heap.Length)
            return;
        Entry[] larger = heap.Items;
        Array.Resize(ref larger, 2 * heap.Length);
        heap = larger;
    }

    private void SiftDown(int i, Entry entry)
    {
        UncheckedArray<Entry> entries = heap;
        int count = HeapCount;
        while (true)
        {
            int child = Branches * i + 1;
            if (child >= count)
                break;
            int least = child, end = Math.Min(child + Branches, count);
            for (int k = child + 1; k < end; k++)
            {
                if (entries[k].Before(in entries[least]))
                    least = k;
            }
            if (!entries[least].Before(in entry))
                break;
            entries[i] = entries[least];
            i = least;
        }
        entries[i] = entry;
    }

    private readonly struct Entry(double key, int edge)
    {
        private readonly double key = key;

        public int Edge { get; } = edge;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool Before(in Entry other) => key < other.key || (key == other.key && Edge < other.Edge);
    }
}
