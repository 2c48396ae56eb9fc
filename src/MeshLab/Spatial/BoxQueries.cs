using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using MeshLab.Numerics;
using Floats = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>Boxes, and the winding number, which asks for a box that is a line.</summary>
public sealed partial class FaceTree
{
    /// <summary>The faces with a triangle whose bounding box meets the box (touching counts), in index order.</summary>
    /// <param name="box">The box to look in; an empty one meets nothing.</param>
    public int[] FindInBox(BoundingBox box)
    {
        var found = new List<int>();
        foreach (int lane in LanesInBox(box))
            found.Add(FaceOfTriangle(_triangles[lane]));
        found.Sort();
        int kept = 0;
        for (int i = 0; i < found.Count; i++)
        {
            if (i == 0 || found[i] != found[i - 1])
                found[kept++] = found[i];
        }
        return [.. found.Take(kept)];
    }

    /// <summary>How often the surface winds around a point (环绕数): 1 inside a closed surface with outward normals, 0 outside.</summary>
    /// <remarks>
    /// The signed crossings of the ray from the point in direction +z, decided exactly. Rays through edges and vertices count once. A
    /// point of the surface itself gets the number of one of its sides. On open meshes the number depends on the direction and says little.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The point is not finite.</exception>
    public int WindingNumber(Vector3D point)
    {
        ThrowIfNotFinite(point);
        int winding = 0;
        foreach (int lane in LanesInBox(new(point, point with { Z = double.PositiveInfinity })))
        {
            (Vector3D a, Vector3D b, Vector3D c) = TriangleAt(lane);
            int turn = Crossing(point, a, b) + Crossing(point, b, c) + Crossing(point, c, a);
            // Seen from above counter-clockwise (turn 1), the triangle is above the point if the point is behind it.
            if (turn != 0 && ExactPredicates.Orient3D(a, b, c, point) == -turn)
                winding += turn;
        }
        return winding;
    }

    /// <summary>Whether a point is inside a closed surface: its winding number is not zero.</summary>
    /// <inheritdoc cref="WindingNumber"/>
    public bool Contains(Vector3D point) => WindingNumber(point) != 0;

    // Whether the edge, seen from above, crosses the line from the point towards +x, upward (1) or downward (−1). The lower end belongs to
    // the edge, the upper one does not, so the crossings around a triangle add up to its winding number, and neighbours never both count.
    private static int Crossing(Vector3D p, Vector3D from, Vector3D to)
    {
        if (from.Y <= p.Y == to.Y <= p.Y)
            return 0;
        bool upward = from.Y <= p.Y;
        (Vector3D low, Vector3D high) = upward ? (from, to) : (to, from);
        // Always from the lower to the upper end, so that both faces of an edge get the same answer.
        bool leftOfEdge = ExactPredicates.Orient2D(low.X, low.Y, high.X, high.Y, p.X, p.Y) > 0;
        return !leftOfEdge ? 0 : upward ? 1 : -1;
    }

    // The places among the leaves of the triangles whose boxes meet the box, in the tree's order.
    private List<int> LanesInBox(BoundingBox box)
    {
        var lanes = new List<int>();
        if (_triangles.Length == 0 || box.IsEmpty)
            return lanes;
        Vector3D center = _frame.Center;
        Floats lowX = Vector256.Create(_frame.BelowClamped(box.Min.X, center.X)), highX = Vector256.Create(_frame.AboveClamped(box.Max.X, center.X));
        Floats lowY = Vector256.Create(_frame.BelowClamped(box.Min.Y, center.Y)), highY = Vector256.Create(_frame.AboveClamped(box.Max.Y, center.Y));
        Floats lowZ = Vector256.Create(_frame.BelowClamped(box.Min.Z, center.Z)), highZ = Vector256.Create(_frame.AboveClamped(box.Max.Z, center.Z));
        Span<int> stack = stackalloc int[StackSize];
        int waiting = 1;
        stack[0] = 0;
        while (waiting > 0)
        {
            int child = stack[--waiting];
            if (child >= 0)
            {
                uint met = Overlaps(ref _boxes[NodeFloats * child], lowX, lowY, lowZ, highX, highY, highZ);
                while (met != 0)
                {
                    stack[waiting++] = _children[Width * child + BitOperations.TrailingZeroCount(met)];
                    met &= met - 1;
                }
                continue;
            }
            for (int k = 0; k < LeafSize; k++)
            {
                int lane = LeafSize * ~child + k;
                if (k > 0 && _triangles[lane] == _triangles[lane - 1])
                    break;
                (Vector3D a, Vector3D b, Vector3D c) = TriangleAt(lane);
                Vector3D min = Vector3D.Min(Vector3D.Min(a, b), c), max = Vector3D.Max(Vector3D.Max(a, b), c);
                if (min.X <= box.Max.X && min.Y <= box.Max.Y && min.Z <= box.Max.Z && max.X >= box.Min.X && max.Y >= box.Min.Y && max.Z >= box.Min.Z)
                    lanes.Add(lane);
            }
        }
        return lanes;
    }

    // Which children's boxes meet the box, as bits. Missing children are inside out and never do.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Overlaps(ref float box, Floats lowX, Floats lowY, Floats lowZ, Floats highX, Floats highY, Floats highZ)
    {
        Floats met = Vector256.LessThanOrEqual(Vector256.LoadUnsafe(ref box), highX)
            & Vector256.LessThanOrEqual(Vector256.LoadUnsafe(ref box, Width), highY)
            & Vector256.LessThanOrEqual(Vector256.LoadUnsafe(ref box, 2 * Width), highZ)
            & Vector256.GreaterThanOrEqual(Vector256.LoadUnsafe(ref box, 3 * Width), lowX)
            & Vector256.GreaterThanOrEqual(Vector256.LoadUnsafe(ref box, 4 * Width), lowY)
            & Vector256.GreaterThanOrEqual(Vector256.LoadUnsafe(ref box, 5 * Width), lowZ);
        return met.ExtractMostSignificantBits();
    }
}
