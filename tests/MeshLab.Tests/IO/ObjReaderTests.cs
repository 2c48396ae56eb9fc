using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

[Trait("Section", "14.1")]
public class ObjReaderTests
{
    [Fact]
    public void Read_Cube_KeepsOrderAndFirstCorners()
    {
        Mesh mesh = Read(CubeObj, MeshFormat.Obj);
        Assert.Equal((8, 18, 12), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Equal(new Vector3D(1, 1, 0), mesh.Vertices[2].Position);
        Assert.Equal([3, 2, 1], mesh.Faces[0].Vertices.Select(v => v.Index));
        Assert.Equal((3, 2), (mesh.Faces[0].HalfEdge.Source.Index, mesh.Faces[0].HalfEdge.Target.Index));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void ReadData_EveryFormOfCorner_TakesTheVertex()
    {
        MeshData data = ReadData("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1 2/1 3//1 4/1/1\nf -4 -3/-1 -2//-1\nf 1/ 2// 3/1/\n", MeshFormat.Obj);
        Assert.Equal([0, 1, 2, 3, 0, 1, 2, 0, 1, 2], data.Corners);
        Assert.Equal([0, 4, 7, 10], data.FaceStart);
    }

    [Fact]
    public void ReadData_WeightsAndColors_AreToldApartByCount()
    {
        MeshData data = ReadData("v 0 0 0\nv 1 0 0 2\nv 2 0 0 1 .5 .25\nv 3 0 0 1 .5 .25 .75\nv 4 0 0 1 .125 .25 .5 1\n", MeshFormat.Obj, out MeshReadReport report);
        Assert.Equal([Color.White, Color.White, new(1, .5f, .25f), new(1, .5f, .25f, .75f), new(.125f, .25f, .5f, 1)], data.VertexColors!);
        Assert.Equal(1, report.IgnoredWeights);
        AssertFormatError("v 1 2 3 4 5\n", MeshFormat.Obj, 1, 12);
        AssertFormatError("v 1 2 3 4 5 6 7 8 9\n", MeshFormat.Obj, 1, 19);
    }

    [Fact]
    public void ReadData_LineContinuation_JoinsLines()
    {
        MeshData data = ReadData("v 0 0 \\\n0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n 3\\\n 4\n", MeshFormat.Obj);
        Assert.Equal([0, 1, 2, 3], data.Corners);
        Assert.Equal(2, data.FaceStart.Length);
    }

    [Fact]
    public void ReadData_GroupsObjectsMaterials_BecomeLabels()
    {
        MeshData data = ReadData(
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\no Körper A\ng a b\nusemtl rot\ns 1\nf 1 2 3\nf 1 2 3\ns off\nusemtl blau\nf 1 2 3\ng\ng unused\ng c\nf 1 2 3\n", MeshFormat.Obj);
        Assert.Equal([FaceLabelSet.Group, FaceLabelSet.Material, FaceLabelSet.Object, FaceLabelSet.Smoothing], data.FaceLabels.Select(l => l.Kind), StringComparer.Ordinal);
        Assert.Equal(["a b", "c"], data.FaceLabels[0].Names);
        Assert.Equal([-1, 0, 0, 0, 1], data.FaceLabels[0].Labels);
        Assert.Equal([-1, 0, 0, 1, 1], data.FaceLabels[1].Labels);
        Assert.Equal(["Körper A"], data.FaceLabels[2].Names);
        Assert.Equal([-1, 0, 0, -1, -1], data.FaceLabels[3].Labels);
    }

    [Fact]
    public void Read_Labels_AreOnTheMesh()
    {
        Mesh mesh = Read("usemtl rot\n" + CubeObj, MeshFormat.Obj);
        FaceLabels material = Assert.Single(mesh.FaceLabels);
        Assert.Equal(("material", "rot"), (material.Sort, material.NameOf(mesh.Faces[5])));
    }

    [Fact]
    public void Read_TextureCoordinates_AreOnVerticesUnlessThereIsASeam()
    {
        string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\n";
        Mesh smooth = Read(quad + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", MeshFormat.Obj);
        Assert.Equal(new Vector2D(1, 1), smooth.Vertices[2].Traits.UV);
        Assert.Empty(smooth.HalfEdgeTraits);

        Mesh seam = Read(quad + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", MeshFormat.Obj);
        HalfEdge intoFirst = seam.Faces[1].HalfEdge.Previous;
        Assert.Equal(0, intoFirst.Target.Index);
        Assert.Equal(new Vector2D(.5, .5), intoFirst.Traits.TextureCoordinate);
        Assert.Equal(new Vector2D(0, 0), seam.Faces[0].HalfEdge.Previous.Traits.TextureCoordinate);
    }

    [Fact]
    public void ReadData_UnknownLines_AreIgnoredAndCounted()
    {
        ReadData(CubeObj + "l 1 2\nl 2 3\ncurv 0 1 2\n# comment\n\n", MeshFormat.Obj, out MeshReadReport report);
        Assert.Equal(3, report.IgnoredLines);
        Assert.Equal(2, report.Ignored["l"]);
        Assert.Equal(1, report.Ignored["curv"]);
    }

    [Theory]
    [InlineData("v 1 2\n", 1, 6)]
    [InlineData("v 1 2 3abc\n", 1, 7)]
    [InlineData("v 1 nan 3\n", 1, 5)]
    [InlineData("v 1 1e999 3\n", 1, 5)]
    [InlineData("v 1 2 3 x\n", 1, 9)]
    [InlineData("v 0 0 0\nf 1 1 x\n", 2, 7)]
    [InlineData("v 0 0 0\nf 1 1 0\n", 2, 7)]
    [InlineData("v 0 0 0\nf 1 1 2\n", 2, 7)]
    [InlineData("v 0 0 0\nf 1 -1 -2\n", 2, 8)]
    [InlineData("v 0 0 0\nf 1 1 1/a\n", 2, 9)]
    [InlineData("v 0 0 0\nvt 0 0\nf 1/1 1/1 1/2\n", 3, 13)]
    [InlineData("v 0 0 0\nf 1 1 99999999999\n", 2, 7)]
    [InlineData("v 0 0 0\nf1 1 1\n", 2, 1)]
    [InlineData("v 0 0 0\nf\n", 2, 2)]
    [InlineData("v 0 0 0\n  \tv ä 0 0\n", 2, 6)]
    [InlineData("# ä\rv 0 0 0\r\nv 0 0\r", 3, 6)]
    [InlineData("<html>\n<body>\n", 1, 1)]
    [InlineData("v 0 0 0\nabc\u0001\u0002\n", 2, 1)]
    public void ReadData_BadLine_SaysWhere(string text, long line, long column) => AssertFormatError(text, MeshFormat.Obj, line, column);

    [Fact]
    public void ReadData_BadIndex_SaysWhatWasExpected()
    {
        MeshFormatException error = AssertFormatError(CubeObj + "f 1 2 9\n", MeshFormat.Obj, 21, 7);
        Assert.Equal("file:21:7: found '9', expected a vertex index of at most 8", error.Message);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(7)]
    public void ReadData_InPieces_GivesTheSameAsWhole(int pieces)
    {
        string text = "\uFEFF" + string.Concat(Enumerable.Range(0, 40).Select(i =>
            $"v {i} 0 {i / 7.0:R}\r\nv {i} 1 \\\r\n0\r\nv {i} 2 0 1 0 .5\nvt {i} .5\nvn 0 0 {i}\ng part {i / 5}\nf {3 * i + 1} -2/-1/-1 -1\n" +
            (i % 11 == 0 ? "usemtl m\nl 1 2\n" : "")));
        MeshData whole = ReadData(text, MeshFormat.Obj, out MeshReadReport expected, new MeshReadOptions { MaxChunks = 1 });
        MeshData joined = ReadData(text, MeshFormat.Obj, out MeshReadReport report, new MeshReadOptions { MaxChunks = pieces, MinChunkBytes = 16 });
        AssertSame(whole, joined);
        Assert.Equal(expected.Ignored, report.Ignored);
        Assert.Equal((120, 40), (joined.VertexCount, joined.FaceCount));
    }

    [Fact]
    public void ReadData_ErrorsInSeveralPieces_ReportsTheFirst()
    {
        string text = CubeObj + "v 1 x 1\n" + string.Concat(Enumerable.Repeat("v 0 0 0\n", 50)) + "v y 0 0\n";
        MeshFormatException error = Assert.Throws<MeshFormatException>(
            () => ReadData(text, MeshFormat.Obj, new MeshReadOptions { MaxChunks = 4, MinChunkBytes = 16 }));
        Assert.Equal((21, 5), (error.Line, error.Column));
    }
}
