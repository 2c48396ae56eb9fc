using System.Globalization;
using System.Text;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

/// <summary>Read → write → read is the identity, bit for bit.</summary>
[Trait("Section", "14")]
public class RoundTripTests
{
    private static readonly (MeshFormat Format, MeshEncoding Encoding)[] ExactForms =
    [
        (MeshFormat.Obj, MeshEncoding.Text), (MeshFormat.Off, MeshEncoding.Text), (MeshFormat.Ply, MeshEncoding.Text),
        (MeshFormat.Ply, MeshEncoding.BinaryLittleEndian), (MeshFormat.Ply, MeshEncoding.BinaryBigEndian),
    ];

    /// <summary>The attributes of a mesh that each format can hold.</summary>
    [Flags]
    public enum Attributes
    {
        None = 0,
        VertexNormals = 1,
        VertexTexture = 2,
        VertexColors = 4,
        CornerNormals = 8,
        CornerTexture = 16,
        FaceColors = 32,
        Labels = 64,
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void WriteRead_PublicModel_IsTheIdentity(string name)
    {
        string path = ReferenceData.ModelPath(name);
        MeshData data = MeshFile.ReadData(path);
        foreach ((MeshFormat format, MeshEncoding encoding) in ExactForms)
            AssertSame(data, ReadData(Write(data, format, encoding), format, out _));
        AssertSame(data, ReferenceData.Load(name).ToMeshData());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void WriteRead_SmallModel_IsTheIdentity(string name)
    {
        Mesh mesh = Models.Create(name);
        foreach ((MeshFormat format, MeshEncoding encoding) in ExactForms)
        {
            using MemoryStream stream = new();
            MeshFile.Write(mesh, stream, format, new MeshWriteOptions { Encoding = encoding });
            stream.Position = 0;
            Mesh again = MeshFile.Read(stream, format);
            AssertSame(mesh.ToMeshData(), again.ToMeshData());
            Assert.Equal(mesh.HalfEdgeOf.Length, again.HalfEdgeOf.Length);
            Assert.Empty(again.Validate());
        }
    }

    [Theory]
    [InlineData(MeshFormat.Obj, Attributes.VertexNormals | Attributes.VertexTexture | Attributes.VertexColors | Attributes.Labels)]
    [InlineData(MeshFormat.Obj, Attributes.CornerNormals | Attributes.CornerTexture | Attributes.Labels)]
    [InlineData(MeshFormat.Obj, Attributes.CornerNormals)]
    [InlineData(MeshFormat.Obj, Attributes.VertexTexture | Attributes.CornerNormals)]
    [InlineData(MeshFormat.Off, Attributes.VertexNormals | Attributes.VertexTexture | Attributes.VertexColors | Attributes.FaceColors)]
    [InlineData(MeshFormat.Off, Attributes.FaceColors)]
    [InlineData(MeshFormat.Ply, Attributes.VertexNormals | Attributes.VertexTexture | Attributes.VertexColors | Attributes.CornerNormals | Attributes.CornerTexture | Attributes.FaceColors | Attributes.Labels)]
    [InlineData(MeshFormat.Ply, Attributes.VertexColors | Attributes.Labels)]
    public void WriteRead_Attributes_AreKeptBitForBit(MeshFormat format, Attributes attributes)
    {
        Mesh mesh = WithAttributes(attributes).ToMesh();
        foreach ((MeshFormat known, MeshEncoding encoding) in ExactForms)
        {
            if (known != format)
                continue;
            using MemoryStream stream = new();
            MeshFile.Write(mesh, stream, format, new MeshWriteOptions { Encoding = encoding });
            stream.Position = 0;
            Mesh again = MeshFile.Read(stream, format);
            AssertSame(WithAttributes(attributes), again.ToMeshData());
            Assert.Empty(again.Validate());
        }
    }

    [Fact]
    public void ToMesh_AfterSplitting_TakesTheAttributesAlong()
    {
        MeshData data = new()
        {
            Positions = [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(-1, 0, 0), new(-1, -1, 0)],
            FaceStart = [0, 3, 6],
            Corners = [0, 1, 2, 0, 3, 4],
            VertexColors = [.. Enumerable.Range(0, 5).Select(i => new Color(i / 8f, 0, 0))],
            CornerTextureCoordinates = [.. Enumerable.Range(0, 6).Select(i => new Vector2D(i, -i))],
        };
        Mesh mesh = data.ToMesh(NonManifoldPolicy.Split, out BuildReport report);
        Assert.Single(report.Repairs);
        Assert.Equal(6, mesh.Vertices.Count);
        MeshData split = mesh.ToMeshData();
        Assert.Equal(data.CornerTextureCoordinates, split.CornerTextureCoordinates);
        Assert.All(Enumerable.Range(0, 6), c => Assert.Equal(data.VertexColors[data.Corners[c]], split.VertexColors![split.Corners[c]]));
    }

    [Theory]
    [InlineData("de-DE")]
    [InlineData("tr-TR")]
    [InlineData("fa-IR")]
    public void WriteRead_InOtherCultures_IsTheSameText(string culture)
    {
        MeshData data = WithAttributes(Attributes.VertexNormals | Attributes.VertexColors | Attributes.Labels);
        string Everything() => string.Concat(ExactForms.Select(f => Encoding.Latin1.GetString(Write(data, f.Format, f.Encoding))))
            + WriteText(data, MeshFormat.Stl) + Encoding.Latin1.GetString(Write(data, MeshFormat.Glb));
        string expected = Everything();
        CultureInfo before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = CultureInfo.GetCultureInfo(culture);
            Assert.Equal(expected, Everything());
            AssertSame(data, ReadData(Write(data, MeshFormat.Obj), MeshFormat.Obj, out _));
            AssertSame(data, ReadData(Write(data, MeshFormat.Ply, MeshEncoding.Text), MeshFormat.Ply, out _));
            Assert.Equal(8, ReadData("SOLID I\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID I\n", MeshFormat.Stl).VertexCount + 5);
            Assert.True(MeshFile.TryFormatOf("CUBE.OBJ", out _));
            AssertFormatError("v 1,5 0 0\n", MeshFormat.Obj, 1, 3);
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void WriteRead_StlText_KeepsGeometryAndSolids()
    {
        MeshData data = ReadData("o A\n" + CubeObj.Replace("f 5 6 7\n", "o B b\nf 5 6 7\n"), MeshFormat.Obj);
        Mesh again = ReadData(Write(data, MeshFormat.Stl, MeshEncoding.Text), MeshFormat.Stl, out _).ToMesh();
        Assert.Equal((8, 12), (again.Vertices.Count, again.Faces.Count));
        Assert.Equal(["A", "B b"], again.FaceLabels[0].Names);
        Assert.Equal(data.FaceLabels[0].Labels, again.ToMeshData().FaceLabels[0].Labels);
    }

    [Fact]
    public void Write_OddNumbersAndNames_AreReadBack()
    {
        MeshData data = new()
        {
            Positions = [new(-0.0, double.Epsilon, double.MaxValue), new(1 / 3.0, -1e-300, 5e22), new(123456789012345678, 0.1, -1e21)],
            FaceStart = [0, 3],
            Corners = [0, 1, 2],
            FaceLabels = [new FaceLabelSet(FaceLabelSet.Material, ["Füß # 1"], [0])],
        };
        foreach ((MeshFormat format, MeshEncoding encoding) in ExactForms)
        {
            MeshData again = ReadData(Write(data, format, encoding), format, out _);
            if (format == MeshFormat.Off)
                data.FaceLabels = [];
            AssertSame(data, again);
            data.FaceLabels = [new FaceLabelSet(FaceLabelSet.Material, ["Füß # 1"], [0])];
        }

        data.FaceLabels = [new FaceLabelSet(FaceLabelSet.Group, ["two\nlines\r\nv 0 0 0"], [0])];
        Assert.Equal(["two lines v 0 0 0"], ReadData(Write(data, MeshFormat.Obj), MeshFormat.Obj, out _).FaceLabels[0].Names);
    }

    [Fact]
    public void Write_LongPolygon_IsKept()
    {
        int n = 300;
        MeshData data = new()
        {
            Positions = [.. Enumerable.Range(0, n).Select(i => new Vector3D(Math.Cos(2 * Math.PI * i / n), Math.Sin(2 * Math.PI * i / n), 0))],
            FaceStart = [0, n],
            Corners = [.. Enumerable.Range(0, n)],
        };
        foreach ((MeshFormat format, MeshEncoding encoding) in ExactForms)
            AssertSame(data, ReadData(Write(data, format, encoding), format, out _));
    }

    [Fact]
    public void Write_AfterDeleting_WritesTheLiveElementsInOrder()
    {
        Mesh mesh = Read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 5 5\nv 5 6 5\nusemtl a\nf 2 3 4\nusemtl b\nf 5 6 7\n", MeshFormat.Obj);
        MeshData all = mesh.ToMeshData();
        Assert.Equal((7, 2), (all.VertexCount, all.FaceCount));
        mesh.Compact();
        AssertSame(all, mesh.ToMeshData());
    }

    /// <summary>A quad and two triangles, the attributes with values that differ everywhere.</summary>
    private static MeshData WithAttributes(Attributes attributes)
    {
        MeshData data = new()
        {
            Positions = [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(2, .5, 1 / 3.0), new(9, 9, 9)],
            FaceStart = [0, 4, 7],
            Corners = [0, 1, 2, 3, 2, 1, 4],
        };
        if (attributes.HasFlag(Attributes.VertexNormals))
            data.VertexNormals = [.. data.Positions.Select(p => p * (1 / 7.0))];
        if (attributes.HasFlag(Attributes.VertexTexture))
            data.VertexTextureCoordinates = [.. data.Positions.Select(p => new Vector2D(p.X / 3, -p.Y))];
        if (attributes.HasFlag(Attributes.VertexColors))
            data.VertexColors = [.. data.Positions.Select((_, i) => new Color(i / 7f, 1 - i / 9f, 0.1f, i / 5f))];
        if (attributes.HasFlag(Attributes.CornerNormals))
            data.CornerNormals = [.. data.Corners.Select((_, c) => new Vector3D(c / 3.0, -0.0, 1))];
        if (attributes.HasFlag(Attributes.CornerTexture))
            data.CornerTextureCoordinates = [.. data.Corners.Select((_, c) => new Vector2D(c / 3.0, c % 2 == 0 ? 0.0 : -0.0))];
        if (attributes.HasFlag(Attributes.FaceColors))
            data.FaceColors = [Color.FromBytes(255, 128, 0), Color.FromBytes(1, 2, 3)];
        if (attributes.HasFlag(Attributes.Labels))
        {
            data.FaceLabels =
            [
                new FaceLabelSet(FaceLabelSet.Group, ["arm links"], [-1, 0]),
                new FaceLabelSet(FaceLabelSet.Material, ["b", "a"], [0, 1]),
                new FaceLabelSet(FaceLabelSet.Object, ["o"], [0, 0]),
                new FaceLabelSet(FaceLabelSet.Smoothing, ["1"], [0, -1]),
            ];
        }

        return data;
    }
}
