using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.5 组的边界: the rim of a group with two patches and a hole, as closed loops.</summary>
[Demo("5.5", "组的边界", "The rim of a group")]
public static class Section_5_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex first = Closeup.InnerVertex(mesh), far = FarFrom(first);
        var hole = first.Disk(2).ToHashSet();
        // A ring around the one vertex, and a full patch around the other.
        ElementGroup group = mesh.Group(mesh.Group(first.Disk(6).Where(v => !hole.Contains(v)).Concat(far.Disk(5))).Faces);
        output.Table("rim loops", ["first half-edge", "half-edges", "length"], group.RimLoops.Select(loop => new object[]
        {
            loop[0], loop.Length, loop.Sum(h => Vector3D.Distance(h.Source.Position, h.Target.Position)),
        }));
        output.Line($"{group.Faces.Length} faces; {group.RimFaces.Length} of them lie on the rim, and {group.OuterRimFaces.Length} faces outside touch it.");

        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        Paint(group.Faces, 0);
        Paint(group.RimFaces, 1);
        Paint(group.OuterRimFaces, 2);
        LegendEntry[] entries = [new("inside", Palette.Categorical(0)), new("rim faces", Palette.Categorical(1)), new("outer rim faces", Palette.Categorical(2))];
        output.Picture("rim", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceLabels(labels, "the group", entries),
            HighlightedEdges = [new([.. group.RimHalfEdges.Select(h => h.Edge.Index)], Closeup.Red)],
        });

        void Paint(Face[] faces, int label)
        {
            foreach (Face f in faces)
                labels[f.Index] = label;
        }
    }

    private static Vertex FarFrom(Vertex v) => v.Component.MaxBy(w => Vector3D.Distance(v.Position, w.Position));
}
