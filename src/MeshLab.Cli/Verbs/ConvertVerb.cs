using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class ConvertVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();

    public override string Name => "convert";

    public override string Summary => "Write a mesh in another format; STL and PLY as text or binary.";

    public override string Example => "convert models/creature.obj creature.ply --binary";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(MeshFiles.Ascii);
        command.Options.Add(MeshFiles.Binary);
    }

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        context.WriteMesh(mesh, context.Get(output));
    }
}
