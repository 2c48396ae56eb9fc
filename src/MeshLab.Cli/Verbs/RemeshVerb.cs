using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Geometry;
using MeshLab.Remeshing;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class RemeshVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<double> edgeLength = new("--edge-length") { Description = "The edge length asked for, in model units." };
    private readonly Option<double> relative = new("--relative") { Description = "The edge length asked for, as a multiple of the input's mean.", DefaultValueFactory = _ => 1 };
    private readonly Option<int> iterations = new("--iterations") { Description = "Passes of split, collapse, flip and smooth.", DefaultValueFactory = _ => 5 };
    private readonly Option<double> featureAngle = new("--feature-angle") { Description = "Keep edges with a sharper dihedral angle than this (degrees).", DefaultValueFactory = _ => 180 };
    private readonly Option<bool> noProjection = new("--no-projection") { Description = "Do not move vertices back to the input's surface." };
    private readonly Option<bool> highQuality = new("--high-quality") { Description = "Nearer to the input and rounder, at about twice the time." };
    private readonly Option<double> curvatureTolerance = new("--curvature-tolerance") { Description = "Shorter edges where the surface is curved: chord height as a multiple of the edge length." };
    private readonly Option<bool> laboratory = new("--laboratory") { Description = "The laboratory's four steps, as in the script." };
    private readonly Option<string> trace = new("--trace") { Description = "Write the steps to a file, a line of JSON each." };

    public override string Name => "remesh";

    public override string Summary => "Remesh with nearly equilateral triangles on the same surface.";

    public override string Example => "remesh models/creature.obj creature-remeshed.obj --relative 0.8";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        foreach (Option option in (Option[])[edgeLength, relative, iterations, featureAngle, noProjection, highQuality, curvatureTolerance, laboratory, trace])
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        CheckOptions(context);
        Mesh mesh = context.ReadMesh(context.Get(input));
        using StreamWriter? lines = context.Has(trace) ? new StreamWriter(context.Get(trace)) : null;
        (Mesh result, RemeshingStop stop, double length) =
            context.Time(() => WithinBudget(() => context.Get(laboratory) ? InLaboratory(mesh, lines, context) : Remesh(mesh, lines, context)));
        context.WriteMesh(result, context.Get(output));

        RemeshingQuality quality = RemeshingQuality.Of(result);
        IReadOnlyDictionary<int, int> histogram = quality.ValenceHistogram;
        var counts = new ResultFields();
        foreach ((int valence, int count) in histogram)
            counts.Add(valence.ToString(CultureInfo.InvariantCulture), count);
        context.Result
            .Add("stopReason", stop == RemeshingStop.PassesDone ? "passes-done" : "nothing-to-do")
            .Add("edgeLength", length)
            .Add("valence", new ResultFields()
                .Add("min", histogram.Count == 0 ? 0 : histogram.Keys.Min())
                .Add("mean", quality.MeanValence)
                .Add("max", histogram.Count == 0 ? 0 : histogram.Keys.Max())
                .Add("histogram", counts))
            .Add("angle", new ResultFields().Add("min", quality.SmallestAngle).Add("mean", quality.MeanSmallestAngle));
    }

    private void CheckOptions(VerbContext context)
    {
        if (context.Has(edgeLength) && context.Has(relative))
            throw new UsageException("--edge-length and --relative exclude each other");
        foreach (Option option in (Option[])[featureAngle, highQuality, curvatureTolerance])
        {
            if (context.Get(laboratory) && context.Has(option))
                throw new UsageException($"{option.Name} does not go with --laboratory, which has four steps and no more");
        }
        foreach (Option<double> option in (Option<double>[])[edgeLength, relative, curvatureTolerance])
        {
            if (context.Has(option) && !(context.Get(option) > 0 && double.IsFinite(context.Get(option))))
                throw new UsageException(FormattableString.Invariant($"{option.Name} {context.Get(option)}: not a positive number"));
        }
        if (context.Get(iterations) < 1)
            throw new UsageException($"--iterations {context.Get(iterations)}: not positive");
        if (!(context.Get(featureAngle) is > 0 and <= 180))
            throw new UsageException(FormattableString.Invariant($"--feature-angle {context.Get(featureAngle)}: not in (0, 180]"));
    }

    private static T WithinBudget<T>(Func<T> remesh)
    {
        try
        {
            return remesh();
        }
        catch (ArgumentException e) when (e.ParamName == "options")
        {
            // Which edges are too short depends on the mesh: they are refused, not wrong usage.
            throw new RefusedException(e.Message.Split(" (Parameter", 2)[0]);
        }
    }

    private (Mesh Mesh, RemeshingStop Stop, double EdgeLength) Remesh(Mesh mesh, TextWriter? lines, VerbContext context)
    {
        var options = new RemeshingOptions
        {
            EdgeLength = context.Has(edgeLength) ? context.Get(edgeLength) : null,
            RelativeLength = context.Get(relative),
            Passes = context.Get(iterations),
            FeatureAngle = double.DegreesToRadians(context.Get(featureAngle)),
            Projection = !context.Get(noProjection),
            HighQuality = context.Get(highQuality),
            CurvatureTolerance = context.Has(curvatureTolerance) ? context.Get(curvatureTolerance) : null,
            Trace = lines,
        };
        RemeshingResult result = mesh.RemeshIsotropically(options, context.Progress("remesh"), context.CancellationToken);
        return (result.Mesh, result.StopReason, result.EdgeLength);
    }

    private (Mesh Mesh, RemeshingStop Stop, double EdgeLength) InLaboratory(Mesh mesh, TextWriter? lines, VerbContext context)
    {
        var options = new LaboratoryRemeshingOptions
        {
            Passes = context.Get(iterations),
            EdgeLength = context.Has(edgeLength) ? context.Get(edgeLength) : context.Has(relative) && mesh.Edges.Count > 0 ? context.Get(relative) * mesh.MeanEdgeLength : null,
            Trace = lines,
        };
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(options, context.Progress("remesh"), context.CancellationToken);
        mesh.Compact();
        return (mesh, result.StopReason, result.EdgeLength);
    }
}
