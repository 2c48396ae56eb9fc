using MeshLab.Morse;
using MeshLab.Structure;

namespace MeshLab.Tests.Morse;

/// <summary>Functions that the tests of this chapter share.</summary>
internal static class MorseCase
{
    public static MorseFunction Height(Mesh mesh) => new(mesh, Values(mesh, v => v.Position.Z));

    /// <summary>A function without any regularity, the same in every run.</summary>
    public static MorseFunction Noise(Mesh mesh, int seed)
    {
        var random = new Random(seed);
        return new(mesh, Values(mesh, _ => random.NextDouble()));
    }

    public static MorseFunction Constant(Mesh mesh) => new(mesh, new double[mesh.VertexSlots]);

    public static double[] Values(Mesh mesh, Func<Vertex, double> f)
    {
        var values = new double[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
            values[v.Index] = f(v);
        return values;
    }

    public static int EulerCharacteristic(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    public static double Range(MorseFunction function) => function.Values.Count == 0 ? 0 : function.Values.Max() - function.Values.Min();
}
