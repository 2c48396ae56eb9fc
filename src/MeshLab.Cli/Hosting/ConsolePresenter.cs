using System.Collections;
using System.Globalization;
using MeshLab.Numerics;
using Spectre.Console;

namespace MeshLab.Cli.Hosting;

/// <summary>Shows a result to a person: short values as a table of two columns, long lists by their beginning.</summary>
internal static class ConsolePresenter
{
    private const int ItemsShown = 8;

    public static void Print(Verb verb, VerbContext context, TextWriter output)
    {
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Out = new AnsiConsoleOutput(output),
            Ansi = Console.IsOutputRedirected ? AnsiSupport.No : AnsiSupport.Detect,
        });
        if (Console.IsOutputRedirected)
            console.Profile.Width = 160;
        var table = new Table { Title = new TableTitle($"mlab {verb.Name}") }.RoundedBorder().HideHeaders();
        table.AddColumn("name").AddColumn("value");
        int rows = 0;
        foreach ((string name, object? value) in Rows(context))
        {
            table.AddRow(new Text(name, new Style(Spectre.Console.Color.Grey)), new Text(Show(value)));
            rows++;
        }
        if (rows > 0)
            console.Write(table);
        foreach (var extra in context.Tables)
            console.Write(extra);
    }

    private static IEnumerable<KeyValuePair<string, object?>> Rows(VerbContext context)
    {
        if (context.Input is not null)
            yield return new("input", context.Input);
        if (context.Output is not null)
            yield return new("output", context.Output);
        foreach (var field in context.Result)
            yield return field;
        if (context.Repairs.Count > 0)
            yield return new("repairs", context.Repairs);
        if (context.Ignored is not null)
            yield return new("ignored", context.Ignored);
        if (context.LeftOut is not null)
            yield return new("left out", context.LeftOut);
        if (context.Seconds > 0)
            yield return new("seconds", context.Seconds);
    }

    private static string Show(object? value) => value switch
    {
        null => "–",
        bool truth => truth ? "yes" : "no",
        double number => number.ToString("G9", CultureInfo.InvariantCulture),
        Vector3D v => string.Create(CultureInfo.InvariantCulture, $"({v.X:G7}, {v.Y:G7}, {v.Z:G7})"),
        string text => text,
        ResultFields nested => string.Join(", ", nested.Take(16).Select(field => $"{field.Key} {Show(field.Value)}")),
        IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
        IEnumerable items => ShowItems(items),
        _ => value.ToString() ?? "",
    };

    private static string ShowItems(IEnumerable items)
    {
        List<object?> all = [.. items.Cast<object?>()];
        // Fields and long lists get a line each; short lists, such as the ends of an edge, stay in the line as (3, 5).
        bool nested = all.Any(item => item is ResultFields || (IsList(item) && ((IEnumerable)item!).Cast<object?>().Skip(3).Any()));
        string shown = string.Join(nested ? "\n" : ", ", all.Take(ItemsShown).Select(item => !nested && IsList(item) ? $"({Show(item)})" : Show(item)));
        return all.Count > ItemsShown ? string.Create(CultureInfo.InvariantCulture, $"{shown}{(nested ? "\n" : ", ")}… ({all.Count} in all)") : all.Count == 0 ? "none" : shown;
    }

    private static bool IsList(object? item) => item is IEnumerable and not (string or ResultFields);
}
