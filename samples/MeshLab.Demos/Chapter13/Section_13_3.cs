using MeshLab.Demos.Hosting;
using MeshLab.Segmentation;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter13;

/// <summary>§13.3 K-均值: clusters of faces, and beside it regions that are as flat as possible.</summary>
[Demo("13.3", "K-均值", "K-means, and variational shape approximation")]
public static class Section_13_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        FaceSegmentation kMeans = KMeans.Segment(mesh, 12, new KMeansOptions { Connect = true });
        FaceSegmentation smooth = BorderSmoothing.Smooth(mesh, kMeans);
        VariationalResult flat = VariationalApproximation.Segment(mesh, 24, new VariationalOptions { MaxTeleports = 4 });

        output.Line($"K-means: {kMeans.Count} clusters after {kMeans.Steps} rounds ({kMeans.StopReason}); borders {BorderSmoothing.BorderLength(mesh, kMeans.Labels):G4} long, {BorderSmoothing.BorderLength(mesh, smooth.Labels):G4} after smoothing");
        output.Line($"variational: {flat.Segmentation.Count} regions, error {flat.Segmentation.Objective:G4}");
        output.Svg("objective of K-means", new SvgChart
        {
            Title = "K-means: the objective never rises",
            XLabel = "round",
            YLabel = "Σ area · distance²",
            Series = [new ChartSeries("objective", [.. Enumerable.Range(1, kMeans.History.Count).Select(i => (double)i)], kMeans.History)],
        }.ToSvg());
        output.Picture("K-means", mesh, new RenderOptions { Coloring = Coloring.FaceLabels(smooth.Labels), Legend = false });
        output.Picture("variational shape approximation", mesh, new RenderOptions { Coloring = Coloring.FaceLabels(flat.Segmentation.Labels), Legend = false });
    }
}
