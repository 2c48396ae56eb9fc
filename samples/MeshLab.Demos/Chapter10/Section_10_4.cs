using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.4 点法向: four kinds of vertex normals; beside the exact ones on analytic surfaces (§10.4.5).</summary>
[Demo("10.4", "点法向及其比较", "Vertex normals, and how good they are")]
public static class Section_10_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vector3D[] angle = mesh.ComputeVertexNormals(VertexNormalWeight.Angle), uniform = mesh.ComputeVertexNormals(VertexNormalWeight.Uniform);
        var between = new double[mesh.VertexSlots];
        for (int v = 0; v < between.Length; v++)
            between[v] = angle[v] == default ? double.NaN : Degrees(Vector3D.Angle(angle[v], uniform[v]));
        output.Picture("uniform beside angle weights", mesh, Coloring.VertexScalars(between, title: "angle between", unit: "degrees").WithoutOutliers());

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
        output.Svg("normals of the ellipsoid", Chart(AnalyticSurface.Ellipsoid).ToSvg());
    }

    private static SvgChart Chart(AnalyticSurface surface)
    {
        (double Edge, IReadOnlyList<NormalError> Errors)[] steps = [.. new[] { 8, 16, 32, 64 }.Select(n =>
        {
            Mesh mesh = surface.Mesh(n);
            return (mesh.MeanEdgeLength, VertexNormalComparison.Compare(mesh, surface.Normal));
        })];
        return new()
        {
            Title = $"Vertex normals on the {surface}",
            XLabel = "mean edge length",
            YLabel = "rms error in degrees",
            XScale = AxisScale.Logarithmic,
            YScale = AxisScale.Logarithmic,
            Series = [.. steps[0].Errors.Select((e, i) => new ChartSeries($"{e.Weight}", [.. steps.Select(s => s.Edge)], [.. steps.Select(s => Degrees(s.Errors[i].RmsError))]))],
        };
    }

    private static double Degrees(double radians) => radians * 180 / Math.PI;
}
