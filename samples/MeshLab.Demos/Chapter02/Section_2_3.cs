using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.3 柱体: two polygons, joined by two triangles per side.</summary>
[Demo("2.3", "柱体", "Prisms")]
public static class Section_2_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ShapeTable.Show(
            output,
            "prisms",
            ("cube", Prisms.Cube()),
            ("cylinder", Prisms.Cylinder()),
            ("open cylinder", Prisms.OpenCylinder(50, 8)));
        Mesh open = Prisms.OpenCylinder(4);
        output.Table(
            "texture coordinates at the seam of an open cylinder of four sides",
            ["corner", "position", "u", "v"],
            open.Faces[6].HalfEdges.ToArray().Select(h => new object[]
            {
                h, h.Target.Position, h.Traits.TextureCoordinate.X, h.Traits.TextureCoordinate.Y,
            }));
    }
}
