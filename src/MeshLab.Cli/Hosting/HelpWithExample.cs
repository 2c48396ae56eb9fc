using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace MeshLab.Cli.Hosting;

/// <summary>The usual help, and under it the verb's example.</summary>
internal sealed class HelpWithExample(HelpAction usual) : SynchronousCommandLineAction
{
    public override bool ClearsParseErrors => true;

    public override int Invoke(ParseResult parseResult)
    {
        int status;
        lock (MlabApp.Grammar)
            status = usual.Invoke(parseResult);
        Verb? verb = MlabApp.Verbs.FirstOrDefault(v => v.Name == parseResult.CommandResult.Command.Name);
        if (verb is not null)
            parseResult.InvocationConfiguration.Output.WriteLine($"Example:\n  mlab {verb.Example}\n");
        return status;
    }
}
