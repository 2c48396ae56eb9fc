using System.Diagnostics;
using System.Text;
using MeshLab.Demos.Hosting;
using MeshLab.IO;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter14;

/// <summary>§14.1 OBJ 文件: writes the model, reads it back bit for bit, and shows what becomes of a mistake in a file.</summary>
[Demo("14.1", "OBJ 文件", "OBJ files")]
public static class Section_14_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        string path = output.FileFor("model.obj");
        long start = Stopwatch.GetTimestamp();
        MeshFile.Write(mesh, path);
        TimeSpan writing = Stopwatch.GetElapsedTime(start);
        start = Stopwatch.GetTimestamp();
        Mesh again = MeshFile.Read(path, out MeshReadReport report);
        TimeSpan reading = Stopwatch.GetElapsedTime(start);

        output.Table(
            "written and read back",
            ("bytes", new FileInfo(path).Length),
            ("written in ms", writing.TotalMilliseconds),
            ("read in ms", reading.TotalMilliseconds),
            ("vertices", report.VertexCount),
            ("faces", report.FaceCount),
            ("positions equal to the last bit", mesh.Vertices.Zip(again.Vertices).All(pair => pair.First.Position == pair.Second.Position)));

        try
        {
            MeshFile.Read(new MemoryStream(Encoding.UTF8.GetBytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")), MeshFormat.Obj);
        }
        catch (MeshFormatException error)
        {
            output.Line($"a face with a vertex too far: {error.Message}");
        }

        output.Picture("read back", again);
    }
}
