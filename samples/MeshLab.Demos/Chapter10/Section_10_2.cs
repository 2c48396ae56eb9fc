using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.2 体积: the signed volume, centroids and inertia; exact values on a sphere, and what the origin does to the digits.</summary>
[Demo("10.2", "体积", "Volume")]
public static class Section_10_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        MassProperties mass = mesh.ComputeMassProperties();
        output.Table(
            mesh.IsClosed ? "the solid" : "the cone from the origin over the surface, which is open",
            ("volume", mass.Volume),
            ("centroid of the surface", mass.SurfaceCentroid),
            ("centroid of the solid", mass.VolumeCentroid),
            ("inertia, trace", mass.Inertia.Trace),
            ("faces of zero area", mass.ZeroAreaFaces));
        output.Picture("centroids", mesh, new RenderOptions
        {
            Surface = false,
            Wireframe = true,
            WireframeColor = new Color(0.3f, 0.35f, 0.45f, 0.6f),
            Points =
            [
                new([mass.SurfaceCentroid], Palette.Categorical(0)),
                .. double.IsFinite(mass.VolumeCentroid.X) ? [new PointMarks([mass.VolumeCentroid], Palette.Categorical(1))] : Array.Empty<PointMarks>(),
            ],
            Coloring = Coloring.FaceLabels(new int[mesh.FaceSlots], "centroid of", [new("the surface", Palette.Categorical(0)), new("the solid", Palette.Categorical(1))]),
        });

        output.Table("the unit sphere in triangles", ["faces", "volume", "of 4π/3", "centroid's distance from the middle"], new[] { 8, 16, 32, 64 }.Select(n =>
        {
            Mesh sphere = AnalyticSurface.Sphere.Mesh(n);
            MassProperties ball = sphere.ComputeMassProperties();
            return new object[] { sphere.Faces.Count, ball.Volume, ball.Volume / (4 * Math.PI / 3), ball.VolumeCentroid.Length };
        }));

        Mesh cube = Generation.Polyhedra.Cube(Math.Sqrt(3) / 2);
        output.Table("a cube of side 1, moved away", ["by", "volume", "error", "error of the plain sum about the origin"], new[] { 0, 1e3, 1e6 }.Select(offset =>
        {
            Mesh moved = cube.Clone();
            foreach (ref Vector3D p in moved.Positions)
                p += new Vector3D(offset, -offset, offset);
            return new object[] { offset, moved.Volume, Math.Abs(moved.Volume - 1), Math.Abs(PlainSum(moved) - 1) };
        }));
    }

    private static double PlainSum(Mesh mesh) => mesh.Faces.Sum(f =>
    {
        Vertex[] v = [.. f.Vertices];
        return Enumerable.Range(1, v.Length - 2).Sum(i => Vector3D.Dot(v[0].Position, Vector3D.Cross(v[i].Position, v[i + 1].Position)) / 6);
    });
}
