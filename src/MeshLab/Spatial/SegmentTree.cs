using MeshLab.Numerics;

namespace MeshLab.Spatial;

/// <summary>The point of a set of segments that is closest to a query point.</summary>
/// <param name="Segment">The segment; −1 if there is none within the bound.</param>
/// <param name="Parameter">Where on it: 0 at its first end, 1 at its second.</param>
/// <param name="Point">Where in space.</param>
/// <param name="DistanceSquared">The squared distance, +∞ if there is none.</param>
public readonly record struct ClosestSegmentPoint(int Segment, double Parameter, Vector3D Point, double DistanceSquared)
{
    /// <summary>Whether there is no such point.</summary>
    public bool IsNone => Segment < 0;

    /// <summary>The distance.</summary>
    public double Distance => Math.Sqrt(DistanceSquared);
}

/// <summary>A bounding volume tree over segments, such as feature lines and boundary curves (特征线).</summary>
/// <remarks>A <see cref="FaceTree"/> of triangles whose last two corners coincide; everything said there holds here.</remarks>
public sealed class SegmentTree
{
    private readonly FaceTree _tree;

    private SegmentTree(FaceTree tree) => _tree = tree;

    /// <summary>Number of segments.</summary>
    public int Count => _tree.TriangleCount;

    /// <summary>The smallest box that holds all segments.</summary>
    public BoundingBox Bounds => _tree.Bounds;

    /// <summary>The tree over segments given as arrays.</summary>
    /// <param name="positions">The vertices.</param>
    /// <param name="ends">Two vertex indices per segment; segments of length zero are allowed.</param>
    /// <exception cref="ArgumentException">The ends are not pairs, name a vertex that is not there, or one with a coordinate that is not finite.</exception>
    public static SegmentTree Build(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> ends)
    {
        if (ends.Length % 2 != 0)
            throw new ArgumentException($"There are {ends.Length} ends; segments need a multiple of two.", nameof(ends));
        var corners = new int[ends.Length / 2 * 3];
        for (int i = 0; i < ends.Length / 2; i++)
        {
            foreach (int v in ends.Slice(2 * i, 2))
            {
                if ((uint)v >= (uint)positions.Length)
                    throw new ArgumentException($"A segment names vertex {v}; there are {positions.Length} vertices.", nameof(ends));
            }
            (corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]) = (ends[2 * i], ends[2 * i + 1], ends[2 * i + 1]);
        }
        return new(FaceTree.Build(positions, corners));
    }

    /// <summary>Whether some point of the segments is within the distance; stops at the first one found.</summary>
    /// <param name="query">The point to start from.</param>
    /// <param name="distance">The largest distance that counts.</param>
    /// <exception cref="ArgumentOutOfRangeException">The query is not finite, or the distance is negative or NaN.</exception>
    public bool IsWithin(Vector3D query, double distance) => _tree.IsWithin(query, distance);

    /// <summary>The point of the segments closest to the query; of equally close segments the one with the lowest index.</summary>
    /// <param name="query">The point to start from.</param>
    /// <param name="maxDistanceSquared">Looks no farther than this (squared).</param>
    /// <exception cref="ArgumentOutOfRangeException">The query is not finite, or the bound is NaN.</exception>
    public ClosestSegmentPoint FindClosest(Vector3D query, double maxDistanceSquared = double.PositiveInfinity)
    {
        ClosestPoint found = _tree.FindClosest(query, maxDistanceSquared);
        return new(found.Triangle, found.Barycentric.Y + found.Barycentric.Z, found.Point, found.DistanceSquared);
    }
}
