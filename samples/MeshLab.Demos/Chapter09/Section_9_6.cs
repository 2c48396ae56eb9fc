using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter09;

/// <summary>§9.6 简化: both engines from the input to a 5-6-7 mesh with the input's number of faces, and how far each moves the surface.</summary>
[Demo("9.6", "简化得到 5-6-7 模型", "5-6-7 meshes by both engines")]
public static class Section_9_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ValenceTable.Show(output, "input", mesh);
        output.Picture("input", mesh, Coloring.ByValence(mesh));
        foreach (FiveSixSevenEngine engine in Enum.GetValues<FiveSixSevenEngine>())
        {
            FiveSixSevenResult result = mesh.ToFiveSixSeven(new FiveSixSevenOptions { Engine = engine });
            MeshDistanceReport distance = MeshDistance.Measure(mesh, result.Mesh, new MeshDistanceOptions { Samples = 20_000 });
            ValenceTable.Show(output, $"{engine}", result.Mesh);
            output.Line($"{engine}: Hausdorff distance {100 * distance.Hausdorff / distance.Diagonal:F2} % of the diagonal, {result.Walks} walks");
            output.Picture($"{engine}", result.Mesh, Coloring.ByValence(result.Mesh));
        }
    }
}
