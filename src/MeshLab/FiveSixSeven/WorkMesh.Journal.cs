using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>The journal: what the columns held before, back to a mark.</summary>
internal sealed partial class WorkMesh
{
    private enum Column
    {
        Next,
        Previous,
        Target,
        Face,
        Crease,
        Outgoing,
        Valence,
        OnRim,
        HalfEdgeOf,
    }

    private readonly List<(Column Column, int Index, int Before)> cells = [];
    private readonly List<(int Vertex, Vector3D Before)> moves = [];
    private readonly List<(int Vertex, Quadric Before)> quadricChanges = [];

    /// <summary>Whether changes are noted.</summary>
    public bool IsRecording { get; private set; }

    /// <summary>A state to come back to.</summary>
    public readonly record struct Mark(int Cells, int Moves, int Quadrics, int Vertices, int Edges, int Faces, int LiveFaces, long Penalty, int Steps);

    public Mark StartRecording()
    {
        IsRecording = true;
        return new(cells.Count, moves.Count, quadricChanges.Count, VertexSlots, EdgeSlots, FaceSlots, LiveFaces, Penalty, steps.Count);
    }

    public void StopRecording()
    {
        IsRecording = false;
        cells.Clear();
        moves.Clear();
        quadricChanges.Clear();
        foreach (Step step in steps)
            Write(step);
        steps.Clear();
    }

    private enum StepKind
    {
        Flip,
        Split,
        Collapse,
    }

    private readonly record struct Step(StepKind Kind, int Edge, int First, int Second, Vector3D Position);

    private readonly List<Step> steps = [];

    /// <summary>Where operations are written that stay; those taken back are not.</summary>
    public StepTrace? Trace { get; set; }

    private void Note(in Step step)
    {
        if (Trace is null)
            return;
        if (IsRecording)
            steps.Add(step);
        else
            Write(step);
    }

    private void Write(in Step step)
    {
        switch (step.Kind)
        {
            case StepKind.Flip:
                Trace!.Flip(step.Edge, step.First, step.Second);
                break;
            case StepKind.Split:
                Trace!.Split(step.Edge, step.First, step.Position);
                break;
            default:
                Trace!.Collapse(step.Edge, step.First, step.Second, step.Position);
                break;
        }
    }

    public void UndoTo(in Mark mark)
    {
        for (int i = cells.Count - 1; i >= mark.Cells; i--)
        {
            (Column column, int index, int before) = cells[i];
            ColumnOf(column)[index] = before;
        }
        for (int i = moves.Count - 1; i >= mark.Moves; i--)
            Positions[moves[i].Vertex] = moves[i].Before;
        for (int i = quadricChanges.Count - 1; i >= mark.Quadrics; i--)
            Quadrics[quadricChanges[i].Vertex] = quadricChanges[i].Before;
        cells.RemoveRange(mark.Cells, cells.Count - mark.Cells);
        moves.RemoveRange(mark.Moves, moves.Count - mark.Moves);
        steps.RemoveRange(mark.Steps, steps.Count - mark.Steps);
        quadricChanges.RemoveRange(mark.Quadrics, quadricChanges.Count - mark.Quadrics);
        (VertexSlots, EdgeSlots, FaceSlots, LiveFaces, Penalty) = (mark.Vertices, mark.Edges, mark.Faces, mark.LiveFaces, mark.Penalty);
    }

    private int[] ColumnOf(Column column) => column switch
    {
        Column.Next => Next,
        Column.Previous => Previous,
        Column.Target => Target,
        Column.Face => Face,
        Column.Crease => Crease,
        Column.Outgoing => Outgoing,
        Column.Valence => Valence,
        Column.OnRim => OnRim,
        _ => HalfEdgeOf,
    };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Put(int[] values, Column column, int index, int value)
    {
        if (IsRecording)
            cells.Add((column, index, values[index]));
        values[index] = value;
    }

    private void Link(int first, int second)
    {
        Put(Next, Column.Next, first, second);
        Put(Previous, Column.Previous, second, first);
    }

    private void SetPosition(int v, Vector3D position)
    {
        if (IsRecording)
            moves.Add((v, Positions[v]));
        Positions[v] = position;
    }

    private void SetQuadric(int v, Quadric quadric)
    {
        if (IsRecording)
            quadricChanges.Add((v, Quadrics[v]));
        Quadrics[v] = quadric;
    }

    private void SetValence(int v, int valence)
    {
        Penalty += PenaltyOf(valence, OnRim[v]) - PenaltyOf(Valence[v], OnRim[v]);
        Put(Valence, Column.Valence, v, valence);
    }

    private void SetOnRim(int v)
    {
        Penalty += PenaltyOf(Valence[v], 1) - PenaltyOf(Valence[v], OnRim[v]);
        Put(OnRim, Column.OnRim, v, 1);
    }

    /// <summary>Room for one split. New slots are written without notes: going back to a mark forgets them.</summary>
    private void EnsureRoom()
    {
        if (VertexSlots + 1 > Outgoing.Length)
        {
            int capacity = VertexSlots + VertexSlots / 2 + 64;
            Array.Resize(ref Outgoing, capacity);
            Array.Resize(ref Valence, capacity);
            Array.Resize(ref OnRim, capacity);
            Array.Resize(ref Kind, capacity);
            Array.Resize(ref Positions, capacity);
            Array.Resize(ref Quadrics, capacity);
        }
        if (2 * (EdgeSlots + 3) > Next.Length)
        {
            int capacity = EdgeSlots + EdgeSlots / 2 + 64;
            Array.Resize(ref Crease, capacity);
            Array.Resize(ref Next, 2 * capacity);
            Array.Resize(ref Previous, 2 * capacity);
            Array.Resize(ref Target, 2 * capacity);
            Array.Resize(ref Face, 2 * capacity);
        }
        if (FaceSlots + 2 > HalfEdgeOf.Length)
            Array.Resize(ref HalfEdgeOf, FaceSlots + FaceSlots / 2 + 64);
    }
}
