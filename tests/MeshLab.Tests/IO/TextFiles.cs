using System.Globalization;
using System.Text;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.IO;

/// <summary>Files as strings.</summary>
internal static class TextFiles
{
    /// <summary>A closed cube of triangles in OBJ.</summary>
    public const string CubeObj =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" +
        "f 4 3 2\nf 4 2 1\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";

    /// <summary>The same in OFF.</summary>
    public const string CubeOff =
        "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n" +
        "3 3 2 1\n3 3 1 0\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n";

    public static MeshData ReadData(string text, MeshFormat format, MeshReadOptions? options = null) => ReadData(text, format, out _, options);

    public static MeshData ReadData(string text, MeshFormat format, out MeshReadReport report, MeshReadOptions? options = null) =>
        ReadData(Encoding.UTF8.GetBytes(text), format, out report, options);

    public static MeshData ReadData(byte[] bytes, MeshFormat format, out MeshReadReport report, MeshReadOptions? options = null) =>
        MeshFile.ReadData(new MemoryStream(bytes), format, out report, options, "file");

    public static Mesh Read(string text, MeshFormat format, MeshReadOptions? options = null) =>
        MeshFile.Read(new MemoryStream(Encoding.UTF8.GetBytes(text)), format, out _, options, "file");

    /// <summary>Asserts that reading fails at the place, and returns the error.</summary>
    public static MeshFormatException AssertFormatError(string text, MeshFormat format, long line, long column)
    {
        MeshFormatException error = Assert.Throws<MeshFormatException>(() => ReadData(text, format));
        Assert.True((line, column) == (error.Line, error.Column), error.Message);
        Assert.StartsWith(string.Create(CultureInfo.InvariantCulture, $"file:{line}:{column}: found "), error.Message, StringComparison.Ordinal);
        return error;
    }

    public static byte[] Write(MeshData data, MeshFormat format, MeshEncoding encoding = MeshEncoding.Default)
    {
        using MemoryStream stream = new();
        MeshFile.WriteData(data, stream, format, new MeshWriteOptions { Encoding = encoding });
        return stream.ToArray();
    }

    public static string WriteText(MeshData data, MeshFormat format) => Encoding.UTF8.GetString(Write(data, format, MeshEncoding.Text));

    /// <summary>Equal bit for bit, 0 and −0 told apart.</summary>
    public static void AssertSame(MeshData expected, MeshData actual)
    {
        AssertSameBits(expected.Positions, actual.Positions, "positions");
        Assert.Equal(expected.FaceStart, actual.FaceStart);
        Assert.Equal(expected.Corners, actual.Corners);
        AssertSameBits(expected.VertexNormals, actual.VertexNormals, "vertex normals");
        AssertSameBits(expected.VertexTextureCoordinates, actual.VertexTextureCoordinates, "vertex texture coordinates");
        AssertSameBits(expected.VertexColors, actual.VertexColors, "vertex colours");
        AssertSameBits(expected.CornerNormals, actual.CornerNormals, "corner normals");
        AssertSameBits(expected.CornerTextureCoordinates, actual.CornerTextureCoordinates, "corner texture coordinates");
        AssertSameBits(expected.FaceColors, actual.FaceColors, "face colours");
        Assert.Equal(expected.FaceLabels.Select(l => l.Kind), actual.FaceLabels.Select(l => l.Kind), StringComparer.Ordinal);
        foreach ((FaceLabelSet e, FaceLabelSet a) in expected.FaceLabels.Zip(actual.FaceLabels))
        {
            Assert.Equal(e.Names, a.Names);
            Assert.Equal(e.Labels, a.Labels);
        }
    }

    private static void AssertSameBits<T>(T[]? expected, T[]? actual, string what)
        where T : unmanaged
    {
        Assert.True(expected is null == actual is null, $"{what}: {(expected is null ? "unexpected" : "missing")}");
        if (expected is null)
            return;
        Assert.Equal(expected.Length, actual!.Length);
        bool same = System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(expected).SequenceEqual(System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(actual));
        if (!same)
            Assert.Equal(expected, actual);
        Assert.True(same, $"{what} differ in a bit");
    }
}
