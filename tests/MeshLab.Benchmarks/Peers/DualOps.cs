using MeshLab.Dual;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

internal static class DualOps
{
    [PeerOp("dual")]
    public static void Dual(PeerRun run)
    {
        Mesh mesh = run.Model.NewMesh();
        var options = new DualOptions { Boundary = DualBoundary.Omitted };
        run.Measure(
            () => mesh,
            m => m.ComputeDual(options).Mesh,
            (_, dual, result) => result.Add("dual_vertices", dual.Vertices.Count).Add("dual_faces", dual.Faces.Count).Add("dual_edges", dual.Edges.Count));
    }
}
