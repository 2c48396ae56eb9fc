using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.1 正多边形: a triangle, a square, and fans around a centre; a 50-gon serves as circle.</summary>
[Demo("2.1", "正多边形", "Regular polygons and the circle")]
public static class Section_2_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Line($"A 50-gon misses the circle's area by {1 - 25 / Math.PI * Math.Sin(2 * Math.PI / 50):P2}.");
        ShapeTable.Show(
            output,
            "polygons",
            ("triangle", Polygons.Polygon(3)),
            ("square", Polygons.Polygon(4)),
            ("hexagon", Polygons.Polygon(6)),
            ("circle", Polygons.Circle()),
            ("annulus", Polygons.Annulus()));
    }
}
