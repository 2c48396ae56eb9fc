using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>A row of the comparison: memory, and what the queries cost.</summary>
/// <param name="Name">The representation.</param>
/// <param name="ChineseName">Its name in the book.</param>
/// <param name="Bytes">Memory for the mesh in question; −1 if it cannot hold it.</param>
/// <param name="FaceVertices">F–V.</param>
/// <param name="FacesBeside">F–F.</param>
/// <param name="FacesAround">V–F.</param>
/// <param name="Neighbors">V–V.</param>
/// <param name="EdgeFaces">E–F.</param>
public sealed record RepresentationCost(
    string Name, string ChineseName, long Bytes, string FaceVertices, string FacesBeside, string FacesAround, string Neighbors, string EdgeFaces);

/// <summary>§1.3 The representations side by side: memory for a mesh, and the cost of each query (d = size of the answer).</summary>
public static class RepresentationComparison
{
    /// <summary>Makes the table for a mesh. O(V + E + F).</summary>
    public static IReadOnlyList<RepresentationCost> Of(Mesh mesh)
    {
        mesh = Source.Compact(mesh);
        bool triangles = mesh.IsTriangleMesh;
        long halfEdge = 24L * mesh.Vertices.Count + 4L * (mesh.Vertices.Count + 8L * mesh.Edges.Count + mesh.Faces.Count);
        return
        [
            new("face set", "以面为中心", triangles ? FaceSet.FromMesh(mesh).Bytes : -1, "O(1)", "O(F)", "O(F)", "O(F)", "O(F)"),
            new("shared vertex", "共享顶点", SharedVertexMesh.FromMesh(mesh).Bytes, "O(1)", "O(F)", "O(F)", "O(F)", "O(F)"),
            new("face-based", "基于面连接", triangles ? FaceBasedMesh.FromMesh(mesh).Bytes : -1, "O(1)", "O(1)", "O(d)", "O(d)", "no edges"),
            new("edge-based", "基于边连接", EdgeBasedMesh.FromMesh(mesh).Bytes, "O(E)", "O(E)", "O(E)", "O(E)", "O(1)"),
            new("winged edge", "翼边", WingedEdgeMesh.FromMesh(mesh).Bytes, "O(d)", "O(d)", "O(d)", "O(d)", "O(1)"),
            new("adjacency matrix", "邻接矩阵", AdjacencyMatrix.FromMesh(mesh).Bytes, "no faces", "no faces", "no faces", "O(d)", "no faces"),
            new("corner table", "角表", triangles ? CornerTable.FromMesh(mesh).Bytes : -1, "O(1)", "O(1)", "O(d)", "O(d)", "no edges"),
            new("half-edge", "半边结构", halfEdge, "O(d)", "O(d)", "O(d)", "O(d)", "O(1)"),
        ];
    }
}
