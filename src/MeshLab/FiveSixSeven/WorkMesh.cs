using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>How freely a vertex may move and vanish.</summary>
internal static class VertexKind
{
    /// <summary>Anywhere on the surface.</summary>
    public const int Smooth = 0;

    /// <summary>Along a line of creases or of the boundary.</summary>
    public const int OnCrease = 1;

    /// <summary>Not at all.</summary>
    public const int Corner = 2;
}

/// <summary>A triangle mesh on plain columns, for walks that are mostly taken back: valences, creases and quadrics are kept up by every
/// operation, and a journal undoes to any mark.</summary>
/// <remarks>Columns and numbering of half-edges are those of <see cref="Mesh"/>. A deleted half-edge has target −1, a deleted vertex outgoing −1,
/// a deleted face half-edge −1. The outgoing half-edge of a boundary vertex may be any.</remarks>
internal sealed partial class WorkMesh
{
    public int[] Next = [];
    public int[] Previous = [];
    public int[] Target = [];
    public int[] Face = [];
    public int[] Crease = [];
    public int[] Outgoing = [];
    public int[] Valence = [];
    public int[] OnRim = [];
    public int[] Kind = [];
    public int[] HalfEdgeOf = [];
    public Vector3D[] Positions = [];
    public Quadric[] Quadrics = [];

    private int[] stamps = [];
    private int stamp;

    private WorkMesh()
    {
    }

    public int VertexSlots { get; private set; }

    public int EdgeSlots { get; private set; }

    public int FaceSlots { get; private set; }

    public int LiveFaces { get; private set; }

    /// <summary>Φ = Σ over inner vertices of max(0, 5 − val)² + max(0, val − 7)²: zero means a 5-6-7 mesh.</summary>
    public long Penalty { get; private set; }

    /// <summary>From a compact triangle mesh without isolated vertices.</summary>
    public static WorkMesh From(Mesh mesh)
    {
        var work = new WorkMesh
        {
            Next = mesh.Next.ToArray(),
            Previous = mesh.Previous.ToArray(),
            Target = mesh.Target.ToArray(),
            Face = mesh.FaceOf.ToArray(),
            Outgoing = mesh.Outgoing.ToArray(),
            HalfEdgeOf = mesh.HalfEdgeOf.ToArray(),
            Positions = mesh.Positions.ToArray(),
            VertexSlots = mesh.VertexSlots,
            EdgeSlots = mesh.EdgeSlots,
            FaceSlots = mesh.FaceSlots,
            LiveFaces = mesh.FaceSlots,
        };
        work.Crease = new int[work.EdgeSlots];
        work.Valence = new int[work.VertexSlots];
        work.OnRim = new int[work.VertexSlots];
        work.Kind = new int[work.VertexSlots];
        work.Quadrics = new Quadric[work.VertexSlots];
        for (int h = 0; h < work.Target.Length; h++)
        {
            work.Valence[work.Target[h]]++;
            if (work.Face[h] < 0)
                work.OnRim[work.Target[h]] = 1;
        }
        for (int v = 0; v < work.VertexSlots; v++)
            work.Penalty += PenaltyOf(work.Valence[v], work.OnRim[v]);
        work.GatherQuadrics();
        return work;
    }

    public bool IsLiveVertex(int v) => Outgoing[v] >= 0;

    public bool IsLiveEdge(int e) => Target[2 * e] >= 0;

    public bool IsLiveFace(int f) => HalfEdgeOf[f] >= 0;

    public int Source(int h) => Target[h ^ 1];

    public int Apex(int h) => Target[Next[h]];

    /// <summary>What a vertex adds to Φ. Boundary vertices add nothing, unless they lose their last face.</summary>
    public static int PenaltyOf(int valence, int onRim)
    {
        if (onRim != 0)
            return valence < 2 ? 100 : 0;
        return valence < 5 ? (5 - valence) * (5 - valence) : valence > 7 ? (valence - 7) * (valence - 7) : 0;
    }

    /// <summary>The squared distance from the regular valence: 6 inside, 4 on the boundary.</summary>
    public static int IrregularityOf(int valence, int onRim)
    {
        int d = valence - (onRim != 0 ? 4 : 6);
        return d * d;
    }

    public bool IsBad(int v) => PenaltyOf(Valence[v], OnRim[v]) > 0;

    /// <summary>How Φ changes if the vertex's valence does.</summary>
    public int PenaltyChange(int v, int d) => PenaltyOf(Valence[v] + d, OnRim[v]) - PenaltyOf(Valence[v], OnRim[v]);

    public int IrregularityChange(int v, int d) => IrregularityOf(Valence[v] + d, OnRim[v]) - IrregularityOf(Valence[v], OnRim[v]);

    public int CountBad()
    {
        int bad = 0;
        for (int v = 0; v < VertexSlots; v++)
        {
            if (IsLiveVertex(v) && IsBad(v))
                bad++;
        }
        return bad;
    }

    public double LengthSquared(int e) => Vector3D.DistanceSquared(Positions[Target[2 * e]], Positions[Target[2 * e + 1]]);

    /// <summary>Twice the area times the unit normal of the half-edge's triangle.</summary>
    public Vector3D AreaNormal(int h) => Shape.AreaNormal(Positions[Source(h)], Positions[Target[h]], Positions[Apex(h)]);

    /// <summary>4√3·A/Σl² of a face: 1 if equilateral, 0 if flat.</summary>
    public double QualityOf(int f)
    {
        int h = HalfEdgeOf[f];
        return Shape.Quality(Positions[Source(h)], Positions[Target[h]], Positions[Apex(h)]);
    }

    public double MeanQuality()
    {
        double sum = 0;
        for (int f = 0; f < FaceSlots; f++)
        {
            if (IsLiveFace(f))
                sum += QualityOf(f);
        }
        return sum / Math.Max(1, LiveFaces);
    }

    /// <summary>The half-edge between two vertices, or −1.</summary>
    public int Find(int from, int to)
    {
        int start = Outgoing[from], h = start;
        do
        {
            if (Target[h] == to)
                return h;
            h = Next[h ^ 1];
        }
        while (h != start);
        return -1;
    }

    /// <summary>The corners of the live faces with live vertices renumbered in order.</summary>
    public (Vector3D[] Positions, int[] Corners, int[] Slots) Export()
    {
        var number = new int[VertexSlots];
        var positions = new List<Vector3D>(VertexSlots);
        var slots = new List<int>(VertexSlots);
        for (int v = 0; v < VertexSlots; v++)
        {
            if (!IsLiveVertex(v))
                continue;
            number[v] = positions.Count;
            positions.Add(Positions[v]);
            slots.Add(v);
        }
        var corners = new List<int>(3 * LiveFaces);
        for (int f = 0; f < FaceSlots; f++)
        {
            if (!IsLiveFace(f))
                continue;
            int h = HalfEdgeOf[f];
            corners.AddRange([number[Source(h)], number[Target[h]], number[Apex(h)]]);
        }
        return ([.. positions], [.. corners], [.. slots]);
    }

    /// <summary>Per vertex the sum of its faces' planes, a third of the area each.</summary>
    public void GatherQuadrics()
    {
        Array.Clear(Quadrics);
        for (int f = 0; f < FaceSlots; f++)
        {
            if (!IsLiveFace(f))
                continue;
            int h = HalfEdgeOf[f];
            Vector3D normal = AreaNormal(h);
            double area2 = normal.Length;
            if (area2 <= 0)
                continue;
            normal /= area2;
            double offset = -Vector3D.Dot(normal, Positions[Target[h]]);
            for (int k = 0; k < 3; k++, h = Next[h])
                Quadrics[Target[h]].AddPlane(normal, offset, area2 / 6);
        }
    }

    private int[] FreshStamps(out int current)
    {
        if (stamps.Length < VertexSlots)
            stamps = new int[Outgoing.Length];
        current = ++stamp;
        return stamps;
    }
}

/// <summary>Measures of single triangles.</summary>
internal static class Shape
{
    public static Vector3D AreaNormal(Vector3D a, Vector3D b, Vector3D c) => Vector3D.Cross(b - a, c - a);

    /// <summary>The unit normal, or zero for a degenerate triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static Vector3D Normal(Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D n = Vector3D.Cross(b - a, c - a);
        double length = n.Length;
        return length > 0 ? n / length : default;
    }

    /// <summary>4√3·A/Σl².</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static double Quality(Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D ab = b - a, ac = c - a, bc = c - b;
        double sum = ab.LengthSquared + ac.LengthSquared + bc.LengthSquared;
        return sum > 0 ? 2 * Math.Sqrt(3) * Vector3D.Cross(ab, ac).Length / sum : 0;
    }
}
