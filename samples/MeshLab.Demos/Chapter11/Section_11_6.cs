using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.6 切割图: the edges along which a surface opens into one disk.</summary>
[Demo("11.6", "切割图", "The cut graph")]
public static class Section_11_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (mesh.Genus == 0)
            mesh = Generation.Tori.KHoled(2);
        Edge[] cutGraph = mesh.FindCutGraph();
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, cutGraph);
        output.Table(
            "before and after the cut",
            ["", "components", "χ", "boundary loops", "genus"],
            [Row("before", mesh), Row($"cut along {cutGraph.Length} edges", cut.Mesh)]);
        output.Picture("cut graph", mesh, new RenderOptions { HighlightedEdges = [new([.. cutGraph.Select(e => e.Index)], new Color(0.8f, 0.1f, 0.1f)) { HiddenOpacity = 0.2 }] });
    }

    private static object[] Row(string name, Mesh mesh)
    {
        TopologyReport r = mesh.ComputeTopology();
        return [name, r.Components.Count, r.EulerCharacteristic, r.BoundaryLoops, r.Genus];
    }
}
