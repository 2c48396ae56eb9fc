using System.Runtime.CompilerServices;

namespace MeshLab.Morse;

/// <summary>A total order of the vertices: what simulation of simplicity (Edelsbrunner, Mücke 1990) makes of a function with equal values.</summary>
internal interface IVertexOrder
{
    /// <summary>Whether the first vertex comes before the second.</summary>
    bool Less(int a, int b);
}

/// <summary>By value, then by index.</summary>
internal readonly struct ByValue(double[] values) : IVertexOrder
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Less(int a, int b)
    {
        double x = values[a], y = values[b];
        return x < y || (x == y && a < b);
    }
}

/// <summary>By a rank of its own, which agrees with the values but decides between equal ones.</summary>
internal readonly struct ByRank(int[] ranks) : IVertexOrder
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Less(int a, int b) => ranks[a] < ranks[b];
}

/// <summary>The order turned round: maxima become minima.</summary>
internal readonly struct Reversed<TOrder>(TOrder order) : IVertexOrder
    where TOrder : struct, IVertexOrder
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Less(int a, int b) => order.Less(b, a);
}

/// <summary>Makes a comparison for sorting of an order.</summary>
internal sealed class OrderComparer<TOrder>(TOrder order) : IComparer<int>
    where TOrder : struct, IVertexOrder
{
    public int Compare(int x, int y) => x == y ? 0 : order.Less(x, y) ? -1 : 1;
}
