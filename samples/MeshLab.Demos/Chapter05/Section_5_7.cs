using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.7 选中边划分的区域: the regions that selected edges cut out; here those that bend sharply.</summary>
[Demo("5.7", "选中边划分的区域", "Regions between selected edges")]
public static class Section_5_7
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        double[] angles = [.. mesh.ComputeUnsignedDihedralAngles().Select(angle => angle * 180 / Math.PI)];
        output.Table("regions between edges that bend by more", ["degrees", "selected edges", "regions", "largest"], new[] { 20, 30, 40, 60 }.Select(limit =>
        {
            FaceRegions cut = mesh.FindRegions([.. angles.Select(angle => angle > limit)]);
            return new object[] { limit, angles.Count(angle => angle > limit), cut.Count, cut.Sizes.DefaultIfEmpty().Max() };
        }));

        // The same by the textbook's flag on the edges.
        foreach (Edge e in mesh.Edges.Where(e => angles[e.Index] > 30))
            e.Traits.SelectedFlag = 1;
        FaceRegions regions = mesh.FindSelectedRegions();
        output.Picture("regions", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceLabels(regions.Labels, "region"),
            HighlightedEdges = [new([.. mesh.Edges.Where(e => e.Traits.SelectedFlag != 0).Select(e => e.Index)], Closeup.Red, 1.5)],
        });
    }
}
