using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.5 同调群的生成元: 2g loops by tree and cotree, and shortened.</summary>
[Demo("11.5", "同调群的生成元", "Homology generators")]
public static class Section_11_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (mesh.Genus == 0)
            mesh = Generation.Tori.KHoled(2);
        IReadOnlyList<MeshLoop> plain = HomologyGenerators.Compute(mesh), shortened = HomologyGenerators.Compute(mesh, new() { Shorten = true });
        output.Table(
            $"genus {mesh.Genus}: {plain.Count} generators",
            ["", "together", "shortest", "longest"],
            [Row("by tree and cotree", plain), Row("chosen and shortened", shortened)]);
        Show("by tree and cotree", plain);
        Show("shortened", shortened);

        void Show(string name, IReadOnlyList<MeshLoop> loops) => output.Picture(name, mesh, new RenderOptions
        {
            Polylines = [.. loops.Select((loop, i) => new Polyline([.. loop.Vertices.Select(v => v.Position)], Palette.Categorical(i), 4) { Closed = true, HiddenOpacity = 0.25 })],
        });
    }

    private static object[] Row(string name, IReadOnlyList<MeshLoop> loops) => [name, loops.Sum(l => l.Length), loops.Min(l => l.Length), loops.Max(l => l.Length)];
}
