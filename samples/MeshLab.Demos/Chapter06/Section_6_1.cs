using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.HoleFilling;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.1 补洞: makes a hole, and fills it in five ways.</summary>
[Demo("6.1", "补洞", "Filling holes")]
public static class Section_6_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh open = mesh.Clone();
        Vector3D center = open.Vertices.MaxBy(v => v.Position.Z).Position;
        double radius = 0.15 * open.BoundingBox.Diagonal;
        open.Detach(open.Faces.Where(f => f.Vertices.All(v => Vector3D.Distance(v.Position, center) < radius)));
        open.Compact();

        Mesh best = open;
        var rows = new List<object[]>();
        foreach ((string name, HoleFillingOptions options) in ((string, HoleFillingOptions)[])
        [
            ("fan", new() { Method = HoleFillingMethod.Fan }),
            ("smallest angle first", new() { Method = HoleFillingMethod.Ear }),
            ("minimum weight", new() { Method = HoleFillingMethod.MinimumWeight }),
            ("refined and faired", new() { Refine = true, Fair = true }),
            ("as the surface around tells", new()),
        ])
        {
            best = open.Clone();
            HoleFillingResult result = best.FillHoles(options with { MaxEdges = 400 });
            rows.Add([name, result.Loops.Count, result.Filled, result.FacesAdded]);
        }
        output.Table("ways to fill", ["", "holes", "filled", "new faces"], rows);

        output.Picture("open", open);
        int first = open.Faces.Count;
        output.Picture("filled", best, Coloring.FaceLabels([.. Enumerable.Range(0, best.FaceSlots).Select(f => f < first ? 0 : 1)]));
    }
}
