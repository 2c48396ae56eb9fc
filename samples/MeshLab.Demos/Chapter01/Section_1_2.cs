using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.HoleFilling;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Subdivision;

namespace MeshLab.Demos.Chapter01;

/// <summary>§1.2 三维模型的操作: every operation of Table 1-1, once, on a copy of the model.</summary>
[Demo("1.2", "三维模型的操作", "What is done to a model: Table 1-1")]
public static class Section_1_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh open = Edited(mesh, m => m.Vertices.FirstOrDefault(v => !v.IsBoundary && v.CanDelete(out _)) is { IsNone: false } v && v.TryDelete(out _));
        Mesh coarse = Edited(mesh, m => m.Simplify(new QuadricOptions { TargetFaces = Math.Max(4, m.Faces.Count / 4) }).Collapses > 0);
        Mesh fine = LoopSubdivision.Subdivide(coarse, new SubdivisionOptions { Steps = 1 });
        output.Table(
            "表 1-1",
            ["operation", "", "section", "V", "E", "F"],
            [
                Row("the model", "原模型", "", mesh),
                Row("delete a vertex", "删除点", "4.4", open),
                Row("fill the hole", "补洞", "6.1", Edited(open, m => m.FillHoles().Filled > 0)),
                Row("delete an edge", "删除边", "4.3", Edited(mesh, m => m.Edges.FirstOrDefault(e => e.CanDelete(out _)) is { IsNone: false } e && e.TryDelete(out _))),
                Row("delete a face", "删除面", "4.2", Edited(mesh, m => m.Faces.FirstOrDefault(f => f.CanDelete(out _)) is { IsNone: false } f && f.TryDelete(out _))),
                Row("merge two vertices", "合并点", "4.6", Edited(mesh, m => m.HalfEdges.FirstOrDefault(h => h.CanCollapse(out _)) is { IsNone: false } h && h.TryCollapse(out _))),
                Row("split a vertex", "分割点", "4.5", Edited(mesh, SplitOne)),
                Row("simplify", "简化", "7.2", coarse),
                Row("refine", "细分", "8.1", fine),
            ]);
        output.Picture("simplified", coarse);
        output.Picture("refined", fine);
    }

    private static bool SplitOne(Mesh mesh)
    {
        foreach (Vertex v in mesh.Vertices)
        {
            Vertex[] ring = [.. v.Neighbors];
            if (ring.Length > 2 && v.TrySplit(ring[0], ring[ring.Length / 2], out _, out _))
                return true;
        }
        return false;
    }

    /// <summary>A changed copy.</summary>
    private static Mesh Edited(Mesh mesh, Func<Mesh, bool> edit)
    {
        Mesh copy = mesh.Clone();
        edit(copy);
        return copy;
    }

    private static object[] Row(string name, string chinese, string section, Mesh mesh) =>
        [name, chinese, section, mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count];
}
