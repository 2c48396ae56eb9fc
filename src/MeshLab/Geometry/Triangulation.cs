using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>A mesh of triangles, and where its faces come from.</summary>
/// <param name="Mesh">The triangle mesh: the same vertices; triangles of a face follow one another, in the order of the faces.</param>
/// <param name="FaceOf">Per triangle, the index of the face of the input.</param>
public sealed record TriangulationResult(Mesh Mesh, int[] FaceOf);

/// <summary>三角化 (triangulation): cuts every polygon into triangles by clipping ears in the plane of its vector area.</summary>
/// <remarks>
/// Each face by <see cref="PolygonTriangulation"/>: of all ears the one with the largest smallest angle goes first, so that convex polygons become good
/// triangles too and the result does not depend on anything but the input. O(d²) mostly per face of degree d.
/// Vertices keep their indices if none is deleted, their order otherwise. Traits are carried over; diagonals have the default value.
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
            PolygonTriangulation.Triangulate(soup.Positions, soup.Face(f), corners);
            for (int i = before; i < corners.Count; i += 3)
                faceOf.Add(face.Index);
            f++;
        }
        Mesh triangles = MeshBuilder.FromTriangles(soup.Positions, System.Runtime.InteropServices.CollectionsMarshal.AsSpan(corners));
        int[] sourceFace = [.. faceOf];
        PartTraits.Derive(mesh, triangles, [.. mesh.Vertices.Select(v => v.Index)], sourceFace, null, null);
        return new(triangles, sourceFace);
    }
}
