using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter09;

/// <summary>§9.4 面分裂: every triangle into nine gives every old vertex a fresh ring of vertices with valence 6.</summary>
[Demo("9.4", "面分裂", "Splitting faces into nine")]
public static class Section_9_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ValenceTable.Show(output, "before", mesh);
        Mesh fine = mesh.SplitFacesIntoNine();
        ValenceTable.Show(output, "after", fine);
        output.Picture("before", mesh, Coloring.ByValence(mesh));
        output.Picture("after", fine, Coloring.ByValence(fine));
    }
}
