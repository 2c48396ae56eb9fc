using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.5 同调群的生成元 and §11.6 切割图: 2g loops by tree and cotree, and the cut that leaves one disk.</summary>
[Demo("11.5", "生成元与切割图", "Homology generators and the cut graph")]
public static class Section_11_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (mesh.Genus == 0)
            mesh = Generation.Tori.Torus(m: 48, n: 24);
        IReadOnlyList<MeshLoop> plain = HomologyGenerators.Compute(mesh), shortened = HomologyGenerators.Compute(mesh, new() { Shorten = true });
        output.Line($"genus {mesh.Genus}: {plain.Count} generators, together {plain.Sum(l => l.Length)} long; shortened {shortened.Sum(l => l.Length)}");
        output.Picture("generators", mesh, new RenderOptions
        {
            Polylines = [.. shortened.Select((loop, i) => new Polyline([.. loop.Vertices.Select(v => v.Position)], Palette.Categorical(i), 4) { Closed = true, HiddenOpacity = 0.25 })],
        });

        Edge[] cutGraph = mesh.FindCutGraph();
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, cutGraph);
        output.Line($"cutting along {cutGraph.Length} edges leaves: {cut.Mesh.ComputeTopology()}");
        output.Picture("cut graph", mesh, new RenderOptions { HighlightedEdges = [new([.. cutGraph.Select(e => e.Index)], new Color(0.8f, 0.1f, 0.1f)) { HiddenOpacity = 0.2 }] });
    }
}
