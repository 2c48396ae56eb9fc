using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>An edge with its wings (翼边).</summary>
/// <param name="V0">Where it begins.</param>
/// <param name="V1">Where it ends.</param>
/// <param name="Left">The face to the left of V0 → V1; −1 for a hole.</param>
/// <param name="Right">The face to the right; −1 for a hole.</param>
/// <param name="LeftNext">The edge after this one around the left face (or hole), at V1.</param>
/// <param name="LeftPrevious">The edge before this one around the left face, at V0.</param>
/// <param name="RightNext">The edge after this one around the right face, at V0.</param>
/// <param name="RightPrevious">The edge before this one around the right face, at V1.</param>
public readonly record struct WingedEdge(int V0, int V1, int Left, int Right, int LeftNext, int LeftPrevious, int RightNext, int RightPrevious);

/// <summary>§1.3 The winged-edge structure (翼边结构) of Baumgart 1972: edges with two vertices, two faces, and the four edges next to them.</summary>
/// <remarks>
/// <code>
///     LeftNext \    / RightPrevious
///               \  /
///                V1
///       Left     │     Right
///                V0
///               /  \
///  LeftPrevious /    \ RightNext
/// </code>
/// 66 bytes per triangle of a closed mesh. Every query takes time proportional to its answer. Unlike a half-edge, an edge does not know from which
/// side one came, so each step asks: am I left or right of it?
/// </remarks>
public sealed class WingedEdgeMesh : IAdjacencyQueries
{
    private WingedEdgeMesh(Vector3D[] positions, WingedEdge[] edges, int[] edgeOfVertex, int[] edgeOfFace) =>
        (Positions, Edges, EdgeOfVertex, EdgeOfFace) = (positions, edges, edgeOfVertex, edgeOfFace);

    /// <summary>Per vertex, its position.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>The edges.</summary>
    public WingedEdge[] Edges { get; }

    /// <summary>Per vertex, one edge: the first one counter-clockwise on a boundary; −1 if isolated.</summary>
    public int[] EdgeOfVertex { get; }

    /// <summary>Per face, the edge that leaves its first vertex.</summary>
    public int[] EdgeOfFace { get; }

    /// <inheritdoc/>
    public int VertexCount => Positions.Length;

    /// <inheritdoc/>
    public int FaceCount => EdgeOfFace.Length;

    /// <inheritdoc/>
    public long Bytes => 24L * VertexCount + 32L * Edges.Length + 4L * (EdgeOfVertex.Length + EdgeOfFace.Length);

    /// <summary>The elements of a mesh in order. O(V + E + F).</summary>
    public static WingedEdgeMesh FromMesh(Mesh mesh)
    {
        mesh = Source.Compact(mesh);
        var edges = new WingedEdge[mesh.Edges.Count];
        foreach (Edge e in mesh.Edges)
        {
            HalfEdge h = e.HalfEdge0, t = e.HalfEdge1;
            edges[e.Index] = new(
                t.Target.Index, h.Target.Index, h.Face.Index, t.Face.Index,
                h.Next.Edge.Index, h.Previous.Edge.Index, t.Next.Edge.Index, t.Previous.Edge.Index);
        }
        var edgeOfVertex = new int[mesh.Vertices.Count];
        foreach (Vertex v in mesh.Vertices)
            edgeOfVertex[v.Index] = v.IsIsolated ? -1 : First(v);
        var edgeOfFace = new int[mesh.Faces.Count];
        foreach (Face f in mesh.Faces)
            edgeOfFace[f.Index] = f.HalfEdge.Edge.Index;
        return new(mesh.Positions.ToArray(), edges, edgeOfVertex, edgeOfFace);
    }

    /// <summary>A boundary vertex's outgoing half-edge is the last counter-clockwise; the first lies across the hole.</summary>
    private static int First(Vertex v) => v.IsBoundary ? v.Outgoing.Previous.Edge.Index : v.Outgoing.Edge.Index;

    /// <summary>Makes a mesh with the same order of vertices, faces and corners. O(V + E + F).</summary>
    /// <exception cref="TopologyException">The arrays were changed and do not make an oriented 2-manifold any more.</exception>
    public Mesh ToMesh()
    {
        var faces = new int[FaceCount][];
        for (int f = 0; f < faces.Length; f++)
            faces[f] = FaceVertices(f);
        return MeshBuilder.FromPolygons(Positions, faces);
    }

    /// <summary>The edges of a face, counter-clockwise from the one that leaves its first vertex. F–E, O(degree).</summary>
    public int[] EdgesOfFace(int face)
    {
        Source.CheckIndex(face, FaceCount);
        var found = new List<int>();
        int e = EdgeOfFace[face];
        do
        {
            found.Add(e);
            e = Edges[e].Left == face ? Edges[e].LeftNext : Edges[e].RightNext;
        }
        while (e != EdgeOfFace[face]);
        return [.. found];
    }

    /// <summary>The edges at a vertex, counter-clockwise. V–E, O(valence).</summary>
    public int[] EdgesAround(int vertex)
    {
        Source.CheckIndex(vertex, VertexCount);
        if (EdgeOfVertex[vertex] < 0)
            return [];
        var found = new List<int>();
        int e = EdgeOfVertex[vertex];
        do
        {
            found.Add(e);
            // The edge before this one around the face on its counter-clockwise side ends here too.
            e = Edges[e].V0 == vertex ? Edges[e].LeftPrevious : Edges[e].RightPrevious;
        }
        while (e != EdgeOfVertex[vertex]);
        return [.. found];
    }

    /// <inheritdoc/>
    /// <remarks>O(degree).</remarks>
    public int[] FaceVertices(int face) => [.. EdgesOfFace(face).Select(e => Edges[e].Left == face ? Edges[e].V0 : Edges[e].V1)];

    /// <inheritdoc/>
    /// <remarks>O(degree).</remarks>
    public int[] FacesBeside(int face) =>
        [.. EdgesOfFace(face).Select(e => Edges[e].Left == face ? Edges[e].Right : Edges[e].Left).Where(f => f >= 0).Distinct()];

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] FacesAround(int vertex) =>
        [.. EdgesAround(vertex).Select(e => Edges[e].V0 == vertex ? Edges[e].Left : Edges[e].Right).Where(f => f >= 0)];

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] NeighborsOf(int vertex) => [.. EdgesAround(vertex).Select(e => Edges[e].V0 == vertex ? Edges[e].V1 : Edges[e].V0)];
}
