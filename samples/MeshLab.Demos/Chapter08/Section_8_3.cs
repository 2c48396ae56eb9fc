using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter08;

/// <summary>§8.3 √3 细分: faces grow by three per step; two steps cut every edge in three, on the boundary too.</summary>
[Demo("8.3", "√3 细分", "√3 subdivision")]
public static class Section_8_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh coarse = Coarse.Of(mesh), grid = Grids.Grid(5, 5);
        foreach (int steps in (int[])[1, 2, 3, 4])
        {
            Mesh finer = Sqrt3Subdivision.Subdivide(coarse, new SubdivisionOptions { Steps = steps });
            output.Line($"{steps} step{(steps > 1 ? "s" : "")}: {finer.Faces.Count} faces = {coarse.Faces.Count} · 3^{steps}");
            output.Picture($"steps {steps}", finer, new RenderOptions { Wireframe = steps < 4, Shading = Shading.Flat });
        }
        foreach (int steps in (int[])[1, 2])
            output.Picture($"boundary {steps}", Sqrt3Subdivision.Subdivide(grid, new SubdivisionOptions { Steps = steps }), new RenderOptions { Wireframe = true, View = new View(0, 89) });
    }
}
