using System.Globalization;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;
using Spectre.Console;

namespace MeshLab.Demos.Hosting;

/// <summary>What a demo shows: lines, tables and pictures, on the terminal and in a folder.</summary>
public sealed class DemoOutput
{
    private readonly string directory;
    private readonly IAnsiConsole? terminal;
    private readonly List<DemoItem> items = [];

    internal DemoOutput(string directory, IAnsiConsole? terminal)
    {
        this.directory = directory;
        this.terminal = terminal;
    }

    internal IReadOnlyList<DemoItem> Items => items;

    /// <summary>Size of the pictures as a share of what the demo asks for.</summary>
    internal double PictureScale { get; init; } = 1;

    /// <summary>Says something; numbers in it have six digits unless they say otherwise, in the invariant culture.</summary>
    public void Line(FormattableString text)
    {
        ArgumentNullException.ThrowIfNull(text);
        object[] values = [.. text.GetArguments().Select(value => value is double or float or Vector3D ? new SixDigits((IFormattable)value) : value!)];
        string line = string.Format(CultureInfo.InvariantCulture, text.Format, values);
        items.Add(new DemoLine(line));
        terminal?.WriteLine(line);
    }

    /// <summary>Shows a table.</summary>
    public void Table(string title, IReadOnlyList<string> columns, IEnumerable<IReadOnlyList<object>> rows)
    {
        List<IReadOnlyList<string>> cells = [.. rows.Select(row => (IReadOnlyList<string>)[.. row.Select(Format)])];
        items.Add(new DemoTable(title, columns, cells));
        if (terminal is null)
            return;
        Table table = new Table { Title = new TableTitle(Markup.Escape(title)) }.RoundedBorder();
        foreach (string column in columns)
            table.AddColumn(Markup.Escape(column));
        foreach (IReadOnlyList<string> row in cells)
            table.AddRow([.. row.Select(Markup.Escape)]);
        terminal.Write(table);
    }

    /// <summary>Shows a table of names and values.</summary>
    public void Table(string title, params (string Name, object Value)[] rows) =>
        Table(title, ["", ""], rows.Select(row => (IReadOnlyList<object>)[row.Name, row.Value]));

    /// <summary>Draws a mesh.</summary>
    public void Picture(string name, Mesh mesh, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(options);
        MeshRenderer.Render(mesh, Scaled(options, PictureScale)).SavePng(FileFor(name + ".png"));
        Note(new DemoPicture(name, FileFor(name + ".png")));
    }

    /// <summary>Draws a mesh with colours.</summary>
    public void Picture(string name, Mesh mesh, Coloring coloring) => Picture(name, mesh, new RenderOptions { Coloring = coloring });

    /// <summary>Draws a mesh in the usual grey, with its edges.</summary>
    public void Picture(string name, Mesh mesh) => Picture(name, mesh, new RenderOptions { Wireframe = mesh?.Faces.Count < 20_000 });

    /// <summary>Saves a drawing or a chart.</summary>
    public void Svg(string name, string svg)
    {
        File.WriteAllText(FileFor(name + ".svg"), svg);
        Note(new DemoPicture(name, FileFor(name + ".svg")));
    }

    /// <summary>Adds a model that can be turned in the page.</summary>
    public void Viewer(string name, Mesh mesh, Coloring? coloring = null) => items.Add(new DemoViewer(name, mesh.Clone(), coloring));

    /// <summary>The path of a file in the demo's folder, for anything else that it writes.</summary>
    public string FileFor(string name)
    {
        Directory.CreateDirectory(directory);
        return Path.Combine(directory, name);
    }

    internal static RenderOptions Scaled(RenderOptions options, double scale) =>
        scale == 1 ? options : options with { Width = Math.Max(1, (int)(options.Width * scale)), Height = Math.Max(1, (int)(options.Height * scale)) };

    private void Note(DemoPicture picture)
    {
        items.Add(picture);
        terminal?.MarkupLineInterpolated($"[grey]{picture.Name}:[/] {Path.GetRelativePath(Environment.CurrentDirectory, picture.Path)}");
    }

    private static string Format(object value) => value switch
    {
        double or float or Vector3D => ((IFormattable)value).ToString("G6", CultureInfo.InvariantCulture),
        IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
        _ => value?.ToString() ?? "",
    };

    private readonly record struct SixDigits(IFormattable Number) : IFormattable
    {
        public string ToString(string? format, IFormatProvider? provider) => Number.ToString(string.IsNullOrEmpty(format) ? "G6" : format, provider);
    }
}

internal abstract record DemoItem;

internal sealed record DemoLine(string Text) : DemoItem;

internal sealed record DemoTable(string Title, IReadOnlyList<string> Columns, IReadOnlyList<IReadOnlyList<string>> Rows) : DemoItem;

internal sealed record DemoPicture(string Name, string Path) : DemoItem;

internal sealed record DemoViewer(string Name, Mesh Mesh, Coloring? Coloring) : DemoItem;
