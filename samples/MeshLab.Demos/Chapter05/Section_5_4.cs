using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.4 组的邻域: what is around a group of vertices, of edges, and of faces, in one patch and in two.</summary>
[Demo("5.4", "组的邻域", "Around a group")]
public static class Section_5_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex first = Closeup.InnerVertex(mesh), last = mesh.Vertices.Last(v => !v.IsIsolated);
        ElementGroup vertices = mesh.Group(first.Disk(1)), edges = mesh.Group(first.LinkEdges), faces = mesh.Group(first.IncidentFaces);
        ElementGroup patches = mesh.Group(first.IncidentFaces.Concat(last.IncidentFaces));
        output.Table(
            "four groups",
            ["", "vertex set", "faces inside", "ring vertices", "ring faces", "ring edges"],
            new[] { ($"{first} and its ring", vertices), ("the link edges", edges), ("the faces around", faces), ("two patches of faces", patches) }
                .Select(named => Row(named.Item1, named.Item2)));
        Closeup.Show(
            output, "a group of faces and its ring", faces, 2, [("the group", faces.Faces), ("ring faces", faces.RingFaces)], (Closeup.Red, faces.RingEdges));
    }

    private static object[] Row(string name, ElementGroup group) =>
        [name, group.Vertices.Length, group.Faces.Length, group.RingVertices.Length, group.RingFaces.Length, group.RingEdges.Length];
}
