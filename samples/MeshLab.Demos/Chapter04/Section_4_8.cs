using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.8 其他基本操作: noise of two sorts, groups of selected vertices, renumbering by space, turning inside out.</summary>
[Demo("4.8", "其他基本操作", "Noise, groups, renumbering, orientation")]
public static class Section_4_8
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        mesh.Normalize();
        output.Line($"normalised to {string.Join(" … ", mesh.BoxCorners().Where((_, i) => i is 0 or 7))}");

        Mesh rough = mesh.Clone(), dented = mesh.Clone();
        rough.AddNoise(1.4, seed: 1);
        dented.AddNoise(1.4, seed: 1, smoothingSteps: 10);
        output.Picture("noise", rough, Coloring.Default);
        output.Picture("smooth noise", dented, Coloring.Default);

        foreach (Vertex v in mesh.Vertices)
            v.Traits.SelectedFlag = Math.Sin(25 * v.Position.Y) > 0.3 ? 1 : 0;
        output.Line($"{mesh.LabelSelectedGroups()} groups of selected vertices");
        output.Picture("groups", mesh, Coloring.VertexLabels([.. mesh.Vertices.Select(v => v.Traits.SelectedFlag)], "group"));

        output.Line($"mean index distance of neighbours: {Spread(mesh):F0}");
        mesh.ReorderBySpace();
        output.Line($"after renumbering by space: {Spread(mesh):F0}");

        mesh.ReverseOrientation();
        output.Line($"turned inside out; violated rules: {mesh.Validate().Count}");
    }

    private static double Spread(Mesh mesh) => mesh.Edges.Average(e => Math.Abs(e.Vertex0.Index - e.Vertex1.Index));
}
