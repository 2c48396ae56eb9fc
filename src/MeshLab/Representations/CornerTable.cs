using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 角表 (corner table): a triangle's corner knows its vertex and the corner opposite across the far edge; the rest is arithmetic.</summary>
/// <remarks>
/// <code>
///            c.V                      c.T = ⌊c/3⌋        the triangle
///           / c \                     c.N, c.P           next and previous corner of the triangle
///   c.L   /   T   \   c.R             c.O                the corner opposite across the edge c does not touch
///       /c.N ── c.P\                  c.R = c.N.O        the opposite corner on the right
///            c.O                      c.L = c.P.O        the opposite corner on the left
/// </code>
/// 38 bytes per triangle of a closed mesh. Every query takes time proportional to its answer. Rossignac 2001.
/// </remarks>
public sealed class CornerTable : IAdjacencyQueries
{
    private CornerTable(Vector3D[] positions, int[] v, int[] o, int[] cornerOf) => (Positions, V, O, CornerOf) = (positions, v, o, cornerOf);

    /// <summary>Per vertex, its position.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>Per corner, its vertex.</summary>
    public int[] V { get; }

    /// <summary>Per corner, the opposite one; −1 across a boundary.</summary>
    public int[] O { get; }

    /// <summary>Per vertex, one corner: the first one counter-clockwise on a boundary; −1 if isolated.</summary>
    public int[] CornerOf { get; }

    /// <inheritdoc/>
    public int VertexCount => Positions.Length;

    /// <inheritdoc/>
    public int FaceCount => V.Length / 3;

    /// <inheritdoc/>
    public long Bytes => 24L * VertexCount + 4L * (V.Length + O.Length + CornerOf.Length);

    /// <summary>The corner with an index: corner k of triangle t is 3t + k.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such corner.</exception>
    public Corner this[int corner]
    {
        get
        {
            Source.CheckIndex(corner, V.Length);
            return new(this, corner);
        }
    }

    /// <summary>The triangles of a mesh in order. O(V + F).</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static CornerTable FromMesh(Mesh mesh)
    {
        mesh = Source.CompactTriangles(mesh);
        int[] v = new int[3 * mesh.Faces.Count], o = new int[v.Length], cornerOf = new int[mesh.Vertices.Count];
        // The corner at the source of each half-edge.
        var corner = new int[mesh.HalfEdgeSlots];
        Array.Fill(corner, -1);
        int c = 0;
        foreach (Face f in mesh.Faces)
        {
            foreach (HalfEdge h in f.HalfEdges)
            {
                corner[h.Index] = c;
                v[c++] = h.Source.Index;
            }
        }
        foreach (Face f in mesh.Faces)
        {
            foreach (HalfEdge h in f.HalfEdges)
            {
                HalfEdge across = h.Next.Twin;
                o[corner[h.Index]] = across.IsBoundary ? -1 : corner[across.Previous.Index];
            }
        }
        foreach (Vertex vertex in mesh.Vertices)
        {
            // A boundary vertex's outgoing half-edge is the last counter-clockwise; the first corner lies across the hole.
            HalfEdge h = vertex.Outgoing;
            cornerOf[vertex.Index] = h.IsNone ? -1 : corner[(h.IsBoundary ? h.Previous.Twin : h).Index];
        }
        return new(mesh.Positions.ToArray(), v, o, cornerOf);
    }

    /// <summary>Makes a mesh with the same order of vertices and faces. O(V + F).</summary>
    /// <exception cref="TopologyException">The arrays were changed and do not make an oriented 2-manifold any more.</exception>
    public Mesh ToMesh() => MeshBuilder.FromTriangles(Positions, V);

    /// <summary>The corners at a vertex, counter-clockwise. O(valence).</summary>
    public Corner[] CornersAround(int vertex)
    {
        Source.CheckIndex(vertex, VertexCount);
        if (CornerOf[vertex] < 0)
            return [];
        var found = new List<Corner>();
        Corner first = new(this, CornerOf[vertex]), c = first;
        do
        {
            found.Add(c);
            // Across the edge that ends here: the corner after the opposite one is at the same vertex.
            c = c.R.IsNone ? default : c.R.N;
        }
        while (!c.IsNone && c != first);
        return [.. found];
    }

    /// <inheritdoc/>
    /// <remarks>O(1).</remarks>
    public int[] FaceVertices(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return V.AsSpan(3 * face, 3).ToArray();
    }

    /// <inheritdoc/>
    /// <remarks>O(1).</remarks>
    public int[] FacesBeside(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return [.. O.AsSpan(3 * face, 3).ToArray().Where(c => c >= 0).Select(c => c / 3)];
    }

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] FacesAround(int vertex) => [.. CornersAround(vertex).Select(c => c.T)];

    /// <inheritdoc/>
    /// <remarks>O(valence).</remarks>
    public int[] NeighborsOf(int vertex)
    {
        var found = new List<int>();
        foreach (Corner c in CornersAround(vertex))
        {
            found.Add(c.N.V);
            if (c.R.IsNone)
                found.Add(c.P.V);
        }
        return [.. found];
    }
}

/// <summary>A corner of a table, with the book's names. <see langword="default"/> is none, as across a boundary.</summary>
/// <param name="Table">The table.</param>
/// <param name="Index">The index.</param>
public readonly record struct Corner(CornerTable Table, int Index)
{
    /// <summary>Whether this is no corner.</summary>
    public bool IsNone => Table is null;

    /// <summary>The triangle.</summary>
    public int T => Index / 3;

    /// <summary>The vertex.</summary>
    public int V => Table.V[Index];

    /// <summary>The next corner of the triangle.</summary>
    public Corner N => this with { Index = Index % 3 == 2 ? Index - 2 : Index + 1 };

    /// <summary>The previous corner of the triangle.</summary>
    public Corner P => this with { Index = Index % 3 == 0 ? Index + 2 : Index - 1 };

    /// <summary>The opposite corner, none across a boundary.</summary>
    public Corner O => Table.O[Index] < 0 ? default : this with { Index = Table.O[Index] };

    /// <summary>The opposite corner on the right, N.O.</summary>
    public Corner R => N.O;

    /// <summary>The opposite corner on the left, P.O.</summary>
    public Corner L => P.O;

    /// <summary><c>c7</c>, or <c>none</c>.</summary>
    public override string ToString() => IsNone ? "none" : $"c{Index}";
}
