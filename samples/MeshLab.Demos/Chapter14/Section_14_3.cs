using MeshLab.Demos.Hosting;
using MeshLab.IO;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter14;

/// <summary>§14.3 STL 与 PLY: one model in every format: how large each is, and what each keeps.</summary>
[Demo("14.3", "STL 与 PLY 文件", "STL, PLY and the formats compared")]
public static class Section_14_3
{
    private static readonly (string Name, MeshEncoding Encoding)[] Forms =
    [
        ("model.obj", MeshEncoding.Text), ("model.off", MeshEncoding.Text), ("model.stl", MeshEncoding.BinaryLittleEndian), ("text.stl", MeshEncoding.Text),
        ("model.ply", MeshEncoding.BinaryLittleEndian), ("text.ply", MeshEncoding.Text), ("model.obj.gz", MeshEncoding.Text), ("model.ply.gz", MeshEncoding.BinaryLittleEndian),
    ];

    public static void Run(Mesh mesh, DemoOutput output)
    {
        List<IReadOnlyList<object>> rows = [];
        foreach ((string name, MeshEncoding encoding) in Forms)
        {
            string path = output.FileFor(name);
            MeshFile.Write(mesh, path, new MeshWriteOptions { Encoding = encoding });
            // STL has no shared vertices: they are found again by their coordinates, which binary STL has rounded.
            MeshData data = MeshFile.ReadData(path, out MeshReadReport report);
            bool isExact = data.VertexCount == mesh.Vertices.Count && mesh.Vertices.Zip(data.Positions).All(pair => pair.First.Position == pair.Second);
            rows.Add([name, encoding, new FileInfo(path).Length, data.VertexCount, data.FaceCount, report.WeldedVertices, isExact ? "yes" : "no"]);
        }

        output.Table("formats", ["file", "encoding", "bytes", "vertices", "faces", "welded", "exact and in order"], rows);
        MeshFile.Write(mesh, output.FileFor("model.glb"));
        output.Line($"model.glb is for viewers: single precision, triangles only, and not read back.");
        output.Picture("model", mesh);
    }
}
