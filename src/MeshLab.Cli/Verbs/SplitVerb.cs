using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Cli.Values;
using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class SplitVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> directory = new("DIR") { Description = "The folder for the parts, made if it is not there." };
    private readonly Option<string> by = new("--by") { Description = "components, or regions between sharp edges.", DefaultValueFactory = _ => "components" };

    public override string Name => "split";

    public override string Summary => "Write every component, or every region between sharp edges, as a mesh of its own.";

    public override string Example => "split models/chain.ply chain-parts --by components";

    public override void Configure(Command command)
    {
        by.AcceptOnlyFromAmong("components", "regions");
        command.Arguments.Add(input);
        command.Arguments.Add(directory);
        command.Options.Add(by);
        command.Options.Add(ValueArguments.Angle);
    }

    public override void Run(VerbContext context)
    {
        double angle = ValueArguments.ParseAngle(context);
        Mesh mesh = context.ReadMesh(context.Get(input));
        IReadOnlyList<MeshPart> parts = context.Time(() => context.Get(by) == "regions" ? mesh.SplitRegions(angle) : mesh.SplitComponents());
        Directory.CreateDirectory(context.Get(directory));
        string extension = context.OutputFormat is { } format ? "." + format : ".obj";
        var listed = new List<ResultFields>();
        for (int i = 0; i < parts.Count; i++)
        {
            string file = Path.Combine(context.Get(directory), string.Create(CultureInfo.InvariantCulture, $"part-{i}{extension}"));
            context.WriteMesh(parts[i].Mesh, file);
            listed.Add(new ResultFields().Add("file", file).Add("vertices", parts[i].Mesh.Vertices.Count).Add("faces", parts[i].Mesh.Faces.Count).Add("area", parts[i].Mesh.Area));
        }
        context.Result.Add("parts", listed);
    }
}
