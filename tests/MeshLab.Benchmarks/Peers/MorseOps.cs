using MeshLab.Morse;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>No packaged library does these; the figures stand alone.</summary>
internal static class MorseOps
{
    [PeerOp("morse-classify")]
    public static void Classify(PeerRun run) => run.Measure(
        () => Height(run),
        CriticalPoints.Of,
        (_, critical, result) => result.Add("minima", critical.Minima.Count).Add("saddles", critical.SaddleCount).Add("maxima", critical.Maxima.Count));

    [PeerOp("morse-persistence")]
    public static void Persistence(PeerRun run) => run.Measure(
        () => CriticalPoints.Of(Height(run)),
        PersistencePairs.Of,
        (_, pairs, result) => result.Add("pairs", pairs.Pairs.Count));

    [PeerOp("morse-gradient")]
    public static void Gradient(PeerRun run) => run.Measure(
        () => Height(run),
        DiscreteGradient.Of,
        (_, gradient, result) => result.Add("minima", gradient.MinimumCount).Add("saddles", gradient.SaddleCount).Add("maxima", gradient.MaximumCount));

    [PeerOp("morse-cancel")]
    public static void Cancel(PeerRun run) => run.Measure(
        () => DiscreteGradient.Of(Height(run)),
        gradient => GradientCancellation.Cancel(gradient, double.PositiveInfinity),
        (_, cancelled, result) => result.Add("saddles", cancelled.Gradient.SaddleCount));

    [PeerOp("morse-all")]
    public static void All(PeerRun run) => run.Measure(
        () => Height(run),
        height =>
        {
            PersistencePairs pairs = PersistencePairs.Of(height);
            return (Pairs: pairs, Cancelled: GradientCancellation.Cancel(DiscreteGradient.Of(height), double.PositiveInfinity));
        },
        (_, all, result) => result.Add("pairs", all.Pairs.Pairs.Count).Add("saddles", all.Cancelled.Gradient.SaddleCount));

    private static MorseFunction Height(PeerRun run)
    {
        Mesh mesh = run.Model.NewMesh();
        return mesh.CoordinateFunction(2);
    }
}
