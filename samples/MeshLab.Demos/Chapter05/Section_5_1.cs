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
        Vertex v = Closeup.InnerVertex(mesh);
        output.Table(
            $"around {v}",
            ("ring vertices", string.Join(" ", v.RingVertices)),
            ("spoke edges", string.Join(" ", v.SpokeEdges)),
            ("link edges", string.Join(" ", v.LinkEdges)),
            ("faces", string.Join(" ", v.IncidentFaces)));
        Closeup.Show(output, "spokes blue, link red", v.AsGroup(), 2, [("incident", v.IncidentFaces)], (Closeup.Blue, v.SpokeEdges), (Closeup.Red, v.LinkEdges));

        var distance = new int[mesh.VertexSlots];
        Array.Fill(distance, -1);
        const int Rings = 8;
        output.Table("k-rings", ["k", "vertices at k edges", "within k edges"], Enumerable.Range(0, Rings + 1).Select(k =>
        {
            foreach (Vertex w in v.Ring(k))
                distance[w.Index] = k;
            return new object[] { k, v.Ring(k).Length, v.Disk(k).Length };
        }));
        output.Picture("k-rings", mesh, Coloring.VertexLabels(distance, "edges away", color: k => k < 0 ? ColorMap.NotANumber : ColorMap.Viridis.Sample((double)k / Rings)));
    }
}
