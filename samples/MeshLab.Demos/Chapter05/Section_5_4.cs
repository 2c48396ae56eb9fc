using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.4 组的邻域 and §5.5 组的边界: two patches of faces, the ring of faces around them, and their rims as loops.</summary>
[Demo("5.4", "组的邻域与边界", "Around a group, and its rim")]
public static class Section_5_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex first = mesh.Vertices.First(v => !v.IsIsolated), last = mesh.Vertices.Last(v => !v.IsIsolated);
        ElementGroup group = mesh.Group(mesh.Group(first.Disk(4).Concat(last.Disk(4))).Faces);
        output.Table(
            "two patches of faces",
            ("faces", group.Faces.Length),
            ("vertices", group.Vertices.Length),
            ("ring vertices", group.RingVertices.Length),
            ("ring faces", group.RingFaces.Length),
            ("ring edges", group.RingEdges.Length),
            ("rim half-edges", group.RimHalfEdges.Length),
            ("rim loops", group.RimLoops.Length),
            ("rim faces inside", group.RimFaces.Length),
            ("rim faces outside", group.OuterRimFaces.Length));

        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        foreach (Face f in group.RingFaces)
            labels[f.Index] = 1;
        foreach (Face f in group.Faces)
            labels[f.Index] = 0;
        output.Picture("group", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceLabels(labels, "the group and its ring"),
            HighlightedEdges = [new([.. group.RimHalfEdges.Select(h => h.Edge.Index)], new Color(0.8f, 0.1f, 0.1f))],
        });
    }
}
