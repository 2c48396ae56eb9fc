using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>A mesh of triangles, and where its faces come from.</summary>
/// <param name="Mesh">The triangle mesh: the same vertices; triangles of a face follow one another, in the order of the faces.</param>
/// <param name="FaceOf">Per triangle, the index of the face of the input.</param>
public sealed record TriangulationResult(Mesh Mesh, int[] FaceOf);

/// <summary>三角化 (triangulation): cuts every polygon into triangles by clipping ears in the plane of its vector area.</summary>
/// <remarks>
/// Meisters 1975: a simple polygon with more than three corners has two ears. Of all ears the one with the largest smallest angle goes first, ties
/// by position in the face, so that convex polygons become good triangles too and the result does not depend on anything but the input. A face
/// that is so bent or degenerate that no ear is left is cut as a fan from there on. O(d³) per face of degree d at worst, O(d²) mostly.
/// Vertices keep their indices if none is deleted, their order otherwise.
/// </remarks>
public static class Triangulation
{
    /// <summary>Makes a triangle mesh of a polygon mesh; the input is not changed.</summary>
    /// <param name="mesh">Any mesh. Deleted vertices are left out, so that indices stay only if there are none.</param>
    /// <exception cref="TopologyException">Triangles of two faces would share a diagonal, as on a pillow of two squares; the message names its vertices.</exception>
    public static TriangulationResult Triangulate(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        PolygonSoup soup = PolygonSoup.From(mesh);
        var corners = new List<int>(3 * soup.FaceCount);
        var faceOf = new List<int>(soup.FaceCount);
        int f = 0;
        foreach (Face face in mesh.Faces)
        {
            int before = corners.Count;
            TriangulatePolygon(soup.Positions, soup.Face(f), corners);
            for (int i = before; i < corners.Count; i += 3)
                faceOf.Add(face.Index);
            f++;
        }
        return new(MeshBuilder.FromTriangles(soup.Positions, System.Runtime.InteropServices.CollectionsMarshal.AsSpan(corners)), [.. faceOf]);
    }

    /// <summary>Cuts one polygon in space into triangles over the same vertices.</summary>
    /// <param name="positions">Per vertex.</param>
    /// <param name="polygon">Vertex indices, counter-clockwise.</param>
    /// <param name="corners">Gets three vertex indices per triangle, degree − 2 triangles.</param>
    public static void TriangulatePolygon(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon, ICollection<int> corners)
    {
        ArgumentNullException.ThrowIfNull(corners);
        if (polygon.Length < 3)
            throw new ArgumentException($"A polygon has three or more corners; this has {polygon.Length}.", nameof(polygon));
        Vector2D[] flat = polygon.Length == 3 ? [] : Project(positions, polygon);
        List<int> left = [.. Enumerable.Range(0, polygon.Length)];
        while (left.Count > 3)
        {
            int ear = BestEar(flat, left);
            Emit(corners, polygon, left[(ear + left.Count - 1) % left.Count], left[ear], left[(ear + 1) % left.Count]);
            left.RemoveAt(ear);
        }
        Emit(corners, polygon, left[0], left[1], left[2]);
    }

    /// <summary>The polygon in its own plane, seen from outside.</summary>
    private static Vector2D[] Project(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> polygon)
    {
        Vector3D origin = positions[polygon[0]], normal = default;
        for (int i = 1; i + 1 < polygon.Length; i++)
            normal += Vector3D.Cross(positions[polygon[i]] - origin, positions[polygon[i + 1]] - origin);
        normal = normal.Normalized();
        if (normal == default)
            normal = Vector3D.UnitZ;
        Vector3D x = Vector3D.Cross(Math.Abs(normal.X) < 0.6 ? Vector3D.UnitX : Vector3D.UnitY, normal).Normalized();
        Vector3D y = Vector3D.Cross(normal, x);
        var flat = new Vector2D[polygon.Length];
        for (int i = 0; i < flat.Length; i++)
        {
            Vector3D p = positions[polygon[i]] - origin;
            flat[i] = new(Vector3D.Dot(p, x), Vector3D.Dot(p, y));
        }
        return flat;
    }

    /// <summary>The place in the list of the ear with the largest smallest angle; if there is none, the first.</summary>
    private static int BestEar(Vector2D[] flat, List<int> left)
    {
        int best = 0;
        double bestAngle = 0;
        for (int i = 0; i < left.Count; i++)
        {
            int before = left[(i + left.Count - 1) % left.Count], at = left[i], after = left[(i + 1) % left.Count];
            double angle = SmallestAngle(flat[before], flat[at], flat[after]);
            if (angle > bestAngle && IsEar(flat, left, before, at, after))
            {
                best = i;
                bestAngle = angle;
            }
        }
        return best;
    }

    private static bool IsEar(Vector2D[] flat, List<int> left, int before, int at, int after)
    {
        Vector2D a = flat[before], b = flat[at], c = flat[after];
        foreach (int other in left)
        {
            if (other == before || other == at || other == after)
                continue;
            Vector2D p = flat[other];
            if (Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    /// <summary>In radians; not positive if the corner turns the wrong way.</summary>
    private static double SmallestAngle(Vector2D a, Vector2D b, Vector2D c)
    {
        double turn = Turn(a, b, c);
        if (!(turn > 0))
            return -1;
        Vector3D p = new(a.X, a.Y, 0), q = new(b.X, b.Y, 0), r = new(c.X, c.Y, 0);
        return new Triangle(p, q, r).MinAngle;
    }

    private static double Turn(Vector2D a, Vector2D b, Vector2D c) => (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);

    private static void Emit(ICollection<int> corners, ReadOnlySpan<int> polygon, int a, int b, int c)
    {
        corners.Add(polygon[a]);
        corners.Add(polygon[b]);
        corners.Add(polygon[c]);
    }
}
