using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.4 删除顶点: a vertex with its faces, the two-ring of another; both taken back.</summary>
[Demo("4.4", "删除顶点", "Deleting vertices and rings")]
public static class Section_4_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();

        Vertex one = mesh.Vertices.FirstOrDefault(v => !v.IsBoundary && v.CanDelete(out _));
        if (!one.IsNone)
        {
            int valence = one.Valence;
            one.Delete();
            output.Line($"{one} deleted with its {valence} faces; its link is a boundary now");
        }

        Vertex two = mesh.Vertices.Skip(mesh.Vertices.Count / 2).FirstOrDefault(v => !v.IsIsolated && v.Neighbors.All(w => !w.IsBoundary));
        if (!two.IsNone)
        {
            two.DeleteTwoRing(new RemovalOptions { SplitPinched = true });
            output.Line($"the two-ring of {two} deleted; violated rules: {mesh.Validate().Count}");
        }
        if (one.IsNone && two.IsNone)
            output.Line($"no vertex of this model is far enough from the boundary");
        output.Picture("holes", mesh);

        history.UndoAll();
        output.Line($"undone, to the last bit: {(mesh.StateHash() == before ? "yes" : "no")}");
    }
}
