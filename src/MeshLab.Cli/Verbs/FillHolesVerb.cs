using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.HoleFilling;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class FillHolesVerb : Verb
{
    private static readonly string[] Methods = ["fan", "centroid", "ear", "minimum-weight", "automatic"];
    private static readonly string[] Weights = ["total-bend", "bend", "area"];

    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<string> method = new("--method") { Description = $"How holes are triangulated: {string.Join(", ", Methods)}.", DefaultValueFactory = _ => "automatic" };
    private readonly Option<string> weight = new("--weight") { Description = "What minimum-weight makes small: total-bend (over all edges), bend (the largest, then area), area.", DefaultValueFactory = _ => Weights[0] };
    private readonly Option<bool> refine = new("--refine") { Description = "Make the patch as dense as the surface around it." };
    private readonly Option<bool> fair = new("--fair") { Description = "Bend the patch to continue the surface around it; with --refine." };
    private readonly Option<int> continuity = new("--continuity") { Description = "How --fair meets the surface: 0 position, 1 slope, 2 curvature.", DefaultValueFactory = _ => 1 };
    private readonly Option<int> maxEdges = new("--max-edges") { Description = "Leave loops with more edges open." };
    private readonly Option<int> maxVertices = new("--max-vertices") { Description = "The most vertices added in all." };

    public override string Name => "fill-holes";

    public override string Summary => "Fill the holes of a mesh.";

    public override string Example => "fill-holes models/perforated-sheet.off filled.off --max-edges 100 --refine";

    public override void Configure(Command command)
    {
        method.AcceptOnlyFromAmong(Methods);
        weight.AcceptOnlyFromAmong(Weights);
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        foreach (Option option in (Option[])[method, weight, refine, fair, continuity, maxEdges, maxVertices])
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        if (context.Has(maxEdges) && context.Get(maxEdges) < 3)
            throw new UsageException("--max-edges must be 3 or more");
        if (context.Has(maxVertices) && context.Get(maxVertices) < 0)
            throw new UsageException("--max-vertices must not be negative");
        if (context.Get(continuity) is < 0 or > 2)
            throw new UsageException("--continuity must be 0, 1 or 2");
        Mesh mesh = context.ReadMesh(context.Get(input));
        var options = new HoleFillingOptions
        {
            Method = (HoleFillingMethod)Array.IndexOf(Methods, context.Get(method)),
            Weight = (HoleWeight)Array.IndexOf(Weights, context.Get(weight)),
            Refine = context.Get(refine),
            Fair = context.Get(fair),
            Continuity = context.Get(continuity),
        };
        if (context.Has(maxEdges))
            options = options with { MaxEdges = context.Get(maxEdges) };
        if (context.Has(maxVertices))
            options = options with { MaxNewVertices = context.Get(maxVertices) };
        HoleFillingResult result = context.Time(() => mesh.FillHoles(options, context.Progress("filling"), context.CancellationToken));
        context.WriteMesh(mesh, context.Get(output));
        context.Result.Add("loops", result.Loops.Select(loop => new ResultFields()
            .Add("firstVertex", loop.FirstVertex)
            .Add("edges", loop.Edges)
            .Add("filled", loop.Filled)
            .Add("reason", loop.Filled ? null : Words(loop.Reason))
            .Add("facesAdded", loop.FacesAdded)
            .Add("verticesAdded", loop.VerticesAdded)
            .Add("method", Methods[(int)loop.Method])
            .Add("continuity", loop.Continuity)));
    }

    private static string Words(HoleRefusal reason) => reason switch
    {
        HoleRefusal.TooManyEdges => "too-many-edges",
        HoleRefusal.VertexBudget => "vertex-budget",
        _ => "no-triangulation",
    };
}
