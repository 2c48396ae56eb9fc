using MeshLab.Demos.Hosting;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter07;

/// <summary>§7.4 误差度量: how far a coarser mesh is from the model, in both directions, and where.</summary>
[Demo("7.4", "误差度量", "Error measure")]
public static class Section_7_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh coarse = mesh.RemeshIsotropically(new RemeshingOptions { RelativeLength = 3 }).Mesh;
        output.Line($"{mesh.Faces.Count} faces, made coarser: {coarse.Faces.Count}");

        MeshDistanceReport report = mesh.DistanceTo(coarse);
        output.Table(
            "distance, as a share of the diagonal",
            ["", "mean", "rms", "max"],
            [Row("model to coarse", report.Forward), Row("coarse to model", report.Backward)]);
        output.Line($"Hausdorff distance {report.Hausdorff:G4}, {report.Hausdorff / report.Diagonal:P3} of the diagonal");

        double[] error = mesh.VertexDistancesTo(coarse);
        output.Picture("coarse", coarse);
        output.Picture("error", mesh, Coloring.VertexScalars(error, title: "distance"));

        object[] Row(string name, DistanceStatistics way) =>
            [name, way.Mean / report.Diagonal, way.Rms / report.Diagonal, way.Max / report.Diagonal];
    }
}
