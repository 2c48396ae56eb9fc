using MeshLab.FiveSixSeven;
using MeshLab.IO;
using MeshLab.Remeshing;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

internal static class RemeshOps
{
    [PeerOp("isotropic-remesh-1")]
    public static void Once(PeerRun run) => Remesh(run, 1);

    [PeerOp("isotropic-remesh-5")]
    public static void FiveTimes(PeerRun run) => Remesh(run, 5);

    [PeerOp("five-six-seven")]
    public static void FiveSixSeven(PeerRun run) =>
        run.Measure(() => run.Model.NewMesh(), mesh => mesh.ToFiveSixSeven().Mesh, (_, mesh, result) => result.Measure(mesh));

    private static void Remesh(PeerRun run, int passes)
    {
        double length = run.Model.MeanEdgeLength;
        var options = new RemeshingOptions { EdgeLength = length, Passes = passes };
        run.Measure(
            () => run.Model.NewMesh(),
            mesh => mesh.RemeshIsotropically(options).Mesh,
            (_, mesh, result) =>
            {
                result.Measure(mesh);
                result.Add("mean_edge", mesh.Edges.Average(e => (e.Vertex0.Position - e.Vertex1.Position).Length)).Add("target_edge", length);
                if (run.DumpDirectory is { } directory)
                    MeshFile.Write(mesh, Path.Combine(directory, $"{run.Model.Name}.{run.Op}.off"));
            });
    }
}
