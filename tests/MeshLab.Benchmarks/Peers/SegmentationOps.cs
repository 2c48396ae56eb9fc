using MeshLab.Morse;
using MeshLab.Segmentation;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>No packaged library does these the same way; the figures stand alone.</summary>
internal static class SegmentationOps
{
    [PeerOp("segment-k-means-20", OnRequestOnly = true)]
    public static void KMeans20(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => KMeans.Segment(mesh, 20),
        (_, found, result) => result.Add("segments", found.Count).Add("steps", found.Steps).Add("objective", found.Objective));

    [PeerOp("segment-variational-20", OnRequestOnly = true)]
    public static void Variational20(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => VariationalApproximation.Segment(mesh, 20, new VariationalOptions { MaxTeleports = 5 }).Segmentation,
        (_, found, result) => result.Add("segments", found.Count).Add("steps", found.Steps).Add("objective", found.Objective));

    [PeerOp("segment-watershed-10", OnRequestOnly = true)]
    public static void Watershed10(PeerRun run) => run.Measure(
        () =>
        {
            Mesh mesh = run.Model.NewMesh();
            return mesh.GeodesicFunction(mesh.Vertices[0]);
        },
        distance => Watershed.Segment(distance, new WatershedOptions { Segments = 10 }),
        (_, found, result) => result.Add("segments", found.Count));
}
