using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9 5-6-7 模型 (5-6-7 meshes): the same surface with every inner vertex of valence 5, 6 or 7.</summary>
/// <remarks>
/// Aghdaii, Younesy, Zhang, "5-6-7 Meshes", Graphics Interface 2012. Works on triangle meshes of any genus, closed or open.
/// <para>The default engine repairs in place. Φ = Σ max(0, 5 − val)² + max(0, val − 7)² over inner vertices. From every bad vertex it tries short walks of flips,
/// splits and collapses, under guards that begin strict (normals, triangle quality, distance to the input) and are loosened level by level; a walk that
/// lowers Φ stays, any other is taken back. Then the number of faces is brought to the one asked for, and triangles are made rounder, neither raising Φ.
/// Where walks do not reach Φ = 0, every face is cut into nine, after which valences can be set right one by one: always possible.</para>
/// <para>It ends: each walk that stays lowers the integer Φ ≥ 0, everything else has a fixed number of rounds.
/// The same input gives the same bits. Positions are treated relative to the bounding box, so place and size of the model do not matter.</para>
/// </remarks>
public static class FiveSixSevenMeshing
{
    private const double PoorQuality = 0.5;

    extension(Mesh mesh)
    {
        /// <summary>Makes a 5-6-7 mesh of the same surface; this mesh is not changed.</summary>
        /// <param name="options">How; the defaults if not given.</param>
        /// <param name="progress">From 0 to 1.</param>
        /// <param name="cancellationToken">Ends the work.</param>
        /// <exception cref="ArgumentException">A face is not a triangle (it is named), or fewer faces are asked for than a 5-6-7 mesh of this topology can have, or more than the budget.</exception>
        /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
        public FiveSixSevenResult ToFiveSixSeven(
            FiveSixSevenOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            mesh.RequireTriangles(nameof(mesh));
            options ??= new();
            IReadOnlyDictionary<int, int> before = InnerValences(mesh);
            if (mesh.Faces.Count == 0)
                return new(mesh.Clone(), before, before, 0, 0, 0, false, FiveSixSevenStop.NothingToDo, true);

            Mesh input = Used(mesh);
            int target = TargetFaces(input, options);
            FiveSixSevenResult result = options.Engine == FiveSixSevenEngine.Textbook
                ? TextbookEngine.Run(input, before, target, options, progress, cancellationToken)
                : Repair(input, before, target, options, progress, cancellationToken);
            result.Mesh.TakeTraitsFrom(mesh, cancellationToken);
            return result;
        }

        /// <summary>How many inner vertices there are of each valence, in rising order; isolated vertices do not count.</summary>
        public IReadOnlyDictionary<int, int> CountInnerValences()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            return InnerValences(mesh);
        }
    }

    private static SortedDictionary<int, int> InnerValences(Mesh mesh)
    {
        var counts = new SortedDictionary<int, int>();
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated || v.IsBoundary)
                continue;
            int valence = v.Valence;
            counts[valence] = counts.GetValueOrDefault(valence) + 1;
        }
        return counts;
    }

    /// <summary>A compact copy without isolated vertices and traits.</summary>
    private static Mesh Used(Mesh mesh)
    {
        var number = new int[mesh.VertexSlots];
        var positions = new List<Vector3D>();
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            number[v.Index] = positions.Count;
            positions.Add(v.Position);
        }
        var corners = new List<int>(3 * mesh.Faces.Count);
        foreach (Face f in mesh.Faces)
        {
            foreach (Vertex v in f.Vertices)
                corners.Add(number[v.Index]);
        }
        return MeshBuilder.FromTriangles([.. positions], [.. corners]);
    }

    private static int TargetFaces(Mesh mesh, FiveSixSevenOptions options)
    {
        int smallest = SmallestCounts.Of(mesh, out bool isOneSphere);
        if (options.TargetFaces is not int asked)
        {
            int faces = Math.Max(mesh.Faces.Count, smallest);
            return isOneSphere && faces == SmallestCounts.Impossible ? faces + 2 : faces;
        }
        if (asked < smallest)
            throw new ArgumentException($"A 5-6-7 mesh of this topology has at least {smallest} faces; {asked} are asked for.", nameof(options));
        if (asked > options.FaceBudget)
            throw new ArgumentException($"{asked} faces are asked for, and {options.FaceBudget} may be made ({nameof(options.FaceBudget)}).", nameof(options));
        if (isOneSphere && asked is SmallestCounts.Impossible)
            throw new ArgumentException($"There is no closed 5-6-7 mesh of genus 0 with {asked} faces.", nameof(options));
        return asked;
    }

    private static FiveSixSevenResult Repair(
        Mesh input, IReadOnlyDictionary<int, int> before, int target, FiveSixSevenOptions options, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var frame = UnitFrame.Of(input);
        WorkMesh work = WorkMesh.From(frame.ToUnit(input));
        work.Trace = StepTrace.Into(options.Trace, frame.FromUnit);
        InputSurface surface = SurfaceOf(work, options);

        if (work.MeanQuality() < PoorQuality || Creases.IsCrumpled(work))
        {
            Tools tools = ToolsFor(work, surface, target, cancellationToken);
            tools.Shape.Remesh(target, 6, new(0.8, 0.1, 0.003));
        }
        progress?.Report(0.2);

        long walks = 0;
        int level = ReachZero(work, surface, target, cancellationToken, ref walks);
        bool lastResort = work.Penalty > 0;
        if (lastResort)
            work = LastResort.Run(work);
        progress?.Report(0.5);

        Tools final = ToolsFor(work, surface, target, cancellationToken);
        ApproachCount(final, target, cancellationToken);
        progress?.Report(0.6);
        if (options.ImproveShape)
            ImproveShape(final, target, progress);
        return Finish(work, frame, input, before, target, walks + final.Walk.Walks, level, lastResort);
    }

    internal static FiveSixSevenResult Finish(
        WorkMesh work, UnitFrame frame, Mesh input, IReadOnlyDictionary<int, int> before, int target, long walks, int level, bool lastResort)
    {
        (Vector3D[] positions, int[] corners, int[] slots) = work.Export();
        for (int i = 0; i < positions.Length; i++)
            positions[i] = frame.FromUnit(positions[i], input, slots[i]);
        Mesh result = MeshBuilder.FromTriangles(positions, corners);
        return new(result, before, InnerValences(result), target, walks, level, lastResort, Stop(work, target), work.Penalty == 0);
    }

    private static FiveSixSevenStop Stop(WorkMesh work, int target) =>
        Math.Abs(work.LiveFaces - target) <= Math.Max(2, target / 200) ? FiveSixSevenStop.Reached : FiveSixSevenStop.CountOutOfReach;

    internal static InputSurface SurfaceOf(WorkMesh work, FiveSixSevenOptions options)
    {
        List<(int A, int B)> creases = Creases.Mark(work, options.FeatureAngle, options.NoiseEdges);
        (Vector3D[] positions, int[] corners, _) = work.Export();
        return new(positions, corners, creases);
    }

    internal sealed record Tools(Guard Guard, RepairWalk Walk, FaceCount Count, ShapeImprovement Shape);

    internal static Tools ToolsFor(WorkMesh work, InputSurface surface, int target, CancellationToken cancellationToken)
    {
        surface.Hint = -1;
        var guard = new Guard(work, surface);
        var walk = new RepairWalk(guard) { TargetFaces = target };
        var count = new FaceCount(guard, walk, cancellationToken);
        return new(guard, walk, count, new ShapeImprovement(guard, count, cancellationToken));
    }

    /// <summary>The levels: guards, longest walk, and from how many first steps it is tried.</summary>
    private static readonly (GuardLevel Level, int Steps, int Starts)[] Schedule =
    [
        (new(0.9, 0.2, 0.002), 4, 4),
        (new(0.7, 0.05, 0.003), 10, 16),
        (new(0.3, 0.005, 0.006), 12, 24),
        (new(0, 1e-4, 0.009), 16, 40),
        (new(-0.5, 0, double.PositiveInfinity), 16, 40),
        (GuardLevel.TopologyOnly, 24, 60),
    ];

    private static int ReachZero(WorkMesh work, InputSurface surface, int target, CancellationToken cancellationToken, ref long walks)
    {
        Tools tools = ToolsFor(work, surface, target, cancellationToken);
        int level = 0;
        foreach ((GuardLevel guard, int steps, int starts) in Schedule)
        {
            if (work.Penalty == 0)
                break;
            level++;
            tools.Walk.Pass(guard, steps, starts, cancellationToken);
        }
        // A component smaller than any 5-6-7 mesh of its topology must grow: walks that rather split, whatever the count.
        if (work.Penalty > 0)
        {
            level++;
            tools.Walk.TargetFaces = int.MaxValue;
            tools.Walk.Pass(GuardLevel.TopologyOnly, 40, 120, cancellationToken);
        }
        walks += tools.Walk.Walks;
        return level;
    }

    internal static void ApproachCount(Tools tools, int target, CancellationToken cancellationToken)
    {
        (GuardLevel Level, int Rounds)[] schedule =
        [
            (new(0.7, 0.1, 0.003), 12),
            (new(0.7, 0.02, 0.003), 6),
            (new(0.5, 0.02, 0.004), 6),
            (new(0.3, 0.005, 0.006), 6),
            (new(0, 1e-4, 0.009), 6),
            (new(-0.5, 0, double.PositiveInfinity), 6),
        ];
        Refinement.TowardsCount(tools.Guard, target, cancellationToken);
        for (int i = 0; i < schedule.Length; i++)
        {
            // The first level is always tried; the rest only while the count is far off.
            if (i > 0 && Math.Abs(tools.Guard.Mesh.LiveFaces - target) <= Math.Max(4, target / 250))
                return;
            tools.Count.Approach(target, schedule[i].Level, schedule[i].Rounds);
        }
    }

    internal static void ImproveShape(Tools tools, int target, IProgress<double>? progress)
    {
        var flip = new GuardLevel(0.9, 0, 0.003);
        var near = new GuardLevel(0, 0, 0.003);
        for (int round = 0; round < 3; round++)
        {
            tools.Shape.Smooth(2, 0.8, 0.7, near);
            tools.Shape.Flip(flip, 3, ShapeImprovement.FlipRule.QualityKeepingPenalty);
            progress?.Report(0.7 + 0.07 * round);
        }
        for (int round = 0; round < 2; round++)
        {
            tools.Shape.CollapseSlivers(0.35, new(0.7, 0.15, 0.003));
            tools.Count.Approach(target, new(0.7, 0.3, 0.003), 2);
            tools.Shape.Flip(flip, 3, ShapeImprovement.FlipRule.QualityKeepingPenalty);
            tools.Shape.Smooth(1, 0.8, 0.7, near);
        }
        tools.Count.Approach(target, new(0.7, 0.1, 0.003), 3);
        tools.Shape.Smooth(2, 0.8, 0.7, near);
        progress?.Report(1);
    }
}
