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
        EnsureVertexCapacity(v + 1);
        vertexSlots++;
        vertexCount++;
        positions[v] = position;
        outgoing[v] = Isolated;
        foreach (Trait trait in vertexTraits)
            trait.Grow(vertexSlots);
        return new(this, v);
    }

    /// <summary>A new edge; its first half-edge goes from <paramref name="from"/> to <paramref name="to"/>. Links are still to be set.</summary>
    internal HalfEdge NewEdge(Vertex from, Vertex to)
    {
        int h = halfEdgeSlots;
        EnsureHalfEdgeCapacity(h + 2);
        halfEdgeSlots += 2;
        edgeCount++;
        target[h] = to.index;
        target[h + 1] = from.index;
        face[h] = face[h + 1] = -1;
        next[h] = previous[h] = h + 1;
        next[h + 1] = previous[h + 1] = h;
        foreach (Trait trait in halfEdgeTraits)
            trait.Grow(halfEdgeSlots);
        foreach (Trait trait in edgeTraits)
            trait.Grow(EdgeSlots);
        return new(this, h);
    }

    internal Face NewFace()
    {
        int f = faceSlots;
        EnsureFaceCapacity(f + 1);
        faceSlots++;
        faceCount++;
        halfEdgeOf[f] = 0;
        foreach (Trait trait in faceTraits)
            trait.Grow(faceSlots);
        return new(this, f);
    }

    /// <summary>Makes <paramref name="second"/> follow <paramref name="first"/>.</summary>
    internal void SetNext(HalfEdge first, HalfEdge second) => SetNext(first.index, second.index);

    internal void SetNext(int first, int second)
    {
        if (journal is not null)
        {
            journal.Write(Column.Next, first, next[first], second);
            journal.Write(Column.Previous, second, previous[second], first);
        }
        next[first] = second;
        previous[second] = first;
    }

    internal void SetTarget(HalfEdge h, Vertex v) => SetTarget(h.index, v.index);

    internal void SetTarget(int h, int v)
    {
        journal?.Write(Column.Target, h, target[h], v);
        target[h] = v;
    }

    internal void SetFace(HalfEdge h, Face f) => SetFace(h.index, f.Index);

    internal void SetFace(int h, int f)
    {
        journal?.Write(Column.Face, h, face[h], f);
        face[h] = f;
    }

    internal void SetOutgoing(Vertex v, HalfEdge h) => SetOutgoing(v.index, h.IsNone ? Isolated : h.index);

    internal void SetOutgoing(int v, int h)
    {
        journal?.Write(Column.Outgoing, v, outgoing[v], h);
        outgoing[v] = h;
    }

    internal void SetHalfEdge(Face f, HalfEdge h) => SetHalfEdge(f.index, h.index);

    internal void SetHalfEdge(int f, int h)
    {
        journal?.Write(Column.HalfEdgeOf, f, halfEdgeOf[f], h);
        halfEdgeOf[f] = h;
    }

    internal void SetPosition(Vertex v, Vector3D position)
    {
        journal?.WritePosition(v.index, positions[v.index], position);
        positions[v.index] = position;
    }

    /// <summary>Links three half-edges into a triangle, with <paramref name="a"/> as the face's first half-edge.</summary>
    internal void LinkTriangle(Face f, HalfEdge a, HalfEdge b, HalfEdge c)
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

    /// <summary>Makes room, so that the next additions do not move the columns.</summary>
    internal void EnsureVertexCapacity(int count)
    {
        if (count <= positions.Length)
            return;
        int capacity = Growth.Capacity(positions.Length, count);
        Array.Resize(ref positions, capacity);
        Array.Resize(ref outgoing, capacity);
    }

    internal void EnsureHalfEdgeCapacity(int count)
    {
        if (count <= next.Length)
            return;
        int capacity = Growth.Capacity(next.Length, count);
        Array.Resize(ref next, capacity);
        Array.Resize(ref previous, capacity);
        Array.Resize(ref target, capacity);
        Array.Resize(ref face, capacity);
    }

    internal void EnsureFaceCapacity(int count)
    {
        if (count <= halfEdgeOf.Length)
            return;
        Array.Resize(ref halfEdgeOf, Growth.Capacity(halfEdgeOf.Length, count));
    }
}

/// <summary>How columns grow.</summary>
internal static class Growth
{
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
