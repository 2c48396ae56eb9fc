using System.Runtime.CompilerServices;

namespace MeshLab.IO;

/// <summary>An array that grows while a file is read. Its first size comes from the number of bytes at hand, never from what the file claims.</summary>
internal struct GrowingArray<T>
    where T : unmanaged
{
    private T[] items;

    public GrowingArray(long capacity)
    {
        items = GC.AllocateUninitializedArray<T>((int)Math.Clamp(capacity, 4, Array.MaxLength));
        Count = 0;
    }

    public int Count { get; private set; }

    public readonly bool IsAllocated => items is not null;

    public readonly Span<T> Span => items.AsSpan(0, Count);

    public readonly ref T this[int index] => ref items[index];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(T item)
    {
        if (Count == items.Length)
            Grow(Count + 1);
        items[Count++] = item;
    }

    /// <summary>Appends one value until there are <paramref name="count"/>.</summary>
    public void PadTo(int count, T value)
    {
        if (count > items.Length)
            Grow(count);
        items.AsSpan(Count, count - Count).Fill(value);
        Count = count;
    }

    /// <summary>The items as an array of exactly their number; the storage itself if it is full.</summary>
    public readonly T[] ToArray() => items is null ? [] : Count == items.Length ? items : Span.ToArray();

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Grow(int least)
    {
        long larger = Math.Min(Math.Max(least, 2L * items.Length), Array.MaxLength);
        T[] grown = GC.AllocateUninitializedArray<T>((int)larger);
        Span.CopyTo(grown);
        items = grown;
    }
}
