using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Every cell that one operation wrote, with its value before and after: enough to undo and to redo it exactly.</summary>
internal sealed class Journal
{
    private readonly List<(Column Column, int Index, int Before, int After)> cells = [];
    private readonly List<(int Vertex, Vector3D Before, Vector3D After)> moves = [];
    private readonly List<TraitChange> traits = [];
    private readonly List<(ElementKind Kind, int Index)> removed = [];

    public Journal(Mesh mesh, OperationKind kind, int element)
    {
        Kind = kind;
        Element = element;
        Before = After = mesh.Counts;
    }

    public OperationKind Kind { get; }

    public int Element { get; }

    public MeshCounts Before { get; }

    public MeshCounts After { get; private set; }

    public IReadOnlyList<(ElementKind Kind, int Index)> Removed => removed;

    public IReadOnlyList<(int Vertex, Vector3D Before, Vector3D After)> Moves => moves;

    public void Write(Column column, int index, int before, int after)
    {
        if (before != after)
            cells.Add((column, index, before, after));
    }

    public void WritePosition(int vertex, Vector3D before, Vector3D after) => moves.Add((vertex, before, after));

    public void WriteTrait(TraitChange change) => traits.Add(change);

    public void Remove(ElementKind kind, int index) => removed.Add((kind, index));

    /// <summary>Notes the counts at the end, and what the new slots hold, so that they can be made again.</summary>
    public void Close(Mesh mesh)
    {
        After = mesh.Counts;
        for (int v = Before.VertexSlots; v < After.VertexSlots; v++)
        {
            moves.Add((v, default, mesh.positions[v]));
            cells.Add((Column.Outgoing, v, 0, mesh.outgoing[v]));
        }
        for (int h = Before.HalfEdgeSlots; h < After.HalfEdgeSlots; h++)
        {
            cells.Add((Column.Next, h, 0, mesh.next[h]));
            cells.Add((Column.Previous, h, 0, mesh.previous[h]));
            cells.Add((Column.Target, h, 0, mesh.target[h]));
            cells.Add((Column.Face, h, 0, mesh.face[h]));
        }
        for (int f = Before.FaceSlots; f < After.FaceSlots; f++)
            cells.Add((Column.HalfEdgeOf, f, 0, mesh.halfEdgeOf[f]));
    }

    public void Undo(Mesh mesh)
    {
        for (int i = traits.Count - 1; i >= 0; i--)
            traits[i].Undo();
        for (int i = moves.Count - 1; i >= 0; i--)
            mesh.positions[moves[i].Vertex] = moves[i].Before;
        for (int i = cells.Count - 1; i >= 0; i--)
            mesh.Cell(cells[i].Column, cells[i].Index) = cells[i].Before;
        mesh.Counts = Before;
    }

    public void Redo(Mesh mesh)
    {
        mesh.Counts = After;
        foreach (var (column, index, _, after) in cells)
            mesh.Cell(column, index) = after;
        foreach (var (vertex, _, after) in moves)
            mesh.positions[vertex] = after;
        foreach (TraitChange change in traits)
            change.Redo();
    }
}

/// <summary>One value of a trait that an operation changed.</summary>
internal abstract class TraitChange
{
    public abstract void Undo();

    public abstract void Redo();
}
