using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.4 球面: by meridians and parallels, and from the icosahedron.</summary>
[Demo("2.4", "球面", "Spheres")]
public static class Section_2_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ShapeTable.Show(
            output,
            "spheres",
            ("UV sphere", Spheres.UVSphere(16)),
            ("icosphere", Spheres.Icosphere(2)),
            ("ellipsoid", Spheres.Ellipsoid(n: 24)));
        foreach (int n in (int[])[8, 16, 32, 64])
        {
            Mesh sphere = Spheres.UVSphere(n);
            output.Line($"n = {n}: V = n(n − 1) + 2 = {sphere.Vertices.Count}, F = 2n(n − 1) = {sphere.Faces.Count}");
        }
    }
}
