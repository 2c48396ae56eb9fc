using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.1–11.4 Components, Euler's theorem, genus, Gauss–Bonnet.</summary>
[Demo("11.1", "欧拉公式与高斯–博内定理", "Euler's theorem and Gauss–Bonnet")]
public static class Section_11_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        TopologyReport report = mesh.ComputeTopology();
        output.Line($"{report}");
        output.Table(
            "components",
            ["first vertex", "V", "E", "F", "χ", "boundary loops", "genus"],
            report.Components.Take(20).Select(c => new object[] { c.FirstVertex, c.Vertices, c.Edges, c.Faces, c.EulerCharacteristic, c.BoundaryLoops, c.Genus }));

        GaussBonnetReport gauss = GaussBonnet.Check(mesh);
        output.Table(
            "Gauss–Bonnet",
            ("Σ defects inside", gauss.InteriorDefects),
            ("Σ turning of the boundary", gauss.BoundaryTurning),
            ("2πχ", gauss.Expected),
            ("difference", gauss.Difference));
        output.Picture("components", mesh, Coloring.FaceLabels(mesh.FindComponents().FaceLabels));

        SoupTopologyReport soup = SoupTopology.Examine(PolygonSoup.From(mesh));
        output.Line($"as polygons: manifold {soup.IsManifold}, orientable {soup.IsOrientable}, closed {soup.IsClosed}");
    }
}
