using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

internal static class BuildOp
{
    [PeerOp("build")]
    public static void Build(PeerRun run) => run.Measure(
        () => run.Model,
        model => MeshBuilder.FromTriangles(model.Positions, model.Corners),
        (_, mesh, result) => result.Measure(mesh));
}
