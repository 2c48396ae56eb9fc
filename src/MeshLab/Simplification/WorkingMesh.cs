using System.Runtime.CompilerServices;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>The four columns of a half-edge side by side: a collapse wants all of them at once, so they share a cache line.</summary>
internal struct HalfEdgeRow
{
    public int Next;
    public int Previous;
    public int Target;
    public int Face;
}

/// <summary>What an edge is doing in the queue.</summary>
internal static class EdgeState
{
    /// <summary>Its key is its cost.</summary>
    public const byte Clean = 0;

    /// <summary>Its key is a lower bound of its cost, which has changed.</summary>
    public const byte Stale = 1;

    /// <summary>It is gone.</summary>
    public const byte Deleted = 2;

    /// <summary>This and larger: it was refused, for the reason that the number says, and waits until something beside it changes.</summary>
    public const byte Parked = 3;

    /// <summary>The contraction would change the topology.</summary>
    public const byte RefusedByTopology = 3;

    /// <summary>A locked boundary, a feature or a seam forbids it.</summary>
    public const byte RefusedByConstraint = 4;

    /// <summary>A face would turn over.</summary>
    public const byte RefusedByFlip = 5;

    /// <summary>The error would be too large.</summary>
    public const byte RefusedByError = 6;
}

/// <summary>A private copy of a triangle mesh to contract edges on: rows of half-edges, and positions in a box of unit diagonal around the origin,
/// so that nothing depends on where the model lies or how large it is. Slots are the mesh's own.</summary>
internal sealed class WorkingMesh
{
    /// <summary>A face may turn by acos of this at most; squared, since cosines are compared squared.</summary>
    private const double LeastTurnCosineSquared = 0.05 * 0.05;

    /// <summary>A face whose area shrinks to the root of this has none left, and a normal of rounding errors.</summary>
    private const double NoArea = 1e-14;

    /// <summary>As <see cref="Mesh.Outgoing"/> marks a deleted vertex.</summary>
    public const int DeletedVertex = -2;

    private readonly UnitFrame frame;
    private UncheckedArray<int> marks;

    /// <summary>Per vertex, the input vertex that it lies on; −1 if on none.</summary>
    private UncheckedArray<int> origins;

    public WorkingMesh(Mesh mesh)
    {
        frame = UnitFrame.Of(mesh);
        Rows = UncheckedArray<HalfEdgeRow>.Uninitialized(mesh.HalfEdgeSlots);
        Positions = UncheckedArray<Vector3D>.Uninitialized(mesh.VertexSlots);
        Outgoing = mesh.Outgoing.ToArray();
        HalfEdgeOf = mesh.HalfEdgeOf.ToArray();
        States = new byte[mesh.EdgeSlots];
        Keys = UncheckedArray<double>.Uninitialized(mesh.EdgeSlots);
        marks = new int[mesh.VertexSlots];
        origins = UncheckedArray<int>.Uninitialized(mesh.VertexSlots);
        FaceCount = mesh.Faces.Count;
        Parallelism.ForBlocks(mesh.HalfEdgeSlots, (first, end) => CopyRows(mesh, first, end));
        Parallelism.ForBlocks(mesh.VertexSlots, (first, end) =>
        {
            Span<Vector3D> from = mesh.Positions;
            for (int v = first; v < end; v++)
            {
                Positions[v] = Normalized(from[v]);
                origins[v] = v;
            }
        });
    }

    public UncheckedArray<HalfEdgeRow> Rows { get; private set; }

    /// <summary>Per vertex an outgoing half-edge, a boundary one if there is any; negative if isolated or deleted.</summary>
    public UncheckedArray<int> Outgoing { get; private set; }

    /// <summary>Per face a half-edge; −1 if deleted.</summary>
    public UncheckedArray<int> HalfEdgeOf { get; private set; }

    public UncheckedArray<Vector3D> Positions { get; }

    /// <summary>Per edge an <see cref="EdgeState"/>.</summary>
    public UncheckedArray<byte> States { get; private set; }

    /// <summary>Per edge its cost, or a lower bound of it.</summary>
    public UncheckedArray<double> Keys { get; private set; }

    /// <summary>What vertices and edges may not do; <see langword="null"/> if they may do anything.</summary>
    public Constraints? Constraints { get; set; }

    /// <summary>Per vertex, itself or the vertex that it went into when it was removed; <see langword="null"/> if nobody asks.</summary>
    public int[]? Successors { get; private set; }

    public int FaceCount { get; set; }

    /// <summary>Model units per working unit.</summary>
    public double Scale => frame.Scale;

    public int EdgeSlots => States.Length;

    /// <summary>A position in working units.</summary>
    public Vector3D Normalized(Vector3D position) => frame.ToUnit(position);

    public Vector3D Restored(Vector3D position) => frame.FromUnit(position);

    /// <summary>The input vertex that a vertex lies on; −1 if on none.</summary>
    public int OriginOf(int vertex) => origins[vertex];

    /// <summary>From now on notes where removed vertices go.</summary>
    public void TrackSuccessors()
    {
        Successors = new int[Positions.Length];
        for (int v = 0; v < Successors.Length; v++)
            Successors[v] = v;
    }

    /// <summary>Lets go of all but positions, successors and constraints: the result was taken, and what comes next wants the memory.</summary>
    public void ReleaseConnectivity()
    {
        Rows = default;
        Outgoing = HalfEdgeOf = marks = origins = default;
        States = default;
        Keys = default;
    }

    /// <summary>Per vertex the live one that it is part of. Ends the tracking: the array is the caller's.</summary>
    public int[] Survivors()
    {
        int[] survivors = Successors ?? throw new InvalidOperationException("Successors were not tracked.");
        Successors = null;
        for (int v = 0; v < survivors.Length; v++)
        {
            int last = v;
            while (survivors[last] != last)
                last = survivors[last];
            for (int w = v; w != last;)
                (w, survivors[w]) = (survivors[w], last);
        }
        return survivors;
    }

    /// <summary>Whether contracting the edge of the half-edge keeps the surface a manifold of the same topology (连接条件): the ends have no common
    /// neighbours but the opposite vertices; no bridge between two borders, no border of three edges, no tetrahedron is lost.</summary>
    /// <param name="h">A half-edge from u to v.</param>
    /// <param name="stamp">A number that was not used on these vertices before.</param>
    public bool LinkConditionHolds(int h, int stamp)
    {
        UncheckedArray<HalfEdgeRow> rows = Rows;
        int o = h ^ 1;
        ref HalfEdgeRow left = ref rows[h], right = ref rows[o];
        int u = right.Target, v = left.Target;
        bool boundaryU = rows[Outgoing[u]].Face < 0, boundaryV = rows[Outgoing[v]].Face < 0;
        int opposite = 0;
        if (left.Face >= 0)
        {
            opposite++;
            if (rows[left.Next ^ 1].Face < 0 && rows[left.Previous ^ 1].Face < 0)
                return false;
        }
        if (right.Face >= 0)
        {
            opposite++;
            if (rows[right.Next ^ 1].Face < 0 && rows[right.Previous ^ 1].Face < 0)
                return false;
        }
        if (opposite == 2 && boundaryU && boundaryV)
            return false;
        if (opposite == 1)
        {
            int border = left.Face < 0 ? h : o;
            if (rows[rows[rows[border].Next].Next].Next == border)
                return false;
        }

        int valenceU = 0, valenceV = 0, common = 0, g = h;
        do
        {
            marks[rows[g].Target] = stamp;
            g = rows[g ^ 1].Next;
            valenceU++;
        }
        while (g != h);
        g = o;
        do
        {
            if (marks[rows[g].Target] == stamp)
                common++;
            g = rows[g ^ 1].Next;
            valenceV++;
        }
        while (g != o);
        return common == opposite && (opposite == 1 || boundaryU || boundaryV || valenceU > 3 || valenceV > 3);
    }

    /// <summary>Whether no face around the source of a half-edge, beside those of its edge, turns over when the source moves.</summary>
    public bool KeepsOrientation(int h, Vector3D position)
    {
        UncheckedArray<HalfEdgeRow> rows = Rows;
        UncheckedArray<Vector3D> positions = Positions;
        int rightFace = rows[h ^ 1].Face;
        Vector3D before = positions[rows[h ^ 1].Target];
        for (int g = rows[h ^ 1].Next; g != h; g = rows[g ^ 1].Next)
        {
            ref HalfEdgeRow row = ref rows[g];
            if (row.Face < 0 || row.Face == rightFace)
                continue;
            Vector3D a = positions[row.Target], edge = positions[rows[row.Next].Target] - a;
            Vector3D oldNormal = Vector3D.Cross(edge, before - a), newNormal = Vector3D.Cross(edge, position - a);
            double oldSquared = oldNormal.LengthSquared;
            // A face without area has no side to keep.
            if (oldSquared == 0)
                continue;
            double cosine = Vector3D.Dot(oldNormal, newNormal), newSquared = newNormal.LengthSquared;
            if (cosine <= 0 || cosine * cosine < LeastTurnCosineSquared * oldSquared * newSquared || newSquared < NoArea * oldSquared)
                return false;
        }
        return true;
    }

    /// <summary>Contracts the edge of a half-edge from u to v; u, the edge, its faces and one edge per face disappear.</summary>
    /// <param name="h">The half-edge.</param>
    /// <param name="position">Where v moves.</param>
    /// <param name="merges">Which edges stay; see <see cref="ChooseMerges"/>.</param>
    /// <returns>A half-edge that leaves v.</returns>
    /// <remarks>
    /// <code>
    ///        c                 c
    ///      / | \               │
    ///     u ─h→ v     ⟶       v
    ///      \ | /               │
    ///        d                 d
    /// </code>
    /// Outgoing of v is restored by the caller, who walks around v anyway.
    /// </remarks>
    public int Collapse(int h, Vector3D position, Merges merges)
    {
        UncheckedArray<HalfEdgeRow> rows = Rows;
        int o = h ^ 1;
        int u = rows[o].Target, v = rows[h].Target;
        int g = h;
        do
        {
            rows[g ^ 1].Target = v;
            g = rows[g ^ 1].Next;
        }
        while (g != h);
        rows[o].Target = u;

        int leavingLeft = RemoveSide(h, (merges & Merges.LeftNextStays) != Merges.None);
        int leavingRight = RemoveSide(o, (merges & Merges.RightNextStays) != Merges.None);
        States[h >> 1] = EdgeState.Deleted;
        Outgoing[u] = DeletedVertex;
        if (Successors is not null)
            Successors[u] = v;
        if (position != Positions[v])
        {
            origins[v] = position == Positions[u] ? origins[u] : -1;
            Positions[v] = position;
        }
        int leaving = leavingRight >= 0 ? leavingRight : leavingLeft;
        Outgoing[v] = leaving;
        return leaving;
    }

    /// <summary>Which edge stays of the two that become one, on either side: the one with the larger key, since a key is a lower bound of the cost;
    /// on a tie the one that was at v.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Merges ChooseMerges(int h)
    {
        ref HalfEdgeRow left = ref Rows[h], right = ref Rows[h ^ 1];
        Merges merges = Merges.None;
        if (left.Face >= 0 && Keys[left.Next >> 1] >= Keys[left.Previous >> 1])
            merges |= Merges.LeftNextStays;
        if (right.Face >= 0 && Keys[right.Next >> 1] > Keys[right.Previous >> 1])
            merges |= Merges.RightNextStays;
        return merges;
    }

    /// <summary>Removes the face to the left of a half-edge and joins its two other edges; or takes the half-edge out of its border.</summary>
    /// <returns>A half-edge that leaves the kept vertex; −1 if the half-edge was on a border.</returns>
    private int RemoveSide(int h, bool nextStays)
    {
        UncheckedArray<HalfEdgeRow> rows = Rows;
        HalfEdgeRow row = rows[h];
        if (row.Face < 0)
        {
            rows[row.Previous].Next = row.Next;
            rows[row.Next].Previous = row.Previous;
            return -1;
        }
        int apex = rows[row.Next].Target;
        HalfEdgeOf[row.Face] = -1;
        if (nextStays)
        {
            if (Outgoing[apex] == row.Previous)
                Outgoing[apex] = row.Next ^ 1;
            TakePlaceOfTwin(row.Next, row.Previous);
            return row.Next;
        }
        if (Outgoing[apex] == (row.Next ^ 1))
            Outgoing[apex] = row.Previous;
        TakePlaceOfTwin(row.Previous, row.Next);
        return row.Previous ^ 1;
    }

    /// <summary>Puts a half-edge where the twin of another was; the other's edge is gone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void TakePlaceOfTwin(int stays, int goes)
    {
        HalfEdgeRow twin = Rows[goes ^ 1];
        ref HalfEdgeRow row = ref Rows[stays];
        row.Next = twin.Next;
        row.Previous = twin.Previous;
        row.Face = twin.Face;
        Rows[twin.Next].Previous = stays;
        Rows[twin.Previous].Next = stays;
        if (twin.Face >= 0)
            HalfEdgeOf[twin.Face] = stays;
        States[goes >> 1] = EdgeState.Deleted;
        Constraints?.Merge(stays >> 1, goes >> 1);
    }

    private void CopyRows(Mesh mesh, int first, int end)
    {
        ReadOnlySpan<int> next = mesh.Next, previous = mesh.Previous, target = mesh.Target, face = mesh.FaceOf;
        for (int h = first; h < end; h++)
        {
            ref HalfEdgeRow row = ref Rows[h];
            row.Next = next[h];
            row.Previous = previous[h];
            row.Target = target[h];
            row.Face = face[h];
            // Blocks are of even length, so both half-edges of an edge are in one.
            States[h >> 1] = row.Next < 0 ? EdgeState.Deleted : EdgeState.Clean;
        }
    }
}

/// <summary>Which edges stay when an edge is contracted and on each side two edges become one.</summary>
[Flags]
internal enum Merges : byte
{
    /// <summary>On both sides the previous half-edge's edge.</summary>
    None = 0,

    /// <summary>On the left, the edge of the half-edge's next.</summary>
    LeftNextStays = 1,

    /// <summary>On the right, the edge of the twin's next.</summary>
    RightNextStays = 2,
}
