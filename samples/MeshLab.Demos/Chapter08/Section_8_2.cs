using System.Globalization;
using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter08;

/// <summary>§8.2 蝴蝶细分: the modified butterfly keeps every old vertex in its place.</summary>
[Demo("8.2", "蝴蝶细分", "Modified butterfly subdivision")]
public static class Section_8_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh coarse = Coarse.Of(mesh);
        Mesh finer = ButterflySubdivision.Subdivide(coarse, new SubdivisionOptions { Steps = 3 });

        bool kept = coarse.Vertices.All(v => finer.Vertices[v.Index].Position == v.Position);
        output.Line($"{finer.Faces.Count} faces; the old vertices are where they were: {kept}");
        foreach (int valence in (int[])[3, 4, 5, 7])
            output.Line($"weights around a vertex of valence {valence}: {string.Join(" ", ButterflySubdivision.ExtraordinaryWeights(valence).Select(w => w.ToString("F4", CultureInfo.InvariantCulture)))}");

        output.Picture("before", coarse, new RenderOptions { Wireframe = true, Shading = Shading.Flat });
        output.Picture("after", finer);
    }
}
