using MeshLab.IO;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

/// <summary>What a format has no place for is said: nothing is dropped silently.</summary>
[Trait("Section", "14")]
public class FormatLossesTests
{
    // A quad and a triangle with everything: colours, two texture coordinates at one vertex, normals, all four sorts of labels, and a vertex of no face.
    private const string Full =
        "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0.1 1 1 1\nv 2 0 0 0 0 0\nv 9 9 9 0 0 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n" +
        "o part\ng side\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/1/1 4/1/1\nusemtl green\nf 2/1/1 5/2/1 3/1/1\n";

    [Theory]
    [InlineData(MeshFormat.Obj, MeshEncoding.Text, "")]
    [InlineData(MeshFormat.Ply, MeshEncoding.Text, "")]
    [InlineData(MeshFormat.Ply, MeshEncoding.BinaryBigEndian, "")]
    [InlineData(MeshFormat.Off, MeshEncoding.Text, "corner texture coordinates 7, labels of group 2, labels of material 2, labels of object 2, labels of smoothing 2")]
    [InlineData(MeshFormat.Stl, MeshEncoding.Text, "corner texture coordinates 7, labels of group 2, labels of material 2, labels of smoothing 2, unused vertices 1, vertex colours 6, vertex normals 6")]
    [InlineData(
        MeshFormat.Stl,
        MeshEncoding.BinaryLittleEndian,
        "corner texture coordinates 7, labels of group 2, labels of material 2, labels of object 2, labels of smoothing 2, unused vertices 1, vertex colours 6, vertex normals 6")]
    [InlineData(MeshFormat.Glb, MeshEncoding.BinaryLittleEndian, "corner texture coordinates 7, labels of group 2, labels of material 2, labels of object 2, labels of smoothing 2")]
    public void WriteData_FullModel_SaysWhatTheFormatHasNoPlaceFor(MeshFormat format, MeshEncoding encoding, string expected)
    {
        MeshData data = ReadData(Full, MeshFormat.Obj);
        using var stream = new MemoryStream();

        MeshWriteReport report = MeshFile.WriteData(data, stream, format, new MeshWriteOptions { Encoding = encoding });

        Assert.Equal((format, encoding), (report.Format, report.Encoding));
        Assert.Equal(expected, string.Join(", ", report.LeftOut.Select(left => $"{left.Key} {left.Value}")));
        Assert.Equal(format is MeshFormat.Stl or MeshFormat.Glb ? 1 : 0, report.TriangulatedFaces);
        Assert.Equal(format == MeshFormat.Glb || (format == MeshFormat.Stl && encoding != MeshEncoding.Text) ? 1 : 0, report.RoundedVertices);
    }

    [Theory]
    [InlineData(MeshFormat.Obj, MeshEncoding.Text)]
    [InlineData(MeshFormat.Off, MeshEncoding.Text)]
    [InlineData(MeshFormat.Stl, MeshEncoding.Text)]
    [InlineData(MeshFormat.Ply, MeshEncoding.Text)]
    [InlineData(MeshFormat.Ply, MeshEncoding.BinaryLittleEndian)]
    public void WriteData_NothingReported_ReadsBackTheSame(MeshFormat format, MeshEncoding encoding)
    {
        foreach (string text in (string[])
        [
            Full,
            CubeObj,
            Full.Replace("usemtl red\n", "", StringComparison.Ordinal).Replace("usemtl green\n", "", StringComparison.Ordinal),
            Full.Replace("vn 0 0 1\n", "", StringComparison.Ordinal).Replace("/1 ", " ", StringComparison.Ordinal).Replace("/1\n", "\n", StringComparison.Ordinal),
        ])
        {
            MeshData data = ReadData(text, MeshFormat.Obj);
            using var stream = new MemoryStream();
            MeshWriteReport report = MeshFile.WriteData(data, stream, format, new MeshWriteOptions { Encoding = encoding });
            MeshData back = ReadData(stream.ToArray(), format, out _);
            if (report.LeftOut.Count == 0 && report.TriangulatedFaces == 0 && format != MeshFormat.Stl)
                AssertSame(data, back);
            Assert.Equal(data.FaceCount + report.TriangulatedFaces, back.FaceCount);
        }
    }

    [Fact]
    public void WriteData_FaceColorsAndOwnLabels_HaveNoPlaceInObj()
    {
        MeshData data = ReadData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n", MeshFormat.Off);
        data.FaceLabels = [new FaceLabelSet("segment", ["a"], [0])];
        using var stream = new MemoryStream();
        Assert.Equal(["face colours", "labels of segment"], MeshFile.WriteData(data, stream, MeshFormat.Obj).LeftOut.Keys, StringComparer.Ordinal);
        Assert.Equal(["labels of segment"], MeshFile.WriteData(data, stream, MeshFormat.Off).LeftOut.Keys, StringComparer.Ordinal);
        Assert.Empty(MeshFile.WriteData(data, stream, MeshFormat.Ply).LeftOut);
    }
}
