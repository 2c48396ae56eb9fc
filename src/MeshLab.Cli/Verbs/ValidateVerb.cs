using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class ValidateVerb : Verb
{
    private readonly Argument<string> input = InputArgument();

    public override string Name => "validate";

    public override string Summary => "Check every rule of the half-edge structure; exit status 1 if one is violated.";

    public override string Example => "validate models/creature.obj";

    public override void Configure(Command command) => command.Arguments.Add(input);

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        IReadOnlyList<Violation> violations = context.Time(mesh.Validate);
        context.Result
            .Add("valid", violations.Count == 0)
            .Add("violations", violations.Select(v => new ResultFields().Add("rule", $"R{v.Rule}").Add("element", v.Element).Add("message", v.Message)));
        context.ExitStatus = violations.Count == 0 ? 0 : 1;
    }
}
