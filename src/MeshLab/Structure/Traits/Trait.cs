using System.Globalization;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>A column of own data, one value per element of a kind, that follows growth, deletion, compaction, cloning and undo.</summary>
public abstract class Trait
{
    private protected Trait(Mesh mesh, string name, ElementKind kind)
    {
        Mesh = mesh;
        Name = name;
        Kind = kind;
    }

    /// <summary>The mesh that the column belongs to.</summary>
    public Mesh Mesh { get; }

    /// <summary>The name, one of a kind among the traits of the same element kind.</summary>
    public string Name { get; }

    /// <summary>Which elements have a value.</summary>
    public ElementKind Kind { get; }

    /// <summary>The type of the values.</summary>
    public abstract Type ValueType { get; }

    /// <summary>The number of values: the slots of the element kind.</summary>
    public abstract int Count { get; }

    /// <summary>Grows or shrinks to a number of slots; new ones get the default value.</summary>
    internal abstract void Grow(int count);

    /// <summary>Keeps the values whose new index is not negative, in order.</summary>
    internal abstract void Compact(ReadOnlySpan<int> newIndex, int newCount);

    /// <summary>Moves every value to its new place.</summary>
    internal abstract void Permute(ReadOnlySpan<int> newIndex);

    internal abstract Trait CloneFor(Mesh mesh);

    /// <summary>A column of the same name, default and blend for another mesh, all default.</summary>
    internal abstract Trait CloneEmptyFor(Mesh mesh);

    /// <summary>Writes the blend of some values of a column of the same type, maybe of another mesh. No weights are equal weights.</summary>
    internal abstract void TakeMix(int to, Trait source, ReadOnlySpan<int> from, ReadOnlySpan<double> weights);

    internal abstract void AppendFrom(Trait other, int offset);

    /// <summary>Takes values derived from another mesh's trait of the same type: per element a source, or the blend of two.</summary>
    /// <param name="source">The trait that the values come from.</param>
    /// <param name="first">Per element here, an element there; −1 for the default value.</param>
    /// <param name="second">Per element here, the second element of a blend; −1 for none. <see langword="null"/> if nothing is blended.</param>
    /// <param name="t">Where between the two.</param>
    internal abstract void Derive(Trait source, int[] first, int[]? second, double[]? t);

    internal abstract void AddTo(ref StateHasher hash);

    /// <summary>Copies one element's value to another.</summary>
    internal abstract void Copy(int from, int to);

    /// <summary>Writes the blend of two elements' values.</summary>
    internal abstract void Mix(int to, int first, int second, double t);

    /// <summary>Gives one element the default value.</summary>
    internal abstract void Reset(int index);

    /// <summary>A record of what a number of steps do to the trait.</summary>
    internal abstract TraitDelta NewDelta(int steps);
}

/// <summary>A trait with values of a type.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
public abstract class Trait<T> : Trait
{
    private T[] values;
    private int count;

    private protected Trait(Mesh mesh, string name, ElementKind kind, int count, T defaultValue, TraitBlend<T>? blend)
        : base(mesh, name, kind)
    {
        DefaultValue = defaultValue;
        Blend = blend ?? Structure.Blend.Nearest;
        values = new T[count];
        this.count = count;
        if (!EqualityComparer<T>.Default.Equals(defaultValue, default))
            Array.Fill(values, defaultValue);
    }

    /// <summary>What new elements get.</summary>
    public T DefaultValue { get; }

    /// <summary>How an operation mixes two values.</summary>
    public TraitBlend<T> Blend { get; }

    /// <inheritdoc/>
    public override Type ValueType => typeof(T);

    /// <inheritdoc/>
    public override int Count => count;

    /// <summary>All values by index, deleted elements' too. Take the span once before a loop; growth makes it stale.</summary>
    public Span<T> Values => values.AsSpan(0, count);

    /// <summary>The value of the element with the index.</summary>
    public ref T this[int index] => ref values.AsSpan(0, count)[index];

    private protected ref T At(Mesh mesh, int index)
    {
        if (!ReferenceEquals(mesh, Mesh))
            throw new ArgumentException($"The trait \"{Name}\" belongs to another mesh than the element.");
        return ref this[index];
    }

    internal void Set(int index, T value)
    {
        Mesh.CurrentJournal?.WriteTrait(new Change(this, index, values[index], value));
        values[index] = value;
    }

    internal override void Grow(int newCount)
    {
        if (newCount > values.Length)
            Array.Resize(ref values, Growth.Capacity(values.Length, newCount));
        if (newCount > count)
            values.AsSpan(count, newCount - count).Fill(DefaultValue);
        count = newCount;
    }

    internal override void Compact(ReadOnlySpan<int> newIndex, int newCount)
    {
        var kept = new T[newCount];
        for (int i = 0; i < newIndex.Length; i++)
        {
            if (newIndex[i] >= 0)
                kept[newIndex[i]] = values[i];
        }
        values = kept;
        count = newCount;
    }

    internal override void Permute(ReadOnlySpan<int> newIndex) => Compact(newIndex, count);

    internal override void AppendFrom(Trait other, int offset)
    {
        if (other is Trait<T> same)
            same.Values.CopyTo(values.AsSpan(offset));
    }

    internal override void Derive(Trait source, int[] first, int[]? second, double[]? t)
    {
        Span<T> theirs = ((Trait<T>)source).Values;
        var derived = new T[first.Length];
        for (int i = 0; i < derived.Length; i++)
        {
            derived[i] = first[i] < 0 ? DefaultValue
                : second is null || second[i] < 0 ? theirs[first[i]]
                : Blend(theirs[first[i]], theirs[second[i]], t![i]);
        }
        values = derived;
        count = derived.Length;
    }

    internal override void Copy(int from, int to) => Set(to, values[from]);

    internal override void Mix(int to, int first, int second, double t) => Set(to, Blend(values[first], values[second], t));

    internal override void TakeMix(int to, Trait source, ReadOnlySpan<int> from, ReadOnlySpan<double> weights)
    {
        if (source is not Trait<T> same)
            return;
        T value = same.values[from[0]];
        double total = weights.IsEmpty ? 1 : weights[0];
        for (int i = 1; i < from.Length; i++)
        {
            double weight = weights.IsEmpty ? 1 : weights[i];
            total += weight;
            value = Blend(value, same.values[from[i]], total == 0 ? 0 : weight / total);
        }
        Set(to, value);
    }

    internal override TraitDelta NewDelta(int steps) => new TraitDelta<T>(this, steps);

    internal override void Reset(int index) => Set(index, DefaultValue);

    internal override void AddTo(ref StateHasher hash)
    {
        hash.Add(Name);
        if (PlainBytes.Known<T>())
        {
            hash.Add(PlainBytes.Of(Values));
            return;
        }
        foreach (T value in Values)
            hash.Add((value as IFormattable)?.ToString(null, CultureInfo.InvariantCulture) ?? value?.ToString() ?? "");
    }

    private protected void TakeValues(Trait<T> other)
    {
        values = other.Values.ToArray();
        count = other.count;
    }

    private sealed class Change(Trait<T> trait, int index, T before, T after) : TraitChange
    {
        public override void Undo() => trait.values[index] = before;

        public override void Redo() => trait.values[index] = after;
    }
}

/// <summary>A value per vertex.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
public sealed class VertexTrait<T> : Trait<T>
{
    internal VertexTrait(Mesh mesh, string name, T defaultValue, TraitBlend<T>? blend)
        : base(mesh, name, ElementKind.Vertex, mesh.VertexSlots, defaultValue, blend)
    {
    }

    /// <summary>The value of a vertex, to read and to write.</summary>
    public ref T this[Vertex vertex] => ref At(vertex.mesh, vertex.index);

    internal override Trait CloneFor(Mesh mesh)
    {
        var copy = new VertexTrait<T>(mesh, Name, DefaultValue, Blend);
        copy.TakeValues(this);
        return copy;
    }

    internal override Trait CloneEmptyFor(Mesh mesh) => new VertexTrait<T>(mesh, Name, DefaultValue, Blend);
}

/// <summary>A value per half-edge, that is per corner: the corner at the half-edge's target in its face.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
public sealed class HalfEdgeTrait<T> : Trait<T>
{
    internal HalfEdgeTrait(Mesh mesh, string name, T defaultValue, TraitBlend<T>? blend)
        : base(mesh, name, ElementKind.HalfEdge, mesh.HalfEdgeSlots, defaultValue, blend)
    {
    }

    /// <summary>The value of a half-edge, to read and to write.</summary>
    public ref T this[HalfEdge halfEdge] => ref At(halfEdge.mesh, halfEdge.index);

    internal override Trait CloneFor(Mesh mesh)
    {
        var copy = new HalfEdgeTrait<T>(mesh, Name, DefaultValue, Blend);
        copy.TakeValues(this);
        return copy;
    }

    internal override Trait CloneEmptyFor(Mesh mesh) => new HalfEdgeTrait<T>(mesh, Name, DefaultValue, Blend);
}

/// <summary>A value per edge.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
public sealed class EdgeTrait<T> : Trait<T>
{
    internal EdgeTrait(Mesh mesh, string name, T defaultValue, TraitBlend<T>? blend)
        : base(mesh, name, ElementKind.Edge, mesh.EdgeSlots, defaultValue, blend)
    {
    }

    /// <summary>The value of an edge, to read and to write.</summary>
    public ref T this[Edge edge] => ref At(edge.mesh, edge.index);

    internal override Trait CloneFor(Mesh mesh)
    {
        var copy = new EdgeTrait<T>(mesh, Name, DefaultValue, Blend);
        copy.TakeValues(this);
        return copy;
    }

    internal override Trait CloneEmptyFor(Mesh mesh) => new EdgeTrait<T>(mesh, Name, DefaultValue, Blend);
}

/// <summary>A value per face.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
public sealed class FaceTrait<T> : Trait<T>
{
    internal FaceTrait(Mesh mesh, string name, T defaultValue, TraitBlend<T>? blend)
        : base(mesh, name, ElementKind.Face, mesh.FaceSlots, defaultValue, blend)
    {
    }

    /// <summary>The value of a face, to read and to write.</summary>
    public ref T this[Face face] => ref At(face.mesh, face.index);

    internal override Trait CloneFor(Mesh mesh)
    {
        var copy = new FaceTrait<T>(mesh, Name, DefaultValue, Blend);
        copy.TakeValues(this);
        return copy;
    }

    internal override Trait CloneEmptyFor(Mesh mesh) => new FaceTrait<T>(mesh, Name, DefaultValue, Blend);
}

/// <summary>Which types can be hashed as bytes: those without padding or references.</summary>
internal static class PlainBytes
{
    public static bool Known<T>() =>
        typeof(T).IsPrimitive || typeof(T).IsEnum || typeof(T) == typeof(Vector2D) || typeof(T) == typeof(Vector3D) || typeof(T) == typeof(Color);

    public static ReadOnlySpan<byte> Of<T>(ReadOnlySpan<T> values)
    {
        if (values.IsEmpty)
            return [];
        ref byte first = ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(values));
        return MemoryMarshal.CreateReadOnlySpan(ref first, values.Length * Unsafe.SizeOf<T>());
    }
}
