using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class ProgressiveVerb : Verb
{
    private readonly Argument<string> input = InputArgument("FILE.pm");
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<int> faces = new("--faces") { Description = "The number of faces wanted; the finest level if not given." };

    public override string Name => "progressive";

    public override string Summary => "Take one level of detail out of a progressive mesh.";

    public override string Example => "progressive model.pm level.obj --faces 1000";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(faces);
    }

    public override void Run(VerbContext context)
    {
        ProgressiveMesh progressive = ProgressiveMeshFile.Load(context.Get(input), cancellationToken: context.CancellationToken);
        context.SetInput(Counts(progressive.Mesh));
        int wanted = context.Has(faces) ? context.Get(faces) : progressive.MaxFaces;
        if (wanted < progressive.MinFaces || wanted > progressive.MaxFaces)
            throw new UsageException($"--faces {wanted}: the file has levels from {progressive.MinFaces} to {progressive.MaxFaces} faces");
        IProgress<double>? progress = context.Progress("refining");
        Mesh level = context.Time(() =>
        {
            progressive.GoToFaces(wanted, progress, context.CancellationToken);
            Mesh copy = progressive.Mesh.Clone();
            copy.Compact();
            return copy;
        });
        context.WriteMesh(level, context.Get(output));
        context.Result.Add("minFaces", progressive.MinFaces).Add("maxFaces", progressive.MaxFaces).Add("collapses", progressive.CollapsesDone);
    }

    private static ResultFields Counts(Mesh mesh) => new ResultFields()
        .Add("vertices", mesh.Vertices.Count).Add("edges", mesh.Edges.Count).Add("faces", mesh.Faces.Count);
}
