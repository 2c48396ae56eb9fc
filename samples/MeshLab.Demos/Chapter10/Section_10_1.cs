using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.1 面积 and §10.2 体积: areas of faces and vertices in every way, the volume, centroids.</summary>
[Demo("10.1", "面积与体积", "Area and volume")]
public static class Section_10_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        MassProperties mass = triangles.ComputeMassProperties();
        double[] mixed = triangles.ComputeMixedAreas();
        output.Table(
            "the whole mesh",
            ("area by cross products", mass.Area),
            ("area by Heron's formula", triangles.Faces.Sum(f => f.HeronArea)),
            ("Σ mixed areas", mixed.Sum()),
            ("Σ Voronoi areas", triangles.ComputeVoronoiAreas().Sum()),
            ("Σ barycentric areas", triangles.ComputeBarycentricAreas().Sum()),
            ("volume", mass.Volume),
            ("centroid of the surface", mass.SurfaceCentroid),
            ("centroid of the solid", mass.VolumeCentroid),
            ("faces of zero area", mass.ZeroAreaFaces));
        output.Picture("mixed area", triangles, Coloring.VertexScalars(mixed, title: "mixed area").WithoutOutliers());

        var needle = new Triangle(new(0, 0, 0), new(1, -5e-9, 0), new(1, 5e-9, 0));
        double a = 1, b = (needle.C - needle.B).Length, s = (a + a + b) / 2;
        output.Line($"a needle 1e-8 wide: area {needle.Area}, Heron's formula in stable order {needle.HeronArea}, as printed in books {Math.Sqrt(s * (s - a) * (s - a) * (s - b))}");
    }
}
