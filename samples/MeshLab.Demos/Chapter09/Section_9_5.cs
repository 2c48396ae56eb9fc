using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter09;

/// <summary>§9.5 分割: after the steps before it, only valences above 7 are left; each such vertex is split in its fresh ring.</summary>
[Demo("9.5", "分割高度数点", "Splitting vertices of high valence")]
public static class Section_9_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        mesh.RaiseValenceThree();
        mesh.RaiseValenceFour();
        Mesh fine = mesh.SplitFacesIntoNine();
        ValenceTable.Show(output, "before", fine);
        output.Line($"{fine.LowerHighValences()} vertices split off");
        ValenceTable.Show(output, "after", fine);
        output.Picture("valence", fine, Coloring.ByValence(fine));
    }
}
