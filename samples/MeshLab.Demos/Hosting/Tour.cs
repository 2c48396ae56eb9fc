using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Text;
using MeshLab.Structure;
using Spectre.Console;

namespace MeshLab.Demos.Hosting;

/// <summary>Runs every demo on one model and writes a page with what they showed.</summary>
internal static class Tour
{
    public static int Run(Mesh mesh, string path, string outDirectory)
    {
        Directory.CreateDirectory(outDirectory);
        var page = new StringBuilder();
        string title = $"MeshLab tour: {Path.GetFileName(path)}";
        page.Append(CultureInfo.InvariantCulture, $"<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>{Encode(title)}</title></head><body><h1>{Encode(title)}</h1><p>{Encode(mesh.ToString())}</p>");
        foreach (Demo demo in DemoCatalog.All)
        {
            long start = Stopwatch.GetTimestamp();
            var output = new DemoOutput(Path.Combine(outDirectory, demo.Section), null);
            string? refusal = RunDemo(demo, mesh, output);
            AnsiConsole.MarkupLineInterpolated($"{demo.Title} [grey]{Stopwatch.GetElapsedTime(start).TotalSeconds:F1} s{(refusal is null ? "" : ", not for this model: " + refusal)}[/]");
            Append(page, demo, output, refusal, outDirectory);
        }
        page.Append("</body></html>");
        string index = Path.Combine(outDirectory, "index.html");
        File.WriteAllText(index, page.ToString());
        AnsiConsole.MarkupLineInterpolated($"open [bold]{Path.GetRelativePath(Environment.CurrentDirectory, index)}[/]");
        return 0;
    }

    /// <summary>Runs a demo on a copy of the model; returns why it is not for this model, if so.</summary>
    internal static string? RunDemo(Demo demo, Mesh mesh, DemoOutput output)
    {
        try
        {
            demo.Run(mesh.Clone(), output);
            return null;
        }
        catch (Exception error) when (error is ArgumentException or TopologyException or InvalidOperationException)
        {
            return error.Message;
        }
    }

    private static void Append(StringBuilder page, Demo demo, DemoOutput output, string? refusal, string outDirectory)
    {
        page.Append(CultureInfo.InvariantCulture, $"<h2 id=\"{demo.Section}\">{Encode(demo.Title)}</h2>");
        foreach (DemoItem item in output.Items)
        {
            switch (item)
            {
                case DemoLine line:
                    page.Append(CultureInfo.InvariantCulture, $"<p>{Encode(line.Text)}</p>");
                    break;
                case DemoPicture picture:
                    string link = Path.GetRelativePath(outDirectory, picture.Path).Replace('\\', '/');
                    page.Append(CultureInfo.InvariantCulture, $"<figure><img src=\"{Encode(link)}\"><figcaption>{Encode(picture.Name)}</figcaption></figure>");
                    break;
                case DemoTable table:
                    page.Append("<table><caption>").Append(Encode(table.Title)).Append("</caption><tr>");
                    page.AppendJoin("", table.Columns.Select(column => $"<th>{Encode(column)}</th>")).Append("</tr>");
                    foreach (IReadOnlyList<string> row in table.Rows)
                        page.Append("<tr>").AppendJoin("", row.Select(cell => $"<td>{Encode(cell)}</td>")).Append("</tr>");
                    page.Append("</table>");
                    break;
            }
        }
        if (refusal is not null)
            page.Append(CultureInfo.InvariantCulture, $"<p><em>not for this model: {Encode(refusal)}</em></p>");
    }

    private static string Encode(string text) => WebUtility.HtmlEncode(text);
}
