using System.Text;

namespace MeshLab.IO;

/// <summary>The number types of PLY.</summary>
internal enum PlyType
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float32,
    Float64,
}

/// <summary>A property of an element: a number, or a list of numbers with its length before them.</summary>
internal sealed record PlyProperty(string Name, PlyType Type, PlyType? LengthType)
{
    public bool IsList => LengthType is not null;
}

/// <summary>A table of the file: so many instances, each with the same properties in the same order.</summary>
internal sealed record PlyElement(string Name, int Count, int HeaderPosition, List<PlyProperty> Properties)
{
    /// <summary>Bytes of an instance in binary if none of its properties is a list.</summary>
    public int? FixedSize => Properties.Exists(p => p.IsList) ? null : Properties.Sum(p => PlyHeader.SizeOf(p.Type));

    /// <summary>The least bytes that an instance can take.</summary>
    public int LeastSize(bool isText) => Properties.Sum(p => isText ? 2 : PlyHeader.SizeOf(p.LengthType ?? p.Type));
}

/// <summary>The header of a PLY file: what tables follow, and how their numbers are written.</summary>
internal sealed class PlyHeader
{
    /// <summary>The comment that gives a name to a label: <c>comment label KIND INDEX NAME</c>.</summary>
    public const string LabelComment = "label";

    public MeshEncoding Encoding { get; private set; }

    public List<PlyElement> Elements { get; } = [];

    /// <summary>The names of each kind of face labels, as this library writes them into comments.</summary>
    public Dictionary<string, List<string>> LabelNames { get; } = new(StringComparer.Ordinal);

    /// <summary>Where the data begin.</summary>
    public int DataPosition { get; private set; }

    public static int SizeOf(PlyType type) => type switch
    {
        PlyType.Int8 or PlyType.UInt8 => 1,
        PlyType.Int16 or PlyType.UInt16 => 2,
        PlyType.Float64 => 8,
        _ => 4,
    };

    public static bool IsInteger(PlyType type) => type < PlyType.Float32;

    public static PlyHeader Read(ReadOnlySpan<byte> file, ReadContext context)
    {
        TextScanner scanner = new(file, 0, file.Length, context);
        PlyHeader header = new();
        if (!scanner.PeekToken().SequenceEqual("ply"u8))
            throw scanner.Error("ply");
        scanner.Position += 3;
        // The end of the first line shows how lines end, which matters only where binary data follow the last one.
        bool isCrOnly = scanner.AtLineEnd() && scanner.Current == '\r' && scanner.Following != '\n';
        bool isCrLf = scanner.Current == '\r' && !isCrOnly;
        EndLine(ref scanner);

        Expect(ref scanner, "format"u8, "format");
        header.Encoding = ReadEncoding(ref scanner);
        context.Encoding = header.Encoding;
        if (!scanner.AtLineEnd())
            scanner.ReadRestOfLine(); // the version, 1.0 since 1994
        EndLine(ref scanner);
        while (!header.ReadLine(ref scanner))
            EndLine(ref scanner);

        if (header.Encoding == MeshEncoding.Text)
            EndLine(ref scanner);
        else if (scanner.Current is not ((byte)'\n' or (byte)'\r'))
            throw scanner.Error("the end of the line after end_header");
        else
            scanner.Position += isCrLf && scanner.Current == '\r' && scanner.Following == '\n' ? 2 : 1;
        header.DataPosition = scanner.Position;
        return header;
    }

    /// <summary>Reads a line of the header; true at <c>end_header</c>, with the position right behind the word.</summary>
    private bool ReadLine(ref TextScanner scanner)
    {
        scanner.SkipBlanks();
        int start = scanner.Position;
        ReadOnlySpan<byte> keyword = Take(ref scanner);
        if (keyword.SequenceEqual("end_header"u8))
            return true;
        if (keyword.SequenceEqual("comment"u8))
            ReadComment(scanner.ReadRestOfLine());
        else if (keyword.SequenceEqual("obj_info"u8))
            scanner.ReadRestOfLine();
        else if (keyword.SequenceEqual("element"u8))
            ReadElement(ref scanner, start);
        else if (keyword.SequenceEqual("property"u8))
            ReadProperty(ref scanner, start);
        else
            throw scanner.ErrorAt(start, "element, property, comment, obj_info or end_header");
        return false;
    }

    private void ReadElement(ref TextScanner scanner, int start)
    {
        scanner.SkipBlanks();
        int namePosition = scanner.Position;
        string name = System.Text.Encoding.UTF8.GetString(Take(ref scanner));
        if (name.Length == 0)
            throw scanner.ErrorAt(namePosition, "an element's name");
        if (Elements.Exists(e => e.Name == name))
            throw scanner.ErrorAt(namePosition, "an element of another name");
        scanner.SkipBlanks();
        int countPosition = scanner.Position;
        int count = scanner.ReadInteger("the number of instances");
        if (count < 0)
            throw scanner.ErrorAt(countPosition, "the number of instances");
        Elements.Add(new PlyElement(name, count, start, []));
    }

    private void ReadProperty(ref TextScanner scanner, int start)
    {
        if (Elements.Count == 0)
            throw scanner.ErrorAt(start, "an element before its properties");
        scanner.SkipBlanks();
        PlyType? lengthType = null;
        if (scanner.PeekToken().SequenceEqual("list"u8))
        {
            Take(ref scanner);
            scanner.SkipBlanks();
            int position = scanner.Position;
            lengthType = ReadType(ref scanner);
            if (!IsInteger(lengthType.Value))
                throw scanner.ErrorAt(position, "a type of integers for the length of a list");
        }

        PlyType type = ReadType(ref scanner);
        scanner.SkipBlanks();
        string name = System.Text.Encoding.UTF8.GetString(Take(ref scanner));
        if (name.Length == 0)
            throw scanner.Error("a property's name");
        Elements[^1].Properties.Add(new PlyProperty(name, type, lengthType));
    }

    private void ReadComment(ReadOnlySpan<byte> comment)
    {
        string[] parts = System.Text.Encoding.UTF8.GetString(comment).Split(' ', 4);
        if (parts.Length < 3 || parts[0] != LabelComment)
            return;
        if (!LabelNames.TryGetValue(parts[1], out List<string>? names))
            LabelNames.Add(parts[1], names = []);
        if (int.TryParse(parts[2], System.Globalization.CultureInfo.InvariantCulture, out int index) && index == names.Count)
            names.Add(parts.Length > 3 ? parts[3] : "");
    }

    private static MeshEncoding ReadEncoding(ref TextScanner scanner)
    {
        scanner.SkipBlanks();
        int start = scanner.Position;
        ReadOnlySpan<byte> word = Take(ref scanner);
        if (word.SequenceEqual("ascii"u8))
            return MeshEncoding.Text;
        if (word.SequenceEqual("binary_little_endian"u8))
            return MeshEncoding.BinaryLittleEndian;
        if (word.SequenceEqual("binary_big_endian"u8))
            return MeshEncoding.BinaryBigEndian;
        throw scanner.ErrorAt(start, "ascii, binary_little_endian or binary_big_endian");
    }

    private static PlyType ReadType(ref TextScanner scanner)
    {
        scanner.SkipBlanks();
        int start = scanner.Position;
        return System.Text.Encoding.UTF8.GetString(Take(ref scanner)) switch
        {
            "char" or "int8" => PlyType.Int8,
            "uchar" or "uint8" => PlyType.UInt8,
            "short" or "int16" => PlyType.Int16,
            "ushort" or "uint16" => PlyType.UInt16,
            "int" or "int32" => PlyType.Int32,
            "uint" or "uint32" => PlyType.UInt32,
            "float" or "float32" => PlyType.Float32,
            "double" or "float64" => PlyType.Float64,
            _ => throw scanner.ErrorAt(start, "a type of numbers"),
        };
    }

    private static ReadOnlySpan<byte> Take(ref TextScanner scanner)
    {
        ReadOnlySpan<byte> token = scanner.PeekToken();
        scanner.Position += token.Length;
        return token;
    }

    private static void Expect(ref TextScanner scanner, ReadOnlySpan<byte> keyword, string expected)
    {
        scanner.SkipBlanks();
        if (!scanner.PeekToken().SequenceEqual(keyword))
            throw scanner.Error(expected);
        scanner.Position += keyword.Length;
    }

    private static void EndLine(ref TextScanner scanner)
    {
        if (!scanner.AtLineEnd())
            throw scanner.Error("the end of the line");
        if (scanner.AtEnd)
            throw scanner.Error("end_header");
        bool isCr = scanner.Current == '\r';
        scanner.NextLine();
        if (isCr && scanner.Current == '\n')
            scanner.Position++;
    }
}
