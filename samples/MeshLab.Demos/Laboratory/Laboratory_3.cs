using MeshLab.Demos.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Laboratory;

/// <summary>L3 二次误差简化: a quarter of the faces, by the book's steps and by the tool's two modes.</summary>
[Demo("L3", "二次误差简化到四分之一", "Quadric simplification to a quarter")]
public static class Laboratory_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Picture("model", mesh);
        var rows = new List<object[]>();
        foreach (QuadricMode mode in (QuadricMode[])[QuadricMode.Textbook, QuadricMode.Fast, QuadricMode.Accurate])
        {
            Mesh quarter = mesh.Clone();
            SimplificationResult result = quarter.Simplify(new QuadricOptions { TargetRatio = 0.25, Mode = mode });
            MeshDistanceReport distance = mesh.DistanceTo(quarter, new MeshDistanceOptions { Samples = 20_000 });
            rows.Add([mode, result.StopReason, result.FacesBefore, result.FacesAfter, result.Collapses, distance.SymmetricRms / distance.Diagonal, distance.Hausdorff / distance.Diagonal]);
            output.Picture(mode.ToString(), quarter);
        }
        output.Table("a quarter of the faces; distances as a share of the diagonal", ["mode", "stopped", "before", "after", "collapses", "rms", "Hausdorff"], rows);
    }
}
