using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.6 合并边: collapses the shortest edges to their midpoints until half the faces are left, and counts what is refused.</summary>
[Demo("4.6", "合并边", "Edge collapse")]
public static class Section_4_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        int target = mesh.Faces.Count / 2;
        output.Picture("before", mesh);
        var refused = new SortedDictionary<CollapseRefusal, int>();
        int flipping = 0;
        foreach (Edge edge in mesh.Edges.OrderBy(e => e.Length).ThenBy(e => e.Index).ToArray())
        {
            if (mesh.Faces.Count <= target || edge.IsDeleted)
                continue;
            HalfEdge h = edge.HalfEdge0;
            if (!h.CanCollapse(out CollapseRefusal why))
                refused[why] = refused.GetValueOrDefault(why) + 1;
            else if (h.CollapseFlips((h.Source.Position + h.Target.Position) * 0.5, minimumCosine: 0.2))
                flipping++;
            else
                h.Collapse();
        }
        output.Line($"{mesh.Faces.Count} faces left; {flipping} edges kept because a face would turn over");
        output.Table("refused", [.. refused.Select(r => (r.Key.ToString(), (object)r.Value))]);
        output.Picture("after", mesh);
    }
}
