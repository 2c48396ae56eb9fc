using System.IO.Compression;
using MeshLab.Structure;

namespace MeshLab.IO;

/// <summary>第 14 章 文件: reads and writes meshes as files.</summary>
/// <remarks>
/// Reading keeps the order of vertices and faces, the first corner of every face, and exact doubles; writing is the shortest text that gives the same
/// doubles again, in every culture the same, so that read → write → read is the identity in OBJ, OFF and PLY. Nothing is rescaled. Errors in a file are
/// <see cref="MeshFormatException"/> with line and column; those of the file system pass through as <see cref="IOException"/> and
/// <see cref="UnauthorizedAccessException"/>. A file is written beside its place and renamed, so that no half-written one is ever seen.
/// </remarks>
public static class MeshFile
{
    /// <summary>The formats, each with its extension.</summary>
    public static IReadOnlyList<MeshFormatInfo> Formats { get; } =
    [
        new(MeshFormat.Obj, ".obj", "Wavefront OBJ", CanRead: true, CanWrite: true),
        new(MeshFormat.Off, ".off", "Object File Format", CanRead: true, CanWrite: true),
        new(MeshFormat.Stl, ".stl", "Stereolithography", CanRead: true, CanWrite: true),
        new(MeshFormat.Ply, ".ply", "Polygon File Format", CanRead: true, CanWrite: true),
        new(MeshFormat.Glb, ".glb", "Binary glTF 2.0", CanRead: false, CanWrite: true),
    ];

    /// <summary>The format of a file by its extension, <c>.gz</c> behind it or not, in any case.</summary>
    /// <param name="path">The file's name.</param>
    /// <param name="format">The format.</param>
    /// <returns>Whether the extension is one of <see cref="Formats"/>.</returns>
    public static bool TryFormatOf(string path, out MeshFormat format)
    {
        ArgumentNullException.ThrowIfNull(path);
        string name = IsPacked(path) ? path[..^3] : path;
        string extension = Path.GetExtension(name);
        foreach (MeshFormatInfo info in Formats)
        {
            if (string.Equals(info.Extension, extension, StringComparison.OrdinalIgnoreCase))
            {
                format = info.Format;
                return true;
            }
        }

        format = default;
        return false;
    }

    /// <summary>Reads a mesh.</summary>
    /// <param name="path">The file.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far reading is.</param>
    /// <param name="cancellationToken">Ends reading with an <see cref="OperationCanceledException"/>.</param>
    /// <exception cref="MeshFormatException">The file is not what its format asks for; the message has line and column.</exception>
    /// <exception cref="TopologyException">The faces are not an oriented 2-manifold and the policy is to throw; the message has the elements, from 0.</exception>
    /// <exception cref="ArgumentException">The extension is not known, or the format cannot be read.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static Mesh Read(string path, MeshReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
        Read(path, out _, options, progress, cancellationToken);

    /// <summary>Reads a mesh and says what was found and left out.</summary>
    /// <inheritdoc cref="Read(string, MeshReadOptions, IProgress{double}, CancellationToken)"/>
    /// <param name="path">The file.</param>
    /// <param name="report">What was found and left out.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far reading is.</param>
    /// <param name="cancellationToken">Ends reading with an <see cref="OperationCanceledException"/>.</param>
    public static Mesh Read(
        string path, out MeshReadReport report, MeshReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        MeshData data = ReadData(path, out report, options, progress, cancellationToken);
        return Build(data, ref report, options, progress, cancellationToken);
    }

    /// <summary>Reads a mesh from a stream, packed by gzip or not.</summary>
    /// <inheritdoc cref="Read(string, MeshReadOptions, IProgress{double}, CancellationToken)"/>
    /// <param name="stream">The bytes, read to the end and left open.</param>
    /// <param name="format">Their format.</param>
    /// <param name="report">What was found and left out.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="name">The name of the stream in errors.</param>
    /// <param name="progress">Told from 0 to 1 how far reading is.</param>
    /// <param name="cancellationToken">Ends reading with an <see cref="OperationCanceledException"/>.</param>
    public static Mesh Read(
        Stream stream,
        MeshFormat format,
        out MeshReadReport report,
        MeshReadOptions? options = null,
        string name = "-",
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        MeshData data = ReadData(stream, format, out report, options, name, progress, cancellationToken);
        return Build(data, ref report, options, progress, cancellationToken);
    }

    /// <inheritdoc cref="Read(Stream, MeshFormat, out MeshReadReport, MeshReadOptions, string, IProgress{double}, CancellationToken)"/>
    public static Mesh Read(Stream stream, MeshFormat format, MeshReadOptions? options = null) => Read(stream, format, out _, options);

    /// <summary>Reads what the file says without building a mesh: the way to look at soups and broken models.</summary>
    /// <inheritdoc cref="Read(string, out MeshReadReport, MeshReadOptions, IProgress{double}, CancellationToken)"/>
    public static MeshData ReadData(
        string path, out MeshReadReport report, MeshReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        options ??= new MeshReadOptions();
        MeshFormat format = ChooseFormat(path, options.Format);
        ThrowIfUnreadable(format);
        ReadContext context = new(path, options, progress, cancellationToken);
        return Parse(FileBytes.Read(path, context), format, context, out report);
    }

    /// <inheritdoc cref="ReadData(string, out MeshReadReport, MeshReadOptions, IProgress{double}, CancellationToken)"/>
    public static MeshData ReadData(string path, MeshReadOptions? options = null) => ReadData(path, out _, options);

    /// <summary>Reads what a stream says without building a mesh.</summary>
    /// <inheritdoc cref="Read(Stream, MeshFormat, out MeshReadReport, MeshReadOptions, string, IProgress{double}, CancellationToken)"/>
    public static MeshData ReadData(
        Stream stream,
        MeshFormat format,
        out MeshReadReport report,
        MeshReadOptions? options = null,
        string name = "-",
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ThrowIfUnreadable(format);
        ReadContext context = new(name, options ?? new MeshReadOptions(), progress, cancellationToken);
        return Parse(FileBytes.Read(stream, context), format, context, out report);
    }

    /// <summary>Writes the live elements of a mesh, with the attributes and labels that the format can hold.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="path">The file; one that is there is replaced when the new one is whole.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far writing is.</param>
    /// <param name="cancellationToken">Ends writing with an <see cref="OperationCanceledException"/>; what was there stays.</param>
    /// <returns>What the format has no place for.</returns>
    /// <exception cref="ArgumentException">The extension is not known, the encoding is not of the format, or a coordinate is too large for single precision.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static MeshWriteReport Write(
        Mesh mesh, string path, MeshWriteOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return WriteData(MeshDataConversion.Gather(mesh, sharePositions: true), path, options, progress, cancellationToken);
    }

    /// <summary>Writes a mesh to a stream.</summary>
    /// <inheritdoc cref="Write(Mesh, string, MeshWriteOptions, IProgress{double}, CancellationToken)"/>
    /// <param name="mesh">The mesh.</param>
    /// <param name="stream">Where to; it is left open.</param>
    /// <param name="format">The format.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far writing is.</param>
    /// <param name="cancellationToken">Ends writing with an <see cref="OperationCanceledException"/>.</param>
    public static MeshWriteReport Write(
        Mesh mesh,
        Stream stream,
        MeshFormat format,
        MeshWriteOptions? options = null,
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return WriteData(MeshDataConversion.Gather(mesh, sharePositions: true), stream, format, options, progress, cancellationToken);
    }

    /// <summary>Writes raw data, manifold or not.</summary>
    /// <inheritdoc cref="Write(Mesh, string, MeshWriteOptions, IProgress{double}, CancellationToken)"/>
    /// <param name="data">The data.</param>
    /// <param name="path">The file; one that is there is replaced when the new one is whole.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far writing is.</param>
    /// <param name="cancellationToken">Ends writing with an <see cref="OperationCanceledException"/>; what was there stays.</param>
    public static MeshWriteReport WriteData(
        MeshData data, string path, MeshWriteOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArgumentException.ThrowIfNullOrEmpty(path);
        options ??= new MeshWriteOptions();
        MeshFormat format = ChooseFormat(path, options.Format);
        MeshEncoding encoding = ChooseEncoding(format, options.Encoding);
        AtomicFile.Write(path, stream =>
        {
            BlockWriter Over(Stream target) => new(target, progress, cancellationToken);
            if (!IsPacked(path))
            {
                Format(data, Over(stream), format, encoding, options);
                return;
            }

            using GZipStream packed = new(stream, CompressionLevel.Optimal, leaveOpen: true);
            Format(data, Over(packed), format, encoding, options);
        });
        return FormatLosses.Of(data, format, encoding);
    }

    /// <summary>Writes raw data to a stream.</summary>
    /// <inheritdoc cref="Write(Mesh, Stream, MeshFormat, MeshWriteOptions, IProgress{double}, CancellationToken)"/>
    /// <param name="data">The data.</param>
    /// <param name="stream">Where to; it is left open.</param>
    /// <param name="format">The format.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <param name="progress">Told from 0 to 1 how far writing is.</param>
    /// <param name="cancellationToken">Ends writing with an <see cref="OperationCanceledException"/>.</param>
    public static MeshWriteReport WriteData(
        MeshData data,
        Stream stream,
        MeshFormat format,
        MeshWriteOptions? options = null,
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(data);
        ArgumentNullException.ThrowIfNull(stream);
        options ??= new MeshWriteOptions();
        MeshEncoding encoding = ChooseEncoding(format, options.Encoding);
        Format(data, new BlockWriter(stream, progress, cancellationToken), format, encoding, options);
        return FormatLosses.Of(data, format, encoding);
    }

    private static bool IsPacked(string path) => path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase);

    private static MeshFormat ChooseFormat(string path, MeshFormat? given)
    {
        if (given is MeshFormat format)
            return format;
        return TryFormatOf(path, out format)
            ? format
            : throw new ArgumentException($"'{path}' has none of the extensions {string.Join(", ", Formats.Select(f => f.Extension))}.", nameof(path));
    }

    private static void ThrowIfUnreadable(MeshFormat format)
    {
        if (!Formats.Any(f => f.Format == format && f.CanRead))
            throw new ArgumentException($"The format {format} is not read.", nameof(format));
    }

    private static MeshEncoding ChooseEncoding(MeshFormat format, MeshEncoding encoding)
    {
        bool isTextFormat = format is MeshFormat.Obj or MeshFormat.Off;
        if (encoding == MeshEncoding.Default)
            return isTextFormat ? MeshEncoding.Text : MeshEncoding.BinaryLittleEndian;
        bool isPossible = encoding switch
        {
            MeshEncoding.Text => format != MeshFormat.Glb,
            MeshEncoding.BinaryLittleEndian => !isTextFormat,
            MeshEncoding.BinaryBigEndian => format == MeshFormat.Ply,
            _ => false,
        };
        return isPossible ? encoding : throw new ArgumentException($"The format {format} is not written as {encoding}.", nameof(encoding));
    }

    private static MeshData Parse(ReadOnlyMemory<byte> bytes, MeshFormat format, ReadContext context, out MeshReadReport report)
    {
        if (bytes.IsEmpty)
            throw context.TextError([], 0, "an empty file", $"a file of the format {format}");
        context.Check(0);
        MeshData data = format switch
        {
            MeshFormat.Obj => ObjReader.Read(bytes, context),
            MeshFormat.Off => OffReader.Read(bytes.Span, context),
            MeshFormat.Stl => StlReader.Read(bytes.Span, context),
            _ => PlyReader.Read(bytes.Span, context),
        };
        context.Check(ReadContext.ReadShare);
        report = context.ToReport(format, data);
        return data;
    }

    private static Mesh Build(
        MeshData data, ref MeshReadReport report, MeshReadOptions? options, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        cancellationToken.ThrowIfCancellationRequested();
        Mesh mesh = MeshDataConversion.Build(data, data.Positions, options?.NonManifold ?? NonManifoldPolicy.Throw, out BuildReport build);
        report = report with { Build = build };
        progress?.Report(1);
        return mesh;
    }

    private static void Format(MeshData data, BlockWriter writer, MeshFormat format, MeshEncoding encoding, MeshWriteOptions options)
    {
        switch (format)
        {
            case MeshFormat.Obj:
                ObjWriter.Write(data, writer, options);
                break;
            case MeshFormat.Off:
                OffWriter.Write(data, writer);
                break;
            case MeshFormat.Stl:
                StlWriter.Write(data, writer, encoding);
                break;
            case MeshFormat.Ply:
                PlyWriter.Write(data, writer, encoding);
                break;
            default:
                GlbWriter.Write(data, writer);
                break;
        }
    }
}
