using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter09;

/// <summary>§9.3 4→5: a triangle at each inner vertex of valence 4, and its neighbours, become sixteen triangles.</summary>
[Demo("9.3", "4→5 操作", "From valence 4 to 5")]
public static class Section_9_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        mesh.RaiseValenceThree();
        ValenceTable.Show(output, "before", mesh);
        output.Line($"{mesh.RaiseValenceFour()} triangles replaced by sixteen");
        ValenceTable.Show(output, "after", mesh);
        output.Picture("valence", mesh, Coloring.ByValence(mesh));
    }
}
