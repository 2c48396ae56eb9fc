using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.6 克隆: a copy with all traits, independent of its source.</summary>
[Demo("2.6", "克隆", "Cloning")]
public static class Section_2_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        VertexTrait<double> height = mesh.AddVertexTrait<double>("height above the floor");
        double floor = mesh.Vertices.Min(v => v.Position.Z);
        foreach (Vertex v in mesh.Vertices)
            height[v] = v.Position.Z - floor;

        ulong source = mesh.StateHash();
        Mesh copy = mesh.Clone();
        output.Line($"same state: {YesNo(copy.StateHash() == mesh.StateHash())}");
        copy.TryGetVertexTrait("height above the floor", out VertexTrait<double>? copied);
        output.Line($"traits come along: {YesNo(copied!.Values.SequenceEqual(height.Values))}");

        foreach (Vertex v in copy.Vertices)
            v.Position *= 2;
        output.Line($"after doubling the copy the source is untouched: {YesNo(mesh.StateHash() == source && copy.StateHash() != source)}");
        output.Picture("clone", copy);
    }

    private static string YesNo(bool truth) => truth ? "yes" : "no";
}
