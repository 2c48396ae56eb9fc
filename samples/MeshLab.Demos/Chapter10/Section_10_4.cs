using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.3 面法向 and §10.4 点法向: four kinds of vertex normals beside the exact ones (§10.4.5).</summary>
[Demo("10.4", "法向及其比较", "Normals, and how good they are")]
public static class Section_10_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        mesh.ComputeFaceNormals(out int degenerate);
        output.Line($"{degenerate} of {mesh.Faces.Count} faces have zero area, and so no normal.");

        foreach (AnalyticSurface surface in AnalyticSurface.All)
        {
            output.Table(
                $"error of vertex normals on the {surface}, in degrees",
                ["weights", "mean", "rms", "max"],
                VertexNormalComparison.Compare(surface.Mesh(32), surface.Normal).Select(e => new object[]
                {
                    e.Weight, Degrees(e.MeanError), Degrees(e.RmsError), Degrees(e.MaxError),
                }));
        }
    }

    private static double Degrees(double radians) => radians * 180 / Math.PI;
}
