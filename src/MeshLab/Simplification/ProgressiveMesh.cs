using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>§7.5 简化记录 (progressive mesh): a mesh with the record of all contractions down to a base, in which any number of faces can be had, back and forth.</summary>
/// <remarks>
/// Hoppe 1996: M₀ ⇄ M₁ ⇄ … ⇄ Mₙ, where each step down contracts an edge and each step up splits a vertex. Going up restores connectivity, indices, positions and
/// traits bit for bit. A step costs O(valence). The record takes about 150 bytes per contraction, and what the traits need.
/// <see cref="Mesh"/> keeps its slots: elements that are not there at the moment are deleted ones.
/// </remarks>
public sealed class ProgressiveMesh
{
    private const int StepsPerReport = 1 << 10;
    private readonly SplitRecord[] records;
    private readonly Vector3D[] otherPositions;
    private readonly List<TraitDelta> deltas;
    private int firstKnown;

    internal ProgressiveMesh(Mesh mesh, SplitRecord[] records, Vector3D[] otherPositions, List<TraitDelta> deltas, int collapsesDone)
    {
        Mesh = mesh;
        this.records = records;
        this.otherPositions = otherPositions;
        this.deltas = deltas;
        CollapsesDone = collapsesDone;
        firstKnown = collapsesDone;
    }

    /// <summary>The mesh at the present level of detail. Do not change its connectivity.</summary>
    public Mesh Mesh { get; }

    /// <summary>The number of recorded contractions.</summary>
    public int CollapseCount => records.Length;

    /// <summary>How many of them are done at the present level of detail.</summary>
    public int CollapsesDone { get; private set; }

    /// <summary>Faces at the present level.</summary>
    public int FaceCount => Mesh.Faces.Count;

    /// <summary>Faces of the base.</summary>
    public int MinFaces { get; private set; }

    /// <summary>Faces of the finest level that is known: of the original, or while a stream is read, of what was read so far.</summary>
    public int MaxFaces { get; private set; }

    /// <summary>What the recording did, and why it ended; <see langword="null"/> for one that was read from a file.</summary>
    public SimplificationResult? Recording { get; private set; }

    /// <summary>Whether the finest level is the original: always, but while a stream is read.</summary>
    public bool IsComplete => firstKnown == 0;

    internal IReadOnlyList<TraitDelta> Deltas => deltas;

    /// <summary>Records the simplification of a mesh.</summary>
    /// <param name="mesh">The mesh; it is copied (without deleted elements) and stays as it is.</param>
    /// <param name="options">How to simplify; as far as possible if no target is set. In accurate mode the contractions are those of that mode, without its fit.</param>
    /// <param name="progress">Hears of the part that is done.</param>
    /// <param name="cancellationToken">Ends the work.</param>
    /// <returns>The progressive mesh at its finest level.</returns>
    /// <exception cref="ArgumentException">The mesh has faces that are not triangles, or textbook mode is asked for.</exception>
    public static ProgressiveMesh Create(
        Mesh mesh, QuadricOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= new QuadricOptions();
        if (options.Mode == QuadricMode.Textbook)
            throw new ArgumentException("The textbook mode keeps no record; use the fast or the accurate one.", nameof(options));
        SimplificationInput.CheckTriangles(mesh);
        int target = options.TargetFaces is null && options.TargetRatio is null ? 0 : QuadricErrorMetric.TargetOf(mesh, options);
        Mesh copy = mesh.Clone();
        if (!copy.IsCompact)
            copy.Compact();
        TraitLog? traits = TraitLog.For(copy);
        var log = new StepLog(traits);
        var contraction = new EdgeContraction(copy, options, traits, LogGroup.Of(log, TraceLog.For(options.Trace, options.AreaWeights)), progress, cancellationToken);
        QuadricErrorMetric.Contract(contraction, options, target);
        cancellationToken.ThrowIfCancellationRequested();
        SimplificationResult report = QuadricErrorMetric.Report(contraction, target, copy.Faces.Count);
        ProgressiveMesh result = Record(copy, contraction.Working, log, traits, cancellationToken);
        result.Recording = report;
        progress?.Report(1);
        return result;
    }

    /// <summary>Goes down, or up, to the level nearest to a number of faces that does not exceed it. O(steps · valence).</summary>
    /// <param name="faces">At least the base's.</param>
    /// <param name="progress">Hears of the part of the way that is done, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the way; the mesh is valid, at the level that was reached.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no level with so few faces, or the number is above the finest level's.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public void GoToFaces(int faces, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(faces, MinFaces);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(faces, MaxFaces);
        int level = CollapsesDone, left = FaceCount;
        while (left > faces)
            left -= records[level++].Faces;
        while (level > firstKnown && left + records[level - 1].Faces <= faces)
            left += records[--level].Faces;
        GoToCollapse(level, progress, cancellationToken);
    }

    /// <summary>Goes down, or up, until so many contractions are done. O(steps · valence).</summary>
    /// <param name="collapses">How many.</param>
    /// <param name="progress">Hears of the part of the way that is done, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the way; the mesh is valid, at the level that was reached.</param>
    /// <exception cref="ArgumentOutOfRangeException">There are not so many, or those above are not read yet.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public void GoToCollapse(int collapses, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(collapses, firstKnown);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(collapses, CollapseCount);
        int start = CollapsesDone, way = Math.Abs(collapses - start);
        MeshCounts counts = Mesh.Counts;
        for (int step = 0; step < way && !cancellationToken.IsCancellationRequested; step++)
        {
            if (collapses > start)
                Collapse(ref counts);
            else
                Split(ref counts);
            if (step % StepsPerReport == 0 && progress is not null)
            {
                // Whoever listens may look at the mesh.
                Mesh.Counts = counts;
                progress.Report((step + 1.0) / way);
            }
        }
        Mesh.Counts = counts;
        cancellationToken.ThrowIfCancellationRequested();
        progress?.Report(1);
    }

    /// <summary>Goes to the base.</summary>
    /// <inheritdoc cref="GoToCollapse" path="/param[@name!='collapses']"/>
    public void GoToBase(IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
        GoToCollapse(CollapseCount, progress, cancellationToken);

    /// <summary>Goes to the finest level.</summary>
    /// <inheritdoc cref="GoToCollapse" path="/param[@name!='collapses']"/>
    public void GoToFinest(IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
        GoToCollapse(firstKnown, progress, cancellationToken);

    internal ref readonly SplitRecord RecordAt(int step) => ref records[step];

    internal Vector3D OtherPosition(int step) => otherPositions[step];

    /// <summary>Adds the record of the next finer step, while a stream is read at its finest level.</summary>
    internal void AddFiner(SplitRecord record, Vector3D position)
    {
        firstKnown--;
        records[firstKnown] = record;
        otherPositions[firstKnown] = position;
        MaxFaces += record.Faces;
    }

    internal void SetFaceRange(int min, int max)
    {
        MinFaces = min;
        MaxFaces = max;
    }

    /// <summary>Does the steps that were logged on the mesh itself, and notes what splitting will need.</summary>
    private static ProgressiveMesh Record(Mesh mesh, WorkingMesh working, StepLog log, TraitLog? traits, CancellationToken cancellationToken)
    {
        List<CollapseStep> steps = log.Steps;
        List<TraitDelta> deltas = [.. mesh.AllTraits.Select(t => t.NewDelta(steps.Count))];
        var result = new ProgressiveMesh(mesh, new SplitRecord[steps.Count], new Vector3D[steps.Count], deltas, 0);
        int finest = mesh.Faces.Count;
        MeshCounts counts = mesh.Counts;
        for (int i = 0; i < steps.Count; i++)
        {
            if (i % StepsPerReport == 0)
                cancellationToken.ThrowIfCancellationRequested();
            CollapseStep step = steps[i];
            SplitRecord record = ColumnSplits.Describe(mesh, step.HalfEdge, step.Merges);
            result.records[i] = record;
            Vector3D u = mesh.positions[record.Removed], v = mesh.positions[record.Kept];
            result.otherPositions[i] = step.Position == working.Normalized(v) ? v : step.Position == working.Normalized(u) ? u : working.Restored(step.Position);
            traits?.Apply(step.Traits, i + 1 < steps.Count ? steps[i + 1].Traits : traits.Mark, deltas);
            foreach (TraitDelta delta in deltas)
                delta.EndStep(i);
            result.CollapseColumns(ref counts);
        }
        mesh.Counts = counts;
        result.SetFaceRange(mesh.Faces.Count, finest);
        result.firstKnown = 0;
        result.GoToFinest(null, cancellationToken);
        return result;
    }

    private void Collapse(ref MeshCounts counts)
    {
        foreach (TraitDelta delta in deltas)
            delta.Swap(CollapsesDone, backward: false);
        CollapseColumns(ref counts);
    }

    private void CollapseColumns(ref MeshCounts counts)
    {
        ref SplitRecord record = ref records[CollapsesDone];
        ColumnSplits.Collapse(Mesh, in record);
        SwapPosition(CollapsesDone, record.Kept);
        counts = counts with { Vertices = counts.Vertices - 1, Edges = counts.Edges - 1 - record.Faces, Faces = counts.Faces - record.Faces };
        CollapsesDone++;
    }

    private void Split(ref MeshCounts counts)
    {
        CollapsesDone--;
        ref SplitRecord record = ref records[CollapsesDone];
        ColumnSplits.Split(Mesh, in record);
        SwapPosition(CollapsesDone, record.Kept);
        counts = counts with { Vertices = counts.Vertices + 1, Edges = counts.Edges + 1 + record.Faces, Faces = counts.Faces + record.Faces };
        for (int i = deltas.Count - 1; i >= 0; i--)
            deltas[i].Swap(CollapsesDone, backward: true);
    }

    /// <summary>The record holds the kept vertex's position on the other side of the step.</summary>
    private void SwapPosition(int step, int vertex) =>
        (Mesh.positions[vertex], otherPositions[step]) = (otherPositions[step], Mesh.positions[vertex]);
}
