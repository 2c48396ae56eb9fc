using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Cli.Values;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class MorseVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Option<string> function = new("--function") { Description = "The function at the vertices.", DefaultValueFactory = _ => "z" };
    private readonly Option<string?> direction = new("--direction") { Description = "The direction, as a,b,c, for --function direction." };
    private readonly Option<string?> persistence = new("--persistence") { Description = "Cancel pairs up to this persistence; inf for all." };
    private readonly Option<bool> complex = new("--complex") { Description = "Also arcs and cells." };
    private readonly Option<int> index = new("--index") { Description = "Which eigenvector, for --function eigenvector.", DefaultValueFactory = _ => 1 };

    public override string Name => "morse";

    public override string Summary => "Critical points, persistence pairs and the Morse complex of a function.";

    public override string Example => "morse models/creature.obj --function z --persistence 0.1 --complex --json";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        function.AcceptOnlyFromAmong("x", "y", "z", "direction", "cosine", "distance", "geodesic", "gaussian", "mean", "harmonic", "eigenvector");
        foreach (Option option in new Option[] { function, direction, ValueArguments.Fixed, ValueArguments.From, persistence, complex, index })
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        double? threshold = ParseThreshold(context.Get(persistence));
        ValueOptions options = ValueArguments.Parse(context);
        Vector3D towards = ParseDirection(context.Get(direction));
        Mesh mesh = context.ReadMesh(context.Get(input));
        context.Time(() => Report(context, mesh, options, towards, threshold));
    }

    private void Report(VerbContext context, Mesh mesh, ValueOptions options, Vector3D towards, double? threshold)
    {
        MorseFunction f = Function(context, mesh, options, towards);
        PersistencePairs pairs = PersistencePairs.Of(f);
        CriticalPoints critical = pairs.Critical;
        DiscreteGradient? gradient = null;
        IReadOnlyList<CriticalPoint> points = critical.Points;
        int minima = critical.Minima.Count, saddles = critical.SaddleCount, maxima = critical.Maxima.Count;
        IReadOnlyList<PersistencePair> left = pairs.Pairs;
        if (threshold is not null)
        {
            gradient = GradientCancellation.Cancel(DiscreteGradient.Of(f), threshold.Value).Gradient;
            left = [.. pairs.Pairs.Where(pair => pair.Persistence > threshold)];
            points = Surviving(critical, pairs, threshold.Value);
            (minima, saddles, maxima) = (gradient.MinimumCount, gradient.SaddleCount, gradient.MaximumCount);
        }
        context.Result
            .Add("minima", minima)
            .Add("saddles", saddles)
            .Add("maxima", maxima)
            .Add("indexSum", minima - saddles + maxima)
            .Add("eulerCharacteristic", critical.EulerCharacteristic)
            .Add("critical", points.Select(p => new ResultFields()
                .Add("vertex", p.Vertex.Index)
                .Add("kind", p.Kind)
                .Add("multiplicity", p.Multiplicity)
                .Add("value", p.Value)))
            .Add("pairs", left.Select(p => new ResultFields().Add("birth", p.Birth.Index).Add("death", p.Death.Index).Add("persistence", p.Persistence)));
        if (!context.Get(complex))
            return;
        MorseComplex built = MorseComplex.Of(gradient ?? DiscreteGradient.Of(f));
        context.Result
            .Add("arcs", built.Arcs.Select(arc => arc.Vertices))
            .Add("cells", MorseCells.Of(built).OfVertex);
    }

    /// <summary>The critical points that are left after cancelling, with what is left of their multiplicities.</summary>
    private static List<CriticalPoint> Surviving(CriticalPoints critical, PersistencePairs pairs, double threshold)
    {
        var left = critical.Points.ToDictionary(p => p.Vertex, p => p.Multiplicity);
        foreach (PersistencePair pair in pairs.Pairs)
        {
            if (pair.Persistence > threshold)
                continue;
            left[pair.Birth]--;
            left[pair.Death]--;
        }
        return [.. critical.Points.Where(p => left[p.Vertex] > 0).Select(p => p with { Multiplicity = left[p.Vertex] })];
    }

    private MorseFunction Function(VerbContext context, Mesh mesh, ValueOptions options, Vector3D towards) => context.Get(function) switch
    {
        "x" => mesh.CoordinateFunction(0),
        "y" => mesh.CoordinateFunction(1),
        "z" => mesh.CoordinateFunction(2),
        "direction" => mesh.DirectionFunction(towards),
        "cosine" => mesh.CosineFunction(),
        "distance" => mesh.DistanceFunction(mesh.Vertices[options.Start(mesh)].Position),
        "geodesic" => mesh.GeodesicFunction(mesh.Vertices[options.Start(mesh)]),
        "gaussian" => mesh.GaussianCurvatureFunction(),
        "mean" => mesh.MeanCurvatureFunction(),
        "harmonic" => mesh.HarmonicFunction(Fixed(mesh, options), cancellationToken: context.CancellationToken),
        _ => mesh.EigenvectorFunction(context.Get(index), context.CancellationToken),
    };

    private static List<(Vertex Vertex, double Value)>? Fixed(Mesh mesh, ValueOptions options)
    {
        if (options.Fixed.Count == 0)
            return null;
        var values = new List<(Vertex, double)>();
        foreach ((int v, double value) in options.Fixed)
        {
            if (v >= mesh.VertexSlots)
                throw new UsageException($"--fixed {v}: the mesh has vertices 0 to {mesh.VertexSlots - 1}");
            values.Add((mesh.Vertices[v], value));
        }
        return values;
    }

    private static double? ParseThreshold(string? text) => text switch
    {
        null => null,
        "inf" or "Infinity" => double.PositiveInfinity,
        _ when double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value >= 0 => value,
        _ => throw new UsageException($"--persistence {text}: expected a number that is 0 or more, or inf"),
    };

    private static Vector3D ParseDirection(string? text)
    {
        if (text is null)
            return Vector3D.UnitZ;
        string[] words = text.Split(',');
        var numbers = new double[3];
        if (words.Length != 3)
            throw new UsageException($"--direction {text}: expected three numbers with commas between them");
        for (int i = 0; i < 3; i++)
        {
            if (!double.TryParse(words[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]))
                throw new UsageException($"--direction {text}: '{words[i]}' is not a number");
        }
        return new(numbers[0], numbers[1], numbers[2]);
    }
}
