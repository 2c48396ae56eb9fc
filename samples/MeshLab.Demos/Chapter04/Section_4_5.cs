using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.5 分割点: splits every vertex of high valence between its first neighbour and the one across, until none has more than seven.</summary>
[Demo("4.5", "分割点", "Vertex split")]
public static class Section_4_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Picture("before", mesh, Coloring.ByValence(mesh));
        int highest = mesh.Vertices.Max(v => v.Valence), splits = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            while (!v.IsBoundary && v.Valence > 7)
            {
                Vertex[] ring = [.. v.Neighbors];
                v.Split(ring[0], ring[ring.Length / 2]);
                splits++;
            }
        }
        output.Line($"{splits} splits; the highest inner valence was {highest}, the new vertices took half of each ring");
        output.Picture("after", mesh, Coloring.ByValence(mesh));
    }
}
