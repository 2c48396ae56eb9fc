using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Smoothing;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class SmoothVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();

    private readonly Option<string> method = new("--method")
    {
        Description = "uniform (towards the neighbours' mean), cotangent (along the normal), taubin (without shrinking) or implicit (large steps).",
        DefaultValueFactory = _ => "taubin",
    };

    private readonly Option<int> steps = new("--steps") { Description = "How many steps; 10, or 1 for implicit, if not given." };

    private readonly Option<string> boundary = new("--boundary")
    {
        Description = "What boundary vertices do: fixed, curve (smoothed along the boundary) or free.",
        DefaultValueFactory = _ => "fixed",
    };

    private readonly Option<double> time = new("--time")
    {
        Description = "For implicit: the time of a step, in units of the mean area per vertex.",
        DefaultValueFactory = _ => 1,
    };

    public override string Name => "smooth";

    public override string Summary => "Smooth a mesh: uniform, cotangent, Taubin or implicit.";

    public override string Example => "smooth models/creature.obj smooth.obj --method taubin --steps 20";

    public override void Configure(Command command)
    {
        method.AcceptOnlyFromAmong("uniform", "cotangent", "taubin", "implicit");
        boundary.AcceptOnlyFromAmong("fixed", "curve", "free");
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(method);
        command.Options.Add(steps);
        command.Options.Add(boundary);
        command.Options.Add(time);
    }

    public override void Run(VerbContext context)
    {
        string way = context.Get(method);
        int count = context.Has(steps) ? context.Get(steps) : way == "implicit" ? 1 : 10;
        if (count < 0)
            throw new UsageException($"--steps {count}: less than nothing");
        if (!(context.Get(time) > 0 && double.IsFinite(context.Get(time))))
            throw new UsageException($"--time {context.Get(time)}: not a positive number");
        Mesh mesh = context.ReadMesh(context.Get(input));
        IProgress<double>? progress = context.Progress("smoothing");

        SmoothingResult result = context.Time(() => Smooth(mesh, way, count, context, progress));

        context.WriteMesh(mesh, context.Get(output));
        context.Result.Add("method", way).Add("steps", result.Steps).Add("largestMove", result.LargestMove).Add("meanMove", result.MeanMove);
    }

    private SmoothingResult Smooth(Mesh mesh, string way, int count, VerbContext context, IProgress<double>? progress)
    {
        SmoothingBoundary rule = context.Get(boundary) switch
        {
            "curve" => SmoothingBoundary.AlongCurve,
            "free" => SmoothingBoundary.Free,
            _ => SmoothingBoundary.Fixed,
        };
        CancellationToken token = context.CancellationToken;
        return way switch
        {
            "uniform" => mesh.SmoothUniformly(new UniformSmoothingOptions { Steps = count, Boundary = rule }, progress, token),
            "cotangent" => mesh.SmoothByCotangents(new CotangentSmoothingOptions { Steps = count, Boundary = rule }, progress, token),
            "taubin" => mesh.SmoothByTaubin(new TaubinSmoothingOptions { Steps = count, Boundary = rule }, progress, token),
            _ => mesh.SmoothImplicitly(new ImplicitSmoothingOptions { Steps = count, Boundary = rule, Time = context.Get(time) }, progress, token),
        };
    }
}
