using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.1 点的邻域: the ring, the spokes and the link of a vertex, and its k-rings as bands.</summary>
[Demo("5.1", "点的邻域", "Around a vertex")]
public static class Section_5_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex v = mesh.Vertices.First(vertex => !vertex.IsIsolated);
        output.Table(
            $"around {v}",
            ("ring vertices", string.Join(" ", v.RingVertices)),
            ("spoke edges", string.Join(" ", v.SpokeEdges)),
            ("link edges", string.Join(" ", v.LinkEdges)),
            ("faces", string.Join(" ", v.IncidentFaces)));

        var distance = new int[mesh.VertexSlots];
        Array.Fill(distance, -1);
        for (int k = 0; k <= 8; k++)
        {
            Vertex[] ring = v.Ring(k);
            output.Line($"{ring.Length} vertices at {k} edges");
            foreach (Vertex w in ring)
                distance[w.Index] = k;
        }
        output.Picture("k-rings", mesh, Coloring.VertexLabels(distance, "edges away"));
    }
}
