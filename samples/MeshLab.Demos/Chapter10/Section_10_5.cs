using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.5 二面角 and §10.6 角度: dihedral angles with sign, corner angles, the shape of triangles.</summary>
[Demo("10.5", "二面角与角度", "Dihedral angles, corner angles, quality")]
public static class Section_10_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        double[] dihedrals = [.. triangles.ComputeDihedralAngles().Where(double.IsFinite).Select(Degrees)];
        double[] corners = [.. triangles.ComputeCornerAngles().Where(double.IsFinite).Select(Degrees)];
        double[] quality = triangles.ComputeFaceQualities();
        output.Table(
            "angles in degrees",
            ["", "min", "mean", "max"],
            [Row("dihedral", dihedrals), Row("corner", corners), Row("quality 4√3 A / Σ l²", quality)]);
        output.Svg("dihedral angles", SvgChart.Histogram("dihedral angles, convex positive", dihedrals, 40, "degrees").ToSvg());
        output.Svg("corner angles", SvgChart.Histogram("corner angles", corners, 36, "degrees").ToSvg());
        output.Picture("quality", triangles, Coloring.FaceScalars(quality, title: "quality").WithRange(0, 1));
    }

    private static object[] Row(string name, double[] values)
    {
        ValueRange range = ValueRange.Of(values);
        return [name, range.Min, range.Mean, range.Max];
    }

    private static double Degrees(double radians) => radians * 180 / Math.PI;
}
