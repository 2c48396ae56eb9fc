using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>One contraction, as the working mesh did it.</summary>
/// <param name="HalfEdge">The half-edge from the removed vertex to the kept one.</param>
/// <param name="Merges">Which edges stayed.</param>
/// <param name="Position">Where the kept vertex went, in working units.</param>
/// <param name="Traits">How much the log of traits held before.</param>
internal readonly record struct CollapseStep(int HalfEdge, Merges Merges, Vector3D Position, TraitLogMark Traits);

/// <summary>Hears of every contraction before it is done.</summary>
internal abstract class CollapseLog
{
    public abstract void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges);
}

/// <summary>Keeps all contractions.</summary>
/// <param name="traits">The log of what the contractions do to traits, if any; it hears of them itself.</param>
internal sealed class StepLog(TraitLog? traits) : CollapseLog
{
    public List<CollapseStep> Steps { get; } = [];

    public override void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges) => 
        Steps.Add(new(h, merges, position, traits?.Mark ?? default));
}

/// <summary>Tells several.</summary>
internal sealed class LogGroup(CollapseLog[] logs) : CollapseLog
{
    public static CollapseLog? Of(params CollapseLog?[] logs)
    {
        CollapseLog[] present = [.. logs.OfType<CollapseLog>()];
        return present.Length switch
        {
            0 => null,
            1 => present[0],
            _ => new LogGroup(present),
        };
    }

    public override void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges)
    {
        foreach (CollapseLog log in logs)
            log.BeforeCollapse(mesh, h, position, merges);
    }
}

/// <summary>How much a <see cref="TraitLog"/> holds.</summary>
internal readonly record struct TraitLogMark(int Vertices, int Corners, int Edges);

/// <summary>Writes what contractions do to traits down as copies and mixtures, so that the mesh itself stays untouched until all is done.</summary>
internal sealed class TraitLog : CollapseLog
{
    private readonly bool hasVertexTraits;
    private readonly bool hasCornerTraits;
    private readonly bool hasEdgeTraits;
    private readonly List<(int To, int First, int Second, double T)> vertices = [];
    private readonly List<(int To, int First, int Second, double T)> corners = [];
    private readonly List<(int To, int Other)> edges = [];

    private TraitLog(Mesh mesh)
    {
        hasVertexTraits = mesh.VertexTraits.Count > 0;
        hasCornerTraits = mesh.HalfEdgeTraits.Count > 0;
        hasEdgeTraits = mesh.EdgeTraits.Count > 0;
    }

    /// <summary>A log for the mesh's traits; <see langword="null"/> if it has none that contractions change.</summary>
    public static TraitLog? For(Mesh mesh) =>
        mesh.VertexTraits.Count + mesh.HalfEdgeTraits.Count + mesh.EdgeTraits.Count > 0 ? new TraitLog(mesh) : null;

    public override void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges)
    {
        int u = mesh.Rows[h ^ 1].Target, v = mesh.Rows[h].Target;
        double t = Parameter(mesh.Positions[u], mesh.Positions[v], position);
        if (hasVertexTraits)
            vertices.Add((v, u, v, t));
        if (hasCornerTraits)
            MixCorners(mesh, h, t);
        NoteMerge(mesh, h, (merges & Merges.LeftNextStays) != Merges.None);
        NoteMerge(mesh, h ^ 1, (merges & Merges.RightNextStays) != Merges.None);
    }

    /// <summary>How much was written down so far: a mark for <see cref="Apply(TraitLogMark, TraitLogMark, IReadOnlyList{TraitDelta})"/>.</summary>
    public TraitLogMark Mark => new(vertices.Count, corners.Count, edges.Count);

    /// <summary>Does what was written down between two marks, and notes what was there before.</summary>
    public void Apply(TraitLogMark from, TraitLogMark to, IReadOnlyList<TraitDelta> deltas)
    {
        foreach (TraitDelta delta in deltas)
        {
            Trait trait = delta.Trait;
            switch (trait.Kind)
            {
                case ElementKind.Vertex:
                    for (int i = from.Vertices; i < to.Vertices; i++)
                    {
                        delta.Note(vertices[i].To);
                        trait.Mix(vertices[i].To, vertices[i].First, vertices[i].Second, vertices[i].T);
                    }
                    break;
                case ElementKind.HalfEdge:
                    for (int i = from.Corners; i < to.Corners; i++)
                    {
                        delta.Note(corners[i].To);
                        Mix(trait, corners[i]);
                    }
                    break;
                case ElementKind.Edge:
                    for (int i = from.Edges; i < to.Edges; i++)
                    {
                        delta.Note(edges[i].To);
                        trait.Mix(edges[i].To, edges[i].To, edges[i].Other, 0.5);
                    }
                    break;
            }
        }
    }

    /// <summary>Does to the traits of a mesh with the same slots all that was written down, in order.</summary>
    public void Apply(Mesh mesh)
    {
        foreach (Trait trait in mesh.VertexTraits)
        {
            foreach (var (to, first, second, t) in vertices)
                trait.Mix(to, first, second, t);
        }
        foreach (Trait trait in mesh.HalfEdgeTraits)
        {
            foreach (var corner in corners)
                Mix(trait, corner);
        }
        foreach (Trait trait in mesh.EdgeTraits)
        {
            foreach (var (to, other) in edges)
                trait.Mix(to, to, other, 0.5);
        }
    }

    private static void Mix(Trait trait, (int To, int First, int Second, double T) corner)
    {
        if (corner.First == corner.Second)
            trait.Copy(corner.First, corner.To);
        else
            trait.Mix(corner.To, corner.First, corner.Second, corner.T);
    }

    /// <summary>Where between two ends a position lies: 0 at the first, 1 at the second.</summary>
    public static double Parameter(Vector3D a, Vector3D b, Vector3D position)
    {
        Vector3D edge = b - a;
        double squared = edge.LengthSquared;
        return squared > 0 ? Math.Clamp(Vector3D.Dot(position - a, edge) / squared, 0, 1) : 0.5;
    }

    /// <summary>All corners at the two ends that are on one side of a seam get the same mixture: of the two corners beside the edge on that side.</summary>
    private void MixCorners(WorkingMesh mesh, int h, double t)
    {
        UncheckedArray<HalfEdgeRow> rows = mesh.Rows;
        int o = h ^ 1;
        bool hasLeft = rows[h].Face >= 0, hasRight = rows[o].Face >= 0;
        // The corners (at u, at v) of either side; a border has one side only.
        (int U, int V) left = hasLeft ? (rows[h].Previous, h) : (o, rows[o].Previous);
        (int U, int V) right = hasRight ? (o, rows[o].Previous) : left;
        MixAround(mesh, h, right, left, t, atSource: true);
        MixAround(mesh, o, left, right, t, atSource: false);
    }

    private void MixAround(WorkingMesh mesh, int h, (int U, int V) first, (int U, int V) afterLine, double t, bool atSource)
    {
        // An end that stays where it is keeps its corners, also those beyond other seams.
        if (atSource ? t == 0 : t == 1)
            return;
        UncheckedArray<HalfEdgeRow> rows = mesh.Rows;
        int leftFace = rows[h].Face, rightFace = rows[h ^ 1].Face;
        (int U, int V) side = first;
        for (int g = rows[h ^ 1].Next; g != h; g = rows[g ^ 1].Next)
        {
            if (mesh.Constraints is { } constraints && constraints.IsSpecial(g >> 1))
                side = afterLine;
            int corner = g ^ 1, face = rows[corner].Face;
            if (face >= 0 && face != leftFace && face != rightFace)
                corners.Add((corner, side.U, side.V, t));
        }
    }

    private void NoteMerge(WorkingMesh mesh, int h, bool nextStays)
    {
        HalfEdgeRow row = mesh.Rows[h];
        if (row.Face < 0)
            return;
        (int stays, int goes) = nextStays ? (row.Next, row.Previous) : (row.Previous, row.Next);
        if (hasCornerTraits)
            corners.Add((stays, goes ^ 1, goes ^ 1, 0));
        if (hasEdgeTraits)
            edges.Add((stays >> 1, goes >> 1));
    }
}
