using System.Diagnostics;
using System.Globalization;
using MeshLab.Structure;
using MeshLab.Visualization;
using Spectre.Console;

namespace MeshLab.Demos.Hosting;

/// <summary>Runs every demo on one model and writes a page with what they showed.</summary>
internal static class Tour
{
    /// <summary>A model that can be turned is stored whole in its page; above this many faces the page would be too large to open quickly.</summary>
    private const int MostFacesToTurn = 120_000;

    public static int Run(Mesh mesh, string path, string outDirectory, double pictureScale = 1)
    {
        Directory.CreateDirectory(outDirectory);
        var page = new HtmlPage("MeshLab", $"{Path.GetFileName(path)} · {mesh}");
        AddModel(page, mesh, outDirectory, pictureScale);
        foreach (Demo demo in DemoCatalog.All)
        {
            long start = Stopwatch.GetTimestamp();
            var output = new DemoOutput(Path.Combine(outDirectory, demo.Section), null) { PictureScale = pictureScale };
            string? refusal = RunDemo(demo, mesh, output);
            string took = Stopwatch.GetElapsedTime(start).TotalSeconds.ToString("F1", CultureInfo.InvariantCulture);
            AnsiConsole.MarkupLineInterpolated($"{demo.Title} [grey]{took} s{(refusal is null ? "" : ", not for this model: " + refusal)}[/]");
            AddSection(page, demo, output, refusal, outDirectory);
        }
        string index = Path.Combine(outDirectory, "index.html");
        page.Save(index);
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

    private static void AddModel(HtmlPage page, Mesh mesh, string outDirectory, double pictureScale)
    {
        HtmlSection section = page.AddSection("0", "模型", "The model");
        string picture = Path.Combine(outDirectory, "model.png");
        MeshRenderer.Render(mesh, DemoOutput.Scaled(new RenderOptions(), pictureScale)).SavePng(picture);
        if (mesh.Faces.Count > MostFacesToTurn)
        {
            section.AddPicture("model.png", "the model");
            return;
        }
        HtmlViewer.Save(Path.Combine(outDirectory, "model.html"), mesh, null, "the model", embedded: true);
        section.AddModel("model.html", "model.png", "the model; turn it with the mouse");
    }

    private static void AddSection(HtmlPage page, Demo demo, DemoOutput output, string? refusal, string outDirectory)
    {
        HtmlSection section = page.AddSection(demo.Section, demo.Chinese, demo.English);
        foreach (DemoItem item in output.Items)
        {
            switch (item)
            {
                case DemoLine line:
                    section.AddText(line.Text);
                    break;
                case DemoTable table:
                    section.AddTable(table.Title, table.Columns, table.Rows);
                    break;
                case DemoPicture { Path: var path, Name: var name } when path.EndsWith(".svg", StringComparison.Ordinal):
                    section.AddSvg(File.ReadAllText(path), name);
                    break;
                case DemoPicture picture:
                    section.AddPicture(Path.GetRelativePath(outDirectory, picture.Path).Replace('\\', '/'), picture.Name);
                    break;
                case DemoViewer { Mesh.Faces.Count: <= MostFacesToTurn } viewer:
                    AddViewer(section, demo, viewer, outDirectory, output.PictureScale);
                    break;
            }
        }
        if (refusal is not null)
            section.AddText($"Not for this model: {refusal}");
    }

    private static void AddViewer(HtmlSection section, Demo demo, DemoViewer viewer, string outDirectory, double pictureScale)
    {
        string folder = Path.Combine(outDirectory, demo.Section);
        Directory.CreateDirectory(folder);
        var options = new RenderOptions { Coloring = viewer.Coloring ?? Coloring.Default };
        HtmlViewer.Save(Path.Combine(folder, viewer.Name + ".html"), viewer.Mesh, options, viewer.Name, embedded: true);
        MeshRenderer.Render(viewer.Mesh, DemoOutput.Scaled(options, pictureScale)).SavePng(Path.Combine(folder, viewer.Name + ".png"));
        section.AddModel($"{demo.Section}/{viewer.Name}.html", $"{demo.Section}/{viewer.Name}.png", viewer.Name);
    }
}
