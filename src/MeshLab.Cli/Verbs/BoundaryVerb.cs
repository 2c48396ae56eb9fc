using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class BoundaryVerb : Verb
{
    private readonly Argument<string> input = InputArgument();

    public override string Name => "boundary";

    public override string Summary => "List the boundary loops, in order, with their lengths.";

    public override string Example => "boundary models/creature.obj";

    public override void Configure(Command command) => command.Arguments.Add(input);

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        IReadOnlyList<BoundaryLoop> loops = context.Time(mesh.FindBoundaryLoops);
        context.Result.Add("loops", loops.Select(loop => new ResultFields()
            .Add("vertices", (int[])[.. loop.Vertices.Select(v => v.Index)])
            .Add("length", loop.Length)));
        context.Table("Boundary loops", ["first vertex", "edges", "length"], loops.Take(50).Select(loop => (IReadOnlyList<string>)
        [
            loop.Vertices[0].ToString(),
            loop.Count.ToString(CultureInfo.InvariantCulture),
            loop.Length.ToString("G6", CultureInfo.InvariantCulture),
        ]));
    }
}
