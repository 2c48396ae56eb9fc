using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Spatial;

namespace MeshLab.FiveSixSeven;

/// <summary>The input as it was, scaled to a box with unit diagonal about the origin: to project onto, and to measure distances from.</summary>
internal sealed class InputSurface
{
    private readonly FaceTree tree;
    private readonly FaceTree? lines;
    private readonly Vector3D[] positions;
    private readonly int[] corners;

    public InputSurface(Vector3D[] positions, int[] corners, List<(int A, int B)> creases)
    {
        this.positions = positions;
        this.corners = corners;
        tree = FaceTree.Build(positions, corners);
        // A line is a tree of triangles without width.
        if (creases.Count > 0)
            lines = FaceTree.Build(positions, [.. creases.SelectMany(e => new[] { e.A, e.B, e.B })]);
    }

    private InputSurface(InputSurface other) => (positions, corners, tree, lines) = (other.positions, other.corners, other.tree, other.lines);

    /// <summary>The same surface with a hint of its own, without any.</summary>
    public InputSurface Fork() => new(this);

    /// <summary>The triangle found last: the next query is mostly near it.</summary>
    public int Hint { get; set; } = -1;

    public double Area
    {
        get
        {
            double sum = 0;
            for (int c = 0; c < corners.Length; c += 3)
                sum += Shape.AreaNormal(positions[corners[c]], positions[corners[c + 1]], positions[corners[c + 2]]).Length / 2;
            return sum;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public Vector3D Project(Vector3D p)
    {
        double bound = double.PositiveInfinity;
        Vector3D nearest = p;
        if (Hint >= 0)
        {
            nearest = OnTriangle(p, Hint);
            bound = Vector3D.DistanceSquared(p, nearest);
        }
        ClosestPoint found = tree.FindClosest(p, bound);
        if (found.IsNone)
            return nearest;
        Hint = found.Triangle;
        return found.Point;
    }

    public Vector3D ProjectToLines(Vector3D p) => lines is null ? p : lines.FindClosest(p).Point;

    /// <summary>Whether the surface is nearer than a distance.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public bool IsNear(Vector3D p, double distance)
    {
        if (double.IsPositiveInfinity(distance))
            return true;
        if (Hint >= 0 && SquaredFromTriangle(p, Hint) < distance * distance)
            return true;
        int triangle = tree.FindTriangleWithin(p, distance);
        if (triangle < 0)
            return false;
        Hint = triangle;
        return true;
    }

    private double SquaredFromTriangle(Vector3D p, int triangle) => TriangleMath.ClosestDistanceSquared(
        p, positions[corners[3 * triangle]], positions[corners[3 * triangle + 1]], positions[corners[3 * triangle + 2]], out _);

    private Vector3D OnTriangle(Vector3D p, int triangle) => TriangleMath.ClosestPoint(
        p, positions[corners[3 * triangle]], positions[corners[3 * triangle + 1]], positions[corners[3 * triangle + 2]]);
}
