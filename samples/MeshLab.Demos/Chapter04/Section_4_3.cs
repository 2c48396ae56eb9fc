using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.3 删除边: deletes some edges with their faces, then dissolves others, which joins triangles to polygons.</summary>
[Demo("4.3", "删除边", "Deleting and dissolving edges")]
public static class Section_4_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh holes = mesh.Clone();
        int deleted = holes.Edges.Count(e => e.Index % 60 == 0 && e.TryDelete(out _));
        output.Line($"{deleted} edges deleted with both faces");
        output.Picture("deleted", holes);

        int dissolved = 0;
        foreach (Edge edge in mesh.Edges)
        {
            if (!edge.IsBoundary && edge.Face0.IsTriangle && edge.Face1.IsTriangle && edge.TryDissolve(out _))
                dissolved++;
        }
        output.Line($"{dissolved} edges dissolved");
        output.Table("degrees", [.. mesh.Faces.GroupBy(f => f.Degree).OrderBy(g => g.Key).Select(g => ($"{g.Key} sides", (object)g.Count()))]);
        output.Picture("dissolved", mesh);
    }
}
