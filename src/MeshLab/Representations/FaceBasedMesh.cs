using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 基于面连接 (face-based connectivity): a vertex knows one face, a triangle its three vertices and three neighbours.</summary>
/// <remarks>
/// <code>
///          v2
///         /  \            Neighbors[3f + k] lies across the side from
///  N2    / f  \   N1      vertex k to vertex k + 1; −1 on the boundary
///       v0 ── v1
///          N0
/// </code>
/// 38 bytes per triangle of a closed mesh. Queries around a vertex turn from face to face: O(valence). There are no edges to carry data.
/// </remarks>
public sealed class FaceBasedMesh : IAdjacencyQueries
{
    private FaceBasedMesh(Vector3D[] positions, int[] faceOf, int[] vertices, int[] neighbors) =>
        (Positions, FaceOf, Vertices, Neighbors) = (positions, faceOf, vertices, neighbors);

    /// <summary>Per vertex, its position.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>Per vertex, one face: the first one counter-clockwise on a boundary; −1 if isolated.</summary>
    public int[] FaceOf { get; }

    /// <summary>Three vertices per face, counter-clockwise.</summary>
    public int[] Vertices { get; }

    /// <summary>Three faces per face, across the sides in order; −1 on the boundary.</summary>
    public int[] Neighbors { get; }

    /// <inheritdoc/>
    public int VertexCount => Positions.Length;

    /// <inheritdoc/>
    public int FaceCount => Vertices.Length / 3;

    /// <inheritdoc/>
    public long Bytes => 24L * VertexCount + 4L * (FaceOf.Length + Vertices.Length + Neighbors.Length);

    /// <summary>The triangles of a mesh in order. O(V + F).</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static FaceBasedMesh FromMesh(Mesh mesh)
    {
        mesh = Source.CompactTriangles(mesh);
        var vertices = new int[3 * mesh.Faces.Count];
        var neighbors = new int[vertices.Length];
        int c = 0;
        foreach (Face f in mesh.Faces)
        {
            foreach (HalfEdge h in f.HalfEdges)
            {
                vertices[c] = h.Source.Index;
                neighbors[c++] = h.Twin.Face.Index;
            }
        }
        var faceOf = new int[mesh.Vertices.Count];
        foreach (Vertex v in mesh.Vertices)
        {
            // A boundary vertex's outgoing half-edge is the last counter-clockwise; the first face lies across the hole.
            HalfEdge h = v.Outgoing;
            faceOf[v.Index] = h.IsNone ? -1 : h.IsBoundary ? h.Previous.Twin.Face.Index : h.Face.Index;
        }
        return new(mesh.Positions.ToArray(), faceOf, vertices, neighbors);
    }

    /// <summary>Makes a mesh with the same order of vertices and faces. O(V + F).</summary>
    /// <exception cref="TopologyException">The arrays were changed and do not make an oriented 2-manifold any more.</exception>
    public Mesh ToMesh() => MeshBuilder.FromTriangles(Positions, Vertices);

    /// <inheritdoc/>
    /// <remarks>O(1).</remarks>
    public int[] FaceVertices(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return Vertices.AsSpan(3 * face, 3).ToArray();
    }

    /// <inheritdoc/>
    /// <remarks>O(1).</remarks>
    public int[] FacesBeside(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return [.. Neighbors.AsSpan(3 * face, 3).ToArray().Where(f => f >= 0)];
    }

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] FacesAround(int vertex)
    {
        Source.CheckIndex(vertex, VertexCount);
        int first = FaceOf[vertex];
        if (first < 0)
            return [];
        var found = new List<int>();
        int f = first;
        do
        {
            found.Add(f);
            f = Neighbors[3 * f + SideInto(f, vertex)];
        }
        while (f >= 0 && f != first);
        return [.. found];
    }

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] NeighborsOf(int vertex)
    {
        int[] faces = FacesAround(vertex);
        var found = new List<int>();
        foreach (int f in faces)
        {
            int side = SideFrom(f, vertex);
            found.Add(Vertices[3 * f + (side + 1) % 3]);
            if (Neighbors[3 * f + SideInto(f, vertex)] < 0)
                found.Add(Vertices[3 * f + (side + 2) % 3]);
        }
        return [.. found];
    }

    /// <summary>The side of the face that leaves the vertex.</summary>
    private int SideFrom(int face, int vertex) => Vertices.AsSpan(3 * face, 3).IndexOf(vertex);

    /// <summary>The side of the face that ends at the vertex.</summary>
    private int SideInto(int face, int vertex) => (SideFrom(face, vertex) + 2) % 3;
}
