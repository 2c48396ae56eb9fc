using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter02;

/// <summary>What the demos of chapter 2 show of each shape.</summary>
internal static class ShapeTable
{
    private static readonly View FromAbove = new(30, 60), FromTheSide = new(75, 24);

    public static void Show(DemoOutput output, string title, params (string Name, Mesh Mesh)[] shapes)
    {
        output.Table(
            title,
            ["shape", "V", "E", "F", "V − E + F", "closed"],
            shapes.Select(shape => new object[]
            {
                shape.Name, shape.Mesh.Vertices.Count, shape.Mesh.Edges.Count, shape.Mesh.Faces.Count,
                shape.Mesh.Vertices.Count - shape.Mesh.Edges.Count + shape.Mesh.Faces.Count, shape.Mesh.IsClosed ? "yes" : "no",
            }));
        foreach ((string name, Mesh mesh) in shapes)
            output.Picture(name, mesh, new RenderOptions { Wireframe = true, View = IsFlat(mesh) ? FromAbove : FromTheSide });
    }

    private static bool IsFlat(Mesh mesh) => mesh.BoundingBox.Size.Z == 0;
}
