using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.6 网格边界: all boundary loops, in order, with their lengths. A closed model gets two holes first.</summary>
[Demo("5.6", "网格边界", "The boundary of the mesh")]
public static class Section_5_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (mesh.IsClosed && mesh.Faces.Count > 0)
        {
            output.Line($"The model is closed: two patches are taken out.");
            TakeOut(mesh.Vertices.Where(v => !v.IsIsolated).MaxBy(v => v.Position.Z), 4);
            TakeOut(mesh.Vertices.Where(v => !v.IsIsolated).MinBy(v => v.Position.Y), 5);
            mesh.Compact();
        }
        IReadOnlyList<BoundaryLoop> loops = mesh.FindBoundaryLoops();
        output.Table(
            $"{loops.Count} boundary loops",
            ["first vertex", "edges", "length"],
            loops.Take(20).Select(loop => new object[] { loop.Vertices[0], loop.Count, loop.Length }));
        output.Picture("boundary loops", mesh, new RenderOptions
        {
            Polylines = [.. loops.Select((loop, i) => new Polyline([.. loop.Vertices.Select(v => v.Position)], Palette.Categorical(i), 5) { Closed = true, HiddenOpacity = 0.3 })],
        });

        // Of a small model only one face, so that something is left.
        void TakeOut(Vertex middle, int rings) => mesh.Detach(mesh.Faces.Count < 500 ? [middle.IncidentFaces[0]] : mesh.Group(middle.Disk(rings)).Faces);
    }
}
