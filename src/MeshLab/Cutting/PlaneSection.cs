using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>One line of a section (截面线).</summary>
/// <param name="Points">In order, no two in a row equal; counter-clockwise seen from above around the inside of the solid. A closed one does not repeat its first point.</param>
/// <param name="IsClosed">Whether the last point joins the first.</param>
/// <param name="Length">In model units.</param>
/// <param name="Area">The signed area that a closed one bounds: positive for outlines, negative for holes; 0 for open ones.</param>
/// <param name="Parent">The number of the smallest closed line around it; −1 if there is none.</param>
/// <param name="Depth">How many closed lines lie around it.</param>
public sealed record SectionPolyline(IReadOnlyList<Vector3D> Points, bool IsClosed, double Length, double Area, int Parent, int Depth);

/// <summary>The section of a mesh with a plane.</summary>
/// <param name="Plane">The plane.</param>
/// <param name="Polylines">Open chains first, then closed ones, each in order of their lowest edge.</param>
/// <param name="Segments">The faces crossed: one segment each, also where it has no length.</param>
public sealed record PlaneSectionResult(CuttingPlane Plane, IReadOnlyList<SectionPolyline> Polylines, int Segments)
{
    /// <summary>The length of all lines.</summary>
    public double Length => Polylines.Sum(line => line.Length);

    /// <summary>The area of the solid's section; <see langword="null"/> if a line is open.</summary>
    public double? Area => OpenChains == 0 ? Math.Abs(Polylines.Sum(line => line.Area)) : null;

    /// <summary>The number of closed lines.</summary>
    public int ClosedLoops => Polylines.Count(line => line.IsClosed);

    /// <summary>The number of open lines.</summary>
    public int OpenChains => Polylines.Count(line => !line.IsClosed);
}

/// <summary>§6.2 沿平面切割: the line in which a plane meets a triangle mesh.</summary>
/// <remarks>
/// Vertices on the plane (or within the tolerance) count as above, so that every triangle is crossed in two edges or none and the lines need no
/// special cases: faces in the plane belong to the part above, and the line runs around them. Points that fall together in a vertex are one
/// point; a line that shrinks to a point is left out. O(V + E), plus the lines; nested lines are found by counting crossings of a ray.
/// </remarks>
public static class PlaneSection
{
    extension(Mesh mesh)
    {
        /// <summary>Cuts the mesh by the plane and returns the lines; a plane that misses it gives none.</summary>
        /// <param name="plane">The plane.</param>
        /// <param name="tolerance">Vertices within this distance count as on the plane.</param>
        /// <exception cref="ArgumentException">A face is not a triangle, or the plane has no normal.</exception>
        public PlaneSectionResult ComputeSection(CuttingPlane plane, double tolerance = 0)
        {
            PlaneCrossings.Check(mesh, plane, tolerance);
            var crossings = PlaneCrossings.Find(mesh, PlaneCrossings.Distances(mesh, plane, tolerance), 1, touchingIsInside: true);
            var lines = new List<SectionPolyline>();
            foreach (PlaneCrossings.Chain chain in crossings.Chains)
            {
                Vector3D[] points = Points(crossings, chain);
                if (points.Length > 1)
                    lines.Add(new(points, chain.IsClosed, LengthOf(points, chain.IsClosed), chain.IsClosed ? AreaOf(points, plane) : 0, -1, 0));
            }
            Nest(lines, plane);
            return new(plane, lines, crossings.FaceCount);
        }
    }

    private static Vector3D[] Points(PlaneCrossings crossings, PlaneCrossings.Chain chain)
    {
        var points = new List<Vector3D>(chain.Leaving.Length);
        foreach (int h in chain.Leaving)
        {
            Vector3D p = crossings.PointOn(h);
            if (points.Count == 0 || points[^1] != p)
                points.Add(p);
        }
        if (chain.IsClosed && points.Count > 1 && points[0] == points[^1])
            points.RemoveAt(points.Count - 1);
        return [.. points];
    }

    private static double LengthOf(Vector3D[] points, bool closed)
    {
        double length = closed ? Vector3D.Distance(points[^1], points[0]) : 0;
        for (int i = 1; i < points.Length; i++)
            length += Vector3D.Distance(points[i - 1], points[i]);
        return length;
    }

    private static double AreaOf(Vector3D[] points, CuttingPlane plane)
    {
        Vector3D sum = default;
        for (int i = 1; i + 1 < points.Length; i++)
            sum += Vector3D.Cross(points[i] - points[0], points[i + 1] - points[0]);
        return Vector3D.Dot(sum, plane.Normal) / 2;
    }

    /// <summary>Finds what lies within what: a line lies within a closed one if its points do, those on the rim apart.</summary>
    private static void Nest(List<SectionPolyline> lines, CuttingPlane plane)
    {
        (Vector3D x, Vector3D y) = plane.Axes();
        Vector2D[][] flat = [.. lines.Select(line => line.Points.Select(p => new Vector2D(Vector3D.Dot(p, x), Vector3D.Dot(p, y))).ToArray())];
        for (int i = 0; i < lines.Count; i++)
        {
            int depth = 0, parent = -1;
            for (int j = 0; j < lines.Count; j++)
            {
                if (j == i || !lines[j].IsClosed || (lines[i].IsClosed && Math.Abs(lines[j].Area) <= Math.Abs(lines[i].Area)) || !PlanarPolygons.Holds(flat[j], flat[i]))
                    continue;
                depth++;
                if (parent < 0 || Math.Abs(lines[j].Area) < Math.Abs(lines[parent].Area))
                    parent = j;
            }
            lines[i] = lines[i] with { Parent = parent, Depth = depth };
        }
    }
}
