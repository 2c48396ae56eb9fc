using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Positions and polygons by index, without any connectivity (共享顶点, §1.3): what files hold and the builder takes.</summary>
public sealed class PolygonSoup
{
    /// <summary>Takes the arrays as they are, without copying.</summary>
    /// <param name="positions">Per vertex.</param>
    /// <param name="faceStart">Per face, where its corners begin in <paramref name="corners"/>; one more entry at the end.</param>
    /// <param name="corners">Vertex indices, face after face, counter-clockwise.</param>
    /// <exception cref="ArgumentException"><paramref name="faceStart"/> does not begin with 0, falls, or does not end with the number of corners.</exception>
    public PolygonSoup(Vector3D[] positions, int[] faceStart, int[] corners)
    {
        ArgumentNullException.ThrowIfNull(positions);
        ArgumentNullException.ThrowIfNull(faceStart);
        ArgumentNullException.ThrowIfNull(corners);
        if (faceStart.Length == 0 || faceStart[0] != 0 || faceStart[^1] != corners.Length)
            throw new ArgumentException("The starts of the faces begin with 0 and end with the number of corners.", nameof(faceStart));
        for (int f = 1; f < faceStart.Length; f++)
        {
            if (faceStart[f] < faceStart[f - 1])
                throw new ArgumentException($"The start of face {f} lies before that of face {f - 1}.", nameof(faceStart));
        }
        Positions = positions;
        FaceStart = faceStart;
        Corners = corners;
    }

    /// <summary>Per vertex, its position.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>Per face, where its corners begin; one more entry at the end.</summary>
    public int[] FaceStart { get; }

    /// <summary>Vertex indices, face after face.</summary>
    public int[] Corners { get; }

    /// <summary>The number of vertices.</summary>
    public int VertexCount => Positions.Length;

    /// <summary>The number of faces.</summary>
    public int FaceCount => FaceStart.Length - 1;

    /// <summary>The vertices of a face.</summary>
    public ReadOnlySpan<int> Face(int face) => Corners.AsSpan(FaceStart[face], FaceStart[face + 1] - FaceStart[face]);

    /// <summary>From lists of vertices per face.</summary>
    public static PolygonSoup From(ReadOnlySpan<Vector3D> positions, IReadOnlyList<int[]> faces)
    {
        ArgumentNullException.ThrowIfNull(faces);
        var start = new int[faces.Count + 1];
        for (int f = 0; f < faces.Count; f++)
            start[f + 1] = start[f] + (faces[f] ?? throw new ArgumentException($"Face {f} is null.", nameof(faces))).Length;
        var corners = new int[start[^1]];
        for (int f = 0; f < faces.Count; f++)
            faces[f].CopyTo(corners, start[f]);
        return new(positions.ToArray(), start, corners);
    }

    /// <summary>From triangles.</summary>
    /// <param name="positions">Per vertex.</param>
    /// <param name="corners">Three vertex indices per triangle.</param>
    /// <exception cref="ArgumentException">The number of corners is not a multiple of three.</exception>
    public static PolygonSoup FromTriangles(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> corners) =>
        new(positions.ToArray(), TriangleStarts(corners.Length, nameof(corners)), corners.ToArray());

    /// <summary>The faces of a mesh in index order, with vertices renumbered in order if some are deleted.</summary>
    public static PolygonSoup From(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        var number = new int[mesh.VertexSlots];
        var positions = new Vector3D[mesh.Vertices.Count];
        int vertices = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            number[v.index] = vertices;
            positions[vertices++] = v.Position;
        }
        var start = new int[mesh.Faces.Count + 1];
        var corners = new int[CountCorners(mesh)];
        int faces = 0, corner = 0;
        foreach (Face f in mesh.Faces)
        {
            foreach (Vertex v in f.Vertices)
                corners[corner++] = number[v.index];
            start[++faces] = corner;
        }
        return new(positions, start, corners);
    }

    internal static int[] TriangleStarts(int corners, string parameter)
    {
        if (corners % 3 != 0)
            throw new ArgumentException($"{corners} corners are not a whole number of triangles.", parameter);
        var start = new int[corners / 3 + 1];
        for (int f = 0; f < start.Length; f++)
            start[f] = 3 * f;
        return start;
    }

    private static int CountCorners(Mesh mesh)
    {
        int corners = 0;
        ReadOnlySpan<int> next = mesh.Next, face = mesh.FaceOf;
        for (int h = 0; h < next.Length; h++)
        {
            if (next[h] >= 0 && face[h] >= 0)
                corners++;
        }
        return corners;
    }
}
