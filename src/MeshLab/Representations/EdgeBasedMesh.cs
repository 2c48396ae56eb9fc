using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 基于边连接 (edge-based connectivity): a vertex knows one edge, an edge its two vertices and two faces, a face one edge.</summary>
/// <remarks>
/// <code>
///            v1
///   Left     │e    Right      the left face has the edge from v0 to v1,
///            │                the right one from v1 to v0
///            v0
/// </code>
/// 42 bytes per triangle of a closed mesh. What lies at an edge is known at once; but from one edge of a face or vertex to the next there is no way
/// but to search all edges, O(E): the <see cref="WingedEdgeMesh"/> adds that.
/// </remarks>
public sealed class EdgeBasedMesh : IAdjacencyQueries
{
    private EdgeBasedMesh(Vector3D[] positions, int[] edgeOfVertex, int[] edgeVertices, int[] edgeFaces, int[] edgeOfFace) =>
        (Positions, EdgeOfVertex, EdgeVertices, EdgeFaces, EdgeOfFace) = (positions, edgeOfVertex, edgeVertices, edgeFaces, edgeOfFace);

    /// <summary>Per vertex, its position.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>Per vertex, one edge; −1 if isolated.</summary>
    public int[] EdgeOfVertex { get; }

    /// <summary>Two vertices per edge.</summary>
    public int[] EdgeVertices { get; }

    /// <summary>Two faces per edge, left and right; −1 for a hole.</summary>
    public int[] EdgeFaces { get; }

    /// <summary>Per face, the edge that leaves its first vertex.</summary>
    public int[] EdgeOfFace { get; }

    /// <inheritdoc/>
    public int VertexCount => Positions.Length;

    /// <summary>The number of edges.</summary>
    public int EdgeCount => EdgeVertices.Length / 2;

    /// <inheritdoc/>
    public int FaceCount => EdgeOfFace.Length;

    /// <inheritdoc/>
    public long Bytes => 24L * VertexCount + 4L * (EdgeOfVertex.Length + EdgeVertices.Length + EdgeFaces.Length + EdgeOfFace.Length);

    /// <summary>The elements of a mesh in order. O(V + E + F).</summary>
    public static EdgeBasedMesh FromMesh(Mesh mesh)
    {
        mesh = Source.Compact(mesh);
        var edgeVertices = new int[2 * mesh.Edges.Count];
        var edgeFaces = new int[edgeVertices.Length];
        foreach (Edge e in mesh.Edges)
        {
            (edgeVertices[2 * e.Index], edgeVertices[2 * e.Index + 1]) = (e.HalfEdge0.Source.Index, e.HalfEdge0.Target.Index);
            (edgeFaces[2 * e.Index], edgeFaces[2 * e.Index + 1]) = (e.HalfEdge0.Face.Index, e.HalfEdge1.Face.Index);
        }
        var edgeOfVertex = new int[mesh.Vertices.Count];
        foreach (Vertex v in mesh.Vertices)
            edgeOfVertex[v.Index] = v.IsIsolated ? -1 : v.Outgoing.Edge.Index;
        var edgeOfFace = new int[mesh.Faces.Count];
        foreach (Face f in mesh.Faces)
            edgeOfFace[f.Index] = f.HalfEdge.Edge.Index;
        return new(mesh.Positions.ToArray(), edgeOfVertex, edgeVertices, edgeFaces, edgeOfFace);
    }

    /// <summary>Makes a mesh with the same order of vertices, faces and corners. O(V + E + F) for faces of bounded degree.</summary>
    /// <exception cref="TopologyException">The arrays were changed and do not make an oriented 2-manifold any more.</exception>
    public Mesh ToMesh()
    {
        int[][] edgesOf = EdgesByFace();
        var faces = new int[FaceCount][];
        for (int f = 0; f < faces.Length; f++)
            faces[f] = Chain(f, edgesOf[f]);
        return MeshBuilder.FromPolygons(Positions, faces);
    }

    /// <summary>The two vertices of an edge. O(1).</summary>
    public (int V0, int V1) VerticesOf(int edge)
    {
        Source.CheckIndex(edge, EdgeCount);
        return (EdgeVertices[2 * edge], EdgeVertices[2 * edge + 1]);
    }

    /// <summary>The faces beside an edge, −1 for a hole. O(1).</summary>
    public (int Left, int Right) FacesOf(int edge)
    {
        Source.CheckIndex(edge, EdgeCount);
        return (EdgeFaces[2 * edge], EdgeFaces[2 * edge + 1]);
    }

    /// <inheritdoc/>
    /// <remarks>O(E).</remarks>
    public int[] FaceVertices(int face) => Chain(face, EdgesOfFace(face));

    /// <inheritdoc/>
    /// <remarks>O(E).</remarks>
    public int[] FacesBeside(int face) =>
        [.. EdgesOfFace(face).Select(e => EdgeFaces[2 * e] == face ? EdgeFaces[2 * e + 1] : EdgeFaces[2 * e]).Where(f => f >= 0).Distinct()];

    /// <inheritdoc/>
    /// <remarks>O(E).</remarks>
    public int[] FacesAround(int vertex) =>
        [.. EdgesAround(vertex).SelectMany(e => new[] { EdgeFaces[2 * e], EdgeFaces[2 * e + 1] }).Where(f => f >= 0).Distinct()];

    /// <inheritdoc/>
    /// <remarks>O(E).</remarks>
    public int[] NeighborsOf(int vertex) => [.. EdgesAround(vertex).Select(e => EdgeVertices[2 * e] == vertex ? EdgeVertices[2 * e + 1] : EdgeVertices[2 * e])];

    /// <summary>The edges at a vertex, in no order. V–E, O(E).</summary>
    public int[] EdgesAround(int vertex)
    {
        Source.CheckIndex(vertex, VertexCount);
        return EdgesWith(EdgeVertices, vertex);
    }

    /// <summary>The edges of a face, in no order. F–E, O(E).</summary>
    public int[] EdgesOfFace(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return EdgesWith(EdgeFaces, face);
    }

    private static int[] EdgesWith(int[] pairs, int element)
    {
        var found = new List<int>();
        for (int e = 0; e < pairs.Length / 2; e++)
        {
            if (pairs[2 * e] == element || pairs[2 * e + 1] == element)
                found.Add(e);
        }
        return [.. found];
    }

    private int[][] EdgesByFace()
    {
        var lists = new List<int>[FaceCount];
        for (int f = 0; f < lists.Length; f++)
            lists[f] = [];
        for (int side = 0; side < EdgeFaces.Length; side++)
        {
            if (EdgeFaces[side] >= 0)
                lists[EdgeFaces[side]].Add(side / 2);
        }
        return [.. lists.Select(list => list.ToArray())];
    }

    /// <summary>The vertices of a face in order, from its edges in no order.</summary>
    private int[] Chain(int face, int[] edges)
    {
        var after = new Dictionary<int, int>();
        foreach (int e in edges)
        {
            (int from, int to) = Directed(e, face);
            after[from] = to;
        }
        var vertices = new int[edges.Length];
        int v = Directed(EdgeOfFace[face], face).From;
        for (int k = 0; k < vertices.Length; k++)
        {
            vertices[k] = v;
            v = after[v];
        }
        return vertices;
    }

    private (int From, int To) Directed(int edge, int face) => EdgeFaces[2 * edge] == face
        ? (EdgeVertices[2 * edge], EdgeVertices[2 * edge + 1])
        : (EdgeVertices[2 * edge + 1], EdgeVertices[2 * edge]);
}
