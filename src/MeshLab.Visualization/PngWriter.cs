using System.Buffers.Binary;
using System.IO.Compression;

namespace MeshLab.Visualization;

/// <summary>
/// Writes PNG files (ISO/IEC 15948): 8-bit RGB, or RGBA if a pixel is not opaque; per row the filter with the smallest sum of absolute differences.
/// The same picture gives the same bytes.
/// </summary>
public static class PngWriter
{
    private static readonly uint[] CrcTable = BuildCrcTable();

    private static ReadOnlySpan<byte> Signature => [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>The bytes of the file.</summary>
    public static byte[] Encode(Image image)
    {
        using var stream = new MemoryStream();
        Write(image, stream);
        return stream.ToArray();
    }

    /// <summary>Writes the file to a stream, which stays open.</summary>
    public static void Write(Image image, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(image);
        ArgumentNullException.ThrowIfNull(stream);
        bool opaque = IsOpaque(image);
        int channels = opaque ? 3 : 4;

        stream.Write(Signature);
        Span<byte> header = stackalloc byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, image.Width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], image.Height);
        header[8] = 8;
        header[9] = opaque ? (byte)2 : (byte)6;
        header[10..].Clear();
        WriteChunk(stream, "IHDR"u8, header);
        WriteChunk(stream, "sRGB"u8, [0]);
        WriteChunk(stream, "IDAT"u8, CompressRows(image, channels));
        WriteChunk(stream, "IEND"u8, []);
    }

    private static bool IsOpaque(Image image)
    {
        ReadOnlySpan<byte> bytes = image.Bytes;
        for (int i = 3; i < bytes.Length; i += 4)
        {
            if (bytes[i] != 255)
                return false;
        }
        return true;
    }

    private static byte[] CompressRows(Image image, int channels)
    {
        int length = image.Width * channels;
        byte[] above = new byte[length], row = new byte[length];
        byte[][] filtered = [new byte[length + 1], new byte[length + 1], new byte[length + 1], new byte[length + 1], new byte[length + 1]];
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.Optimal, leaveOpen: true))
        {
            for (int y = 0; y < image.Height; y++)
            {
                ReadOnlySpan<byte> pixels = image.Bytes.Slice(4 * y * image.Width, 4 * image.Width);
                for (int x = 0, to = 0; x < pixels.Length; x += 4)
                {
                    for (int c = 0; c < channels; c++)
                        row[to++] = pixels[x + c];
                }
                zlib.Write(BestFilter(row, above, channels, filtered));
                (row, above) = (above, row);
            }
        }
        return packed.ToArray();
    }

    private static byte[] BestFilter(byte[] row, byte[] above, int channels, byte[][] filtered)
    {
        int best = 0;
        long bestSum = long.MaxValue;
        for (int filter = 0; filter < 5; filter++)
        {
            byte[] result = filtered[filter];
            result[0] = (byte)filter;
            long sum = 0;
            for (int i = 0; i < row.Length; i++)
            {
                int a = i >= channels ? row[i - channels] : 0, b = above[i], c = i >= channels ? above[i - channels] : 0;
                int predicted = filter switch
                {
                    0 => 0,
                    1 => a,
                    2 => b,
                    3 => (a + b) >> 1,
                    _ => Paeth(a, b, c),
                };
                byte value = (byte)(row[i] - predicted);
                result[i + 1] = value;
                sum += Math.Abs((sbyte)value & 0xFF) is var d && d > 128 ? 256 - d : d;
            }
            if (sum < bestSum)
            {
                bestSum = sum;
                best = filter;
            }
        }
        return filtered[best];
    }

    private static int Paeth(int a, int b, int c)
    {
        int p = a + b - c, pa = Math.Abs(p - a), pb = Math.Abs(p - b), pc = Math.Abs(p - c);
        if (pa <= pb && pa <= pc)
            return a;
        return pb <= pc ? b : c;
    }

    private static void WriteChunk(Stream stream, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data)
    {
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
        stream.Write(number);
        stream.Write(type);
        stream.Write(data);
        BinaryPrimitives.WriteUInt32BigEndian(number, ~Crc(Crc(uint.MaxValue, type), data));
        stream.Write(number);
    }

    private static uint Crc(uint crc, ReadOnlySpan<byte> data)
    {
        foreach (byte b in data)
            crc = CrcTable[(crc ^ b) & 0xFF] ^ (crc >> 8);
        return crc;
    }

    private static uint[] BuildCrcTable()
    {
        var table = new uint[256];
        for (uint n = 0; n < 256; n++)
        {
            uint c = n;
            for (int k = 0; k < 8; k++)
                c = (c & 1) != 0 ? 0xEDB88320 ^ (c >> 1) : c >> 1;
            table[n] = c;
        }
        return table;
    }
}
