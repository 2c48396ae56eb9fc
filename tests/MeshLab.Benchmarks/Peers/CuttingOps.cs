using MeshLab.Cutting;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>A skew plane through the middle of the box; the part below stays.</summary>
internal static class CuttingOps
{
    [PeerOp("plane-clip")]
    public static void Clip(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.Clip(Plane(run), PlaneSide.Below).Part.Mesh,
        (_, part, result) => result.Measure(part));

    [PeerOp("plane-clip-closed")]
    public static void ClipClosed(PeerRun run)
    {
        if (!run.Model.NewMesh().IsClosed)
            throw new NotSupportedException("skipped: the input is not closed");
        var options = new PlaneCutOptions { Cap = true };
        run.Measure(
            run.Model.NewMesh,
            mesh => mesh.Clip(Plane(run), PlaneSide.Below, options).Part.Mesh,
            (_, part, result) => result.Measure(part));
    }

    [PeerOp("plane-slice")]
    public static void Slice(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.ComputeSection(Plane(run)),
        (_, section, result) => result.Add("polylines", section.Polylines.Count).Add("segments", section.Segments).Add("length", section.Length));

    private static CuttingPlane Plane(PeerRun run) => CuttingPlane.Through(run.Model.BoxCenter, new(1, 0.3, 0.2));
}
