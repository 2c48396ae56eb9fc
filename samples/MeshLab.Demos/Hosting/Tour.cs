using System.Diagnostics;
using System.Globalization;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;
using Spectre.Console;

namespace MeshLab.Demos.Hosting;

/// <summary>Runs every demo on one model and writes a page with what they showed.</summary>
internal static class Tour
{
    /// <summary>A model that can be turned is stored whole in its page; above this many faces the page would be too large to open quickly.</summary>
    private const int MostFacesToTurn = 120_000;

    private const string CutNote = "This section is about triangles; it shows the model with its polygons cut into triangles.";

    /// <summary>Runs the tour; the status is 1 if a demo failed, which is not the same as not being for the model.</summary>
    public static int Run(Mesh mesh, string path, string outDirectory, double pictureScale = 1)
    {
        if (mesh.Faces.Count == 0)
            throw new ArgumentException($"{path} has no faces to show.", nameof(mesh));
        Directory.CreateDirectory(outDirectory);
        Mesh? triangles = mesh.IsTriangleMesh ? null : TryTriangulate(mesh);
        bool failed = false;
        var page = new HtmlPage("MeshLab", $"{Path.GetFileName(path)} · {mesh}");
        AddModel(page, mesh, outDirectory, pictureScale);
        foreach (Demo demo in DemoCatalog.All)
        {
            long start = Stopwatch.GetTimestamp();
            DemoOutput NewOutput() => new(Path.Combine(outDirectory, demo.Section), null) { PictureScale = pictureScale };
            DemoOutput output = NewOutput();
            DemoEnd end = RunDemo(demo, mesh, output);
            if (end.Kind == DemoEndKind.NotForThisModel && triangles is not null)
            {
                output = NewOutput();
                end = RunDemo(demo, triangles, output) is { Kind: not DemoEndKind.Done } again ? again : new(DemoEndKind.Done, CutNote);
            }
            failed |= end.Kind == DemoEndKind.Failed;
            string took = Stopwatch.GetElapsedTime(start).TotalSeconds.ToString("F1", CultureInfo.InvariantCulture);
            AnsiConsole.MarkupLineInterpolated($"{demo.Title} [grey]{took} s{(end.Note.Length == 0 ? "" : " · " + end.Note)}[/]");
            AddSection(page, demo, output, end.Note, outDirectory);
        }
        string index = Path.Combine(outDirectory, "index.html");
        page.Save(index);
        AnsiConsole.MarkupLineInterpolated($"open [bold]{Path.GetRelativePath(Environment.CurrentDirectory, index)}[/]");
        return failed ? 1 : 0;
    }

    /// <summary>Runs a demo on a copy of the model, and says how it ended.</summary>
    internal static DemoEnd RunDemo(Demo demo, Mesh mesh, DemoOutput output)
    {
        try
        {
            demo.Run(mesh.Clone(), output);
            return new(DemoEndKind.Done, "");
        }
        catch (Exception refusal) when (refusal is ArgumentException or TopologyException)
        {
            return new(DemoEndKind.NotForThisModel, $"Not for this model: {ForPeople(refusal)}");
        }
#pragma warning disable CA1031 // One demo that fails must not take the other sections away; the tour's status tells.
        catch (Exception error) when (error is not OutOfMemoryException)
#pragma warning restore CA1031
        {
            return new(DemoEndKind.Failed, $"This demo failed: {error.GetType().Name}: {error.Message}");
        }
    }

    /// <summary>The message without the parameter's name, which means nothing to somebody who named a model.</summary>
    internal static string ForPeople(Exception error)
    {
        int parameter = error.Message.IndexOf(" (Parameter '", StringComparison.Ordinal);
        return parameter < 0 ? error.Message : error.Message[..parameter];
    }

    private static Mesh? TryTriangulate(Mesh mesh)
    {
        try
        {
            return Triangulation.Triangulate(mesh).Mesh;
        }
        catch (TopologyException)
        {
            // Sections about triangles then say themselves why they are not for this model.
            return null;
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

    private static void AddSection(HtmlPage page, Demo demo, DemoOutput output, string note, string outDirectory)
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
        if (note.Length > 0)
            section.AddText(note);
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

/// <summary>How a demo ended.</summary>
internal enum DemoEndKind
{
    Done,
    NotForThisModel,
    Failed,
}

/// <summary>How a demo ended, and what is to be said about it.</summary>
internal sealed record DemoEnd(DemoEndKind Kind, string Note);
