using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 以面为中心 (face set): three coordinates per triangle and nothing else, as in an STL file.</summary>
/// <remarks>
/// 72 bytes per triangle. Whether two triangles meet can only be told by comparing coordinates, so every query of adjacency looks at all of them:
/// O(F). Isolated vertices are lost, and vertices at equal places become one.
/// </remarks>
public sealed class FaceSet
{
    /// <summary>Takes the corners without copying.</summary>
    /// <param name="corners">Three positions per triangle, counter-clockwise seen from outside.</param>
    /// <exception cref="ArgumentException">The number of corners is not a multiple of three.</exception>
    public FaceSet(Vector3D[] corners)
    {
        ArgumentNullException.ThrowIfNull(corners);
        if (corners.Length % 3 != 0)
            throw new ArgumentException($"{corners.Length} corners are not a whole number of triangles.", nameof(corners));
        Corners = corners;
    }

    /// <summary>Three positions per triangle.</summary>
    public Vector3D[] Corners { get; }

    /// <summary>The number of triangles.</summary>
    public int FaceCount => Corners.Length / 3;

    /// <summary>The memory of the corners in bytes.</summary>
    public long Bytes => 24L * Corners.Length;

    /// <summary>The triangles of a mesh in order. O(F).</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static FaceSet FromMesh(Mesh mesh)
    {
        mesh = Source.CompactTriangles(mesh);
        var corners = new Vector3D[3 * mesh.Faces.Count];
        int c = 0;
        foreach (Face f in mesh.Faces)
        {
            foreach (Vertex v in f.Vertices)
                corners[c++] = v.Position;
        }
        return new(corners);
    }

    /// <summary>Finds equal corners (by their bits, with −0 as 0) and makes a mesh; vertices are numbered by first appearance. O(F) expected.</summary>
    /// <exception cref="TopologyException">The triangles do not make an oriented 2-manifold.</exception>
    public Mesh ToMesh()
    {
        var number = new Dictionary<Vector3D, int>(Corners.Length / 4);
        var positions = new List<Vector3D>();
        var corners = new int[Corners.Length];
        for (int c = 0; c < corners.Length; c++)
        {
            if (!number.TryGetValue(Corners[c], out corners[c]))
            {
                number[Corners[c]] = corners[c] = positions.Count;
                positions.Add(Corners[c]);
            }
        }
        return MeshBuilder.FromTriangles(positions.ToArray(), corners);
    }

    /// <summary>The corners of a triangle. O(1).</summary>
    public ReadOnlySpan<Vector3D> Triangle(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return Corners.AsSpan(3 * face, 3);
    }

    /// <summary>The triangles with a corner at a place. O(F).</summary>
    public int[] FacesAround(Vector3D place)
    {
        var found = new List<int>();
        for (int f = 0; f < FaceCount; f++)
        {
            if (Triangle(f).Contains(place))
                found.Add(f);
        }
        return [.. found];
    }

    /// <summary>The triangles that share two corners with a triangle. O(F).</summary>
    public int[] FacesBeside(int face)
    {
        ReadOnlySpan<Vector3D> own = Triangle(face);
        var found = new List<int>();
        for (int f = 0; f < FaceCount; f++)
        {
            int common = 0;
            foreach (Vector3D corner in Triangle(f))
            {
                if (own.Contains(corner))
                    common++;
            }
            if (f != face && common >= 2)
                found.Add(f);
        }
        return [.. found];
    }
}
