using System.CommandLine;
using System.Diagnostics;
using MeshLab.IO;
using MeshLab.Structure;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace MeshLab.Cli.Hosting;

/// <summary>What a verb works with: its options, the meshes it reads and writes, and the result that it fills.</summary>
internal sealed class VerbContext(ParseResult parsed, TextWriter output, TextWriter error, StandardStreams streams, CancellationToken cancellationToken)
{
    private readonly Stopwatch stopwatch = new();
    private readonly List<IRenderable> tables = [];
    private readonly SortedDictionary<string, long> ignored = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, long> leftOut = new(StringComparer.Ordinal);
    private (int Vertices, int Edges, int Faces) written;

    /// <summary>The result's own fields, in the order of the contract.</summary>
    public ResultFields Result { get; } = new();

    /// <summary>Counts of the input, once it is read.</summary>
    public ResultFields? Input { get; private set; }

    /// <summary>Counts of the output, once it is written; of all files together if there are several.</summary>
    public ResultFields? Output { get; private set; }

    /// <summary>What reading skipped or split.</summary>
    public List<ResultFields> Repairs { get; } = [];

    /// <summary>What reading met and has no use for, by keyword; null if nothing.</summary>
    public ResultFields? Ignored => Fields(ignored);

    /// <summary>What the written format has no place for, and of how many elements; null if nothing.</summary>
    public ResultFields? LeftOut => Fields(leftOut);

    /// <summary>The material libraries that the first mesh read names; one written as OBJ names them again.</summary>
    public IReadOnlyList<string> MaterialLibraries { get; private set; } = [];

    /// <summary>0 unless the verb says otherwise: 1 for "no".</summary>
    public int ExitStatus { get; set; }

    public bool Json => Get(CommonOptions.Json);

    public int Seed => Get(CommonOptions.Seed);

    public NonManifoldPolicy NonManifold => Enum.Parse<NonManifoldPolicy>(Get(CommonOptions.NonManifold), ignoreCase: true);

    public string? InputFormat => Get(CommonOptions.InputFormat);

    public string? OutputFormat => Get(CommonOptions.OutputFormat);

    public CancellationToken CancellationToken => cancellationToken;

    /// <summary>Standard output, for verbs that print a mesh or a script there.</summary>
    public TextWriter StandardOutput => output;

    /// <summary>Where meshes named <c>-</c> come from and go to.</summary>
    public StandardStreams Streams => streams;

    /// <summary>True once standard output holds the result itself (a mesh, a script), so that nothing else may be printed there.</summary>
    public bool OutputTaken { get; set; }

    /// <summary>The file being read at the moment, for error messages.</summary>
    public string? CurrentFile { get; private set; }

    public bool IsReading { get; private set; }

    public double Seconds => stopwatch.Elapsed.TotalSeconds;

    public IReadOnlyList<IRenderable> Tables => tables;

    public T Get<T>(Option<T> option) => parsed.GetValue(option)!;

    public T Get<T>(Argument<T> argument) => parsed.GetValue(argument)!;

    /// <summary>Whether the user gave the option.</summary>
    public bool Has(Option option) => parsed.GetResult(option) is { Implicit: false };

    /// <summary>Reads a mesh; the first one read is the "input" of the result.</summary>
    public Mesh ReadMesh(string path)
    {
        (CurrentFile, IsReading) = (path, true);
        Mesh mesh = MeshFiles.Read(path, this);
        (CurrentFile, IsReading) = (null, false);
        Input ??= MeshFiles.Counts(mesh);
        return mesh;
    }

    /// <summary>Writes a mesh; all that are written together are the "output" of the result.</summary>
    public void WriteMesh(Mesh mesh, string path)
    {
        CurrentFile = path;
        MeshFiles.Write(mesh, path, this);
        CurrentFile = null;
        written = (written.Vertices + mesh.Vertices.Count, written.Edges + mesh.Edges.Count, written.Faces + mesh.Faces.Count);
        Output = MeshFiles.Counts(written.Vertices, written.Edges, written.Faces);
    }

    /// <summary>Names the input of a verb that reads no mesh.</summary>
    public void SetInput(ResultFields counts) => Input = counts;

    /// <summary>Lists what the builder skipped or split.</summary>
    public void AddRepairs(BuildReport? report)
    {
        foreach (Repair repair in report?.Repairs ?? [])
        {
            Repairs.Add(new ResultFields()
                .Add("kind", repair.Kind == RepairKind.SkippedFace ? "skipped-face" : "split-vertex")
                .Add("element", repair.Element)
                .Add("message", repair.Message));
        }
    }

    /// <summary>Takes over what a reader found beside the mesh.</summary>
    public void NoteRead(MeshReadReport report)
    {
        if (Input is null)
            MaterialLibraries = report.MaterialLibraries;
        foreach ((string keyword, int count) in report.Ignored)
            Count(ignored, keyword, count);
        Count(ignored, "weights", report.IgnoredWeights);
        Count(ignored, "attributes that are not finite", report.ReplacedAttributes);
        Count(ignored, "trailing bytes", report.TrailingBytes);
    }

    /// <summary>Takes over what a writer had no place for.</summary>
    public void NoteWritten(MeshWriteReport report)
    {
        foreach ((string what, int count) in report.LeftOut)
            Count(leftOut, what, count);
        Count(leftOut, "polygons (cut into triangles)", report.TriangulatedFaces);
        Count(leftOut, "double precision (rounded vertices)", report.RoundedVertices);
    }

    private static void Count(SortedDictionary<string, long> counts, string what, long count)
    {
        if (count > 0)
            counts[what] = counts.GetValueOrDefault(what) + count;
    }

    private static ResultFields? Fields(SortedDictionary<string, long> counts)
    {
        if (counts.Count == 0)
            return null;
        var fields = new ResultFields();
        foreach ((string what, long count) in counts)
            fields.Add(what, count);
        return fields;
    }

    /// <summary>Runs the algorithm on the clock; reading and writing stay outside.</summary>
    public T Time<T>(Func<T> work)
    {
        stopwatch.Start();
        try
        {
            return work();
        }
        finally
        {
            stopwatch.Stop();
        }
    }

    /// <inheritdoc cref="Time{T}(Func{T})"/>
    public void Time(Action work) => Time(() =>
    {
        work();
        return 0;
    });

    /// <summary>A progress bar on standard error, if that is a terminal and the result is for people.</summary>
    public IProgress<double>? Progress(string label) =>
        Json || Console.IsErrorRedirected || !ReferenceEquals(error, Console.Error) ? null : new ProgressLine(label, error);

    /// <summary>Adds a table for people; with <c>--json</c> it is not shown.</summary>
    public void Table(string title, IReadOnlyList<string> columns, IEnumerable<IReadOnlyList<string>> rows)
    {
        var table = new Table { Title = new TableTitle(Markup.Escape(title)) }.RoundedBorder();
        foreach (string column in columns)
            table.AddColumn(new TableColumn(Markup.Escape(column)));
        foreach (IReadOnlyList<string> row in rows)
            table.AddRow([.. row.Select(cell => new Text(cell))]);
        tables.Add(table);
    }
}
