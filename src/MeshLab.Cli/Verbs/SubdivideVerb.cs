using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Structure;
using MeshLab.Subdivision;

namespace MeshLab.Cli.Verbs;

internal sealed class SubdivideVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();

    private readonly Option<string> scheme = new("--scheme")
    {
        Description = "loop, loop-warren, butterfly and sqrt3 take triangles; catmull-clark and doo-sabin any faces; midpoint moves nothing.",
        DefaultValueFactory = _ => "loop",
    };

    private readonly Option<int> steps = new("--steps") { Description = "How often.", DefaultValueFactory = _ => 1 };
    private readonly Option<bool> limit = new("--limit") { Description = "Move every vertex to its limit (loop, loop-warren, catmull-clark)." };
    private readonly Option<double?> creaseAngle = new("--crease-angle") { Description = "Keep edges sharp whose faces meet at more than these degrees (loop, loop-warren, catmull-clark)." };

    private readonly Option<string> trace = new("--trace") { Description = "Write the steps to a file, a line of JSON each." };

    public override string Name => "subdivide";

    public override string Summary => "Refine a mesh by a subdivision scheme.";

    public override string Example => "subdivide models/cube.obj smooth.obj --scheme loop --steps 3";

    public override void Configure(Command command)
    {
        scheme.AcceptOnlyFromAmong("loop", "loop-warren", "butterfly", "sqrt3", "catmull-clark", "doo-sabin", "midpoint");
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        foreach (Option option in new Option[] { scheme, steps, limit, creaseAngle, trace })
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        string name = context.Get(scheme);
        bool smooths = name is "loop" or "loop-warren" or "catmull-clark";
        if (context.Get(steps) < 0)
            throw new UsageException("--steps must not be negative");
        if (context.Get(limit) && !smooths)
            throw new UsageException($"--limit is known for loop, loop-warren and catmull-clark, not for {name}");
        if (context.Get(creaseAngle) is not null && !smooths)
            throw new UsageException($"--crease-angle is for loop, loop-warren and catmull-clark, not for {name}");
        if (context.Get(creaseAngle) is { } bend && !(bend is >= 0 and <= 180))
            throw new UsageException(FormattableString.Invariant($"--crease-angle {bend}: not in [0, 180]"));

        Mesh mesh = context.ReadMesh(context.Get(input));
        using StreamWriter? lines = context.Has(trace) ? new StreamWriter(context.Get(trace)) : null;
        var options = new SubdivisionOptions
        {
            Trace = lines,
            Steps = context.Get(steps),
            ToLimit = context.Get(limit),
            Weights = name == "loop-warren" ? LoopWeights.Warren : LoopWeights.Loop1987,
        };
        IProgress<double>? progress = context.Progress("subdividing");
        int creases = 0;
        SubdivisionReport? report = null;
        Mesh finer = context.Time(() =>
        {
            if (context.Get(creaseAngle) is { } degrees)
                creases = Creases.SetByAngle(mesh, degrees * Math.PI / 180);
            try
            {
                return mesh.Subdivide(SchemeOf(name), options, out report, progress, context.CancellationToken);
            }
            catch (ArgumentException e) when (e.ParamName == nameof(options))
            {
                // What is too many steps depends on the mesh: it is refused, not wrong usage.
                throw new RefusedException(e.Message.Split(" (Parameter", 2)[0]);
            }
        });
        context.WriteMesh(finer, context.Get(output));
        context.Result.Add("stopReason", report!.StopReason == SubdivisionStop.StepsDone ? "steps-done" : "nothing-to-do").Add("scheme", name).Add("steps", options.Steps).Add("limit", context.Get(limit));
        if (context.Get(creaseAngle) is not null)
            context.Result.Add("creases", creases);
    }

    private static SubdivisionScheme SchemeOf(string name) => name switch
    {
        "butterfly" => SubdivisionScheme.ModifiedButterfly,
        "sqrt3" => SubdivisionScheme.Sqrt3,
        "catmull-clark" => SubdivisionScheme.CatmullClark,
        "doo-sabin" => SubdivisionScheme.DooSabin,
        "midpoint" => SubdivisionScheme.Midpoint,
        _ => SubdivisionScheme.Loop,
    };
}
