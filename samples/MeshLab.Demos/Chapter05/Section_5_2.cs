using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.2 边的邻域: the loop around an edge, and the faces that touch it.</summary>
[Demo("5.2", "边的邻域", "Around an edge")]
public static class Section_5_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Edge edge = Closeup.InnerVertex(mesh).SpokeEdges[0];
        output.Table(
            $"around {edge} between {edge.Vertex0} and {edge.Vertex1}",
            ("loop vertices", string.Join(" ", edge.LoopVertices)),
            ("loop edges", string.Join(" ", edge.LoopEdges)),
            ("touching faces", string.Join(" ", edge.TouchingFaces)),
            ("vertices at 2 edges", string.Join(" ", edge.Ring(2))));
        (int a, int b) = (edge.Vertex0.Valence, edge.Vertex1.Valence);
        output.Line($"The loop has {edge.LoopEdges.Length} edges; inside a triangle mesh val(a) + val(b) - 4 = {a} + {b} - 4 = {a + b - 4}.");
        Closeup.Show(output, "edge blue, loop red", edge.AsGroup(), 2, [("touching", edge.TouchingFaces)], (Closeup.Blue, [edge]), (Closeup.Red, edge.LoopEdges));
    }
}
