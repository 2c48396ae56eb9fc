using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>A polygon mesh on the half-edge structure (半边结构, §1.4): orientable, 2-manifold, with or without boundary, at every moment.</summary>
/// <remarks>
/// <code>
///              v (Target)
///            ↗ ↘
///     h.Previous  h.Next        the face is to the left of its half-edges, counter-clockwise seen from outside
///        ↑  face ↘
///        ●───────→●
/// </code>
/// Connectivity is six columns of <see langword="int"/>: next, previous, target and face per half-edge, one outgoing half-edge per vertex,
/// one half-edge per face. The two half-edges of edge e are 2e and 2e + 1, so twin and edge need no storage. A boundary half-edge is a real
/// half-edge whose face is none; they form loops by <see cref="HalfEdge.Next"/>. A boundary vertex's outgoing half-edge is a boundary one.
/// Deleting marks; an index is never used again until <see cref="Compact"/>.
/// People use the handles (<see cref="Vertex"/>, <see cref="HalfEdge"/>, <see cref="Edge"/>, <see cref="Face"/>); hot loops take the columns as spans.
/// Any number of threads may read a mesh at once while none changes it.
/// </remarks>
public sealed partial class Mesh
{
    /// <summary>What <see cref="Outgoing"/> holds for a vertex without edges.</summary>
    internal const int Isolated = -1;

    /// <summary>What the columns hold for a deleted element (for vertices in <see cref="Outgoing"/>).</summary>
    internal const int DeletedVertexMark = -2;

    internal int[] next = [];
    internal int[] previous = [];
    internal int[] target = [];
    internal int[] face = [];
    internal int[] outgoing = [];
    internal int[] halfEdgeOf = [];
    internal Vector3D[] positions = [];

    private int vertexSlots;
    private int halfEdgeSlots;
    private int faceSlots;
    private int vertexCount;
    private int edgeCount;
    private int faceCount;

    /// <summary>Creates a mesh without elements.</summary>
    public Mesh()
    {
    }

    internal Mesh(Vector3D[] positions, int[] next, int[] previous, int[] target, int[] face, int[] outgoing, int[] halfEdgeOf)
    {
        (this.positions, this.outgoing, this.halfEdgeOf) = (positions, outgoing, halfEdgeOf);
        (this.next, this.previous, this.target, this.face) = (next, previous, target, face);
        vertexCount = vertexSlots = positions.Length;
        halfEdgeSlots = next.Length;
        edgeCount = halfEdgeSlots / 2;
        faceCount = faceSlots = halfEdgeOf.Length;
    }

    /// <summary>The vertices (顶点) that are not deleted.</summary>
    public VertexList Vertices => new(this);

    /// <summary>The half-edges (半边) that are not deleted.</summary>
    public HalfEdgeList HalfEdges => new(this);

    /// <summary>The edges (边) that are not deleted.</summary>
    public EdgeList Edges => new(this);

    /// <summary>The faces (面) that are not deleted.</summary>
    public FaceList Faces => new(this);

    /// <summary>Length of the vertex columns: live and deleted vertices.</summary>
    public int VertexSlots => vertexSlots;

    /// <summary>Length of the half-edge columns: live and deleted half-edges.</summary>
    public int HalfEdgeSlots => halfEdgeSlots;

    /// <summary>Length of the edge columns: live and deleted edges.</summary>
    public int EdgeSlots => halfEdgeSlots >> 1;

    /// <summary>Length of the face columns: live and deleted faces.</summary>
    public int FaceSlots => faceSlots;

    internal int LiveVertices => vertexCount;

    internal int LiveEdges => edgeCount;

    internal int LiveFaces => faceCount;

    /// <summary>Whether no element is deleted, so that every slot is live.</summary>
    public bool IsCompact => vertexCount == vertexSlots && edgeCount == EdgeSlots && faceCount == faceSlots;

    /// <summary>Per half-edge, the next one around its face or hole; −1 if deleted. Take the span once before a loop; growth makes it stale.</summary>
    public ReadOnlySpan<int> Next => next.AsSpan(0, halfEdgeSlots);

    /// <summary>Per half-edge, the previous one around its face or hole.</summary>
    public ReadOnlySpan<int> Previous => previous.AsSpan(0, halfEdgeSlots);

    /// <summary>Per half-edge, the vertex that it points to (目的顶点).</summary>
    public ReadOnlySpan<int> Target => target.AsSpan(0, halfEdgeSlots);

    /// <summary>Per half-edge, the face to its left; −1 on the boundary.</summary>
    public ReadOnlySpan<int> FaceOf => face.AsSpan(0, halfEdgeSlots);

    /// <summary>Per vertex, one half-edge that leaves it, a boundary one if there is any; −1 if isolated, −2 if deleted.</summary>
    public ReadOnlySpan<int> Outgoing => outgoing.AsSpan(0, vertexSlots);

    /// <summary>Per face, its first half-edge: from its first to its second vertex; −1 if deleted.</summary>
    public ReadOnlySpan<int> HalfEdgeOf => halfEdgeOf.AsSpan(0, faceSlots);

    /// <summary>Per vertex, its position; free to be written. Changes through this span are not recorded by a listener.</summary>
    public Span<Vector3D> Positions => positions.AsSpan(0, vertexSlots);

    /// <summary>The smallest axis-parallel box around the live vertices (包围盒). O(V).</summary>
    public BoundingBox BoundingBox
    {
        get
        {
            if (vertexCount == vertexSlots)
                return BoundingBox.Of(Positions);
            BoundingBox box = BoundingBox.Empty;
            for (int v = 0; v < vertexSlots; v++)
            {
                if (outgoing[v] != DeletedVertexMark)
                    box = box.Including(positions[v]);
            }
            return box;
        }
    }

    /// <summary>Whether every face is a triangle. O(H).</summary>
    public bool IsTriangleMesh
    {
        get
        {
            int corners = 0;
            for (int h = 0; h < halfEdgeSlots; h++)
            {
                if (next[h] >= 0 && face[h] >= 0)
                    corners++;
            }
            // No face has fewer than three corners, so three on average means three everywhere.
            return corners == 3 * faceCount;
        }
    }

    /// <summary>Whether no half-edge lies on a boundary. O(H).</summary>
    public bool IsClosed
    {
        get
        {
            for (int h = 0; h < halfEdgeSlots; h++)
            {
                if (next[h] >= 0 && face[h] < 0)
                    return false;
            }
            return true;
        }
    }

    /// <summary>Whether the vertex with this index is deleted.</summary>
    public bool IsDeletedVertex(int vertex) => outgoing[vertex] == DeletedVertexMark;

    /// <summary>Whether the edge with this index is deleted.</summary>
    public bool IsDeletedEdge(int edge) => next[2 * edge] < 0;

    /// <summary>Whether the face with this index is deleted.</summary>
    public bool IsDeletedFace(int face) => halfEdgeOf[face] < 0;

    /// <summary>The half-edge from one vertex to another, or none. O(valence of <paramref name="from"/>).</summary>
    /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
    public HalfEdge FindHalfEdge(Vertex from, Vertex to)
    {
        CheckOwn(from, nameof(from));
        CheckOwn(to, nameof(to));
        int h = FindHalfEdge(from.index, to.index);
        return h < 0 ? default : new(this, h);
    }

    /// <summary>The edge between two vertices, or none. O(valence of <paramref name="a"/>).</summary>
    /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
    public Edge FindEdge(Vertex a, Vertex b)
    {
        HalfEdge h = FindHalfEdge(a, b);
        return h.IsNone ? default : h.Edge;
    }

    /// <summary>The half-edge between two vertices by index, or −1.</summary>
    internal int FindHalfEdge(int from, int to)
    {
        int start = outgoing[from];
        if (start < 0)
            return -1;
        int h = start;
        do
        {
            if (target[h] == to)
                return h;
            h = next[h ^ 1];
        }
        while (h != start);
        return -1;
    }

    /// <summary>Throws unless the element is a live one of this mesh.</summary>
    internal void CheckOwn(Vertex vertex, string parameter)
    {
        if (!ReferenceEquals(vertex.mesh, this))
            throw new ArgumentException($"{vertex} does not belong to this mesh.", parameter);
        vertex.ThrowIfDead();
    }

    /// <inheritdoc cref="CheckOwn(Vertex, string)"/>
    internal void CheckOwn(HalfEdge halfEdge, string parameter)
    {
        if (!ReferenceEquals(halfEdge.mesh, this))
            throw new ArgumentException($"{halfEdge} does not belong to this mesh.", parameter);
        halfEdge.ThrowIfDead();
    }

    /// <inheritdoc cref="CheckOwn(Vertex, string)"/>
    internal void CheckOwn(Edge edge, string parameter)
    {
        if (!ReferenceEquals(edge.mesh, this))
            throw new ArgumentException($"{edge} does not belong to this mesh.", parameter);
        edge.ThrowIfDead();
    }

    /// <inheritdoc cref="CheckOwn(Vertex, string)"/>
    internal void CheckOwn(Face face, string parameter)
    {
        if (!ReferenceEquals(face.mesh, this))
            throw new ArgumentException($"{face} does not belong to this mesh.", parameter);
        face.ThrowIfDead();
    }

    /// <summary>The counts, for people and debuggers.</summary>
    public override string ToString() => $"Mesh: {vertexCount} vertices, {edgeCount} edges, {faceCount} faces";
}
