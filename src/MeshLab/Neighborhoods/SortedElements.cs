using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>Turns found indices into handles: each once, in index order.</summary>
internal static class SortedElements
{
    public static Vertex[] Vertices(Mesh mesh, List<int> found) => Array.ConvertAll(Distinct(found), v => new Vertex(mesh, v));

    public static Edge[] Edges(Mesh mesh, List<int> found) => Array.ConvertAll(Distinct(found), e => new Edge(mesh, e));

    public static Face[] Faces(Mesh mesh, List<int> found) => Array.ConvertAll(Distinct(found), f => new Face(mesh, f));

    public static HalfEdge[] HalfEdges(Mesh mesh, List<int> found) => Array.ConvertAll(Distinct(found), h => new HalfEdge(mesh, h));

    public static int[] Distinct(List<int> found)
    {
        found.Sort();
        int count = 0;
        for (int i = 0; i < found.Count; i++)
        {
            if (i == 0 || found[i] != found[i - 1])
                found[count++] = found[i];
        }
        return [.. found[..count]];
    }
}
