using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter01;

/// <summary>§1.4 半边结构: walks around a vertex in both directions, and counts what the structure knows of the model.</summary>
[Demo("1.4", "半边结构", "The half-edge structure")]
public static class Section_1_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex v = mesh.Vertices.MaxBy(vertex => vertex.Valence);
        output.Line($"{v} has the highest valence, {v.Valence}{(v.IsBoundary ? ", and lies on a boundary" : "")}.");
        output.Line($"its neighbours counter-clockwise (h → h.Previous.Twin): {string.Join(" ", v.Neighbors)}");
        output.Line($"its neighbours clockwise (h → h.Twin.Next): {string.Join(" ", v.NeighborsClockwise)}");

        output.Table(
            "what the structure knows",
            ("vertices", mesh.Vertices.Count),
            ("edges", mesh.Edges.Count),
            ("faces", mesh.Faces.Count),
            ("boundary edges", mesh.Edges.Count(edge => edge.IsBoundary)),
            ("mean valence", mesh.Vertices.Average(vertex => vertex.Valence)),
            ("violated rules", mesh.Validate().Count));

        output.Picture("model", mesh);
        output.Picture("valence", mesh, Coloring.ByValence(mesh));
    }
}
