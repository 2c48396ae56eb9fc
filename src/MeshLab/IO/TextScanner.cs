using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;

namespace MeshLab.IO;

/// <summary>Walks through UTF-8 text token by token. A line ends with LF, CRLF or CR alone; blanks are spaces, tabs, and a backslash before a line end.</summary>
/// <remarks>Lines are not counted on the way: an error counts them once, from the position. So the scanner can start anywhere in a file.</remarks>
internal ref struct TextScanner
{
    private readonly ReadOnlySpan<byte> text;
    private readonly int end;
    private readonly ReadContext context;

    /// <summary>Scans a part of a file.</summary>
    /// <param name="text">The whole file, so that errors know their line.</param>
    /// <param name="from">The first byte to scan.</param>
    /// <param name="to">The byte after the last one to scan.</param>
    /// <param name="context">Names the file in errors.</param>
    public TextScanner(ReadOnlySpan<byte> text, int from, int to, ReadContext context)
    {
        this.text = text[..to];
        end = to;
        Position = from;
        this.context = context;
    }

    /// <summary>The byte to be looked at next.</summary>
    public int Position { get; set; }

    public readonly bool AtEnd => Position >= end;

    /// <summary>The byte at the position; 0 at the end.</summary>
    public readonly byte Current
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (uint)Position < (uint)text.Length ? text[Position] : (byte)0;
    }

    /// <summary>The byte after <see cref="Current"/>; 0 at the end.</summary>
    public readonly byte Following
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (uint)(Position + 1) < (uint)text.Length ? text[Position + 1] : (byte)0;
    }

    /// <summary>Skips blanks and says whether the line, or what of it is not comment, ends here.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool AtLineEnd()
    {
        SkipBlanks();
        return (uint)Position >= (uint)text.Length || text[Position] is (byte)'\n' or (byte)'\r' or (byte)'#';
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void SkipBlanks()
    {
        int p = Position;
        while ((uint)p < (uint)text.Length && text[p] is (byte)' ' or (byte)'\t')
            p++;
        Position = p;
        if ((uint)p < (uint)text.Length && text[p] == '\\')
            SkipContinuation();
    }

    private void SkipContinuation()
    {
        int p = Position + 1;
        if (p >= end || text[p] is not ((byte)'\n' or (byte)'\r'))
            return;
        Position = p + (text[p] == '\r' && p + 1 < end && text[p + 1] == '\n' ? 2 : 1);
        SkipBlanks();
    }

    /// <summary>Goes to the start of the next line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void NextLine()
    {
        // Nearly always the line ends here already.
        if ((uint)Position < (uint)text.Length && text[Position] == '\n')
            Position++;
        else
            SkipToNextLine();
    }

    private void SkipToNextLine()
    {
        int length = text[Position..].IndexOfAny((byte)'\n', (byte)'\r');
        Position = length < 0 ? end : Position + length + 1;
    }

    /// <summary>Skips blanks, line ends and comments.</summary>
    public void SkipLinesAndComments()
    {
        while (AtLineEnd() && !AtEnd)
            NextLine();
    }

    /// <summary>The bytes up to the next white space; the position stays before them.</summary>
    public readonly ReadOnlySpan<byte> PeekToken()
    {
        int p = Position;
        while (p < end && text[p] > ' ')
            p++;
        return text[Position..p];
    }

    /// <summary>The rest of the line as text, without blanks at its ends; the position goes to the line's end.</summary>
    public ReadOnlySpan<byte> ReadRestOfLine()
    {
        SkipBlanks();
        int length = text[Position..].IndexOfAny((byte)'\n', (byte)'\r');
        if (length < 0)
            length = end - Position;
        ReadOnlySpan<byte> rest = text.Slice(Position, length);
        Position += length;
        return rest.TrimEnd(" \t"u8);
    }

    /// <summary>Reads a coordinate: a finite number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double ReadFinite(string expected)
    {
        SkipBlanks();
        if (!DecimalParser.TryParse(text[Position..], out double value, out int length) || !double.IsFinite(value))
            throw Error(expected);
        Position += length;
        return value;
    }

    /// <summary>Reads a number that may also be one of the words for NaN and infinity, as attributes sometimes are.</summary>
    public double ReadAttribute(string expected)
    {
        SkipBlanks();
        if (DecimalParser.TryParse(text[Position..], out double value, out int length))
        {
            Position += length;
            return value;
        }

        ReadOnlySpan<byte> token = PeekToken();
        ReadOnlySpan<byte> word = token.TrimStart("+-"u8);
        if (!(StartsWithWord(word, "nan"u8) || StartsWithWord(word, "inf"u8)))
            throw Error(expected);
        Position += token.Length;
        return double.NaN;
    }

    /// <summary>Reads an integer that fits <see cref="int"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int ReadInteger(string expected)
    {
        SkipBlanks();
        int start = Position;
        if (!TryReadDigits(out int value) || Current > ' ')
        {
            Position = start;
            throw Error(expected);
        }

        return value;
    }

    /// <summary>Reads an integer, whatever follows it; the position stays if there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryReadDigits(out int value)
    {
        int p = Position;
        bool negative = false;
        if ((uint)p < (uint)text.Length && text[p] is (byte)'-' or (byte)'+')
            negative = text[p++] == '-';
        int start = p;
        long magnitude = 0;
        while ((uint)p < (uint)text.Length && (uint)(text[p] - '0') <= 9)
        {
            magnitude = magnitude * 10 + (text[p++] - '0');
            if (magnitude > int.MaxValue)
                break;
        }

        value = negative ? -(int)magnitude : (int)magnitude;
        if (p == start || magnitude > int.MaxValue)
            return false;
        Position = p;
        return true;
    }

    /// <summary>The error that something else was expected at the position.</summary>
    public readonly MeshFormatException Error(string expected) => ErrorAt(Position, expected);

    /// <summary>The error that something else was expected at an earlier position.</summary>
    public readonly MeshFormatException ErrorAt(int position, string expected) => context.TextError(text, position, expected);

    private static bool StartsWithWord(ReadOnlySpan<byte> token, ReadOnlySpan<byte> word) =>
        token.Length >= word.Length && Ascii.EqualsIgnoreCase(token[..word.Length], word);
}
