using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>What a series of steps did to a trait: per step the places that it wrote and the value of the other side. Swapping goes back and forth.</summary>
internal abstract class TraitDelta
{
    public abstract Trait Trait { get; }

    /// <summary>Whether values can be written to a file.</summary>
    public abstract bool IsPlain { get; }

    /// <summary>Notes, before it is written, what a place holds.</summary>
    public abstract void Note(int index);

    /// <summary>Ends a step with all that was noted since the last.</summary>
    public abstract void EndStep(int step);

    /// <summary>Exchanges the values of a step with the trait's.</summary>
    public abstract void Swap(int step, bool backward);

    public abstract void WriteStep(BinaryWriter writer, int step);

    public abstract void ReadStep(BinaryReader reader, int step);

    public abstract void WriteValue(BinaryWriter writer, int index);

    public abstract void ReadValue(BinaryReader reader, int index);
}

/// <inheritdoc/>
/// <typeparam name="T">The type of the values.</typeparam>
/// <param name="trait">The trait.</param>
/// <param name="steps">The number of steps.</param>
internal sealed class TraitDelta<T>(Trait<T> trait, int steps) : TraitDelta
{
    private readonly (int Index, T Other)[]?[] changes = new (int, T)[]?[steps];
    private readonly List<(int Index, T Other)> noted = [];

    public override Trait Trait => trait;

    public override bool IsPlain => PlainBytes.Known<T>();

    public override void Note(int index) => noted.Add((index, trait[index]));

    public override void EndStep(int step)
    {
        changes[step] = noted.Count == 0 ? null : [.. noted];
        noted.Clear();
    }

    public override void Swap(int step, bool backward)
    {
        if (changes[step] is not { } all)
            return;
        for (int k = 0; k < all.Length; k++)
        {
            ref (int Index, T Other) change = ref all[backward ? all.Length - 1 - k : k];
            (trait[change.Index], change.Other) = (change.Other, trait[change.Index]);
        }
    }

    public override void WriteStep(BinaryWriter writer, int step)
    {
        (int Index, T Other)[] all = changes[step] ?? [];
        writer.Write7BitEncodedInt(all.Length);
        foreach (var (index, other) in all)
        {
            writer.Write7BitEncodedInt(index);
            Write(writer, other);
        }
    }

    public override void ReadStep(BinaryReader reader, int step)
    {
        int count = reader.Read7BitEncodedInt();
        if (count == 0)
            return;
        if (count < 0 || count > trait.Count)
            throw new InvalidDataException($"{count} changes of a trait with {trait.Count} values");
        var all = new (int, T)[count];
        for (int k = 0; k < count; k++)
        {
            int index = reader.Read7BitEncodedInt();
            if ((uint)index >= (uint)trait.Count)
                throw new InvalidDataException($"place {index} of a trait with {trait.Count} values");
            all[k] = (index, Read(reader));
        }
        changes[step] = all;
    }

    public override void WriteValue(BinaryWriter writer, int index) => Write(writer, trait[index]);

    public override void ReadValue(BinaryReader reader, int index) => trait[index] = Read(reader);

    private static void Write(BinaryWriter writer, T value) =>
        writer.Write(MemoryMarshal.CreateReadOnlySpan(ref Unsafe.As<T, byte>(ref value), Unsafe.SizeOf<T>()));

    private static T Read(BinaryReader reader)
    {
        T value = default!;
        reader.BaseStream.ReadExactly(MemoryMarshal.CreateSpan(ref Unsafe.As<T, byte>(ref value), Unsafe.SizeOf<T>()));
        return value;
    }
}

/// <summary>Traits by the name of their type, as files name them.</summary>
internal static class TraitTypes
{
    /// <summary>Adds a trait with the type of a name.</summary>
    /// <returns>Null if the name is unknown.</returns>
    public static Trait? Add(Mesh mesh, ElementKind kind, string name, string type) => type switch
    {
        "Double" => Add<double>(mesh, kind, name, Blend.Linear),
        "Vector2D" => Add<Vector2D>(mesh, kind, name, Blend.Linear),
        "Vector3D" => Add<Vector3D>(mesh, kind, name, name == TraitNames.Normal ? Blend.Direction : Blend.Linear),
        "Color" => Add<Color>(mesh, kind, name, Blend.Linear),
        "Int32" => Add<int>(mesh, kind, name, null),
        "Boolean" => Add<bool>(mesh, kind, name, null),
        "Byte" => Add<byte>(mesh, kind, name, null),
        "Int64" => Add<long>(mesh, kind, name, null),
        "Single" => Add<float>(mesh, kind, name, null),
        _ => null,
    };

    private static Trait Add<T>(Mesh mesh, ElementKind kind, string name, TraitBlend<T>? blend) => kind switch
    {
        ElementKind.Vertex => mesh.AddVertexTrait<T>(name, default!, blend),
        ElementKind.HalfEdge => mesh.AddHalfEdgeTrait<T>(name, default!, blend),
        ElementKind.Edge => mesh.AddEdgeTrait<T>(name, default!, blend),
        _ => mesh.AddFaceTrait<T>(name, default!, blend),
    };
}
