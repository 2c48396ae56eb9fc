using MeshLab.Curvature;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.7 高斯曲率与平均曲率: on the model, and how fast they approach the exact values on smooth surfaces.</summary>
[Demo("10.7", "高斯曲率与平均曲率", "Gaussian and mean curvature")]
public static class Section_10_7
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        VertexCurvatures curvatures = triangles.ComputeCurvatures();
        output.Picture("gaussian", triangles, Signed(curvatures.Gaussian, "Gaussian curvature"));
        output.Picture("mean", triangles, Signed(curvatures.Mean, "mean curvature"));

        foreach (AnalyticSurface surface in AnalyticSurface.All)
        {
            IReadOnlyList<ConvergenceStep> steps = ConvergenceStudy.Measure(surface, 8, 16, 32, 64);
            output.Table(
                $"convergence on the {surface}",
                ["quantity", "size", "edge length", "rms error", "max error", "order"],
                steps.Select(s => new object[] { s.Quantity, s.Size, s.EdgeLength, s.RmsError, s.MaxError, s.Order }));
            output.Svg($"convergence {surface}", Chart(surface, steps).ToSvg());
        }
    }

    private static SvgChart Chart(AnalyticSurface surface, IReadOnlyList<ConvergenceStep> steps) => new()
    {
        Title = $"Convergence on the {surface}",
        XLabel = "mean edge length",
        YLabel = "rms error",
        XScale = AxisScale.Logarithmic,
        YScale = AxisScale.Logarithmic,
        Height = 520,
        Series =
        [
            .. steps.GroupBy(s => s.Quantity, StringComparer.Ordinal).Select(g => new ChartSeries(g.Key, [.. g.Select(s => s.EdgeLength)], [.. g.Select(s => s.RmsError)])),
            SecondOrder([.. steps.Take(4)]),
        ],
    };

    private static ChartSeries SecondOrder(IReadOnlyList<ConvergenceStep> steps) => new(
        "order 2",
        [.. steps.Select(s => s.EdgeLength)],
        [.. steps.Select(s => steps[0].RmsError * Math.Pow(s.EdgeLength / steps[0].EdgeLength, 2))],
        SeriesStyle.Dashed);

    private static Coloring Signed(double[] values, string title) =>
        Coloring.VertexScalars(values, ColorMap.Coolwarm, title).WithoutOutliers(0.03).Symmetric();
}
