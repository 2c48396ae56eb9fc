using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;

namespace MeshLab.IO;

/// <summary>A growing buffer of the bytes to be written: text in UTF-8 and the invariant culture, or binary.</summary>
internal sealed class ByteBuffer
{
    private const int LongestNumber = 40;
    private byte[] bytes = GC.AllocateUninitializedArray<byte>(1 << 16);

    public int Length { get; private set; }

    public ReadOnlyMemory<byte> Written => bytes.AsMemory(0, Length);

    public bool IsAtLineStart => Length == 0 || bytes[Length - 1] == '\n';

    public void Clear() => Length = 0;

    public void Append(byte value)
    {
        Reserve(1)[0] = value;
        Length++;
    }

    public void Append(ReadOnlySpan<byte> text)
    {
        text.CopyTo(Reserve(text.Length));
        Length += text.Length;
    }

    public void Append(string text) => Length += Encoding.UTF8.GetBytes(text, Reserve(Encoding.UTF8.GetMaxByteCount(text.Length)));

    /// <summary>A name from outside: line ends would end the statement that it stands in.</summary>
    public void AppendName(string name) => Append(name.AsSpan().IndexOfAny('\r', '\n') < 0 ? name : name.ReplaceLineEndings(" "));

    /// <summary>A blank and the shortest text that gives the same double when read.</summary>
    public void AppendBlankAnd(double number)
    {
        Span<byte> free = Reserve(LongestNumber);
        free[0] = (byte)' ';
        Length += 1 + ShortestDecimal.Format(number, free[1..]);
    }

    /// <summary>The shortest text that gives the same double when read.</summary>
    public void AppendNumber(double number)
    {
        Length += ShortestDecimal.Format(number, Reserve(LongestNumber));
    }

    /// <summary>A blank and the shortest text that gives the same float when read.</summary>
    public void AppendBlankAnd(float number)
    {
        Span<byte> free = Reserve(LongestNumber);
        free[0] = (byte)' ';
        number.TryFormat(free[1..], out int length, default, CultureInfo.InvariantCulture);
        Length += length + 1;
    }

    /// <summary>A blank and an integer.</summary>
    public void AppendBlankAnd(int number)
    {
        Span<byte> free = Reserve(LongestNumber);
        free[0] = (byte)' ';
        Length += 1 + ShortestDecimal.Format(number, free[1..]);
    }

    public void AppendInteger(int number) => Length += ShortestDecimal.Format(number, Reserve(LongestNumber));

    public void AppendBinary(double number, bool isBig)
    {
        Span<byte> free = Reserve(8);
        if (isBig)
            BinaryPrimitives.WriteDoubleBigEndian(free, number);
        else
            BinaryPrimitives.WriteDoubleLittleEndian(free, number);
        Length += 8;
    }

    public void AppendBinary(float number, bool isBig)
    {
        Span<byte> free = Reserve(4);
        if (isBig)
            BinaryPrimitives.WriteSingleBigEndian(free, number);
        else
            BinaryPrimitives.WriteSingleLittleEndian(free, number);
        Length += 4;
    }

    public void AppendBinary(int number, bool isBig)
    {
        Span<byte> free = Reserve(4);
        if (isBig)
            BinaryPrimitives.WriteInt32BigEndian(free, number);
        else
            BinaryPrimitives.WriteInt32LittleEndian(free, number);
        Length += 4;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Span<byte> Reserve(int count)
    {
        if (bytes.Length - Length < count)
            Grow(count);
        return bytes.AsSpan(Length);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Grow(int count) => Array.Resize(ref bytes, checked(Math.Max(2 * bytes.Length, Length + count)));
}
