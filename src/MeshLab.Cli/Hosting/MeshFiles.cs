using System.CommandLine;
using MeshLab.IO;
using MeshLab.Structure;

namespace MeshLab.Cli.Hosting;

/// <summary>Reading and writing of meshes as the options say.</summary>
internal static class MeshFiles
{
    /// <summary>Asks for text; only verbs that add it have it.</summary>
    public static readonly Option<bool> Ascii = new("--ascii") { Description = "Write text." };

    /// <summary>Asks for binary; only verbs that add it have it.</summary>
    public static readonly Option<bool> Binary = new("--binary") { Description = "Write binary." };

    public static ResultFields Counts(Mesh mesh) => Counts(mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count);

    public static ResultFields Counts(int vertices, int edges, int faces) => new ResultFields().Add("vertices", vertices).Add("edges", edges).Add("faces", faces);

    public static Mesh Read(string path, VerbContext context)
    {
        var options = new MeshReadOptions { NonManifold = context.NonManifold, Format = FormatOf(context.InputFormat, path, "--input-format") };
        IProgress<double>? progress = context.Progress("reading");
        MeshReadReport report;
        Mesh mesh;
        if (path == "-")
        {
            using Stream input = context.Streams.OpenInput();
            mesh = MeshFile.Read(input, options.Format!.Value, out report, options, "-", progress, context.CancellationToken);
        }
        else
        {
            mesh = MeshFile.Read(path, out report, options, progress, context.CancellationToken);
        }
        progress?.Report(1);
        context.AddRepairs(report.Build);
        context.NoteRead(report);
        return mesh;
    }

    public static void Write(Mesh mesh, string path, VerbContext context)
    {
        var options = new MeshWriteOptions
        {
            Format = FormatOf(context.OutputFormat, path, "--output-format"),
            Encoding = EncodingOf(context),
            MaterialLibraries = context.MaterialLibraries,
        };
        if (path == "-")
        {
            using Stream output = context.Streams.OpenOutput();
            context.NoteWritten(MeshFile.Write(mesh, output, options.Format!.Value, options, null, context.CancellationToken));
            context.OutputTaken = true;
            return;
        }
        IProgress<double>? progress = context.Progress("writing");
        context.NoteWritten(MeshFile.Write(mesh, path, options, progress, context.CancellationToken));
        progress?.Report(1);
    }

    private static MeshEncoding EncodingOf(VerbContext context)
    {
        bool ascii = context.Get(Ascii), binary = context.Get(Binary);
        if (ascii && binary)
            throw new UsageException("--ascii and --binary exclude each other");
        return ascii ? MeshEncoding.Text : binary ? MeshEncoding.BinaryLittleEndian : MeshEncoding.Default;
    }

    private static MeshFormat? FormatOf(string? word, string path, string option)
    {
        if (word is null)
        {
            if (path == "-")
                throw new UsageException($"{option} must be given with -");
            if (!MeshFile.TryFormatOf(path, out _))
                throw new UsageException($"{path}: the extension is not one of {string.Join(" ", MeshFile.Formats.Select(f => f.Extension))}; {option} names the format");
            return null;
        }
        return MeshFile.TryFormatOf("x." + word, out MeshFormat format)
            ? format
            : throw new UsageException($"{option} {word} is not one of {string.Join(", ", MeshFile.Formats.Select(f => f.Extension[1..]))}");
    }
}
