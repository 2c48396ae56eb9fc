using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.3 亏格: the genus counts the cuts along closed curves that leave a surface in one piece.</summary>
[Demo("11.3", "亏格", "Genus")]
public static class Section_11_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Line($"genus of the model: {mesh.Genus}");
        if (mesh.Genus == 0)
            mesh = Tori.KHoled(3);
        // Of each pair of generators one is cut; every cut adds two boundary loops and takes one handle away.
        MeshLoop[] cuts = [.. NotCrossing(HomologyGenerators.Compute(mesh, new() { Shorten = true }), mesh.Genus)];
        output.Table("cutting handle after handle", ["cuts", "components", "boundary loops", "genus", "χ"], Enumerable.Range(0, Math.Min(cuts.Length, 8) + 1).Select(count =>
        {
            TopologyReport r = EdgeCutting.CutAlong(mesh, cuts.Take(count).SelectMany(l => l.HalfEdges.Select(h => h.Edge))).Mesh.ComputeTopology();
            return new object[] { count, r.Components.Count, r.BoundaryLoops, r.Genus, r.EulerCharacteristic };
        }));
        output.Picture("the cuts", mesh, new RenderOptions
        {
            HighlightedEdges = [.. cuts.Select((loop, i) => new EdgeMarks([.. loop.HalfEdges.Select(h => h.Edge.Index)], Palette.Categorical(i), 4) { HiddenOpacity = 0.25 })],
        });
    }

    /// <summary>Loops without common vertices, none of which cuts a piece off together with those before.</summary>
    private static IEnumerable<MeshLoop> NotCrossing(IReadOnlyList<MeshLoop> loops, int most)
    {
        var used = new HashSet<Vertex>();
        var edges = new List<Edge>();
        int pieces = loops[0].HalfEdges[0].Mesh.ComponentCount, found = 0;
        foreach (MeshLoop loop in loops.OrderBy(l => l.Length))
        {
            if (found == most || loop.Vertices.Any(used.Contains))
                continue;
            edges.AddRange(loop.HalfEdges.Select(h => h.Edge));
            if (EdgeCutting.CutAlong(loop.HalfEdges[0].Mesh, edges).Mesh.ComponentCount > pieces)
            {
                edges.RemoveRange(edges.Count - loop.HalfEdges.Count, loop.HalfEdges.Count);
                continue;
            }
            used.UnionWith(loop.Vertices);
            found++;
            yield return loop;
        }
    }
}
