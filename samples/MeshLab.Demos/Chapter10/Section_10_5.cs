using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.5 二面角: how much the surface bends at an edge; positive where it is convex.</summary>
[Demo("10.5", "二面角", "Dihedral angles")]
public static class Section_10_5
{
    private const double Sharp = 30;

    public static void Run(Mesh mesh, DemoOutput output)
    {
        double[] angles = [.. mesh.ComputeDihedralAngles().Select(a => a * 180 / Math.PI)], inner = [.. angles.Where(double.IsFinite)];
        output.Table(
            "dihedral angles in degrees",
            ("inner edges", inner.Length),
            ("convex", inner.Count(a => a > 0)),
            ("concave", inner.Count(a => a < 0)),
            ("sharpest convex", inner.DefaultIfEmpty(double.NaN).Max()),
            ("sharpest concave", inner.DefaultIfEmpty(double.NaN).Min()),
            ("mean, unsigned", inner.Select(Math.Abs).DefaultIfEmpty(double.NaN).Average()),
            ($"above {Sharp}", inner.Count(a => Math.Abs(a) > Sharp)));
        output.Svg("dihedral angles", SvgChart.Histogram("dihedral angles, convex positive", inner, 40, "degrees").ToSvg());

        (Color convex, Color concave) = (Palette.Categorical(1), Palette.Categorical(0));
        output.Picture("sharp edges", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceColors(Enumerable.Repeat(Coloring.Default.Color, mesh.FaceSlots).ToArray(), $"above {Sharp} degrees", [new("convex", convex), new("concave", concave)]),
            HighlightedEdges = [Marks(a => a > Sharp, convex), Marks(a => a < -Sharp, concave)],
        });

        EdgeMarks Marks(Func<double, bool> which, Color color) => new([.. mesh.Edges.Where(e => which(angles[e.Index])).Select(e => e.Index)], color);
    }
}
