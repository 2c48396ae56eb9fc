using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.2 锥体: a base polygon facing down, and an apex.</summary>
[Demo("2.2", "锥体", "Cones")]
public static class Section_2_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ShapeTable.Show(
            output,
            "cones",
            ("pyramid", Cones.Pyramid()),
            ("tetrahedron", Cones.Tetrahedron()),
            ("cone", Cones.Cone()));
        double[] lengths = [.. Cones.Tetrahedron().Edges.Select(e => (e.Vertex0.Position - e.Vertex1.Position).Length)];
        output.Line($"the tetrahedron's edges are from {lengths.Min()} to {lengths.Max()} long: it is regular");
    }
}
