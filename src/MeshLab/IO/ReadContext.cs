using System.Globalization;
using System.Text;

namespace MeshLab.IO;

/// <summary>What a reader needs beside the bytes: the file's name for errors, options, progress and cancellation, and a place for its findings.</summary>
internal sealed class ReadContext(string file, MeshReadOptions options, IProgress<double>? progress, CancellationToken cancellationToken)
{
    /// <summary>The share of reading in the time until the mesh is there; building is the rest.</summary>
    public const double ReadShare = 0.6;

    private const int ShownTokenLength = 32;
    private const int KeptKeywords = 64;
    private readonly Dictionary<string, int> ignoredKeywords = new(StringComparer.Ordinal);

    public string File => file;

    public MeshReadOptions Options => options;

    public List<string> MaterialLibraries { get; } = [];

    public MeshEncoding Encoding { get; set; } = MeshEncoding.Text;

    public long IgnoredLines { get; set; }

    public long IgnoredWeights { get; set; }

    public long ReplacedAttributes { get; set; }

    public long TrailingBytes { get; set; }

    public int WeldedVertices { get; set; }

    /// <summary>Throws if the caller has cancelled, and tells how much is done.</summary>
    public void Check(double fraction)
    {
        cancellationToken.ThrowIfCancellationRequested();
        progress?.Report(fraction);
    }

    public void ThrowIfCancelled() => cancellationToken.ThrowIfCancellationRequested();

    /// <summary>Counts something that the library does not read, by its keyword.</summary>
    public void CountIgnored(string keyword, int count = 1)
    {
        // A damaged file must not fill the memory with its keywords.
        if (ignoredKeywords.Count >= KeptKeywords && !ignoredKeywords.ContainsKey(keyword))
            keyword = "…";
        ignoredKeywords[keyword] = ignoredKeywords.GetValueOrDefault(keyword) + count;
    }

    /// <summary>The findings for the caller.</summary>
    public MeshReadReport ToReport(MeshFormat format, MeshData data) => new()
    {
        Format = format,
        Encoding = Encoding,
        VertexCount = data.VertexCount,
        FaceCount = data.FaceCount,
        MaterialLibraries = MaterialLibraries,
        Ignored = ignoredKeywords,
        IgnoredLines = IgnoredLines,
        IgnoredWeights = IgnoredWeights,
        ReplacedAttributes = ReplacedAttributes,
        TrailingBytes = TrailingBytes,
        WeldedVertices = WeldedVertices,
    };

    /// <summary>The error at a place of a text: counts the lines up to there.</summary>
    public MeshFormatException TextError(ReadOnlySpan<byte> text, int position, string expected) =>
        TextError(text, position, Describe(text, position), expected);

    /// <inheritdoc cref="TextError(ReadOnlySpan{byte}, int, string)"/>
    public MeshFormatException TextError(ReadOnlySpan<byte> text, int position, string found, string expected)
    {
        (long line, long column) = Locate(text, position);
        return new MeshFormatException(file, line, column, found, expected);
    }

    /// <summary>The error at a place of binary data: line 0, and the byte's offset as column.</summary>
    public MeshFormatException BinaryError(long offset, string found, string expected) => new(file, 0, offset, found, expected);

    private static (long Line, long Column) Locate(ReadOnlySpan<byte> text, int position)
    {
        long line = 1;
        int start = text.StartsWith("\uFEFF"u8) ? 3 : 0;
        for (int i = start; i < position; i++)
        {
            if (text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.Length && text[i + 1] == '\n')))
            {
                line++;
                start = i + 1;
            }
        }

        // Characters, not bytes: continuation bytes of UTF-8 do not count.
        long column = 1;
        for (int i = start; i < position; i++)
            column += (text[i] & 0xC0) == 0x80 ? 0 : 1;
        return (line, column);
    }

    private static string Describe(ReadOnlySpan<byte> text, int position)
    {
        if (position >= text.Length)
            return "the end of the file";
        if (text[position] is (byte)'\n' or (byte)'\r')
            return "the end of the line";
        if (text[position] is < (byte)' ' or 0x7F)
            return string.Create(CultureInfo.InvariantCulture, $"byte 0x{text[position]:X2}");

        int length = 0;
        while (position + length < text.Length && length < ShownTokenLength && text[position + length] > ' ')
            length++;
        if (length == 0)
            return "a blank";
        bool isLonger = position + length < text.Length && text[position + length] > ' ';
        return $"'{Decode(text.Slice(position, length))}{(isLonger ? "…" : "")}'";
    }

    private static string Decode(ReadOnlySpan<byte> bytes) => System.Text.Encoding.UTF8.GetString(bytes);
}
