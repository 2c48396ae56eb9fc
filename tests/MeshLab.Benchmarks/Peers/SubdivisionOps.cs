using MeshLab.Structure;
using MeshLab.Subdivision;

namespace MeshLab.Benchmarks.Peers;

internal static class SubdivisionOps
{
    [PeerOp("loop-1")]
    public static void LoopOnce(PeerRun run) => Measure(run, mesh => LoopSubdivision.Subdivide(mesh));

    [PeerOp("loop-2")]
    public static void LoopTwice(PeerRun run) => Measure(run, mesh => LoopSubdivision.Subdivide(mesh, new SubdivisionOptions { Steps = 2 }));

    [PeerOp("sqrt3-1")]
    public static void Sqrt3Once(PeerRun run) => Measure(run, mesh => Sqrt3Subdivision.Subdivide(mesh));

    [PeerOp("butterfly-1")]
    public static void ButterflyOnce(PeerRun run) => Measure(run, mesh => ButterflySubdivision.Subdivide(mesh));

    private static void Measure(PeerRun run, Func<Mesh, Mesh> subdivide)
    {
        Mesh mesh = run.Model.NewMesh();
        run.Measure(() => mesh, subdivide, (_, finer, result) => result.Measure(finer));
    }
}
