using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

/// <summary>Makes a shape of the catalogue by name. Every parameter of any shape is an option; those that the shape does not take are refused.</summary>
internal sealed class GenerateVerb : Verb
{
    private const string SeedParameter = "seed";

    private readonly Argument<string?> kind = new("KIND")
    {
        Description = "The shape's name; --list shows all.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Argument<string?> file = new("OUTPUT")
    {
        Description = "The file to write (.obj .off .stl .ply .glb), or - for standard output.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Option<bool> list = new("--list") { Description = "List the shapes and what they take." };

    private readonly Dictionary<string, Option<double>> parameters = ShapeCatalog.Shapes
        .SelectMany(shape => shape.Parameters.Select(parameter => (shape, parameter)))
        .Where(pair => pair.parameter.Name != SeedParameter)
        .GroupBy(pair => pair.parameter.Name, StringComparer.Ordinal)
        .ToDictionary(
            group => group.Key,
            group => new Option<double>("--" + group.Key) { Description = "For " + string.Join(", ", group.Select(pair => pair.shape.Name)) + "." },
            StringComparer.Ordinal);

    public override string Name => "generate";

    public override string Summary => "Make a shape: polygons, solids, surfaces, knots, a creature.";

    public override string Example => "generate torus torus.obj --major 2 --m 64";

    public override void Configure(Command command)
    {
        command.Arguments.Add(kind);
        command.Arguments.Add(file);
        command.Options.Add(list);
        foreach (Option<double> option in parameters.Values)
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        if (context.Get(list))
        {
            List(context);
            return;
        }
        if (context.Get(kind) is not { } name || context.Get(file) is not { } output)
            throw new UsageException("generate needs a kind and a file, or --list.");

        Shape shape = ShapeCatalog.Find(name);
        ShapeArguments arguments = shape.Complete(Given(context));
        BuildReport report = null!;
        Mesh mesh = context.Time(() => shape.Create(arguments, context.NonManifold, out report));
        context.AddRepairs(report);
        var values = new ResultFields();
        foreach (ShapeParameter parameter in shape.Parameters)
            values.Add(parameter.Name, arguments.Values[parameter.Name]);
        context.SetInput(new ResultFields().Add("vertices", 0).Add("edges", 0).Add("faces", 0));
        context.WriteMesh(mesh, output);
        context.Result.Add("kind", shape.Name).Add("parameters", values);
    }

    private Dictionary<string, double> Given(VerbContext context)
    {
        var given = new Dictionary<string, double>(StringComparer.Ordinal);
        foreach ((string name, Option<double> option) in parameters)
        {
            if (context.Has(option))
                given[name] = context.Get(option);
        }
        if (context.Has(CommonOptions.Seed) && ShapeCatalog.Find(context.Get(kind)!).Parameters.Any(p => p.Name == SeedParameter))
            given[SeedParameter] = context.Seed;
        return given;
    }

    private static void List(VerbContext context)
    {
        if (context.Json)
        {
            context.Result.Add("kinds", ShapeCatalog.Shapes.Select(shape => new ResultFields()
                .Add("kind", shape.Name)
                .Add("section", shape.Section)
                .Add("chineseName", shape.ChineseName)
                .Add("description", shape.Description)
                .Add("parameters", shape.Parameters.Select(p => new ResultFields()
                    .Add("name", p.Name)
                    .Add("description", p.Description)
                    .Add("default", p.Default)
                    .Add("minimum", p.Minimum)
                    .Add("maximum", p.Maximum)
                    .Add("integer", p.IsInteger)))));
            return;
        }
        context.Table(
            "Shapes",
            ["kind", "section", "中文", "what", "options"],
            ShapeCatalog.Shapes.Select(shape => new[]
            {
                shape.Name, shape.Section, shape.ChineseName, shape.Description,
                string.Join(" ", shape.Parameters.Select(p => $"--{p.Name} {p.Default.ToString("0.###", CultureInfo.InvariantCulture)}")),
            }));
    }
}
