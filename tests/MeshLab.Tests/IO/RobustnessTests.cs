using System.IO.Compression;
using System.Text;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

/// <summary>Whatever the bytes: a mesh, or one of the two errors; never another exception, a hang, or memory without end.</summary>
[Trait("Section", "14")]
public class RobustnessTests
{
    private const long MostBytes = 8_000_000;

    public static TheoryData<MeshFormat, MeshEncoding> Forms => new()
    {
        { MeshFormat.Obj, MeshEncoding.Text }, { MeshFormat.Off, MeshEncoding.Text }, { MeshFormat.Stl, MeshEncoding.Text },
        { MeshFormat.Stl, MeshEncoding.BinaryLittleEndian }, { MeshFormat.Ply, MeshEncoding.Text },
        { MeshFormat.Ply, MeshEncoding.BinaryLittleEndian }, { MeshFormat.Ply, MeshEncoding.BinaryBigEndian },
    };

    [Theory]
    [MemberData(nameof(Forms))]
    public void Read_CutOffAtEveryByte_LoadsOrIsRefused(MeshFormat format, MeshEncoding encoding)
    {
        byte[] whole = Sample(format, encoding);
        int refused = 0;
        for (int length = 0; length < whole.Length; length++)
            refused += TryRead(whole.AsSpan(0, length).ToArray(), format) ? 0 : 1;
        Assert.True(TryRead(whole, format));
        // Only OBJ has no counts and no end, so that it can be cut between two lines unseen.
        Assert.True(format == MeshFormat.Obj || refused > whole.Length - 8, $"{refused} of {whole.Length} refused");
    }

    [Theory]
    [MemberData(nameof(Forms))]
    public void Read_RandomlyDamaged_LoadsOrIsRefused(MeshFormat format, MeshEncoding encoding)
    {
        byte[] whole = Sample(format, encoding);
        Random random = new(14);
        for (int i = 0; i < 2500; i++)
        {
            byte[] damaged = [.. whole];
            for (int k = random.Next(1, 5); k > 0; k--)
                Damage(ref damaged, random);
            TryRead(damaged, format);
        }
    }

    [Theory]
    [InlineData(MeshFormat.Obj)]
    [InlineData(MeshFormat.Off)]
    [InlineData(MeshFormat.Stl)]
    [InlineData(MeshFormat.Ply)]
    public void Read_RandomBytes_IsRefused(MeshFormat format)
    {
        Random random = new(15);
        for (int i = 0; i < 300; i++)
        {
            byte[] bytes = new byte[random.Next(1, 400)];
            random.NextBytes(bytes);
            bytes[0] |= 0x80;
            Assert.False(TryRead(bytes, format));
        }
    }

    [Theory]
    [InlineData(MeshFormat.Obj)]
    [InlineData(MeshFormat.Off)]
    [InlineData(MeshFormat.Stl)]
    [InlineData(MeshFormat.Ply)]
    public void Read_EmptyFile_SaysSo(MeshFormat format) =>
        Assert.Contains("an empty file", AssertFormatError("", format, 1, 1).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_DamagedGzip_IsRefusedAtEveryByte()
    {
        byte[] packed = Pack(Encoding.UTF8.GetBytes(CubeObj));
        Assert.Equal(12, ReadData(packed, MeshFormat.Obj, out _).FaceCount);
        for (int length = 2; length < packed.Length; length++)
        {
            byte[] cut = packed[..length];
            Assert.Throws<MeshFormatException>(() => ReadData(cut, MeshFormat.Obj, out _));
        }

        Random random = new(16);
        for (int i = 0; i < 500; i++)
        {
            byte[] damaged = [.. packed];
            damaged[random.Next(2, packed.Length)] ^= (byte)(1 << random.Next(8));
            TryRead(damaged, MeshFormat.Obj);
        }
    }

    private static byte[] Pack(byte[] bytes)
    {
        using MemoryStream packed = new();
        using (GZipStream gzip = new(packed, CompressionLevel.Optimal))
            gzip.Write(bytes);
        return packed.ToArray();
    }

    private static byte[] Sample(MeshFormat format, MeshEncoding encoding)
    {
        MeshData data = ReadData(
            "o a\nv 0 0 0 1 0 0\nv 1.5 0 0 0 1 0\nv 1 1e-3 0 0 0 1\nv 0 1 .125 1 1 1\nv -2 0 0 0 0 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 3/1/1 4/1/1\ng b\nf 1/2/1 4/2/1 5/2/1\n",
            MeshFormat.Obj);
        return Write(data, format, encoding);
    }

    private static void Damage(ref byte[] bytes, Random random)
    {
        int at = random.Next(bytes.Length);
        switch (random.Next(5))
        {
            case 0:
                bytes[at] = (byte)random.Next(256);
                break;
            case 1:
                bytes[at] = (byte)"0123456789-. \n/eE#\\"[random.Next(19)];
                break;
            case 2:
                bytes[at] ^= (byte)(1 << random.Next(8));
                break;
            case 3:
                int length = random.Next(1, Math.Min(12, bytes.Length - at) + 1);
                bytes = [.. bytes[..at], .. bytes[(at + length)..], .. bytes.Length - length < 1 ? [(byte)' '] : Array.Empty<byte>()];
                break;
            default:
                bytes = [.. bytes[..at], .. bytes[(bytes.Length / 2)..], .. bytes[at..]];
                break;
        }
    }

    /// <summary>Whether the bytes make a mesh; anything but the two errors fails the test.</summary>
    private static bool TryRead(byte[] bytes, MeshFormat format)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        try
        {
            Mesh mesh = MeshFile.Read(new MemoryStream(bytes), format);
            Assert.Empty(mesh.Validate());
            return true;
        }
        catch (MeshFormatException error)
        {
            Assert.True(error.Line >= 1 ? error.Column >= 1 : error.Column >= 0, error.Message);
            return false;
        }
        catch (TopologyException error)
        {
            Assert.NotEmpty(error.Elements);
            return true;
        }
        finally
        {
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, MostBytes);
        }
    }
}
