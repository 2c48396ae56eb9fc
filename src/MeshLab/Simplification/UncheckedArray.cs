using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace MeshLab.Simplification;

/// <summary>A view of an array for inner loops whose indices come from connectivity that was checked when it was built: no bounds check in release builds.</summary>
/// <typeparam name="T">The type of the elements.</typeparam>
/// <param name="items">The array.</param>
internal readonly struct UncheckedArray<T>(T[] items)
{
    private readonly T[] items = items;

    public T[] Items => items;

    public int Length => items.Length;

    public ref T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Debug.Assert((uint)index < (uint)items.Length, "An index of the working mesh is out of range.");
            return ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(items), (nint)(uint)index);
        }
    }

    public static implicit operator UncheckedArray<T>(T[] items) => new(items);

    /// <summary>An array whose elements are all written before they are read.</summary>
    public static UncheckedArray<T> Uninitialized(int length) => GC.AllocateUninitializedArray<T>(length);
}
