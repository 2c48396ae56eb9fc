using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Geometry;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class FiveSixSevenVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<int> faces = new("--faces") { Description = "The number of faces asked for (the input's by default)." };
    private readonly Option<double> featureAngle = new("--feature-angle") { Description = "Keep edges with a sharper dihedral angle than this (degrees).", DefaultValueFactory = _ => 40 };
    private readonly Option<bool> textbook = new("--textbook") { Description = "The book's engine, step by step." };
    private readonly Option<string> trace = new("--trace") { Description = "Write the steps to a file, a line of JSON each." };

    public override string Name => "five-six-seven";

    public override string Summary => "Give every inner vertex valence 5, 6 or 7 on the same surface.";

    public override string Example => "five-six-seven models/creature.obj creature-567.obj --faces 20000";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        foreach (Option option in (Option[])[faces, featureAngle, textbook, trace])
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        if (context.Has(faces) && context.Get(faces) <= 0)
            throw new UsageException($"--faces {context.Get(faces)}: not positive");
        if (!(context.Get(featureAngle) is >= 0 and <= 180))
            throw new UsageException(FormattableString.Invariant($"--feature-angle {context.Get(featureAngle)}: not in [0, 180]"));
        Mesh mesh = context.ReadMesh(context.Get(input));
        if (mesh.Faces.FirstOrDefault(f => !f.IsTriangle) is { IsNone: false } polygon)
            throw new RefusedException($"f{polygon.Index} has {polygon.Degree} corners; a 5-6-7 mesh is made of triangles. Triangulate the mesh first.", $"f{polygon.Index}");
        using StreamWriter? lines = context.Has(trace) ? new StreamWriter(context.Get(trace)) : null;
        var options = new FiveSixSevenOptions
        {
            Trace = lines,
            TargetFaces = context.Has(faces) ? context.Get(faces) : null,
            FeatureAngle = context.Get(featureAngle) * Math.PI / 180,
            Engine = context.Get(textbook) ? FiveSixSevenEngine.Textbook : FiveSixSevenEngine.Repair,
        };
        FiveSixSevenResult result = context.Time(() => Make(mesh, options, context));
        context.WriteMesh(result.Mesh, context.Get(output));
        MeshDistanceReport? distance = mesh.Faces.Count == 0 ? null : MeshDistance.Measure(mesh, result.Mesh, new MeshDistanceOptions { Seed = context.Seed });

        context.Result
            .Add("valence", new ResultFields().Add("5", Count(result, 5)).Add("6", Count(result, 6)).Add("7", Count(result, 7)))
            .Add("stopReason", result.StopReason switch
            {
                FiveSixSevenStop.Reached => "reached",
                FiveSixSevenStop.CountOutOfReach => "count-out-of-reach",
                _ => "nothing-to-do",
            })
            .Add("complete", result.IsComplete)
            .Add("faces", result.Mesh.Faces.Count)
            .Add("hausdorff", distance?.Hausdorff ?? 0)
            .Add("rms", distance?.Rms ?? 0)
            .Add("diagonal", distance?.Diagonal ?? 0)
            .Add("meanQuality", result.Mesh.Faces.Count == 0 ? 0 : result.Mesh.ComputeFaceQualities().Average())
            .Add("operations", new ResultFields().Add("walks", result.Walks).Add("level", result.Level).Add("lastResort", result.UsedLastResort));
        context.Table(
            "Inner valences",
            ["valence", "before", "after"],
            [.. result.Before.Keys.Union(result.After.Keys).Order().Select(v => new[] { Text(v), Text(result.Before.GetValueOrDefault(v)), Text(result.After.GetValueOrDefault(v)) })]);
    }

    private static FiveSixSevenResult Make(Mesh mesh, FiveSixSevenOptions options, VerbContext context)
    {
        try
        {
            return mesh.ToFiveSixSeven(options, context.Progress("5-6-7"), context.CancellationToken);
        }
        catch (ArgumentException e) when (e.ParamName == nameof(options))
        {
            // What is too few depends on the mesh: it is refused, not wrong usage.
            throw new RefusedException(e.Message.Split(" (Parameter", 2)[0]);
        }
    }

    private static int Count(FiveSixSevenResult result, int valence) => result.After.GetValueOrDefault(valence);

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
}
