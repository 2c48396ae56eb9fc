using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;
using Xunit;

namespace MeshLab.Tests.Visualization;

/// <summary>A second opinion on PNG files: reads 8-bit RGB and RGBA and checks every chunk's CRC bit by bit.</summary>
internal sealed record Png(int Width, int Height, int Channels, byte[] Pixels)
{
    public static Png Read(byte[] file)
    {
        Assert.Equal([0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A], file[..8]);
        int at = 8, width = 0, height = 0, channels = 0;
        using var packed = new MemoryStream();
        var types = new List<string>();
        while (at < file.Length)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            string type = Encoding.ASCII.GetString(file, at + 4, 4);
            types.Add(type);
            ReadOnlySpan<byte> data = file.AsSpan(at + 8, length);
            Assert.Equal(Crc(file.AsSpan(at + 4, length + 4)), BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at + 8 + length)));
            if (type == "IHDR")
            {
                width = BinaryPrimitives.ReadInt32BigEndian(data);
                height = BinaryPrimitives.ReadInt32BigEndian(data[4..]);
                Assert.Equal(8, data[8]);
                channels = data[9] == 6 ? 4 : 3;
            }
            if (type == "IDAT")
                packed.Write(data);
            at += length + 12;
        }
        Assert.Equal("IHDR", types[0]);
        Assert.Equal("IEND", types[^1]);
        packed.Position = 0;
        return new(width, height, channels, Unfilter(packed, width, height, channels));
    }

    private static byte[] Unfilter(MemoryStream packed, int width, int height, int channels)
    {
        using var zlib = new ZLibStream(packed, CompressionMode.Decompress);
        int stride = width * channels;
        var pixels = new byte[stride * height];
        var row = new byte[stride + 1];
        for (int y = 0; y < height; y++)
        {
            zlib.ReadExactly(row);
            for (int i = 0; i < stride; i++)
            {
                int a = i >= channels ? pixels[y * stride + i - channels] : 0, b = y > 0 ? pixels[(y - 1) * stride + i] : 0;
                int c = i >= channels && y > 0 ? pixels[(y - 1) * stride + i - channels] : 0;
                int p = a + b - c, pa = Math.Abs(p - a), pb = Math.Abs(p - b), pc = Math.Abs(p - c);
                int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
                int predicted = row[0] switch { 0 => 0, 1 => a, 2 => b, 3 => (a + b) / 2, 4 => paeth, _ => throw new InvalidDataException() };
                pixels[y * stride + i] = (byte)(row[i + 1] + predicted);
            }
        }
        Assert.Equal(-1, zlib.ReadByte());
        return pixels;
    }

    private static uint Crc(ReadOnlySpan<byte> data)
    {
        uint crc = uint.MaxValue;
        foreach (byte b in data)
        {
            crc ^= b;
            for (int k = 0; k < 8; k++)
                crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
        }
        return ~crc;
    }
}
