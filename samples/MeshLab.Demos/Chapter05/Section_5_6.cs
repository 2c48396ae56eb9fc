using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.6 网格边界 and §5.7 选中边划分的区域: the boundary loops, and the regions that sharp edges cut out.</summary>
[Demo("5.6", "网格边界与区域", "Boundary loops and regions")]
public static class Section_5_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        IReadOnlyList<BoundaryLoop> loops = mesh.FindBoundaryLoops();
        output.Table(
            "boundary loops",
            ["first vertex", "edges", "length"],
            loops.Take(20).Select(loop => new object[] { loop.Vertices[0], loop.Count, loop.Length }));

        double[] angles = mesh.ComputeDihedralAngles();
        bool[] isSharp = [.. angles.Select(angle => Math.Abs(angle) > 30 * Math.PI / 180)];
        FaceRegions regions = mesh.FindRegions(isSharp);
        output.Line($"{isSharp.Count(sharp => sharp)} edges bend by more than 30°; they cut out {regions.Count} regions.");
        output.Picture("regions", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceLabels(regions.Labels),
            HighlightedEdges = [new([.. mesh.BoundaryEdges.Select(e => e.Index)], new Color(0.8f, 0.1f, 0.1f))],
        });
    }
}
