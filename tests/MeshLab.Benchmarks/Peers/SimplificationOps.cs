using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>Simplification to a percentage of the faces.</summary>
internal static class SimplificationOps
{
    [PeerOp("qem-50")]
    public static void Qem50(PeerRun run) => Simplify(run, 50, new());

    [PeerOp("qem-10")]
    public static void Qem10(PeerRun run) => Simplify(run, 10, new());

    [PeerOp("qem-1")]
    public static void Qem1(PeerRun run) => Simplify(run, 1, new());

    [PeerOp("qem-guard-50")]
    public static void QemGuard50(PeerRun run) => Simplify(run, 50, new());

    [PeerOp("qem-guard-10")]
    public static void QemGuard10(PeerRun run) => Simplify(run, 10, new());

    [PeerOp("qem-guard-1")]
    public static void QemGuard1(PeerRun run) => Simplify(run, 1, new());

    [PeerOp("qem-accurate-10")]
    public static void QemAccurate10(PeerRun run) => Simplify(run, 10, new() { Mode = QuadricMode.Accurate });

    [PeerOp("cluster-50")]
    public static void Cluster50(PeerRun run) => Cluster(run, 50);

    [PeerOp("cluster-10")]
    public static void Cluster10(PeerRun run) => Cluster(run, 10);

    [PeerOp("cluster-1")]
    public static void Cluster1(PeerRun run) => Cluster(run, 1);

    /// <summary>As many cells as the other libraries get; theirs are as long as the box, ours are cubes of the same volume.</summary>
    private static void Cluster(PeerRun run, int percent)
    {
        int divisions = Math.Max(4, (int)Math.Sqrt(run.Model.FaceCount * percent / 100.0 / 4));
        Vector3D size = BoundingBox.Of(run.Model.Positions).Size;
        double cell = Math.Cbrt(size.X * size.Y * size.Z) / divisions;
        run.Measure(
            run.Model.NewMesh,
            mesh => mesh.ClusterVertices(new() { CellSize = cell, Representative = CellRepresentative.QuadricOptimum }).Mesh,
            (_, mesh, result) => result.Measure(mesh));
    }

    private static void Simplify(PeerRun run, int percent, QuadricOptions options) => run.Measure(
        run.Model.NewMesh,
        mesh =>
        {
            mesh.Simplify(options with { TargetFaces = Math.Max(1, mesh.Faces.Count * percent / 100) });
            return mesh;
        },
        (_, mesh, result) => result.Measure(mesh));
}
