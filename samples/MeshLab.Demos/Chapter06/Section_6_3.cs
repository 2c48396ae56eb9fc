using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.3 按三角形面切割: takes the faces of the upper half out of the model; appending them is the way back.</summary>
[Demo("6.3", "按三角形面切割", "Cutting off faces")]
public static class Section_6_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        double middle = mesh.BoundingBox.Center.Z;
        Mesh rest = mesh.Clone();
        MeshPart part = rest.Detach(rest.Faces.Where(f => f.Barycenter.Z > middle));
        output.Line($"{part.Mesh} taken out, {rest} left");
        int rim = part.SourceVertex.Count(v => !rest.IsDeletedVertex(v));
        output.Line($"{rim} vertices are on the rim, and in both.");
        output.Picture("rest", rest);
        rest.Append(part.Mesh);
        output.Line($"put back as a further part: {rest.Faces.Count} faces of {mesh.Faces.Count}");
    }
}
