using MeshLab.IO;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>Files: from the disk to a mesh with connectivity, and back.</summary>
internal static class IoOps
{
    [PeerOp("load-obj")]
    public static void LoadObj(PeerRun run) => run.Measure(
        () => run.Model.Path,
        path => MeshFile.Read(path),
        (_, mesh, result) => result.Measure(mesh));

    [PeerOp("load-off")]
    public static void LoadOff(PeerRun run)
    {
        string path = TemporaryFile("off");
        MeshFile.Write(run.Model.NewMesh(), path);
        try
        {
            run.Measure(() => path, p => MeshFile.Read(p), (_, mesh, result) => result.Measure(mesh));
        }
        finally
        {
            File.Delete(path);
        }
    }

    [PeerOp("write-obj")]
    public static void WriteObj(PeerRun run)
    {
        string path = TemporaryFile("obj");
        try
        {
            run.Measure(
                run.Model.NewMesh,
                mesh =>
                {
                    MeshFile.Write(mesh, path);
                    return path;
                },
                (_, _, result) => result.Add("bytes", new FileInfo(path).Length));
        }
        finally
        {
            File.Delete(path);
        }
    }

    private static string TemporaryFile(string extension) =>
        Path.Combine(Path.GetTempPath(), $"peers-meshlab-out-{Environment.ProcessId}.{extension}");
}
