using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter09;

/// <summary>§9.2 3→4: the edge opposite to each inner vertex of valence 3 is split.</summary>
[Demo("9.2", "3→4 操作", "From valence 3 to 4")]
public static class Section_9_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (!mesh.CountInnerValences().ContainsKey(3))
        {
            output.Line($"no inner vertex has valence 3: one is put into every hundredth face");
            foreach (Face face in mesh.Faces.Where(f => f.Index % 100 == 0).ToArray())
                face.Split();
        }
        ValenceTable.Show(output, "before", mesh);
        output.Line($"{mesh.RaiseValenceThree()} edges split");
        ValenceTable.Show(output, "after", mesh);
        output.Picture("valence", mesh, Coloring.ByValence(mesh));
    }
}
