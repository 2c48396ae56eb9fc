using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.1 面积: areas of faces, and of vertices in three ways.</summary>
[Demo("10.1", "面积", "Area")]
public static class Section_10_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        double[] mixed = triangles.ComputeMixedAreas(), voronoi = triangles.ComputeVoronoiAreas();
        output.Table(
            "the whole mesh",
            ("area by cross products", triangles.Area),
            ("area by Heron's formula", triangles.Faces.Sum(f => f.HeronArea)),
            ("Σ mixed areas", mixed.Sum()),
            ("Σ Voronoi areas", voronoi.Sum()),
            ("Σ barycentric areas", triangles.ComputeBarycentricAreas().Sum()),
            ("vertices with negative Voronoi area", voronoi.Count(a => a < 0)));
        output.Picture("mixed area", triangles, Coloring.VertexScalars(mixed, title: "mixed area").WithoutOutliers());

        output.Table("a needle of side 1, and Heron's formula", ["width", "area", "relative error in stable order", "as printed in books"], new[] { 1e-2, 1e-4, 1e-6, 1e-8 }.Select(width =>
        {
            // Two sides of 1 and one of the width: the area is known exactly.
            double exact = width / 4 * Math.Sqrt(4 - (width * width)), s = (2 + width) / 2;
            var needle = new Triangle(new(0, 0, 0), new(2 * exact / width, -width / 2, 0), new(2 * exact / width, width / 2, 0));
            double printed = Math.Sqrt(s * (s - 1) * (s - 1) * (s - width));
            return new object[] { width, exact, Math.Abs((needle.HeronArea / exact) - 1), Math.Abs((printed / exact) - 1) };
        }));
    }
}
