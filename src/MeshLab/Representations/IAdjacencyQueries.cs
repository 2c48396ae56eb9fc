namespace MeshLab.Representations;

/// <summary>What every representation with numbered vertices and faces can answer, each at its own cost (§1.3).</summary>
public interface IAdjacencyQueries
{
    /// <summary>The number of vertices.</summary>
    int VertexCount { get; }

    /// <summary>The number of faces.</summary>
    int FaceCount { get; }

    /// <summary>The memory of the arrays in bytes, positions included.</summary>
    long Bytes { get; }

    /// <summary>The vertices of a face, counter-clockwise. F–V.</summary>
    int[] FaceVertices(int face);

    /// <summary>The faces that share an edge with a face. F–F.</summary>
    int[] FacesBeside(int face);

    /// <summary>The faces at a vertex. V–F.</summary>
    int[] FacesAround(int vertex);

    /// <summary>The vertices joined to a vertex by an edge. V–V.</summary>
    int[] NeighborsOf(int vertex);
}
