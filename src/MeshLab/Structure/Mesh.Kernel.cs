using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>The few writes from which every local operation is made. Each is entered in the journal when somebody listens.</summary>
public sealed partial class Mesh
{
    private Journal? journal;
    private int operationDepth;

    /// <summary>Who hears of every finished operation; <see langword="null"/> for nobody, and then nothing is recorded.</summary>
    public IOperationListener? Listener { get; set; }

    /// <summary>Adds a vertex without edges. O(1).</summary>
    /// <exception cref="ArgumentException">The position is not finite.</exception>
    public Vertex AddVertex(Vector3D position)
    {
        if (!position.IsFinite)
            throw new ArgumentException($"The position {position} is not finite.", nameof(position));
        using OperationScope operation = BeginOperation(OperationKind.AddVertex);
        Vertex v = NewVertex(position);
        operation.Complete();
        return v;
    }

    /// <summary>Moves a vertex, so that a listener hears of it (writing <see cref="Vertex.Position"/> is faster and silent). O(1).</summary>
    /// <exception cref="ArgumentException">The vertex is not a live one of this mesh, or the position is not finite.</exception>
    public void MoveVertex(Vertex vertex, Vector3D position)
    {
        CheckOwn(vertex, nameof(vertex));
        if (!position.IsFinite)
            throw new ArgumentException($"The position {position} is not finite.", nameof(position));
        using OperationScope operation = BeginOperation(OperationKind.MoveVertex, vertex.index);
        SetPosition(vertex, position);
        operation.Complete();
    }

    /// <summary>Opens an operation. Without a listener this does nothing; with one, the record is delivered when the outermost scope completes.</summary>
    internal OperationScope BeginOperation(OperationKind kind, int element = -1)
    {
        if (Listener is null)
            return default;
        if (operationDepth++ == 0)
            journal = new Journal(this, kind, element);
        return new OperationScope(this);
    }

    /// <summary>As <see cref="BeginOperation"/>, but recorded even when nobody listens, so that leaving it without completion takes everything back.</summary>
    internal OperationScope BeginReversibleOperation(OperationKind kind, int element = -1)
    {
        if (operationDepth++ == 0)
            journal = new Journal(this, kind, element);
        return new OperationScope(this);
    }

    internal void EndOperation(bool completed)
    {
        if (--operationDepth > 0)
            return;
        Journal finished = journal!;
        journal = null;
        if (!completed)
        {
            finished.Close(this);
            finished.Undo(this);
            return;
        }
        finished.Close(this);
        Listener?.OnOperation(new OperationRecord(this, finished));
    }

    internal Journal? CurrentJournal => journal;

    internal Vertex NewVertex(Vector3D position)
    {
        int v = vertexSlots;
        if (v == positions.Length)
            EnsureVertexCapacity(v + 1);
        vertexSlots = v + 1;
        vertexCount++;
        positions[v] = position;
        outgoing[v] = Isolated;
        if (vertexTraits.Count > 0)
            GrowTraits(vertexTraits, vertexSlots);
        return new(this, v);
    }

    /// <summary>A new edge; its first half-edge goes from <paramref name="from"/> to <paramref name="to"/>. Links are still to be set.</summary>
    internal HalfEdge NewEdge(Vertex from, Vertex to) => new(this, NewEdge(from.index, to.index));

    /// <inheritdoc cref="NewEdge(Vertex, Vertex)"/>
    internal int NewEdge(int from, int to)
    {
        int h = halfEdgeSlots;
        if (h + 2 > next.Length)
            EnsureHalfEdgeCapacity(h + 2);
        halfEdgeSlots = h + 2;
        edgeCount++;
        int[] targets = target, faces = face, n = next, p = previous;
        targets[h + 1] = from;
        targets[h] = to;
        faces[h + 1] = faces[h] = -1;
        n[h + 1] = p[h + 1] = h;
        n[h] = p[h] = h + 1;
        if (halfEdgeTraits.Count > 0)
            GrowTraits(halfEdgeTraits, halfEdgeSlots);
        if (edgeTraits.Count > 0)
            GrowTraits(edgeTraits, EdgeSlots);
        return h;
    }

    internal Face NewFace()
    {
        int f = faceSlots;
        if (f == halfEdgeOf.Length)
            EnsureFaceCapacity(f + 1);
        faceSlots = f + 1;
        faceCount++;
        halfEdgeOf[f] = 0;
        if (faceTraits.Count > 0)
            GrowTraits(faceTraits, faceSlots);
        return new(this, f);
    }

    private static void GrowTraits(List<Trait> traits, int slots)
    {
        foreach (Trait trait in traits)
            trait.Grow(slots);
    }

    /// <summary>Makes <paramref name="second"/> follow <paramref name="first"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetNext(HalfEdge first, HalfEdge second) => SetNext(first.index, second.index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetNext(int first, int second)
    {
        if (journal is not null)
        {
            Note(Column.Next, first, next[first], second);
            Note(Column.Previous, second, previous[second], first);
        }
        next[first] = second;
        previous[second] = first;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetTarget(HalfEdge h, Vertex v) => SetTarget(h.index, v.index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetTarget(int h, int v)
    {
        if (journal is not null)
            Note(Column.Target, h, target[h], v);
        target[h] = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetFace(HalfEdge h, Face f) => SetFace(h.index, f.Index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetFace(int h, int f)
    {
        if (journal is not null)
            Note(Column.Face, h, face[h], f);
        face[h] = f;
    }

    internal void SetOutgoing(Vertex v, HalfEdge h) => SetOutgoing(v.index, h.IsNone ? Isolated : h.index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetOutgoing(int v, int h)
    {
        if (journal is not null)
            Note(Column.Outgoing, v, outgoing[v], h);
        outgoing[v] = h;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetHalfEdge(Face f, HalfEdge h) => SetHalfEdge(f.index, h.index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void SetHalfEdge(int f, int h)
    {
        if (journal is not null)
            Note(Column.HalfEdgeOf, f, halfEdgeOf[f], h);
        halfEdgeOf[f] = h;
    }

    internal void SetPosition(Vertex v, Vector3D position)
    {
        journal?.WritePosition(v.index, positions[v.index], position);
        positions[v.index] = position;
    }

    /// <summary>Kept out of the writes above, so that they stay small enough to be inlined.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Note(Column column, int index, int before, int after) => journal!.Write(column, index, before, after);

    /// <summary>Links three half-edges into a triangle, with <paramref name="a"/> as the face's first half-edge.</summary>
    internal void LinkTriangle(Face f, HalfEdge a, HalfEdge b, HalfEdge c) => LinkTriangle(f.index, a.index, b.index, c.index);

    /// <inheritdoc cref="LinkTriangle(Face, HalfEdge, HalfEdge, HalfEdge)"/>
    internal void LinkTriangle(int f, int a, int b, int c)
    {
        if (journal is not null)
        {
            LinkTriangleNoting(f, a, b, c);
            return;
        }
        int[] n = next, p = previous, faces = face;
        n[a] = b;
        n[b] = c;
        n[c] = a;
        p[b] = a;
        p[c] = b;
        p[a] = c;
        faces[a] = f;
        faces[b] = f;
        faces[c] = f;
        halfEdgeOf[f] = a;
    }

    private void LinkTriangleNoting(int f, int a, int b, int c)
    {
        SetNext(a, b);
        SetNext(b, c);
        SetNext(c, a);
        SetFace(a, f);
        SetFace(b, f);
        SetFace(c, f);
        SetHalfEdge(f, a);
    }

    /// <summary>Restores the rule that a boundary vertex's outgoing half-edge is a boundary one, starting from some half-edge that leaves it. O(valence).</summary>
    internal void AdjustOutgoing(Vertex v, HalfEdge leaving) => AdjustOutgoing(v.index, leaving.index);

    internal void AdjustOutgoing(int v, int leaving)
    {
        int h = leaving;
        do
        {
            if (face[h] < 0)
            {
                leaving = h;
                break;
            }
            h = next[h ^ 1];
        }
        while (h != leaving);
        if (outgoing[v] != leaving)
            SetOutgoing(v, leaving);
    }

    /// <summary>Marks a vertex as deleted. Nothing may refer to it any more.</summary>
    internal void DeleteVertexSlot(int v)
    {
        journal?.Remove(ElementKind.Vertex, v);
        SetOutgoing(v, DeletedVertexMark);
        vertexCount--;
    }

    /// <summary>Marks an edge as deleted. Nothing may refer to its half-edges any more.</summary>
    internal void DeleteEdgeSlot(int e)
    {
        int h = 2 * e;
        if (journal is not null)
        {
            journal.Remove(ElementKind.Edge, e);
            for (int k = h; k <= h + 1; k++)
            {
                journal.Write(Column.Next, k, next[k], -1);
                journal.Write(Column.Previous, k, previous[k], -1);
                journal.Write(Column.Target, k, target[k], -1);
                journal.Write(Column.Face, k, face[k], -1);
            }
        }
        next[h] = next[h + 1] = previous[h] = previous[h + 1] = -1;
        target[h] = target[h + 1] = face[h] = face[h + 1] = -1;
        edgeCount--;
    }

    /// <summary>Marks a face as deleted. No half-edge may refer to it any more.</summary>
    internal void DeleteFaceSlot(int f)
    {
        journal?.Remove(ElementKind.Face, f);
        SetHalfEdge(f, -1);
        faceCount--;
    }

    /// <summary>The raw cell of a column, for undo and redo.</summary>
    internal ref int Cell(Column column, int index)
    {
        switch (column)
        {
            case Column.Next:
                return ref next[index];
            case Column.Previous:
                return ref previous[index];
            case Column.Target:
                return ref target[index];
            case Column.Face:
                return ref face[index];
            case Column.Outgoing:
                return ref outgoing[index];
            default:
                return ref halfEdgeOf[index];
        }
    }

    internal MeshCounts Counts
    {
        get => new(vertexSlots, halfEdgeSlots, faceSlots, vertexCount, edgeCount, faceCount);
        set
        {
            EnsureVertexCapacity(value.VertexSlots);
            EnsureHalfEdgeCapacity(value.HalfEdgeSlots);
            EnsureFaceCapacity(value.FaceSlots);
            (vertexSlots, halfEdgeSlots, faceSlots, vertexCount, edgeCount, faceCount) = value;
            ResizeTraits();
        }
    }

    /// <summary>Makes room for further elements, so that adding them does not move the columns; the mesh does not change.</summary>
    /// <param name="vertices">How many vertices will be added.</param>
    /// <param name="edges">How many edges.</param>
    /// <param name="faces">How many faces.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative.</exception>
    public void Reserve(int vertices, int edges, int faces)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(vertices);
        ArgumentOutOfRangeException.ThrowIfNegative(edges);
        ArgumentOutOfRangeException.ThrowIfNegative(faces);
        EnsureVertexCapacity(checked(vertexSlots + vertices));
        EnsureHalfEdgeCapacity(checked(halfEdgeSlots + 2 * edges));
        EnsureFaceCapacity(checked(faceSlots + faces));
    }

    internal void EnsureVertexCapacity(int count)
    {
        if (count <= positions.Length)
            return;
        int capacity = Growth.Capacity(positions.Length, count);
        Growth.Resize(ref positions, vertexSlots, capacity);
        Growth.Resize(ref outgoing, vertexSlots, capacity);
    }

    internal void EnsureHalfEdgeCapacity(int count)
    {
        if (count <= next.Length)
            return;
        int capacity = Growth.Capacity(next.Length, count);
        Growth.Resize(ref next, halfEdgeSlots, capacity);
        Growth.Resize(ref previous, halfEdgeSlots, capacity);
        Growth.Resize(ref target, halfEdgeSlots, capacity);
        Growth.Resize(ref face, halfEdgeSlots, capacity);
    }

    internal void EnsureFaceCapacity(int count)
    {
        if (count <= halfEdgeOf.Length)
            return;
        Growth.Resize(ref halfEdgeOf, faceSlots, Growth.Capacity(halfEdgeOf.Length, count));
    }
}

/// <summary>How columns grow.</summary>
internal static class Growth
{
    /// <summary>A larger column with the same first <paramref name="used"/> values; the rest is not cleared, every new slot is written before it is read.</summary>
    public static void Resize<T>(ref T[] column, int used, int capacity)
        where T : unmanaged
    {
        T[] larger = GC.AllocateUninitializedArray<T>(capacity);
        column.AsSpan(0, used).CopyTo(larger);
        column = larger;
    }

    public static int Capacity(int current, int needed) => Math.Max(needed, (int)Math.Min(Array.MaxLength, Math.Max(8L, current + (long)(current >> 1))));
}

/// <summary>The counts that an operation changes.</summary>
internal readonly record struct MeshCounts(int VertexSlots, int HalfEdgeSlots, int FaceSlots, int Vertices, int Edges, int Faces);

/// <summary>A kind of element (元素).</summary>
public enum ElementKind
{
    /// <summary>Vertices.</summary>
    Vertex,

    /// <summary>Half-edges, also the corners of faces.</summary>
    HalfEdge,

    /// <summary>Edges.</summary>
    Edge,

    /// <summary>Faces.</summary>
    Face,
}

/// <summary>The connectivity columns.</summary>
internal enum Column : byte
{
    Next,
    Previous,
    Target,
    Face,
    Outgoing,
    HalfEdgeOf,
}
