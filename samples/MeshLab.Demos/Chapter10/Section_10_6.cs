using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.6 角度: the angles of the corners, and the shape of the triangles.</summary>
[Demo("10.6", "角度", "Corner angles and the shape of triangles")]
public static class Section_10_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        double[] corners = [.. triangles.ComputeCornerAngles().Where(double.IsFinite).Select(a => a * 180 / Math.PI)];
        double[] quality = triangles.ComputeFaceQualities();
        output.Table(
            "corners and triangles",
            ["", "min", "mean", "max"],
            [Row("corner angle in degrees", corners), .. Enum.GetValues<QualityMeasure>().Select(m => Row($"quality {m}", triangles.ComputeFaceQualities(m)))]);
        output.Line($"{corners.Count(a => a > 90)} corners are obtuse, {corners.Count(a => a < 10)} below 10 degrees.");
        output.Svg("corner angles", SvgChart.Histogram("corner angles", corners, 36, "degrees").ToSvg());
        output.Picture("quality", triangles, Coloring.FaceScalars(quality, title: "quality").WithRange(0, 1));
    }

    private static object[] Row(string name, double[] values)
    {
        ValueRange range = ValueRange.Of(values);
        return [name, range.Min, range.Mean, range.Max];
    }
}
