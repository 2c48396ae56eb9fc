using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

internal static class GeometryOps
{
    /// <summary>Unit face normals and equally weighted vertex normals, as OpenMesh's own function gives them.</summary>
    [PeerOp("normals-lib")]
    public static void Normals(PeerRun run)
    {
        run.MeasureRounds(
            () =>
            {
                Mesh mesh = run.Model.NewMesh();
                return (Mesh: mesh, Faces: new Vector3D[mesh.FaceSlots], Vertices: new Vector3D[mesh.VertexSlots]);
            },
            state => state.Mesh.UpdateNormals(state.Faces, state.Vertices),
            (state, result) => result.Add("abs_normal_sum", state.Vertices.Sum(n => Math.Abs(n.X) + Math.Abs(n.Y) + Math.Abs(n.Z))));
    }

    [PeerOp("curvature-gauss-mean")]
    public static void Curvatures(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.ComputeCurvatures(),
        (_, curvatures, result) => result
            .Add("median_gauss", Median(curvatures.Gaussian))
            .Add("median_mean", Median([.. curvatures.Mean.Select(Math.Abs)])));

    [PeerOp("curvature-principal")]
    public static void Principal(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.ComputePrincipalCurvatures(PrincipalCurvatureMethod.JetFitting),
        (_, principal, result) => result.Add("median_gauss", Median([.. principal.Max.Zip(principal.Min, (a, b) => a * b)])));

    private static double Median(double[] values)
    {
        double[] sorted = [.. values];
        Array.Sort(sorted);
        return sorted[sorted.Length / 2];
    }
}
