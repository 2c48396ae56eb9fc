using System.Numerics;

namespace MeshLab.Structure;

/// <summary>Numbers pairs of vertices by first appearance: a table with open addressing, at most half full.</summary>
internal sealed class EdgeTable
{
    private readonly int[] slots;
    private readonly (int A, int B)[] pairs;
    private readonly int shift;

    /// <summary>An empty table.</summary>
    /// <param name="most">At most so many different pairs will come.</param>
    public EdgeTable(int most)
    {
        int bits = BitOperations.Log2((uint)Math.Max(8, most)) + 2;
        // Numbers plus one: a fresh table of zeros is empty.
        slots = new int[1 << bits];
        pairs = GC.AllocateUninitializedArray<(int, int)>(most);
        shift = 64 - bits;
    }

    /// <summary>How many different pairs have come.</summary>
    public int Count { get; private set; }

    /// <summary>The number of the ordered pair; a new one if it has none.</summary>
    public int NumberOf(int a, int b)
    {
        int at = SlotOf(a, b);
        if (slots[at] == 0)
        {
            pairs[Count] = (a, b);
            slots[at] = ++Count;
        }
        return slots[at] - 1;
    }

    private int SlotOf(int a, int b)
    {
        int at = (int)(((ulong)(uint)a << 32 | (uint)b) * 0x9E3779B97F4A7C15 >> shift);
        while (slots[at] != 0 && pairs[slots[at] - 1] != (a, b))
            at = (at + 1) & (slots.Length - 1);
        return at;
    }
}
