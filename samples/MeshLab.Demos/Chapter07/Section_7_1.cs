using MeshLab.Demos.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter07;

/// <summary>§7.1 顶点聚类: one vertex per cell of a grid, as a mean and as the optimum of the quadrics; and the book's form, which keeps the topology.</summary>
[Demo("7.1", "顶点聚类", "Vertex clustering")]
public static class Section_7_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        var options = new ClusteringOptions { CellSize = mesh.BoundingBox.Diagonal / 40 };
        ClusteringResult mean = mesh.ClusterVertices(options);
        ClusteringResult optimum = mesh.ClusterVertices(options with { Representative = CellRepresentative.QuadricOptimum });
        Mesh kept = mesh.Clone();
        kept.CollapseCells(options);

        output.Line($"{mesh.Vertices.Count} vertices in {mean.Cells} cells; {mean.CollapsedFaces} faces collapsed, {mean.Report.Repairs.Count} left out");
        output.Table("faces, and rms distance as a share of the diagonal", ["form", "faces", "rms"], [
            Row("mean", mean.Mesh),
            Row("quadric optimum", optimum.Mesh),
            Row("topology kept", kept)]);
        output.Picture("before", mesh);
        output.Picture("mean", mean.Mesh);
        output.Picture("quadric optimum", optimum.Mesh);
        output.Picture("topology kept", kept);

        object[] Row(string name, Mesh result)
        {
            MeshDistanceReport report = mesh.DistanceTo(result);
            return [name, result.Faces.Count, report.SymmetricRms / report.Diagonal];
        }
    }
}
