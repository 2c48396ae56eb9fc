using System.Text;
using MeshLab.IO;
using MeshLab.Numerics;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

[Trait("Section", "14.3")]
public class PlyReaderTests
{
    private const string Header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    private const string Faces = "element face 1\nproperty list uchar int vertex_indices\n";
    private const string Data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

    [Fact]
    public void ReadData_UnknownPropertiesAndElements_AreSkippedAndCounted()
    {
        MeshData data = ReadData(
            "ply\nformat ascii 1.0\ncomment x\nobj_info y\nelement vertex 3\nproperty list uchar int extra\nproperty float x\nproperty int q\nproperty float y\nproperty float z\n" +
            "element edge 1\nproperty int vertex1\nproperty int vertex2\n" + Faces + "property int after\nend_header\n" +
            "2 7 7 0 9 0 0\n0 1 9 0 0\n1 7 0 9 1 0\n0 1\n3 0 1 2 5\n",
            MeshFormat.Ply,
            out MeshReadReport report);
        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], data.Positions);
        Assert.Equal([0, 1, 2], data.Corners);
        Assert.Equal(["element edge", "property face.after", "property vertex.extra", "property vertex.q"], report.Ignored.Keys.Order(StringComparer.Ordinal), StringComparer.Ordinal);
    }

    [Fact]
    public void ReadData_Attributes_AreRead()
    {
        MeshData data = ReadData(
            Header + "property float nx\nproperty float ny\nproperty float nz\nproperty float u\nproperty float v\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n" +
            Faces + "property list uchar float texcoord\nproperty float red\nproperty float green\nproperty float blue\nproperty float alpha\nend_header\n" +
            "0 0 0 0 0 1 0 0 255 0 51\n1 0 0 0 0 1 1 0 0 0 0\n0 1 0 0 0 1 0 1 0 0 0\n3 0 1 2 6 0 0 .5 0 0 .5 1 .5 .25 .125\n",
            MeshFormat.Ply);
        Assert.Equal(new Vector3D(0, 0, 1), data.VertexNormals![1]);
        Assert.Equal(new Vector2D(0, 1), data.VertexTextureCoordinates![2]);
        Assert.Equal(Color.FromBytes(255, 0, 51), data.VertexColors![0]);
        Assert.Equal([new(0, 0), new(.5, 0), new(0, .5)], data.CornerTextureCoordinates!);
        Assert.Equal([new Color(1, .5f, .25f, .125f)], data.FaceColors!);
    }

    [Theory]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void ReadData_BinaryAfterAnyLineEnd_BeginsAtTheRightByte(string lineEnd)
    {
        string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
        byte[] bytes = [.. Encoding.ASCII.GetBytes(header.Replace("\n", lineEnd)), 10, 13, 32];
        MeshData data = ReadData(bytes, MeshFormat.Ply, out MeshReadReport report);
        Assert.Equal([new(10, 13, 32)], data.Positions);
        Assert.Equal(0, report.TrailingBytes);
    }

    [Theory]
    [InlineData(new byte[] { 10 }, true)]
    [InlineData(new byte[] { 0, 0, 32, 13, 10 }, true)]
    [InlineData(new byte[] { 1, 2, 3 }, false)]
    [InlineData(new byte[] { 0, 7 }, false)]
    public void ReadData_BytesBehindBinaryData_ArePaddingOrAnError(byte[] more, bool isPadding)
    {
        string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
        byte[] bytes = [.. Encoding.ASCII.GetBytes(header), 1, 2, 3, .. more];
        if (isPadding)
        {
            ReadData(bytes, MeshFormat.Ply, out MeshReadReport report);
            Assert.Equal(more.Length, report.TrailingBytes);
            return;
        }
        MeshFormatException error = Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Ply, out _));
        Assert.Equal((0, header.Length + 3), (error.Line, error.Column));
    }

    [Theory]
    [InlineData("plx\n", 1, 1)]
    [InlineData("ply\nformat asci 1.0\n", 2, 8)]
    [InlineData("ply\nformat ascii 1.0\nproperty float x\n", 3, 1)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex -3\n", 3, 16)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 3\nproperty flaot x\n", 4, 10)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int x\n", 4, 15)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0\n0\n0\n", 3, 1)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 3\n", 4, 1)]
    [InlineData("ply\nformat ascii 1.0\nelement vertex 3\nelement vertex 3\n", 4, 9)]
    [InlineData(Header + Faces + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 13, 7)]
    [InlineData(Header + Faces + "end_header\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 11, 4)]
    [InlineData(Header + Faces + "end_header\n0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n", 11, 7)]
    [InlineData(Header + Faces + "end_header\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", 11, 3)]
    [InlineData(Header + Faces + "end_header\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", 13, 1)]
    [InlineData(Header + Faces + "end_header\n" + Data + "3 0 1 2\n", 14, 1)]
    public void ReadData_BadFile_SaysWhere(string text, long line, long column) => AssertFormatError(text, MeshFormat.Ply, line, column);

    [Theory]
    [InlineData("ascii")]
    [InlineData("binary_little_endian")]
    public void ReadData_LyingCounts_AllocatesByTheBytesOnly(string format)
    {
        foreach (string header in (string[])
        [
            Header.Replace("vertex 3", "vertex 2000000000") + Faces,
            Header + Faces.Replace("face 1", "face 2000000000"),
            Header + Faces.Replace("uchar int", "int int"),
            "ply\nformat ascii 1.0\nelement nothing 2000000000\nelement some 2000000000\nproperty uchar a\nproperty list uint double b\n" + Faces,
        ])
        {
            byte[] bytes = [.. Encoding.ASCII.GetBytes(header.Replace("ascii", format) + "end_header\n"), .. Enumerable.Repeat((byte)0x30, 37)];
            Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Ply, out _));
            long before = GC.GetAllocatedBytesForCurrentThread();
            Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Ply, out _));
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1_000_000);
        }
    }

    /// <summary>A strip ends at −1, which an unsigned index cannot say but by its largest value; every second triangle is turned back.</summary>
    [Theory]
    [InlineData("int", "-1")]
    [InlineData("uint", "4294967295")]
    public void ReadData_TriangleStrips_AreUnrolled(string type, string end)
    {
        MeshData data = ReadData(
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n" +
            $"property list int {type} vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 {end} 2 3 4 {end}\n",
            MeshFormat.Ply);
        Assert.Equal([0, 1, 2, 2, 1, 3, 2, 3, 4], data.Corners);
        Assert.Equal([0, 3, 6, 9], data.FaceStart);
    }
}
