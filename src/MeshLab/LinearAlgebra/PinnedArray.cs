using System.Runtime.InteropServices;

namespace MeshLab.LinearAlgebra;

/// <summary>Numbers at an address that does not change until this is disposed of; not cleared.</summary>
/// <remarks>
/// An ordinary array, held by a handle. Arrays of the pinned heap would need no handle, but the collector gives that heap's memory back to the
/// system soon, and then the first touch of every new page costs more than the arithmetic on it.
/// </remarks>
internal sealed unsafe class PinnedArray : IDisposable
{
    private GCHandle handle;

    public PinnedArray(long length)
    {
        handle = GCHandle.Alloc(GC.AllocateUninitializedArray<double>(checked((int)length)), GCHandleType.Pinned);
        Pointer = (double*)handle.AddrOfPinnedObject();
    }

    /// <summary>The address of the first number.</summary>
    public double* Pointer { get; }

    public void Dispose()
    {
        if (handle.IsAllocated)
            handle.Free();
    }
}
