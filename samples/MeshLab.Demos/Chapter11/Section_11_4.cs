using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.4 高斯–博内定理: the angle defects add up to 2πχ, also with a boundary.</summary>
[Demo("11.4", "高斯–博内定理", "Gauss–Bonnet")]
public static class Section_11_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        (string Name, Mesh Mesh)[] shapes =
        [
            ("the model", triangles), ("sphere", AnalyticSurface.Sphere.Mesh(16)), ("torus", AnalyticSurface.Torus.Mesh(16)), ("catenoid, open", AnalyticSurface.Catenoid.Mesh(16)),
            ("three holes", Generation.Tori.KHoled(3)),
        ];
        output.Table("Σ defects = 2πχ", ["", "Σ defects inside", "Σ turning of the boundary", "χ", "2πχ", "difference"], shapes.Select(shape =>
        {
            GaussBonnetReport r = GaussBonnet.Check(shape.Mesh);
            return new object[] { shape.Name, r.InteriorDefects, r.BoundaryTurning, r.EulerCharacteristic, r.Expected, r.Difference };
        }));
        output.Picture(
            "angle defects", triangles, Coloring.VertexScalars(triangles.ComputeAngleDefects(), ColorMap.Coolwarm, "angle defect", "rad").WithoutOutliers(0.02).Symmetric());
    }
}
