using MeshLab.Demos.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter07;

/// <summary>§7.2 二次误差度量: the same number of faces in the three modes.</summary>
[Demo("7.2", "二次误差度量", "Quadric error metric")]
public static class Section_7_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        int target = Math.Max(20, mesh.Faces.Count / 10);
        output.Picture("before", mesh);
        var rows = new List<object[]>();
        foreach (QuadricMode mode in (QuadricMode[])[QuadricMode.Textbook, QuadricMode.Fast, QuadricMode.Accurate])
        {
            Mesh copy = mesh.Clone();
            SimplificationResult result = copy.Simplify(new QuadricOptions { TargetFaces = target, Mode = mode });
            MeshDistanceReport distance = mesh.DistanceTo(copy);
            rows.Add([mode, result.StopReason, copy.Faces.Count, distance.SymmetricRms / distance.Diagonal, distance.Hausdorff / distance.Diagonal]);
            output.Picture(mode.ToString(), copy);
        }
        output.Table($"to {target} faces; distances as a share of the diagonal", ["mode", "stopped", "faces", "rms", "Hausdorff"], rows);
    }
}
