using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.Globalization;
using System.Text;
using System.Text.Json;
using MeshLab.Numerics;

namespace MeshLab.Cli.Hosting;

/// <summary>The program: finds the verb, runs it, prints the result or the error, returns the exit status.</summary>
internal static class MlabApp
{
    public static IReadOnlyList<Verb> Verbs { get; } =
    [
        .. typeof(MlabApp).Assembly.GetTypes()
            .Where(type => type.IsSubclassOf(typeof(Verb)) && !type.IsAbstract)
            .Select(type => (Verb)Activator.CreateInstance(type)!)
            .OrderBy(verb => verb.Name, StringComparer.Ordinal),
    ];

    /// <summary>Held while the grammar is built or read: the verbs and their options are the same objects in every call, and know the commands that they belong to.</summary>
    public static Lock Grammar { get; } = new();

    public static int Run(string[] args, TextWriter output, TextWriter error, CancellationToken cancellationToken = default) =>
        Run(args, output, error, StandardStreams.OfConsole, cancellationToken);

    public static int Run(string[] args, TextWriter output, TextWriter error, StandardStreams streams, CancellationToken cancellationToken = default)
    {
        // Numbers in options are read the same everywhere.
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        int status = 0;
        ParseResult parsed;
        lock (Grammar)
            parsed = BuildRoot((verb, result) => status = RunVerb(verb, result, output, error, streams, cancellationToken)).Parse(args);
        if (parsed.Action is ParseErrorAction)
            return Report(CliErrorOf(parsed, args), args.Contains("--json"), null, false, output, error);
        var configuration = new InvocationConfiguration { Output = output, Error = error, EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null };
        int invoked = parsed.Invoke(configuration);
        return status != 0 ? status : invoked;
    }

    public static RootCommand BuildRoot(Action<Verb, ParseResult> run)
    {
        var root = new RootCommand("mlab: mesh processing on the half-edge structure. Every verb has --help with an example, and --json for programs.");
        CommonOptions.AddTo(root);
        foreach (HelpOption help in root.Options.OfType<HelpOption>())
            help.Action = new HelpWithExample((HelpAction)help.Action!);
        foreach (Verb verb in Verbs)
        {
            var command = new Command(verb.Name, verb.Summary);
            verb.Configure(command);
            command.SetAction(parsed => run(verb, parsed));
            root.Subcommands.Add(command);
        }
        return root;
    }

    private static int RunVerb(Verb verb, ParseResult parsed, TextWriter output, TextWriter error, StandardStreams streams, CancellationToken cancellationToken)
    {
        var context = new VerbContext(parsed, output, error, streams, cancellationToken);
        try
        {
            int threads = context.Get(CommonOptions.Threads);
            if (threads < 0)
                throw new UsageException("--threads is 0 or more");
            Parallelism.MaxThreads = threads;
            verb.Run(context);
        }
#pragma warning disable CA1031 // Every failure becomes one line or one JSON object with an exit status of its own.
        catch (Exception failure)
#pragma warning restore CA1031
        {
            return Report(CliError.Of(failure, context.IsReading, context.CurrentFile), context.Json, failure, context.Get(CommonOptions.Debug), output, error);
        }
        finally
        {
            Parallelism.MaxThreads = 0;
        }
        // Standard output may hold a mesh; the result then goes where it is in nobody's way.
        if (context.Json)
            PrintJson(ResultOf(verb, context), context.OutputTaken ? error : output);
        else
            ConsolePresenter.Print(verb, context, context.OutputTaken ? error : output);
        return context.ExitStatus;
    }

    private static ResultFields ResultOf(Verb verb, VerbContext context)
    {
        var all = new ResultFields().Add("command", verb.Name);
        if (context.Input is not null)
            all.Add("input", context.Input);
        if (context.Output is not null)
            all.Add("output", context.Output);
        foreach ((string name, object? value) in context.Result)
            all.Add(name, value);
        if (context.Repairs.Count > 0)
            all.Add("repairs", context.Repairs);
        if (context.Ignored is not null)
            all.Add("ignored", context.Ignored);
        if (context.LeftOut is not null)
            all.Add("leftOut", context.LeftOut);
        return all.Add("seconds", context.Seconds);
    }

    private static CliError CliErrorOf(ParseResult parsed, string[] args)
    {
        if (parsed.CommandResult.Command is RootCommand)
        {
            string? word = Array.Find(args, arg => !arg.StartsWith('-'));
            return new CliError(2, "usage", word is null ? "no verb given; mlab --help lists them" : $"there is no verb '{word}'; mlab --help lists them");
        }
        // A choice of words comes on several lines.
        string[] words = parsed.Errors[0].Message.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        return new CliError(2, "usage", string.Join(' ', words));
    }

    private static int Report(CliError problem, bool json, Exception? cause, bool debug, TextWriter output, TextWriter error)
    {
        error.WriteLine(problem.Message.ReplaceLineEndings(" "));
        if (debug && cause is not null)
            error.WriteLine(cause);
        if (json)
            PrintJson(new ResultFields().Add("error", problem.ToFields()), output);
        return problem.ExitStatus;
    }

    private static void PrintJson(ResultFields fields, TextWriter output)
    {
        using var buffer = new MemoryStream();
        using (var json = new Utf8JsonWriter(buffer, new JsonWriterOptions { Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
            fields.WriteTo(json);
        output.WriteLine(Encoding.UTF8.GetString(buffer.GetBuffer(), 0, (int)buffer.Length));
    }
}
