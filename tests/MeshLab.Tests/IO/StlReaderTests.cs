using System.Buffers.Binary;
using System.Text;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

[Trait("Section", "14.3")]
public class StlReaderTests
{
    private const string Facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

    [Fact]
    public void ReadData_Text_WeldsEqualCoordinates()
    {
        MeshData data = ReadData("solid\n" + Facet + Facet.Replace("vertex 0 0 0", "vertex -0 1 0").Replace("vertex 0 1 0\n", "vertex -0.0 -1 0\n") + "endsolid\n", MeshFormat.Stl, out MeshReadReport report);
        Assert.Equal((4, 2), (data.VertexCount, data.FaceCount));
        Assert.Equal(2, report.WeldedVertices);
        Assert.Equal([0, 1, 2, 2, 1, 3], data.Corners);
    }

    [Fact]
    public void ReadData_WithoutWelding_KeepsEveryCorner()
    {
        MeshData data = ReadData("solid\n" + Facet + Facet + "endsolid\n", MeshFormat.Stl, new MeshReadOptions { Weld = false });
        Assert.Equal([0, 1, 2, 3, 4, 5], data.Corners);
    }

    [Fact]
    public void ReadData_SeveralSolids_AreObjects()
    {
        MeshData data = ReadData("SOLID A b\n" + Facet + "EndSolid A b\nsolid\n" + Facet + "endsolid\n" + "solid C\nendsolid C", MeshFormat.Stl);
        FaceLabelSet solids = Assert.Single(data.FaceLabels);
        Assert.Equal(["A b"], solids.Names);
        Assert.Equal([0, -1], solids.Labels);
    }

    [Theory]
    [InlineData("solid\n", 2, 1)]
    [InlineData("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", 5, 1)]
    [InlineData("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 inf 0\n", 4, 10)]
    [InlineData("solid\nfacet normal 0 x 1\n", 2, 16)]
    [InlineData("solid\nfacets\n", 2, 1)]
    [InlineData("obj?\n", 1, 1)]
    public void ReadData_BadText_SaysWhere(string text, long line, long column) => AssertFormatError(text, MeshFormat.Stl, line, column);

    [Fact]
    public void ReadData_FourVerticesInALoop_IsRefused() =>
        AssertFormatError("solid\n" + Facet.Replace("endloop", "vertex 1 1 0\nendloop"), MeshFormat.Stl, 7, 1);

    [Fact]
    public void ReadData_Binary_TellsItFromTextByLength()
    {
        byte[] bytes = Binary(1, "solid as it looks");
        MeshData data = ReadData(bytes, MeshFormat.Stl, out MeshReadReport report);
        Assert.Equal(MeshEncoding.BinaryLittleEndian, report.Encoding);
        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], data.Positions);
    }

    [Fact]
    public void ReadData_BinaryThatLies_AllocatesByTheBytesOnly()
    {
        byte[] bytes = Binary(1, "binary");
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(80), uint.MaxValue);
        Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Stl, out _));
        long before = GC.GetAllocatedBytesForCurrentThread();
        MeshFormatException error = Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Stl, out _));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1_000_000);
        Assert.Equal((0, 134), (error.Line, error.Column));
    }

    /// <summary>Shorter than a binary header, begins as text, and has a zero byte, which only binary files have.</summary>
    [Theory]
    [InlineData("solid a\0b\nendsolid\n")]
    [InlineData("solid \0")]
    [InlineData("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 \0 0")]
    public void ReadData_ZeroByteInShortText_IsRefused(string text)
    {
        try
        {
            Assert.Equal(0, ReadData(text, MeshFormat.Stl).FaceCount);
        }
        catch (MeshFormatException error)
        {
            Assert.True(error.Line >= 1, error.Message);
        }
    }

    /// <summary>Some programs write the count 0 and never correct it: to believe it would lose every face.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void ReadData_BinaryWithMoreFacetsThanItsCount_IsRefusedBehindTheLast(int count)
    {
        byte[] bytes = Binary(3, "binary");
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(80), count);
        MeshFormatException error = Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Stl, out _));
        Assert.Equal((0, 84 + 50 * count), (error.Line, error.Column));
    }

    [Fact]
    public void ReadData_BinaryNaN_SaysTheByte()
    {
        byte[] bytes = Binary(1, "binary");
        BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(84 + 24), float.NaN);
        MeshFormatException error = Assert.Throws<MeshFormatException>(() => ReadData(bytes, MeshFormat.Stl, out _));
        Assert.Equal((0, 84 + 24), (error.Line, error.Column));
    }

    [Fact]
    public void Write_Polygons_AreCutIntoTrianglesWithoutFolds()
    {
        // The non-convex hexagon: a fan from any corner but one would fold.
        MeshData data = ReadData("OFF\n6 1 0\n0 0 0\n2 0 0\n2 2 0\n1 2 0\n1 1 0\n0 1 0\n6 0 1 2 3 4 5\n", MeshFormat.Off);
        foreach (MeshEncoding encoding in (MeshEncoding[])[MeshEncoding.Text, MeshEncoding.BinaryLittleEndian])
        {
            Mesh mesh = ReadData(Write(data, MeshFormat.Stl, encoding), MeshFormat.Stl, out _).ToMesh();
            Assert.Equal((6, 4), (mesh.Vertices.Count, mesh.Faces.Count));
            double area = 0;
            foreach (Face f in mesh.Faces)
            {
                Vector3D[] p = [.. f.Vertices.Select(v => v.Position)];
                double signed = Vector3D.Cross(p[1] - p[0], p[2] - p[0]).Z / 2;
                Assert.True(signed > 0);
                area += signed;
            }

            Assert.Equal(3, area, 12);
        }
    }

    [Fact]
    public void Write_CoordinateBeyondFloat_IsRefused()
    {
        MeshData data = ReadData("v 1e300 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat.Obj);
        Assert.Throws<ArgumentException>(() => Write(data, MeshFormat.Stl));
        Assert.Contains("1E+300", WriteText(data, MeshFormat.Stl), StringComparison.Ordinal);
    }

    private static byte[] Binary(int facets, string header)
    {
        byte[] bytes = new byte[84 + 50 * facets];
        Encoding.ASCII.GetBytes(header, bytes);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(80), facets);
        for (int f = 0; f < facets; f++)
        {
            BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(84 + 50 * f + 24), 1);
            BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(84 + 50 * f + 40), 1);
        }

        return bytes;
    }
}
