using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>§7.2 二次误差度量 (quadric error metric): contracts the edge that costs least, again and again.</summary>
/// <remarks>
/// Garland and Heckbert 1997: the cost of putting the two ends of an edge at p is the sum of the squared distances of p to the planes of the faces that the
/// ends stand for, q(p) = pᵀA p + 2 bᵀp + c, a <see cref="Quadric"/>; p is where it is smallest, A p = −b. Edges of equal cost go by index, so the result is the
/// same on every run, machine and number of threads. The work is done on a private copy in a box of unit diagonal: a call that is cancelled or throws leaves the
/// mesh as it was (textbook mode works on the mesh itself and leaves it valid, simplified so far). At the end the mesh given is replaced by the result without gaps, its elements in the old order; handles from before are void.
/// Topology (components, boundary loops, Euler characteristic) never changes. Vertex traits are blended by where the new vertex lies along the edge, corner traits
/// likewise on either side of a seam (in textbook mode only where edges merge), faces keep their traits and labels.
/// Cost: O(n log n) with a small constant; memory of fast mode about twice that of the mesh, beside the mesh itself.
/// </remarks>
public static class QuadricErrorMetric
{
    /// <summary>Accurate mode goes over to costs from the current faces at this multiple of the target.</summary>
    private const long MemorylessFactor = 3;

    extension(Mesh mesh)
    {
        /// <summary>Simplifies the mesh (简化) by the quadric error metric.</summary>
        /// <param name="options">Targets and ways.</param>
        /// <param name="progress">Hears of the part that is done, from 0 to 1.</param>
        /// <param name="cancellationToken">Ends the work; the mesh stays as it was.</param>
        /// <returns>What was done and why it stopped.</returns>
        /// <exception cref="ArgumentException">No target is set, the target exceeds the mesh's faces, or the mesh has faces that are not triangles.</exception>
        /// <exception cref="InvalidOperationException">Operations on the mesh are being recorded (textbook mode can be).</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public SimplificationResult Simplify(
            QuadricOptions options, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(options);
            int target = TargetOf(mesh, options);
            SimplificationInput.CheckTriangles(mesh);
            cancellationToken.ThrowIfCancellationRequested();
            if (options.Mode != QuadricMode.Textbook)
                SimplificationInput.CheckNotRecorded(mesh);
            SimplificationResult result = options.Mode switch
            {
                QuadricMode.Textbook => new TextbookQuadricSimplifier(mesh, options).Run(target, progress, cancellationToken),
                QuadricMode.Accurate => RunAccurate(mesh, options, target, progress, cancellationToken),
                _ => RunFast(mesh, options, target, progress, cancellationToken),
            };
            progress?.Report(1);
            return result;
        }
    }

    private static SimplificationResult RunFast(
        Mesh mesh, QuadricOptions options, int target, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var contraction = new EdgeContraction(mesh, options, TraitLog.For(mesh), TraceLog.For(options.Trace, options.AreaWeights), progress, cancellationToken);
        Contract(contraction, options, target);
        return Finish(mesh, contraction, Take(mesh, contraction, target, out SimplificationResult report), report, cancellationToken);
    }

    private static SimplificationResult RunAccurate(
        Mesh mesh, QuadricOptions options, int target, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var contraction = new EdgeContraction(mesh, options, TraitLog.For(mesh), TraceLog.For(options.Trace, options.AreaWeights), progress, cancellationToken) { ProgressShare = 0.8 };
        contraction.Working.TrackSuccessors();
        Contract(contraction, options, target);
        CompactResult result = Take(mesh, contraction, target, out SimplificationResult report);
        if (options.Placement == VertexPlacement.Optimal)
            SurfaceFit.Run(mesh, contraction.Working, result, cancellationToken);
        return Finish(mesh, contraction, result, report, cancellationToken);
    }

    /// <summary>Contracts edges as the mode says, until the number of faces is reached; 0 for as far as possible.</summary>
    internal static void Contract(EdgeContraction contraction, QuadricOptions options, int target)
    {
        // Without a number of faces to approach, sums say best where the error limit is.
        if (options.Mode != QuadricMode.Accurate || target == 0)
        {
            contraction.ContractBySums(target);
            return;
        }
        UncheckedArray<Quadric> sums = contraction.ContractBySums((int)Math.Min(int.MaxValue, MemorylessFactor * target));
        contraction.ContractMemoryless(sums, target);
    }

    /// <summary>Takes the result out of the working mesh, which is of no further use.</summary>
    private static CompactResult Take(Mesh mesh, EdgeContraction contraction, int target, out SimplificationResult report)
    {
        report = Report(contraction, target, mesh.Faces.Count);
        var result = new CompactResult(mesh, contraction.Working);
        contraction.Release();
        return result;
    }

    /// <summary>Changes the mesh: from here on nothing may fail.</summary>
    private static SimplificationResult Finish(
        Mesh mesh, EdgeContraction contraction, CompactResult compact, SimplificationResult report, CancellationToken cancellationToken)
    {
        cancellationToken.ThrowIfCancellationRequested();
        contraction.ApplyTraits(mesh);
        compact.WriteTo(mesh);
        return report;
    }

    internal static SimplificationResult Report(EdgeContraction contraction, int target, int before)
    {
        RefusalCounts refusals = contraction.CountRefusals();
        int after = contraction.Working.FaceCount;
        StopReason reason = after <= target ? StopReason.TargetReached
            : refusals.Error > 0 ? StopReason.MaxErrorReached
            : StopReason.NothingCollapsible;
        return new(reason, before, after, contraction.Collapses, Math.Sqrt(contraction.MaxMeanSquare) * contraction.Working.Scale, refusals);
    }

    /// <summary>The number of faces to reach; 0 if only the error limits.</summary>
    internal static int TargetOf(Mesh mesh, QuadricOptions options)
    {
        if (options.TargetFaces is null && options.TargetRatio is null && options.MaxError is null)
            throw new ArgumentException("Set a number of faces, a ratio or a largest error.", nameof(options));
        int target = 0;
        if (options.TargetFaces is int faces)
            target = SimplificationInput.CheckTarget(mesh, faces, nameof(options));
        if (options.TargetRatio is double ratio)
            target = Math.Max(target, Math.Max(1, (int)(mesh.Faces.Count * ratio)));
        return target;
    }
}

/// <summary>What all simplifications ask of their input.</summary>
internal static class SimplificationInput
{
    public static int CheckTarget(Mesh mesh, int faces, string parameter)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(faces, parameter);
        if (faces > mesh.Faces.Count)
            throw new ArgumentOutOfRangeException(parameter, faces, $"The mesh has {mesh.Faces.Count} faces; simplification cannot reach {faces}.");
        return faces;
    }

    public static void CheckTriangles(Mesh mesh)
    {
        if (mesh.IsTriangleMesh)
            return;
        foreach (Face f in mesh.Faces)
        {
            if (!f.IsTriangle)
                throw new ArgumentException($"{f} has {f.Degree} corners; simplification needs triangles. Triangulate the mesh first.", nameof(mesh));
        }
    }

    public static void CheckNotRecorded(Mesh mesh)
    {
        if (mesh.Listener is not null)
            throw new InvalidOperationException("Operations on the mesh are being recorded; this simplification replaces the whole mesh and cannot be.");
    }
}
