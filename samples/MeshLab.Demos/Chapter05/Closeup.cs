using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>Draws the neighbourhood of some vertices from close by: the faces within a few edges, seen from outside, with the names of the mesh.</summary>
internal static class Closeup
{
    public static readonly Color Red = new(0.8f, 0.1f, 0.1f), Blue = new(0.1f, 0.25f, 0.75f), Ink = new(0.1f, 0.1f, 0.12f);

    /// <summary>The vertex nearest to the viewer of the usual picture; one with faces all around, if there is one.</summary>
    public static Vertex InnerVertex(Mesh mesh)
    {
        var viewer = new Vector3D(0.47, -0.81, 0.34);
        Vertex[] used = [.. mesh.Vertices.Where(v => !v.IsIsolated)], inner = [.. used.Where(v => !v.IsBoundary && v.Neighbors.All(w => !w.IsBoundary))];
        return (inner.Length > 0 ? inner : used).MaxBy(v => Vector3D.Dot(v.Position, viewer));
    }

    /// <param name="output">Where it is shown.</param>
    /// <param name="name">The picture's name.</param>
    /// <param name="middle">What is in the middle.</param>
    /// <param name="rings">How many edges away faces are still shown.</param>
    /// <param name="labels">Names of colours with their faces; later ones win.</param>
    /// <param name="edges">Edges that stand out.</param>
    public static void Show(
        DemoOutput output, string name, ElementGroup middle, int rings, (string Name, Face[] Faces)[] labels, params (Color Color, Edge[] Edges)[] edges)
    {
        Mesh mesh = middle.Mesh;
        Face[] shown = mesh.Group(middle.Disk(rings)).Faces;
        if (shown.Length == 0)
            shown = [.. mesh.Faces];
        MeshPart part = mesh.Extract(shown);
        var label = new int[part.Mesh.FaceSlots];
        Array.Fill(label, -1);
        for (int i = 0; i < labels.Length; i++)
        {
            foreach (Face f in labels[i].Faces)
            {
                if (part.NewFace[f.Index] >= 0)
                    label[part.NewFace[f.Index]] = i;
            }
        }

        output.Picture(name, part.Mesh, new RenderOptions
        {
            View = Facing(middle),
            Shading = Shading.Flat,
            Wireframe = true,
            GroundShadow = false,
            Coloring = Coloring.FaceLabels(label, "faces", [.. labels.Select((l, i) => new LegendEntry(l.Name, Palette.Categorical(i)))]),
            Polylines = [.. edges.SelectMany(set => set.Edges.Select(e => new Polyline([e.Vertex0.Position, e.Vertex1.Position], set.Color, 4)))],
            Labels = [.. part.Mesh.Vertices.Select(v => new TextLabel(v.Position, $"v{part.SourceVertex[v.Index]}", Ink, 13))],
        });
    }

    /// <summary>Looks along the normal of the group, from outside.</summary>
    private static View Facing(ElementGroup group)
    {
        Vector3D normal = default;
        foreach (Face f in group.RingFaces.Concat(group.Faces))
        {
            HalfEdge h = f.HalfEdge;
            normal += Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
        }
        Vector3D n = normal.Normalized();
        const double Degrees = 180 / Math.PI;
        // Not quite from straight above, so that the shape is seen too.
        return new(Math.Atan2(n.X, -n.Y) * Degrees + 12, Math.Clamp((Math.Asin(Math.Clamp(n.Z, -1, 1)) * Degrees) - 8, -90, 90));
    }
}
