using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>How variational shape approximation runs.</summary>
public sealed record VariationalOptions
{
    /// <summary>The most rounds of flooding and fitting for a fixed number of proxies.</summary>
    public int MaxRounds
    {
        get;
        init => field = value >= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is at least one round.");
    } = 20;

    /// <summary>How often a region may be merged away and begin again where the error is largest (瞬移).</summary>
    public int MaxTeleports
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of teleportations is 0 or more.");
    } = 20;

    /// <summary>At the end regions are merged across borders less than half of which are sharper than this dihedral angle, in radians; 0 for no merging.</summary>
    public double MergeAngle
    {
        get;
        init => field = value is >= 0 and <= Math.PI ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The angle is between 0 and π.");
    }
}

/// <summary>A planar proxy (代理) of a region: the mean of its normals.</summary>
/// <param name="Center">The area-weighted mean of the barycentres.</param>
/// <param name="Normal">The unit vector of Σ area·normal.</param>
public readonly record struct PlanarProxy(Vector3D Center, Vector3D Normal);

/// <summary>A segmentation with its proxies.</summary>
/// <param name="Segmentation">The labels; the objective is the L²·¹ error.</param>
/// <param name="Proxies">Per segment.</param>
public sealed record VariationalResult(FaceSegmentation Segmentation, IReadOnlyList<PlanarProxy> Proxies);

/// <summary>§13 变分形状逼近: regions that are each as flat as possible (Cohen-Steiner, Alliez, Desbrun 2004, metric L²·¹).</summary>
/// <remarks>
/// E = Σ area·|n − N|² with N the normal of the face's proxy. Rounds of two steps: flood all regions at once from their best faces, always taking the face with
/// the least error; then fit the proxies. Regions are born one after the other at the worst face. When the rounds end, the two neighbours that lose least
/// by merging are merged and a region begins at the worst face instead, if that lowers E (teleportation). At the end neighbours may be merged where the border between
/// them is not sharp, so that curved parts of a CAD model become one segment each. O(rounds · F log F).
/// </remarks>
public static class VariationalApproximation
{
    /// <summary>Segments the faces.</summary>
    /// <param name="mesh">The mesh; each component needs at least one region.</param>
    /// <param name="regions">How many regions before merging.</param>
    /// <param name="options">Rounds, teleportations, merging.</param>
    /// <param name="progress">Told the part of the regions that is born.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="ArgumentException">There are more regions than faces, or fewer than components.</exception>
    public static VariationalResult Segment(
        Mesh mesh, int regions, VariationalOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        options ??= new VariationalOptions();
        var work = new RegionFlood(mesh);
        ArgumentOutOfRangeException.ThrowIfLessThan(regions, 1);
        if (regions > work.Geometry.Live.Length)
            throw new ArgumentException($"{regions} regions cannot be made of {work.Geometry.Live.Length} faces.", nameof(regions));
        int[] firstFaces = work.FirstFaceOfEachComponent();
        if (regions < firstFaces.Length)
            throw new ArgumentException($"The faces have {firstFaces.Length} components; {regions} regions cannot cover them.", nameof(regions));

        work.Begin(firstFaces);
        var history = new List<double>();
        while (work.Count < regions)
        {
            cancellationToken.ThrowIfCancellationRequested();
            work.AddAtWorstFace();
            // A new region only has to find its place; the full number of rounds follows when all are there.
            Round(work, 2, history, cancellationToken);
            progress?.Report((double)work.Count / regions);
        }
        bool converged = Round(work, options.MaxRounds, history, cancellationToken);
        for (int k = 0; k < options.MaxTeleports && Teleport(work, options.MaxRounds, history, cancellationToken); k++)
        {
        }
        if (options.MergeAngle > 0)
            RegionMerging.MergeAcrossFlatBorders(mesh, work.Labels, options.MergeAngle);
        progress?.Report(1);
        return Finish(work, history, converged);
    }

    /// <summary>Floods and fits until nothing changes, or so many times; whether nothing changed.</summary>
    private static bool Round(RegionFlood work, int rounds, List<double> history, CancellationToken cancellationToken)
    {
        double last = double.PositiveInfinity;
        for (int round = 0; round < rounds; round++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            work.Flood();
            work.Fit();
            double error = work.Error();
            history.Add(error);
            if (Math.Abs(last - error) <= 1e-9 * error)
                return true;
            last = error;
        }
        return false;
    }

    /// <summary>Tries to spend the region that is missed least where the error is worst; takes it back if the error does not fall.</summary>
    private static bool Teleport(RegionFlood work, int rounds, List<double> history, CancellationToken cancellationToken)
    {
        double before = work.Error();
        RegionFlood.State state = work.Save();
        if (!work.MergeCheapestNeighbors())
            return false;
        work.AddAtWorstFace();
        Round(work, rounds, history, cancellationToken);
        if (work.Error() < before * (1 - 1e-6))
            return true;
        work.Restore(state);
        history.Add(before);
        return false;
    }

    private static VariationalResult Finish(RegionFlood work, List<double> history, bool converged)
    {
        int count = Relabeling.Compact(work.Labels);
        PlanarProxy[] proxies = work.FitProxies(work.Labels, count);
        double error = work.Error(work.Labels, proxies);
        SegmentationStop stop = converged ? SegmentationStop.Converged : SegmentationStop.RoundLimit;
        return new(new FaceSegmentation(work.Labels, count, error, history.Count, stop) { History = history }, proxies);
    }
}
