using System.Collections.Immutable;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>The local operations, as a trace names them.</summary>
public enum OperationKind
{
    /// <summary>A vertex was added.</summary>
    AddVertex,

    /// <summary>A vertex was moved.</summary>
    MoveVertex,

    /// <summary>§4.1 A face was added.</summary>
    AddFace,

    /// <summary>§4.2 A face was deleted.</summary>
    DeleteFace,

    /// <summary>§4.3 An edge was deleted with its faces.</summary>
    DeleteEdge,

    /// <summary>§4.3 The two faces of an edge became one.</summary>
    DissolveEdge,

    /// <summary>§4.4 A vertex was deleted with its faces.</summary>
    DeleteVertex,

    /// <summary>§4.5 A vertex became two.</summary>
    VertexSplit,

    /// <summary>§4.6 An edge was contracted.</summary>
    EdgeCollapse,

    /// <summary>§4.7 An edge was flipped.</summary>
    EdgeFlip,

    /// <summary>A point was put on an edge.</summary>
    EdgeSplit,

    /// <summary>A point was put into a face.</summary>
    FaceSplit,

    /// <summary>A face was cut along a diagonal.</summary>
    SplitFaceByDiagonal,

    /// <summary>Two faces were joined across their edge.</summary>
    JoinFaces,

    /// <summary>Two boundary vertices became one.</summary>
    MergeVertices,

    /// <summary>Two boundary edges became one.</summary>
    StitchEdges,

    /// <summary>Several operations under one name.</summary>
    Group,
}

/// <summary>What one operation did; can undo and redo it exactly.</summary>
public sealed class OperationRecord
{
    private readonly Mesh mesh;
    private readonly Journal journal;

    internal OperationRecord(Mesh mesh, Journal journal)
    {
        this.mesh = mesh;
        this.journal = journal;
    }

    /// <summary>Which operation.</summary>
    public OperationKind Kind => journal.Kind;

    /// <summary>The index of the element that it was called on; −1 if there is none.</summary>
    public int Element => journal.Element;

    /// <summary>Indices of the vertices that it created.</summary>
    public Range CreatedVertices => journal.Before.VertexSlots..journal.After.VertexSlots;

    /// <summary>Indices of the edges that it created.</summary>
    public Range CreatedEdges => (journal.Before.HalfEdgeSlots / 2)..(journal.After.HalfEdgeSlots / 2);

    /// <summary>Indices of the faces that it created.</summary>
    public Range CreatedFaces => journal.Before.FaceSlots..journal.After.FaceSlots;

    /// <summary>The elements that it removed, in the order of removal.</summary>
    public ImmutableArray<(ElementKind Kind, int Index)> Removed => [.. journal.Removed];

    internal IReadOnlyList<(int Vertex, Vector3D Before, Vector3D After)> Moves => journal.Moves;

    /// <summary>Takes the operation back. Only right when everything done after it was taken back before; <see cref="OperationHistory"/> sees to that.</summary>
    public void Undo() => journal.Undo(mesh);

    /// <summary>Does the operation again. Only right in the state that it was first done in.</summary>
    public void Redo() => journal.Redo(mesh);
}

/// <summary>Hears of every finished operation on a mesh.</summary>
public interface IOperationListener
{
    /// <summary>Called after the operation, with the mesh in its new state.</summary>
    void OnOperation(OperationRecord record);
}

/// <summary>The bracket around an operation; an operation left without <see cref="Complete"/> is rolled back.</summary>
internal struct OperationScope : IDisposable
{
    private readonly Mesh? mesh;
    private bool completed;

    public OperationScope(Mesh mesh)
    {
        this.mesh = mesh;
        completed = false;
    }

    public void Complete() => completed = true;

    public readonly void Dispose() => mesh?.EndOperation(completed);
}

/// <summary>Records the operations on a mesh and takes them back, or does them again, exactly: indices, positions and traits.</summary>
/// <remarks>Only operations are recorded; positions or traits written directly are not. Ends with <see cref="Dispose"/>.</remarks>
public sealed class OperationHistory : IOperationListener, IDisposable
{
    private readonly Mesh mesh;
    private readonly IOperationListener? outer;
    private readonly List<OperationRecord> records = [];
    private int done;

    internal OperationHistory(Mesh mesh)
    {
        this.mesh = mesh;
        outer = mesh.Listener;
        mesh.Listener = this;
    }

    /// <summary>How many operations are done and can be taken back.</summary>
    public int Count => done;

    /// <summary>How many operations were taken back and can be done again.</summary>
    public int UndoneCount => records.Count - done;

    /// <summary>The operations that are done, oldest first.</summary>
    public IReadOnlyList<OperationRecord> Records => records.GetRange(0, done);

    void IOperationListener.OnOperation(OperationRecord record)
    {
        records.RemoveRange(done, records.Count - done);
        records.Add(record);
        done++;
        outer?.OnOperation(record);
    }

    /// <summary>Takes back the last operation; false if there is none.</summary>
    public bool Undo()
    {
        if (done == 0)
            return false;
        records[--done].Undo();
        return true;
    }

    /// <summary>Does again what was taken back last; false if there is nothing.</summary>
    public bool Redo()
    {
        if (done == records.Count)
            return false;
        records[done++].Redo();
        return true;
    }

    /// <summary>Takes back operations until <paramref name="count"/> are left.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There are not so many.</exception>
    public void UndoTo(int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(count, done);
        while (done > count)
            Undo();
    }

    /// <summary>Takes back everything.</summary>
    public void UndoAll() => UndoTo(0);

    /// <summary>Does again everything that was taken back.</summary>
    public void RedoAll()
    {
        while (Redo())
        {
        }
    }

    /// <summary>Stops recording and gives the mesh back to the listener that was there before.</summary>
    public void Dispose()
    {
        if (ReferenceEquals(mesh.Listener, this))
            mesh.Listener = outer;
    }
}
