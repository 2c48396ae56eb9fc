using System.Diagnostics;
using MeshLab.IO;
using MeshLab.Structure;
using Spectre.Console;

namespace MeshLab.Demos.Hosting;

/// <summary>The demos' command line: a list, one section, or the tour of all.</summary>
internal static class DemoProgram
{
    private const string DefaultModel = "creature.obj";

    public static int Run(string[] args)
    {
        if (Console.IsOutputRedirected)
        {
            // In a file there are no colours, and lines need not be broken.
            AnsiConsole.Console = AnsiConsole.Create(new AnsiConsoleSettings { Ansi = AnsiSupport.No });
            AnsiConsole.Profile.Width = 200;
        }
        string outDirectory = "out";
        var words = new List<string>();
        for (int i = 0; i < args.Length; i++)
        {
            if (args[i] == "--out" && i + 1 < args.Length)
                outDirectory = args[++i];
            else
                words.Add(args[i]);
        }
        if (words.Count == 0)
            return List();
        if (words.Count > 2)
            return Fail("usage: [SECTION | tour] [MODEL] [--out DIR]");

        bool isTour = words[0].Equals("tour", StringComparison.OrdinalIgnoreCase);
        Demo? demo = isTour ? null : DemoCatalog.Find(words[0]);
        if (!isTour && demo is null)
            return Fail($"there is no section {words[0]}; without arguments the program lists them");
        try
        {
            string path = words.Count == 2 ? words[1] : FindDefaultModel();
            Mesh mesh = MeshFile.Read(path);
            return isTour ? Tour.Run(mesh, path, outDirectory) : RunOne(demo!, mesh, path, outDirectory);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException or MeshFormatException or TopologyException or ArgumentException)
        {
            return Fail(Tour.ForPeople(error));
        }
    }

    private static int List()
    {
        Table table = new Table { Title = new TableTitle("MeshLab demos: run one by its section, or tour") }.RoundedBorder();
        table.AddColumn("section").AddColumn("").AddColumn("");
        foreach (Demo demo in DemoCatalog.All)
            table.AddRow(demo.Section, Markup.Escape(demo.Chinese), Markup.Escape(demo.English));
        AnsiConsole.Write(table);
        return 0;
    }

    private static int RunOne(Demo demo, Mesh mesh, string path, string outDirectory)
    {
        AnsiConsole.MarkupLineInterpolated($"[bold]{demo.Title}[/]  {Path.GetFileName(path)}: {mesh}");
        long start = Stopwatch.GetTimestamp();
        demo.Run(mesh, new DemoOutput(Path.Combine(outDirectory, demo.Section), AnsiConsole.Console));
        AnsiConsole.MarkupLineInterpolated($"[grey]{Stopwatch.GetElapsedTime(start).TotalSeconds:F1} s[/]");
        return 0;
    }

    private static string FindDefaultModel()
    {
        foreach (string start in (string[])[Environment.CurrentDirectory, AppContext.BaseDirectory])
        {
            for (var folder = new DirectoryInfo(start); folder is not null; folder = folder.Parent)
            {
                string candidate = Path.Combine(folder.FullName, "models", DefaultModel);
                if (File.Exists(candidate))
                    return candidate;
            }
        }
        throw new FileNotFoundException($"models/{DefaultModel} was not found above this folder; name a model.");
    }

    private static int Fail(string message)
    {
        Console.Error.WriteLine(message);
        return 2;
    }
}
