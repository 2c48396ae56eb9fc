using MeshLab.Demos.Hosting;
using MeshLab.Dual;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter03;

/// <summary>§3 对偶模型: a vertex for every face and a face for every vertex, in both forms, and the dual of the dual.</summary>
[Demo("3.1", "对偶模型", "The dual model")]
public static class Section_3_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh pure = mesh.ComputeDual().Mesh;
        Mesh cells = mesh.ComputeDual(new DualOptions { Form = DualForm.Cells, Center = DualCenter.CircumcenterIfAcute }).Mesh;
        output.Table(
            "counts",
            ["", "vertices", "edges", "faces"],
            [Row("primal", mesh), Row("pure dual", pure), Row("textbook's cells", cells)]);

        int hexagons = pure.Faces.Count(cell => cell.Degree == 6);
        output.Line($"{hexagons} of {pure.Faces.Count} cells are hexagons: a cell has as many corners as its vertex has neighbours.");
        if (mesh.IsClosed)
            output.Line($"The dual of the dual: {pure.ComputeDual().Mesh}.");

        output.Picture("dual", pure, new RenderOptions { Wireframe = true });

        object[] Row(string name, Mesh m) => [name, m.Vertices.Count, m.Edges.Count, m.Faces.Count];
    }
}
