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
            // The rms error falls like the edge length to the power of the order.
            IReadOnlyList<ConvergenceStep> steps = ConvergenceStudy.Measure(surface, 8, 16, 32, 64);
            output.Table(
                $"rms error on the {surface} by edge length h, and its order",
                ["quantity", .. steps.Take(4).Select(s => $"h = {s.EdgeLength:G3}"), "largest error", "order"],
                steps.GroupBy(s => s.Quantity, StringComparer.Ordinal).Select(g => (object[])
                [
                    g.Key, .. g.Select(s => (object)s.RmsError), g.Last().MaxError, double.IsNaN(g.Last().Order) ? "exact" : g.Last().Order,
                ]));
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
