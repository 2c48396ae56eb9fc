using System.Runtime.InteropServices;

namespace MeshLab.Structure;

/// <summary>Copying, hashing and recording of whole meshes.</summary>
public sealed partial class Mesh
{
    /// <summary>Starts to record operations, to undo them exactly. Recordings nest; the inner one ends first.</summary>
    public OperationHistory StartRecording() => new(this);

    /// <summary>§2.6 克隆: a deep copy of connectivity, positions and all traits, with the same indices. O(V + E + F).</summary>
    public Mesh Clone()
    {
        var copy = new Mesh(
            positions.AsSpan(0, vertexSlots).ToArray(),
            next.AsSpan(0, halfEdgeSlots).ToArray(),
            previous.AsSpan(0, halfEdgeSlots).ToArray(),
            target.AsSpan(0, halfEdgeSlots).ToArray(),
            face.AsSpan(0, halfEdgeSlots).ToArray(),
            outgoing.AsSpan(0, vertexSlots).ToArray(),
            halfEdgeOf.AsSpan(0, faceSlots).ToArray())
        {
            vertexCount = vertexCount,
            edgeCount = edgeCount,
            faceCount = faceCount,
        };
        copy.CopyTraitsFrom(this);
        return copy;
    }

    /// <summary>A hash of connectivity, positions and traits: equal for equal states, on every machine. O(V + E + F).</summary>
    public ulong StateHash()
    {
        var hash = new StateHasher();
        hash.Add(vertexSlots);
        hash.Add(halfEdgeSlots);
        hash.Add(faceSlots);
        hash.Add(MemoryMarshal.AsBytes(Next));
        hash.Add(MemoryMarshal.AsBytes(Previous));
        hash.Add(MemoryMarshal.AsBytes(Target));
        hash.Add(MemoryMarshal.AsBytes(FaceOf));
        hash.Add(MemoryMarshal.AsBytes(Outgoing));
        hash.Add(MemoryMarshal.AsBytes(HalfEdgeOf));
        hash.Add(MemoryMarshal.AsBytes(Positions));
        foreach (Trait trait in AllTraits)
            trait.AddTo(ref hash);
        return hash.Value;
    }
}

/// <summary>A 64-bit multiply-and-rotate hash over little-endian words; not for secrets.</summary>
internal struct StateHasher
{
    private ulong state;

    public StateHasher() => state = 0x9E3779B97F4A7C15;

    public readonly ulong Value
    {
        get
        {
            ulong x = state;
            x ^= x >> 32;
            x *= 0xD6E8FEB86659FD93;
            return x ^ (x >> 29);
        }
    }

    public void Add(ulong word) => state = (ulong.RotateLeft(state, 27) ^ word) * 0xFF51AFD7ED558CCD + 0x52DCE729;

    public void Add(int value) => Add((ulong)(uint)value);

    public void Add(ReadOnlySpan<byte> bytes)
    {
        Add(bytes.Length);
        ReadOnlySpan<ulong> words = MemoryMarshal.Cast<byte, ulong>(bytes);
        foreach (ulong word in words)
            Add(word);
        foreach (byte b in bytes[(words.Length * 8)..])
            Add(b);
    }

    public void Add(string text)
    {
        Add(text.Length);
        foreach (char c in text)
            Add(c);
    }
}
