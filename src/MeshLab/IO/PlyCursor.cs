using System.Buffers.Binary;
using System.Buffers.Text;

namespace MeshLab.IO;

/// <summary>Takes number after number out of the data of a PLY file, whether they are text or binary.</summary>
internal ref struct PlyCursor
{
    private readonly ReadOnlySpan<byte> file;
    private readonly ReadContext context;
    private readonly MeshEncoding encoding;
    private TextScanner scanner;
    private int position;
    private int numberPosition;

    public PlyCursor(ReadOnlySpan<byte> file, PlyHeader header, ReadContext context)
    {
        this.file = file;
        this.context = context;
        encoding = header.Encoding;
        position = header.DataPosition;
        scanner = new TextScanner(file, header.DataPosition, file.Length, context);
    }

    public readonly bool IsText => encoding == MeshEncoding.Text;

    /// <summary>Bytes not read yet.</summary>
    public readonly int Remaining => file.Length - (IsText ? scanner.Position : position);

    public readonly double Fraction => 1 - (double)Remaining / Math.Max(1, file.Length);

    /// <summary>Before an instance: in text it begins on a line of its own.</summary>
    public void BeginInstance()
    {
        if (IsText)
            scanner.SkipLinesAndComments();
    }

    /// <summary>After an instance: in text its line ends.</summary>
    public void EndInstance()
    {
        if (IsText && !scanner.AtLineEnd())
            throw scanner.Error("the end of the line");
    }

    /// <summary>Reads a number of any type; NaN if the text says so.</summary>
    public double ReadNumber(PlyType type)
    {
        if (PlyHeader.IsInteger(type))
            return ReadInteger(type);
        if (IsText)
        {
            scanner.SkipBlanks();
            numberPosition = scanner.Position;
            return scanner.ReadAttribute("a number");
        }

        ReadOnlySpan<byte> bytes = Take(PlyHeader.SizeOf(type));
        bool isBig = encoding == MeshEncoding.BinaryBigEndian;
        if (type == PlyType.Float64)
            return isBig ? BinaryPrimitives.ReadDoubleBigEndian(bytes) : BinaryPrimitives.ReadDoubleLittleEndian(bytes);
        return isBig ? BinaryPrimitives.ReadSingleBigEndian(bytes) : BinaryPrimitives.ReadSingleLittleEndian(bytes);
    }

    /// <summary>Reads an integer.</summary>
    public long ReadInteger(PlyType type)
    {
        if (IsText)
        {
            scanner.SkipBlanks();
            numberPosition = scanner.Position;
            return type == PlyType.UInt32 && TryTakeLarge(out long large) ? large : scanner.ReadInteger("an integer");
        }

        ReadOnlySpan<byte> bytes = Take(PlyHeader.SizeOf(type));
        bool isBig = encoding == MeshEncoding.BinaryBigEndian;
        return type switch
        {
            PlyType.Int8 => (sbyte)bytes[0],
            PlyType.UInt8 => bytes[0],
            PlyType.Int16 => isBig ? BinaryPrimitives.ReadInt16BigEndian(bytes) : BinaryPrimitives.ReadInt16LittleEndian(bytes),
            PlyType.UInt16 => isBig ? BinaryPrimitives.ReadUInt16BigEndian(bytes) : BinaryPrimitives.ReadUInt16LittleEndian(bytes),
            PlyType.Int32 => isBig ? BinaryPrimitives.ReadInt32BigEndian(bytes) : BinaryPrimitives.ReadInt32LittleEndian(bytes),
            PlyType.UInt32 => isBig ? BinaryPrimitives.ReadUInt32BigEndian(bytes) : BinaryPrimitives.ReadUInt32LittleEndian(bytes),
            _ => throw new ArgumentOutOfRangeException(nameof(type), type, "Not a type of integers."),
        };
    }

    /// <summary>Reads the length of a list.</summary>
    public int ReadLength(PlyType type)
    {
        long length = ReadInteger(type);
        // A list that is too long for a text ends at its place, with the end of the line.
        return length >= 0 && (IsText || length <= Remaining) ? (int)length : throw ErrorAtNumber($"the length {length} of a list", "a length that the file has room for");
    }

    public void SkipProperty(PlyProperty property)
    {
        int count = property.LengthType is PlyType lengthType ? ReadLength(lengthType) : 1;
        for (int k = 0; k < count; k++)
            ReadNumber(property.Type);
    }

    /// <summary>Takes an unsigned integer beyond the signed ones, such as the −1 that ends a strip.</summary>
    private bool TryTakeLarge(out long large)
    {
        const int LeastDigits = 10;
        ReadOnlySpan<byte> token = scanner.PeekToken();
        large = 0;
        if (token.Length < LeastDigits || !Utf8Parser.TryParse(token, out uint value, out int used) || used != token.Length || value <= int.MaxValue)
            return false;
        scanner.Position += used;
        large = value;
        return true;
    }

    /// <summary>Skips an element that holds nothing for a mesh.</summary>
    public void SkipElement(PlyElement element)
    {
        if (element.Properties.Count == 0)
            return;
        if (!IsText && element.FixedSize is int size)
        {
            long bytes = (long)size * element.Count;
            if (bytes > Remaining)
                throw context.BinaryError(file.Length, "the end of the file", $"{element.Count} instances of {element.Name}");
            position += (int)bytes;
            return;
        }

        for (int i = 0; i < element.Count; i++)
        {
            BeginInstance();
            foreach (PlyProperty property in element.Properties)
                SkipProperty(property);
            EndInstance();
        }
    }

    /// <summary>After the last element the file must end, or a count in the header is too small. Blanks and zeros behind binary data are padding, and counted.</summary>
    public void Finish()
    {
        if (!IsText)
        {
            if (file[position..].ContainsAnyExcept(" \t\r\n\0"u8))
                throw context.BinaryError(position, $"{Remaining} more bytes", "the end of the file after the instances that the header announces");
            context.TrailingBytes = Remaining;
            return;
        }

        scanner.SkipLinesAndComments();
        if (!scanner.AtEnd)
            throw scanner.Error("the end of the file after the instances that the header announces");
    }

    /// <summary>The error that the number read last is not what it should be.</summary>
    public readonly MeshFormatException ErrorAtNumber(string found, string expected) => IsText
        ? context.TextError(file, numberPosition, expected)
        : context.BinaryError(numberPosition, found, expected);

    /// <summary>The error that the header's line for an element promises too little.</summary>
    public readonly MeshFormatException ErrorAtHeader(PlyElement element, string expected) =>
        context.TextError(file, element.HeaderPosition, $"element {element.Name} without it", expected);

    private ReadOnlySpan<byte> Take(int bytes)
    {
        if (bytes > file.Length - position)
            throw context.BinaryError(file.Length, "the end of the file", $"{bytes} more bytes of data");
        numberPosition = position;
        position += bytes;
        return file.Slice(numberPosition, bytes);
    }
}
