using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Cli.Verbs;

internal sealed class DistanceVerb : Verb
{
    private readonly Argument<string> first = InputArgument("A");
    private readonly Argument<string> second = InputArgument("B");
    private readonly Option<int> samples = new("--samples") { Description = "Points spread over each surface by area.", DefaultValueFactory = _ => 100_000 };
    private readonly Option<bool> deterministic = new("--deterministic") { Description = "Edge midpoints and face barycentres in place of random points." };

    private readonly Option<string> colors = new("--colors") { Description = "Write A to a file (.ply, .off, .obj, .glb), each vertex coloured by its distance from B." };

    public override string Name => "distance";

    public override string Summary => "Measure the distance between two surfaces, both ways.";

    public override string Example => "distance models/torus.off models/torus-triangles.obj";

    public override void Configure(Command command)
    {
        command.Arguments.Add(first);
        command.Arguments.Add(second);
        command.Options.Add(samples);
        command.Options.Add(deterministic);
        command.Options.Add(colors);
    }

    public override void Run(VerbContext context)
    {
        if (context.Get(samples) < 1)
            throw new UsageException($"--samples {context.Get(samples)}: not positive");
        Mesh a = context.ReadMesh(context.Get(first)), b = context.ReadMesh(context.Get(second));
        if (a.Faces.Count == 0 || b.Faces.Count == 0)
            throw new RefusedException("a mesh without faces has no distance from anything");
        var options = new MeshDistanceOptions { Samples = context.Get(samples), Seed = context.Seed, Deterministic = context.Get(deterministic) };
        MeshDistanceReport report = context.Time(() => MeshDistance.Measure(a, b, options, context.Progress("distance"), context.CancellationToken));
        context.Result
            .Add("forward", Fields(report.Forward))
            .Add("backward", Fields(report.Backward))
            .Add("hausdorff", report.Hausdorff)
            .Add("diagonal", report.Diagonal);
        if (context.Has(colors))
            WriteColored(context, a, b);
        context.Table("Distance", ["", "mean", "rms", "max", "max / diagonal"], [Row("A to B", report.Forward), Row("B to A", report.Backward)]);

        string[] Row(string name, DistanceStatistics way) => [name, Text(way.Mean), Text(way.Rms), Text(way.Max), Text(way.Max / report.Diagonal)];
    }

    /// <summary>Dark is on the other surface, light the farthest away.</summary>
    private void WriteColored(VerbContext context, Mesh a, Mesh b)
    {
        double[] distances = context.Time(() => a.VertexDistancesTo(b, context.Progress("colours"), context.CancellationToken));
        double farthest = distances.Where(double.IsFinite).DefaultIfEmpty(0).Max();
        VertexTrait<Color> trait = a.GetOrAddVertexTrait<Color>(TraitNames.Color, default);
        foreach (Vertex v in a.Vertices)
            trait[v] = ColorMap.Viridis.Sample(farthest > 0 ? distances[v.Index] / farthest : 0);
        context.WriteMesh(a, context.Get(colors));
        context.Result.Add("farthestVertex", farthest);
    }

    private static ResultFields Fields(DistanceStatistics way) => new ResultFields().Add("mean", way.Mean).Add("rms", way.Rms).Add("max", way.Max);

    private static string Text(double value) => value.ToString("G6", CultureInfo.InvariantCulture);
}
