using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class SimplifyVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();

    private readonly Option<string> method = new("--method")
    {
        Description = "qem, qem-accurate, qem-textbook, clustering, shortest-edge, smallest-triangle or lowest-curvature.",
        DefaultValueFactory = _ => "qem",
    };

    private readonly Option<int> faces = new("--faces") { Description = "The number of faces to reach." };
    private readonly Option<double> ratio = new("--ratio") { Description = "The part of the faces to keep, between 0 and 1." };
    private readonly Option<double> maxError = new("--max-error") { Description = "For qem: the largest error of a contraction, in model units." };
    private readonly Option<double> cellSize = new("--cell-size") { Description = "For clustering: the side of a cell, in model units." };
    private readonly Option<int> cells = new("--cells") { Description = "For clustering: cells along the shortest side of the box." };

    private readonly Option<string> boundary = new("--boundary")
    {
        Description = "What boundaries do: free, weighted (held by planes) or locked.",
        DefaultValueFactory = _ => "weighted",
    };

    private readonly Option<bool> allowFlips = new("--allow-flips") { Description = "Faces may turn over." };
    private readonly Option<double> featureAngle = new("--feature-angle") { Description = "For qem: keep edges that bend by more than so many degrees." };

    private readonly Option<string> placement = new("--placement")
    {
        Description = "For qem: where new vertices lie: optimal, segment (on the edge) or endpoint (at an end of it).",
        DefaultValueFactory = _ => "optimal",
    };

    private readonly Option<bool> noAreaWeights = new("--no-area-weights") { Description = "For qem: every plane weighs the same." };
    private readonly Option<double> boundaryWeight = new("--boundary-weight") { Description = "For qem: the weight of the planes that hold boundaries, features and seams.", DefaultValueFactory = _ => 10 };
    private readonly Option<bool> ignoreSeams = new("--ignore-seams") { Description = "For qem: texture seams need not be kept." };
    private readonly Option<bool> ignoreLabels = new("--ignore-labels") { Description = "For qem: borders of materials and groups need not be kept." };
    private readonly Option<bool> keepTopology = new("--keep-topology") { Description = "For clustering: only contract legal edges within a cell." };
    private readonly Option<bool> quadric = new("--quadric-optimum") { Description = "For clustering: the quadric's optimum in place of the mean." };
    private readonly Option<string> trace = new("--trace") { Description = "Write every step to a file, a line of JSON each: contractions, or cells." };
    private readonly Option<string> record = new("--record") { Description = "For qem: write the progressive mesh to a file (.pm)." };

    public override string Name => "simplify";

    public override string Summary => "Simplify a mesh to fewer faces.";

    public override string Example => "simplify models/creature.obj small.obj --ratio 0.1 --method qem-accurate";

    public override void Configure(Command command)
    {
        method.AcceptOnlyFromAmong("qem", "qem-accurate", "qem-textbook", "clustering", "shortest-edge", "smallest-triangle", "lowest-curvature");
        boundary.AcceptOnlyFromAmong("free", "weighted", "locked");
        placement.AcceptOnlyFromAmong("optimal", "segment", "endpoint");
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        foreach (Option option in (Option[])[method, faces, ratio, maxError, cellSize, cells, boundary, allowFlips, featureAngle, placement, noAreaWeights, boundaryWeight, ignoreSeams, ignoreLabels, keepTopology, quadric, trace, record])
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        string way = context.Get(method);
        CheckOptions(context, way);
        Mesh mesh = context.ReadMesh(context.Get(input));
        using StreamWriter? lines = context.Has(trace) ? new StreamWriter(context.Get(trace)) : null;
        switch (way)
        {
            case "clustering":
                mesh = Cluster(context, mesh, lines);
                break;
            case "qem" or "qem-accurate" or "qem-textbook":
                Report(context, Contract(context, mesh, way, lines));
                break;
            default:
                DeletionOptions deletion = Deletion(context, mesh, way, lines);
                Report(context, context.Time(() => mesh.DeleteElements(deletion, context.Progress("simplifying"), context.CancellationToken)));
                break;
        }
        context.WriteMesh(mesh, context.Get(output));
    }

    private void CheckOptions(VerbContext context, string way)
    {
        bool isQem = way.StartsWith("qem", StringComparison.Ordinal), isClustering = way == "clustering";
        if (isClustering != (context.Has(cellSize) || context.Has(cells)))
            throw new UsageException(isClustering ? "--method clustering needs --cell-size or --cells" : $"--cell-size and --cells go with --method clustering, not {way}");
        if (!isClustering && !context.Has(faces) && !context.Has(ratio) && !(isQem && context.Has(maxError)))
            throw new UsageException(isQem ? "one of --faces, --ratio, --max-error is needed" : "one of --faces, --ratio is needed");
        foreach ((Option one, Option other) in ((Option, Option)[])[(faces, ratio), (cellSize, cells)])
        {
            if (context.Has(one) && context.Has(other))
                throw new UsageException($"{one.Name} and {other.Name} exclude each other");
        }
        foreach (Option option in (Option[])[faces, ratio])
        {
            if (isClustering && context.Has(option))
                throw new UsageException($"{option.Name} does not go with --method clustering, whose cells tell how many faces remain");
        }
        if (context.Has(faces) && context.Get(faces) <= 0)
            throw new UsageException($"--faces {context.Get(faces)}: not positive");
        if (context.Has(ratio) && !(context.Get(ratio) > 0 && context.Get(ratio) <= 1))
            throw new UsageException($"--ratio {context.Get(ratio)}: not in (0, 1]");
        if (context.Has(maxError) && !(context.Get(maxError) >= 0 && double.IsFinite(context.Get(maxError))))
            throw new UsageException($"--max-error {context.Get(maxError)}: not a number from 0");
        if (context.Has(cellSize) && !(context.Get(cellSize) > 0 && double.IsFinite(context.Get(cellSize))))
            throw new UsageException($"--cell-size {context.Get(cellSize)}: not a positive number");
        if (context.Has(cells) && context.Get(cells) <= 0)
            throw new UsageException($"--cells {context.Get(cells)}: not positive");
        if (context.Has(featureAngle) && !(context.Get(featureAngle) > 0 && context.Get(featureAngle) <= 180))
            throw new UsageException($"--feature-angle {context.Get(featureAngle)}: not in (0, 180]");
        if (context.Has(boundaryWeight) && !(context.Get(boundaryWeight) >= 0 && double.IsFinite(context.Get(boundaryWeight))))
            throw new UsageException($"--boundary-weight {context.Get(boundaryWeight)}: not a number from 0");
        foreach (Option option in (Option[])[maxError, featureAngle, placement, noAreaWeights, boundaryWeight, ignoreSeams, ignoreLabels, record])
        {
            if (!isQem && context.Has(option))
                throw new UsageException($"{option.Name} goes with the qem methods, not {way}");
        }
        if (way == "qem-textbook" && context.Has(record))
            throw new UsageException("--record goes with --method qem or qem-accurate");
    }

    private SimplificationResult Contract(VerbContext context, Mesh mesh, string way, TextWriter? lines)
    {
        var options = new QuadricOptions
        {
            Mode = way switch { "qem-accurate" => QuadricMode.Accurate, "qem-textbook" => QuadricMode.Textbook, _ => QuadricMode.Fast },
            TargetFaces = context.Has(faces) ? context.Get(faces) : null,
            TargetRatio = context.Has(ratio) ? context.Get(ratio) : null,
            MaxError = context.Has(maxError) ? context.Get(maxError) : null,
            Boundary = Enum.Parse<BoundaryTreatment>(context.Get(boundary), ignoreCase: true),
            BoundaryWeight = context.Get(boundaryWeight),
            AreaWeights = !context.Get(noAreaWeights),
            Placement = Enum.Parse<VertexPlacement>(context.Get(placement), ignoreCase: true),
            KeepTextureSeams = !context.Get(ignoreSeams),
            KeepLabelBorders = !context.Get(ignoreLabels),
            AllowFlips = context.Get(allowFlips),
            FeatureAngle = context.Has(featureAngle) ? double.DegreesToRadians(context.Get(featureAngle)) : null,
        };
        CheckCount(context, mesh);
        if (context.Has(record))
            ProgressiveMesh.Create(mesh, options, cancellationToken: context.CancellationToken).Save(context.Get(record), cancellationToken: context.CancellationToken);
        options = options with { Trace = lines };
        return context.Time(() => mesh.Simplify(options, context.Progress("simplifying"), context.CancellationToken));
    }

    private DeletionOptions Deletion(VerbContext context, Mesh mesh, string way, TextWriter? lines)
    {
        CheckCount(context, mesh);
        return new DeletionOptions
        {
            Measure = way switch
            {
                "shortest-edge" => DeletionMeasure.ShortestEdge,
                "smallest-triangle" => DeletionMeasure.SmallestTriangle,
                _ => DeletionMeasure.LowestCurvature,
            },
            TargetFaces = context.Has(faces) ? context.Get(faces) : Math.Max(1, (int)(mesh.Faces.Count * context.Get(ratio))),
            AllowFlips = context.Get(allowFlips),
            LockBoundary = context.Get(boundary) == "locked",
            Trace = lines,
        };
    }

    private Mesh Cluster(VerbContext context, Mesh mesh, TextWriter? lines)
    {
        var options = new ClusteringOptions
        {
            CellSize = context.Has(cellSize) ? context.Get(cellSize) : null,
            Cells = context.Has(cells) ? context.Get(cells) : null,
            Representative = context.Get(quadric) ? CellRepresentative.QuadricOptimum : CellRepresentative.Mean,
            NonManifold = context.NonManifold == NonManifoldPolicy.Throw ? NonManifoldPolicy.Skip : context.NonManifold,
            Trace = lines,
        };
        if (context.Get(keepTopology))
        {
            Report(context, context.Time(() => mesh.CollapseCells(options, context.Progress("clustering"), context.CancellationToken)));
            return mesh;
        }
        ClusteringResult result = context.Time(() => mesh.ClusterVertices(options, context.Progress("clustering"), context.CancellationToken));
        context.Result.Add("stopReason", NameOf(result.StopReason)).Add("maxError", result.MaxError).Add("cells", result.Cells).Add("collapsedFaces", result.CollapsedFaces)
            .Add("duplicateFaces", result.DuplicateFaces).Add("skippedFaces", result.Report.Repairs.Count);
        return result.Mesh;
    }

    private void CheckCount(VerbContext context, Mesh mesh)
    {
        if (context.Has(faces) && context.Get(faces) > mesh.Faces.Count)
            throw new UsageException($"--faces {context.Get(faces)}: the mesh has {mesh.Faces.Count}");
    }

    private static void Report(VerbContext context, SimplificationResult result) => context.Result
        .Add("stopReason", NameOf(result.StopReason))
        .Add("maxError", result.MaxError)
        .Add("collapses", result.Collapses)
        .Add("refused", result.Refusals.Total);

    private static string NameOf(StopReason reason) => reason switch
    {
        StopReason.TargetReached => "target-reached",
        StopReason.MaxErrorReached => "max-error-reached",
        StopReason.CellsDone => "cells",
        _ => "nothing-collapsible",
    };
}
