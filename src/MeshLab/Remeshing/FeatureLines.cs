using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>The lines that remeshing keeps: boundaries and features (特征边), with the corners where they end, cross or turn sharply.</summary>
internal sealed class FeatureLines
{
    // A line that turns by more than this at a vertex has a corner there: cos of π − 78°.
    private const double CornerCosine = -0.2;

    // How far an edge may leave the input's lines: a share of the length wanted, but not more than this share of the diagonal.
    private const double ChordTolerance = 0.03, DiagonalTolerance = 4e-4;

    private readonly SegmentTree? _segments;

    private readonly double _chord;

    private FeatureLines(SegmentTree? segments, double chord, int featureEdges, int corners) =>
        (_segments, _chord, FeatureEdges, Corners) = (segments, chord, featureEdges, corners);

    public int FeatureEdges { get; }

    public int Corners { get; }

    /// <summary>Finds the lines of the input and marks them in the surface, whose slots are still the input's.</summary>
    public static FeatureLines Mark(Mesh mesh, RemeshSurface surface, double featureAngle, double length)
    {
        int features = 0, corners = 0;
        var ends = new List<int>();
        for (int h = 0; h < mesh.HalfEdgeSlots; h += 2)
        {
            bool boundary = surface.Face[h] < 0 || surface.Face[h + 1] < 0;
            if (!boundary && !IsSharp(surface, h, featureAngle))
                continue;
            features += boundary ? 0 : 1;
            surface.OnLine[h >> 1] = true;
            surface.LineCount[surface.Target[h]]++;
            surface.LineCount[surface.Target[h + 1]]++;
            ends.AddRange([surface.Target[h + 1], surface.Target[h]]);
        }
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (surface.LineCount[v] == 0)
                continue;
            surface.IsCorner[v] = surface.LineCount[v] != 2 || TurnsSharply(surface, v);
            corners += surface.IsCorner[v] ? 1 : 0;
        }
        SegmentTree? tree = ends.Count == 0 ? null : SegmentTree.Build(mesh.Positions, System.Runtime.InteropServices.CollectionsMarshal.AsSpan(ends));
        return new(tree, Math.Min(ChordTolerance * length, DiagonalTolerance * mesh.BoundingBox.Diagonal), features, corners);
    }

    /// <summary>The point of the input's lines closest to a point.</summary>
    public Vector3D Project(Vector3D point) => _segments is null ? point : _segments.FindClosest(point).Point;

    /// <summary>Whether a straight edge between two points of the lines may stand for the way over a third between them.</summary>
    public bool AllowsChord(Vector3D a, Vector3D b, Vector3D between) =>
        IsNear(a, b) && DistanceSquared(between, a, b) <= _chord * _chord;

    /// <summary>Where a vertex of a line goes: the line's point closest to the place wanted, unless an edge beside it would leave the line more than allowed.</summary>
    public Vector3D Slide(RemeshSurface s, int v, Vector3D place)
    {
        Vector3D old = s.Positions[v], point = Project(place);
        double left = double.PositiveInfinity;
        int start = s.Outgoing[v], h = start;
        do
        {
            if (s.OnLine[h >> 1])
            {
                Vector3D end = s.Positions[s.Target[h]];
                if (!IsNear(point, end))
                    return old;
                left = Math.Min(left, DistanceSquared(old, point, end));
            }
            h = s.Next[h ^ 1];
        }
        while (h != start);
        // The place it leaves must still be close to one of the two edges.
        return left <= _chord * _chord ? point : old;
    }

    private bool IsNear(Vector3D a, Vector3D b) =>
        _segments!.IsWithin((a + b) * 0.5, _chord) && _segments.IsWithin(Vector3D.Lerp(a, b, 0.25), _chord) && _segments.IsWithin(Vector3D.Lerp(a, b, 0.75), _chord);

    private static double DistanceSquared(Vector3D p, Vector3D a, Vector3D b) => TriangleMath.ClosestDistanceSquared(p, a, b, b, out _);

    private static bool IsSharp(RemeshSurface s, int h, double featureAngle)
    {
        if (featureAngle >= Math.PI)
            return false;
        Vector3D n = Normal(s, h), m = Normal(s, h ^ 1);
        // A face without area has no angle; its edges are left free so that it can go.
        return n != default && m != default && Vector3D.Angle(n, m) > featureAngle;
    }

    private static Vector3D Normal(RemeshSurface s, int h)
    {
        Vector3D a = s.Positions[s.Target[h ^ 1]];
        return Vector3D.Cross(s.Positions[s.Target[h]] - a, s.Positions[s.Target[s.Next[h]]] - a);
    }

    private static bool TurnsSharply(RemeshSurface s, int v)
    {
        Vector3D first = default;
        bool second = false;
        int start = s.Outgoing[v], h = start;
        do
        {
            if (s.OnLine[h >> 1])
            {
                Vector3D direction = (s.Positions[s.Target[h]] - s.Positions[v]).Normalized();
                if (second)
                    return Vector3D.Dot(first, direction) > CornerCosine;
                (first, second) = (direction, true);
            }
            h = s.Next[h ^ 1];
        }
        while (h != start);
        return false;
    }
}
