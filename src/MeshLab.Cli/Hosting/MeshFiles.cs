using MeshLab.Structure;

namespace MeshLab.Cli.Hosting;

/// <summary>Reading and writing as the options say.</summary>
internal static class MeshFiles
{
    public static ResultFields Counts(Mesh mesh) =>
        new ResultFields().Add("vertices", mesh.Vertices.Count).Add("edges", mesh.Edges.Count).Add("faces", mesh.Faces.Count);

    public static Mesh Read(string path, VerbContext context) => throw new NotSupportedException($"{path} {context.InputFormat}");

    public static void Write(Mesh mesh, string path, VerbContext context) => throw new NotSupportedException($"{mesh} {path} {context.OutputFormat}");
}
