using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.5 分割组件: one mesh per component, and one per region between sharp edges.</summary>
[Demo("6.5", "分割组件", "Splitting into parts")]
public static class Section_6_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        IReadOnlyList<MeshPart> components = mesh.SplitComponents(), regions = mesh.SplitRegions(Math.PI / 5);
        output.Table("parts", ["", "number", "faces of the largest"], [Row("components", components), Row("regions at 36°", regions)]);

        var label = new int[mesh.FaceSlots];
        for (int i = 0; i < regions.Count; i++)
        {
            foreach (int f in regions[i].SourceFace)
                label[f] = i;
        }
        output.Picture("regions", mesh, Coloring.FaceLabels(label));

        object[] Row(string name, IReadOnlyList<MeshPart> parts) => [name, parts.Count, parts.Count == 0 ? 0 : parts.Max(p => p.Mesh.Faces.Count)];
    }
}
