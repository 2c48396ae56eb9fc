using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter08;

/// <summary>§8.1 Loop 细分: three steps, the limit beside them, and a cube whose upper edges stay sharp.</summary>
[Demo("8.1", "Loop 细分", "Loop subdivision")]
public static class Section_8_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh coarse = Coarse.Of(mesh);
        output.Picture("before", coarse, new RenderOptions { Wireframe = true, Shading = Shading.Flat });
        foreach (int steps in (int[])[1, 2, 3])
        {
            Mesh finer = LoopSubdivision.Subdivide(coarse, new SubdivisionOptions { Steps = steps });
            output.Line($"{steps} step{(steps > 1 ? "s" : "")}: {finer.Vertices.Count} vertices, {finer.Faces.Count} faces");
            output.Picture($"steps {steps}", finer, new RenderOptions { Wireframe = steps < 3, Shading = steps < 3 ? Shading.Flat : Shading.Smooth });
        }

        LimitPoints limit = LimitSurface.OfLoop(coarse);
        double farthest = coarse.Vertices.Max(v => (limit.Positions[v.Index] - v.Position).Length);
        output.Line($"no vertex moves farther than {farthest:G4} on its way to the limit");

        Mesh cube = Prisms.Cube();
        // The square around the top; the longer diagonal is none of its sides.
        Creases.Set(cube, cube.Edges.Where(e => e.Vertex0.Position.Z > 0 && e.Vertex1.Position.Z > 0 && (e.Vertex0.Position - e.Vertex1.Position).Length < 0.8));
        output.Picture("creases", LoopSubdivision.Subdivide(cube, new SubdivisionOptions { Steps = 4 }));
    }
}
