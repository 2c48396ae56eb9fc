using MeshLab.IO;
using MeshLab.Numerics;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

[Trait("Section", "14.2")]
public class OffReaderTests
{
    private const string Triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

    [Theory]
    [InlineData("OFF\n3 1 3\n")]
    [InlineData("OFF 3 1 0\n")]
    [InlineData("OFF\n3 1\n")]
    [InlineData("OFF\n3\n1\n0\n")]
    [InlineData("3 1 0\n")]
    [InlineData("# c\n\n  OFF # c\n# c\n3 1 0 # c\n")]
    [InlineData("\uFEFFOFF\r\n3 1 0\r\n")]
    [InlineData("OFF\r3 1 0\r")]
    public void ReadData_EveryFormOfHeader_IsRead(string header)
    {
        MeshData data = ReadData(header + Triangle, MeshFormat.Off);
        Assert.Equal([0, 1, 2], data.Corners);
        Assert.Equal(new Vector3D(0, 1, 0), data.Positions[2]);
    }

    [Fact]
    public void ReadData_AllPrefixes_ReadsEveryAttribute()
    {
        MeshData data = ReadData("STCNOFF\n3 1 0\n0 0 0 0 0 1 .5 .25 0 1 0 0\n1 0 0 0 0 1 1 1 1 1 1 0\n0 1 0 0 0 -1 0 0 0 .5 0 1\n3 0 1 2 1 0 0\n", MeshFormat.Off);
        Assert.Equal(new Vector3D(0, 0, -1), data.VertexNormals![2]);
        Assert.Equal(new Color(.5f, .25f, 0), data.VertexColors![0]);
        Assert.Equal(.5f, data.VertexColors[2].A);
        Assert.Equal(new Vector2D(0, 1), data.VertexTextureCoordinates![2]);
        Assert.Equal([new Color(1, 0, 0)], data.FaceColors!);
    }

    [Fact]
    public void ReadData_ColorsOfBytes_AreScaledAsOne()
    {
        MeshData data = ReadData("COFF\n3 2 0\n0 0 0 255 0 1\n1 0 0 0 51 0\n0 1 0 0 0 0\n3 0 1 2 255 0 51 0\n3 0 1 2\n", MeshFormat.Off);
        Assert.Equal(Color.FromBytes(255, 0, 1), data.VertexColors![0]);
        Assert.Equal([Color.FromBytes(255, 0, 51, 0), Color.White], data.FaceColors!);
    }

    [Fact]
    public void ReadData_NumbersOverLines_AreRead()
    {
        MeshData data = ReadData("OFF 3 1 0\n0 0 0 1 0\n0\n0\n\t1 0 3\n0 1\n2", MeshFormat.Off);
        Assert.Equal([0, 1, 2], data.Corners);
        Assert.Equal(new Vector3D(1, 0, 0), data.Positions[1]);
    }

    [Fact]
    public void ReadData_IndexIntoColorMap_IsCounted()
    {
        ReadData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n", MeshFormat.Off, out MeshReadReport report);
        Assert.Equal(1, report.Ignored["index into a colour map"]);
    }

    [Theory]
    [InlineData("OFF BINARY\n", 1, 5)]
    [InlineData("4OFF\n", 1, 1)]
    [InlineData("nOFF\n", 1, 1)]
    [InlineData("OFFx\n", 1, 4)]
    [InlineData("ply\n", 1, 1)]
    [InlineData("OFF\n-1 1 0\n", 2, 1)]
    [InlineData("OFF\n3 x 0\n", 2, 3)]
    [InlineData("OFF\n3.5 1 0\n", 2, 1)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 nan 0\n", 4, 3)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", 6, 1)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 6, 7)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", 6, 7)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 2\n", 6, 12)]
    [InlineData("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n", 7, 1)]
    [InlineData("OFF\n99999999999 1 0\n", 2, 1)]
    public void ReadData_BadFile_SaysWhere(string text, long line, long column) => AssertFormatError(text, MeshFormat.Off, line, column);

    [Theory]
    [InlineData("OFF\n2000000000 2000000000 0\n0 0 0\n")]
    [InlineData("OFF\n1 2000000000 0\n0 0 0\n2000000000 0 0 0\n")]
    [InlineData("STCNOFF\n2147483647 1 0\n")]
    public void ReadData_LyingCounts_AllocatesByTheBytesOnly(string text)
    {
        Assert.Throws<MeshFormatException>(() => ReadData(text, MeshFormat.Off));
        long before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Throws<MeshFormatException>(() => ReadData(text, MeshFormat.Off));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1_000_000);
    }
}
