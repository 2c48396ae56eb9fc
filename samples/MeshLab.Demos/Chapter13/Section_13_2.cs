using MeshLab.Demos.Hosting;
using MeshLab.Segmentation;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter13;

/// <summary>§13.2 区域增长: regions grown by the areas of one-rings and by normals, with the three references.</summary>
[Demo("13.2", "区域增长", "Region growing")]
public static class Section_13_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        var rows = new List<IReadOnlyList<object>>();
        foreach (GrowingReference reference in Enum.GetValues<GrowingReference>())
        {
            rows.Add(
            [
                reference,
                RegionGrowing.ByVertices(mesh, new RegionGrowingOptions { Reference = reference }).Count,
                RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Reference = reference, Threshold = 0.449 }).Count,
                RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Reference = reference, Threshold = 0.898 }).Count,
            ]);
        }
        output.Table("regions", ["compared with", "by vertices", "by faces, 63°", "by faces, 26°"], rows);

        FaceSegmentation faces = RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Reference = GrowingReference.Seed });
        output.Picture("by faces, compared with the seed", mesh, new RenderOptions { Coloring = Coloring.FaceLabels(faces.Labels), Legend = false });
    }
}
