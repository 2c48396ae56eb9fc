using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Spatial;

/// <summary>Whether two triangles of space have a point in common (三角形相交), decided exactly; touching counts.</summary>
/// <remarks>
/// Two triangles meet if and only if an edge of one meets the other: six plane sides reject most pairs, then each edge that is not on one side
/// of the other triangle is tested by three orientations; edges in the plane are tested there. As in Guigue, Devillers 2003. Triangles
/// without area are segments or points and are treated as such.
/// </remarks>
public static class TriangleTriangle
{
    /// <summary>Whether triangles a, b, c and p, q, r have a common point.</summary>
    public static bool Intersect(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D p, in Vector3D q, in Vector3D r)
    {
        int sideP = ExactPredicates.Orient3D(a, b, c, p), sideQ = ExactPredicates.Orient3D(a, b, c, q), sideR = ExactPredicates.Orient3D(a, b, c, r);
        if (SameSide(sideP, sideQ, sideR))
            return false;
        int sideA = ExactPredicates.Orient3D(p, q, r, a), sideB = ExactPredicates.Orient3D(p, q, r, b), sideC = ExactPredicates.Orient3D(p, q, r, c);
        if (SameSide(sideA, sideB, sideC))
            return false;
        if ((sideA | sideB | sideC | sideP | sideQ | sideR) == 0 && PlaneAxis(a, b, c) is >= 0 and var axis && Turn(axis, p, q, r) != 0)
            return !EdgeSeparates(axis, a, b, c, p, q, r) && !EdgeSeparates(axis, p, q, r, a, b, c);
        return SegmentMeets(a, b, sideA, sideB, p, q, r) || SegmentMeets(b, c, sideB, sideC, p, q, r) || SegmentMeets(c, a, sideC, sideA, p, q, r)
            || SegmentMeets(p, q, sideP, sideQ, a, b, c) || SegmentMeets(q, r, sideQ, sideR, a, b, c) || SegmentMeets(r, p, sideR, sideP, a, b, c);
    }

    /// <summary>Whether the segment from a to b and the triangle p, q, r have a common point.</summary>
    public static bool SegmentMeets(in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q, in Vector3D r) =>
        SegmentMeets(a, b, ExactPredicates.Orient3D(p, q, r, a), ExactPredicates.Orient3D(p, q, r, b), p, q, r);

    /// <summary>
    /// Whether two triangles that share the vertex s have more in common than that: the edge opposite to it in one meets the other triangle.
    /// </summary>
    internal static bool IntersectBeyondVertex(in Vector3D s, in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q)
    {
        int sideA = ExactPredicates.Orient3D(s, p, q, a), sideB = ExactPredicates.Orient3D(s, p, q, b);
        if (sideA * sideB > 0)
            return false;
        int sideP = ExactPredicates.Orient3D(s, a, b, p), sideQ = ExactPredicates.Orient3D(s, a, b, q);
        if (sideP * sideQ > 0)
            return false;
        return SegmentMeets(a, b, sideA, sideB, s, p, q) || SegmentMeets(p, q, sideP, sideQ, s, a, b);
    }

    /// <summary>Whether two triangles with the common edge a, b and the tips p and q have more in common than that: both in one plane, on one side.</summary>
    internal static bool IntersectBeyondEdge(in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q)
    {
        if (ExactPredicates.Orient3D(a, b, p, q) != 0)
            return false;
        int axis = PlaneAxis(a, b, p);
        return axis >= 0 && Turn(axis, a, b, p) * Turn(axis, a, b, q) > 0;
    }

    // In a plane: whether p, q, r are beyond one of the edges of a, b, c. If no edge of either triangle separates them, they meet.
    private static bool EdgeSeparates(int axis, in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D p, in Vector3D q, in Vector3D r)
    {
        int outside = -Turn(axis, a, b, c);
        return Beyond(a, b, p, q, r) || Beyond(b, c, p, q, r) || Beyond(c, a, p, q, r);

        bool Beyond(in Vector3D from, in Vector3D to, in Vector3D p, in Vector3D q, in Vector3D r) =>
            Turn(axis, from, to, p) == outside && Turn(axis, from, to, q) == outside && Turn(axis, from, to, r) == outside;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool SameSide(int x, int y, int z) => (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);

    // The sides of a and b of the triangle's plane are known.
    private static bool SegmentMeets(in Vector3D a, in Vector3D b, int sideA, int sideB, in Vector3D p, in Vector3D q, in Vector3D r)
    {
        if (sideA * sideB > 0)
            return false;
        if (sideA == 0 && sideB == 0)
            return SegmentMeetsInPlane(a, b, p, q, r);
        int x = ExactPredicates.Orient3D(a, b, p, q), y = ExactPredicates.Orient3D(a, b, q, r), z = ExactPredicates.Orient3D(a, b, r, p);
        return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
    }

    // All five points are in one plane, or the triangle has no area.
    private static bool SegmentMeetsInPlane(in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q, in Vector3D r)
    {
        int axis = PlaneAxis(p, q, r);
        if (axis < 0)
            return SegmentsMeet(a, b, p, q) || SegmentsMeet(a, b, q, r) || SegmentsMeet(a, b, r, p);
        int turn = Turn(axis, p, q, r);
        return Inside(a, p, q, r) || Inside(b, p, q, r)
            || SegmentsMeetInPlane(axis, a, b, p, q) || SegmentsMeetInPlane(axis, a, b, q, r) || SegmentsMeetInPlane(axis, a, b, r, p);

        bool Inside(in Vector3D x, in Vector3D p, in Vector3D q, in Vector3D r) =>
            Turn(axis, p, q, x) * turn >= 0 && Turn(axis, q, r, x) * turn >= 0 && Turn(axis, r, p, x) * turn >= 0;
    }

    /// <summary>Whether two segments of space have a common point.</summary>
    internal static bool SegmentsMeet(in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q)
    {
        if (ExactPredicates.Orient3D(a, b, p, q) != 0)
            return false;
        int axis = PlaneAxis(a, b, p);
        if (axis < 0)
            axis = PlaneAxis(a, b, q);
        if (axis < 0)
            axis = PlaneAxis(p, q, a);
        if (axis >= 0)
            return SegmentsMeetInPlane(axis, a, b, p, q);
        // All on one line: lexicographic order is order along it.
        return Compare(Larger(a, b), Smaller(p, q)) >= 0 && Compare(Larger(p, q), Smaller(a, b)) >= 0;
    }

    private static bool SegmentsMeetInPlane(int axis, in Vector3D a, in Vector3D b, in Vector3D p, in Vector3D q)
    {
        int abp = Turn(axis, a, b, p), abq = Turn(axis, a, b, q), pqa = Turn(axis, p, q, a), pqb = Turn(axis, p, q, b);
        if (abp * abq > 0 || pqa * pqb > 0)
            return false;
        // On one line: they meet if their intervals do, in both coordinates of the plane.
        return abp != 0 || abq != 0 || pqa != 0 || pqb != 0
            || (Compare(Larger(a, b), Smaller(p, q)) >= 0 && Compare(Larger(p, q), Smaller(a, b)) >= 0);
    }

    // The axis along which the three points can be projected without ending up on a line; −1 if they are on one.
    private static int PlaneAxis(in Vector3D a, in Vector3D b, in Vector3D c)
    {
        Vector3D n = Vector3D.Cross(b - a, c - a);
        double x = Math.Abs(n.X), y = Math.Abs(n.Y), z = Math.Abs(n.Z);
        int likely = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        for (int i = 0; i < 3; i++)
        {
            int axis = (likely + i) % 3;
            if (Turn(axis, a, b, c) != 0)
                return axis;
        }
        return -1;
    }

    private static int Turn(int axis, in Vector3D a, in Vector3D b, in Vector3D c) => axis switch
    {
        0 => ExactPredicates.Orient2D(a.Y, a.Z, b.Y, b.Z, c.Y, c.Z),
        1 => ExactPredicates.Orient2D(a.Z, a.X, b.Z, b.X, c.Z, c.X),
        _ => ExactPredicates.Orient2D(a.X, a.Y, b.X, b.Y, c.X, c.Y),
    };

    private static int Compare(in Vector3D a, in Vector3D b) =>
        a.X != b.X ? (a.X < b.X ? -1 : 1) : a.Y != b.Y ? (a.Y < b.Y ? -1 : 1) : a.Z != b.Z ? (a.Z < b.Z ? -1 : 1) : 0;

    private static Vector3D Larger(in Vector3D a, in Vector3D b) => Compare(a, b) >= 0 ? a : b;

    private static Vector3D Smaller(in Vector3D a, in Vector3D b) => Compare(a, b) <= 0 ? a : b;
}
