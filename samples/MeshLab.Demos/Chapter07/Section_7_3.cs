using MeshLab.Demos.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter07;

/// <summary>§7.3 元素删除: the shortest edge, the smallest triangle, the flattest vertex go first.</summary>
[Demo("7.3", "元素删除", "Element deletion")]
public static class Section_7_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        int target = Math.Max(20, mesh.Faces.Count / 5);
        output.Picture("before", mesh);
        var rows = new List<object[]>();
        foreach (DeletionMeasure measure in Enum.GetValues<DeletionMeasure>())
        {
            Mesh copy = mesh.Clone();
            SimplificationResult result = copy.DeleteElements(new DeletionOptions { TargetFaces = target, Measure = measure });
            MeshDistanceReport distance = mesh.DistanceTo(copy);
            rows.Add([measure, copy.Faces.Count, result.MaxError, distance.SymmetricRms / distance.Diagonal]);
            output.Picture(measure.ToString(), copy);
        }
        output.Table("element deletion", ["first goes", "faces", "largest removed (length, area, angle)", "rms / diagonal"], rows);
    }
}
