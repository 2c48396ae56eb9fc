using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.1 连通分量: the components of a mesh, and what is wrong with a set of polygons that is none.</summary>
[Demo("11.1", "连通分量", "Components, and polygons that are no mesh")]
public static class Section_11_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        TopologyReport report = mesh.ComputeTopology();
        output.Table(
            $"components: {report.Components.Count}, isolated vertices: {report.IsolatedVertices}",
            ["first vertex", "V", "E", "F", "χ", "boundary loops", "genus"],
            report.Components.Take(20).Select(c => new object[] { c.FirstVertex, c.Vertices, c.Edges, c.Faces, c.EulerCharacteristic, c.BoundaryLoops, c.Genus }));
        output.Picture("components", mesh, Coloring.FaceLabels(mesh.FindComponents().FaceLabels, "component"));

        output.Table("sets of polygons", ["", "manifold", "orientable", "oriented", "what is wrong"], Soups(mesh).Select(named =>
        {
            SoupTopologyReport soup = SoupTopology.Examine(named.Soup);
            string[] wrong =
            [
                .. soup.NonManifoldEdges.Take(1).Select(e => $"edge {e}"), .. soup.NonManifoldVertices.Take(3).Select(v => $"fans meet in v{v}"),
                .. soup.FlippedFaces.Take(1).Select(f => $"f{f} to be turned"), .. soup.UnorientableEdges.Take(1).Select(e => $"closes a Möbius band: {e}"),
            ];
            return new object[] { named.Name, soup.IsManifold, soup.IsOrientable, soup.IsOriented, string.Join("; ", wrong) };
        }));
    }

    private static IEnumerable<(string Name, PolygonSoup Soup)> Soups(Mesh mesh) =>
    [
        ("the model", PolygonSoup.From(mesh)),
        ("three faces on an edge", Corners([0, 1, 2], [1, 0, 3], [0, 1, 4])),
        ("a bow tie", Corners([0, 1, 2], [0, 3, 4])),
        ("a face turned round", Corners([0, 1, 2], [0, 3, 1], [0, 3, 2], [1, 3, 2])),
        ("a Möbius band", Corners([0, 2, 3, 1], [2, 4, 5, 3], [4, 1, 0, 5])),
    ];

    private static PolygonSoup Corners(params int[][] faces) => PolygonSoup.From(new Numerics.Vector3D[faces.Max(f => f.Max()) + 1], faces);
}
