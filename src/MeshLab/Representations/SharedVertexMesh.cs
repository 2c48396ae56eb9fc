using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 共享顶点 (shared vertex, indexed faces): every position once, faces as lists of vertex numbers, as in an OBJ or OFF file.</summary>
/// <remarks>
/// 28 bytes per triangle of a closed mesh (F ≈ 2V: 12 for half a position, 12 for three numbers, 4 for where the face begins). The vertices
/// of a face are there at once, O(1); what is at a vertex or beside a face takes a search over all faces, O(F).
/// </remarks>
public sealed class SharedVertexMesh : IAdjacencyQueries
{
    /// <summary>Wraps positions and polygons without copying.</summary>
    public SharedVertexMesh(PolygonSoup polygons)
    {
        ArgumentNullException.ThrowIfNull(polygons);
        Polygons = polygons;
    }

    /// <summary>The arrays.</summary>
    public PolygonSoup Polygons { get; }

    /// <inheritdoc/>
    public int VertexCount => Polygons.VertexCount;

    /// <inheritdoc/>
    public int FaceCount => Polygons.FaceCount;

    /// <inheritdoc/>
    public long Bytes => 24L * VertexCount + 4L * (Polygons.Corners.Length + Polygons.FaceStart.Length);

    /// <summary>The faces of a mesh in order. O(V + F).</summary>
    public static SharedVertexMesh FromMesh(Mesh mesh) => new(PolygonSoup.From(mesh));

    /// <summary>Makes a mesh with the same order of vertices and faces. O(V + F).</summary>
    /// <exception cref="TopologyException">The polygons do not make an oriented 2-manifold.</exception>
    public Mesh ToMesh() => MeshBuilder.FromPolygons(Polygons);

    /// <inheritdoc/>
    /// <remarks>O(1).</remarks>
    public int[] FaceVertices(int face)
    {
        Source.CheckIndex(face, FaceCount);
        return Polygons.Face(face).ToArray();
    }

    /// <inheritdoc/>
    /// <remarks>O(F).</remarks>
    public int[] FacesBeside(int face)
    {
        int[] own = FaceVertices(face);
        var found = new List<int>();
        for (int f = 0; f < FaceCount; f++)
        {
            if (f != face && ShareAnEdge(own, Polygons.Face(f)))
                found.Add(f);
        }
        return [.. found];
    }

    /// <inheritdoc/>
    /// <remarks>O(F).</remarks>
    public int[] FacesAround(int vertex)
    {
        Source.CheckIndex(vertex, VertexCount);
        var found = new List<int>();
        for (int f = 0; f < FaceCount; f++)
        {
            if (Polygons.Face(f).Contains(vertex))
                found.Add(f);
        }
        return [.. found];
    }

    /// <inheritdoc/>
    /// <remarks>O(F).</remarks>
    public int[] NeighborsOf(int vertex)
    {
        var found = new SortedSet<int>();
        foreach (int f in FacesAround(vertex))
        {
            ReadOnlySpan<int> corners = Polygons.Face(f);
            int at = corners.IndexOf(vertex);
            found.Add(corners[(at + 1) % corners.Length]);
            found.Add(corners[(at + corners.Length - 1) % corners.Length]);
        }
        return [.. found];
    }

    /// <summary>Whether some side of one polygon is a side of the other in the opposite direction.</summary>
    private static bool ShareAnEdge(ReadOnlySpan<int> a, ReadOnlySpan<int> b)
    {
        for (int i = 0; i < a.Length; i++)
        {
            int from = b.IndexOf(a[(i + 1) % a.Length]);
            if (from >= 0 && b[(from + 1) % b.Length] == a[i])
                return true;
        }
        return false;
    }
}
