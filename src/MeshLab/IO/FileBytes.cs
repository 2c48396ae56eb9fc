using System.Buffers.Binary;
using System.IO.Compression;

namespace MeshLab.IO;

/// <summary>Brings the bytes of a file or a stream into memory, unpacked if they are packed by gzip.</summary>
internal static class FileBytes
{
    private const int BlockBytes = 1 << 21;

    // A header of 10 bytes and a trailer of 8: checksum and length.
    private const int LeastPackedBytes = 18;

    public static ReadOnlyMemory<byte> Read(string path, ReadContext context)
    {
        if (Directory.Exists(path))
            throw new IOException($"'{path}' is a directory, not a file.");
        ReadOnlyMemory<byte> bytes = ReadWhole(path);
        return path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? Unpack(bytes, context) : bytes;
    }

    public static ReadOnlyMemory<byte> Read(Stream stream, ReadContext context)
    {
        ReadOnlyMemory<byte> bytes = ReadToEnd(stream, 1 << 16, context);
        return IsGzip(bytes.Span) ? Unpack(bytes, context) : bytes;
    }

    private static bool IsGzip(ReadOnlySpan<byte> bytes) => bytes.StartsWith((ReadOnlySpan<byte>)[0x1F, 0x8B]);

    private static ReadOnlyMemory<byte> ReadWhole(string path)
    {
        using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0);
        if (!stream.CanSeek || stream.Length < 2 * BlockBytes)
            return File.ReadAllBytes(path);
        if (stream.Length > Array.MaxLength)
            throw new IOException($"'{path}' has more than {Array.MaxLength} bytes, the most that can be read.");

        byte[] bytes = GC.AllocateUninitializedArray<byte>((int)stream.Length);
        int missing = 0;
        OrderedTasks.Run((bytes.Length - 1) / BlockBytes + 1, block =>
        {
            int from = block * BlockBytes, to = (int)Math.Min(bytes.Length, (long)from + BlockBytes);
            while (from < to)
            {
                int read = RandomAccess.Read(stream.SafeFileHandle, bytes.AsSpan(from..to), from);
                if (read == 0)
                {
                    Interlocked.Add(ref missing, to - from);
                    return;
                }

                from += read;
            }
        });
        return missing == 0 ? bytes : throw new IOException($"'{path}' became shorter while it was read.");
    }

    private static ReadOnlyMemory<byte> ReadToEnd(Stream stream, long guess, ReadContext context)
    {
        byte[] bytes = GC.AllocateUninitializedArray<byte>((int)Math.Clamp(guess, 1 << 12, 1 << 30));
        int length = 0;
        while (true)
        {
            context.ThrowIfCancelled();
            if (length == bytes.Length)
            {
                if (length == Array.MaxLength)
                    throw new IOException($"'{context.File}' has more than {Array.MaxLength} bytes, the most that can be read.");
                Array.Resize(ref bytes, (int)Math.Min(2L * length, Array.MaxLength));
            }

            int read = stream.Read(bytes.AsSpan(length, Math.Min(bytes.Length - length, 1 << 20)));
            if (read == 0)
                return bytes.AsMemory(0, length);
            length += read;
        }
    }

    private static ReadOnlyMemory<byte> Unpack(ReadOnlyMemory<byte> packed, ReadContext context)
    {
        if (!IsGzip(packed.Span))
            throw context.BinaryError(0, packed.IsEmpty ? "an empty file" : "other bytes", "data packed by gzip");
        if (packed.Length < LeastPackedBytes)
            throw context.BinaryError(packed.Length, "the end of the file", "data packed by gzip");
        try
        {
            using MemoryStream source = new(packed.ToArray(), writable: false);
            using GZipStream stream = new(source, CompressionMode.Decompress);
            ReadOnlyMemory<byte> bytes = ReadToEnd(stream, 4L * packed.Length, context);
            if (!EndsWhole(packed.Span, bytes.Length))
                throw context.BinaryError(packed.Length, "the end of the file", "the end of the data packed by gzip");
            return bytes;
        }
        catch (InvalidDataException error)
        {
            throw context.BinaryError(packed.Length, "damaged data", $"data packed by gzip ({error.Message})");
        }
    }

    /// <summary>Packed data end with their unpacked length, which the runtime does not miss if it is cut off. Bytes may follow, or several packed parts stand one after the other.</summary>
    private static bool EndsWhole(ReadOnlySpan<byte> packed, int length)
    {
        Span<byte> trailer = stackalloc byte[4];
        BinaryPrimitives.WriteInt32LittleEndian(trailer, length);
        return packed.EndsWith(trailer) || packed[10..].IndexOf(trailer) >= 0 || packed[LeastPackedBytes..].IndexOf((ReadOnlySpan<byte>)[0x1F, 0x8B, 8]) >= 0;
    }
}
