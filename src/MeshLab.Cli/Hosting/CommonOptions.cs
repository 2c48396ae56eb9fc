using System.CommandLine;

namespace MeshLab.Cli.Hosting;

/// <summary>The options that every verb has.</summary>
internal static class CommonOptions
{
    public static readonly Option<bool> Json = Recursive(new Option<bool>("--json") { Description = "Print one JSON object and nothing else." });

    public static readonly Option<bool> Debug = Recursive(new Option<bool>("--debug") { Description = "Print stack traces of errors." });

    public static readonly Option<string> NonManifold = OneOf("--non-manifold", "What is done with faces that do not make a manifold.", "throw", "skip", "split");

    public static readonly Option<int> Seed = Recursive(new Option<int>("--seed") { Description = "Seed of everything random.", DefaultValueFactory = _ => 1 });

    public static readonly Option<int> Threads = Recursive(new Option<int>("--threads")
    {
        Description = "The most threads; 0 for all. The result is the same for every number.",
        DefaultValueFactory = _ => 0,
    });

    public static readonly Option<string?> InputFormat = Recursive(new Option<string?>("--input-format") { Description = "Format of the input if its name does not tell: obj, off, stl or ply." });

    public static readonly Option<string?> OutputFormat = Recursive(new Option<string?>("--output-format") { Description = "Format of the output if its name does not tell: obj, off, stl, ply or glb." });

    public static void AddTo(Command root)
    {
        foreach (Option option in new Option[] { Json, Debug, NonManifold, Seed, Threads, InputFormat, OutputFormat })
            root.Options.Add(option);
    }

    /// <summary>An option with a choice of words; the first is the default.</summary>
    private static Option<string> OneOf(string name, string description, params string[] words)
    {
        var option = new Option<string>(name) { Description = description, DefaultValueFactory = _ => words[0] };
        option.AcceptOnlyFromAmong(words);
        return Recursive(option);
    }

    private static Option<T> Recursive<T>(Option<T> option)
    {
        option.Recursive = true;
        return option;
    }
}
