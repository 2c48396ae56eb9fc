using System.Text;
using System.Text.Json;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.IO.TextFiles;

namespace MeshLab.Tests.IO;

[Trait("Section", "14")]
public sealed class MeshFileTests : IDisposable
{
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("meshlab-io-");

    public void Dispose() => folder.Delete(recursive: true);

    private string PathOf(string name) => Path.Combine(folder.FullName, name);

    [Theory]
    [InlineData("a.obj", MeshFormat.Obj)]
    [InlineData("a.b.OFF", MeshFormat.Off)]
    [InlineData("/x.y/a.stl.gz", MeshFormat.Stl)]
    [InlineData("a.PLY.GZ", MeshFormat.Ply)]
    [InlineData("a.glb", MeshFormat.Glb)]
    public void TryFormatOf_KnownExtension_IsFound(string path, MeshFormat expected)
    {
        Assert.True(MeshFile.TryFormatOf(path, out MeshFormat format));
        Assert.Equal(expected, format);
    }

    [Theory]
    [InlineData("a")]
    [InlineData("a.gz")]
    [InlineData("a.mtl")]
    [InlineData("obj")]
    public void Read_UnknownExtension_Throws(string path)
    {
        Assert.False(MeshFile.TryFormatOf(path, out _));
        Assert.Throws<ArgumentException>(() => MeshFile.Read(path));
        Assert.Throws<ArgumentException>(() => MeshFile.Write(new Mesh(), path));
    }

    [Theory]
    [InlineData("a.obj")]
    [InlineData("a.off")]
    [InlineData("a.stl")]
    [InlineData("a.ply")]
    [InlineData("a.obj.gz")]
    [InlineData("a.off.gz")]
    [InlineData("a.stl.gz")]
    [InlineData("a.ply.gz")]
    public void WriteRead_EveryExtension_KeepsTheCube(string name)
    {
        Mesh cube = Read(CubeOff, MeshFormat.Off);
        MeshFile.Write(cube, PathOf(name));
        byte[] bytes = File.ReadAllBytes(PathOf(name));
        Assert.Equal(name.EndsWith(".gz", StringComparison.Ordinal), bytes[0] == 0x1F && bytes[1] == 0x8B);
        Mesh again = MeshFile.Read(PathOf(name), out MeshReadReport report);
        Assert.Equal((8, 18, 12), (again.Vertices.Count, again.Edges.Count, again.Faces.Count));
        Assert.Empty(again.Validate());
        Assert.Empty(report.Build!.Repairs);
        Assert.Single(folder.GetFiles());
    }

    [Theory]
    [InlineData("a.obj")]
    [InlineData("a.off")]
    [InlineData("a.stl")]
    [InlineData("a.ply")]
    [InlineData("a.glb")]
    public void Write_EmptyMesh_IsReadBackEmpty(string name)
    {
        MeshFile.Write(new Mesh(), PathOf(name));
        Assert.True(new FileInfo(PathOf(name)).Length > 0);
        if (name != "a.glb")
            Assert.Equal(0, MeshFile.Read(PathOf(name)).Vertices.Count);
    }

    [Fact]
    public void Read_MissingFileOrFolder_PassesTheSystemsError()
    {
        Assert.Throws<FileNotFoundException>(() => MeshFile.Read(PathOf("none.obj")));
        Directory.CreateDirectory(PathOf("folder.obj"));
        Assert.Contains("is a directory", Assert.Throws<IOException>(() => MeshFile.Read(PathOf("folder.obj"))).Message, StringComparison.Ordinal);
        Assert.Contains("is a directory", Assert.Throws<IOException>(() => MeshFile.Write(new Mesh(), PathOf("folder.obj"))).Message, StringComparison.Ordinal);
        DirectoryNotFoundException error = Assert.Throws<DirectoryNotFoundException>(() => MeshFile.Write(new Mesh(), PathOf("no/such/a.obj")));
        Assert.Contains("there is no directory", error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain(".tmp", error.Message, StringComparison.Ordinal);
    }

    [SkippableFact]
    public void Write_WithoutPermission_PassesTheSystemsErrorAndKeepsTheFile()
    {
        Skip.If(OperatingSystem.IsWindows() || Environment.UserName == "root", "This user may write everywhere.");
        File.WriteAllText(PathOf("a.obj"), "old");
        File.SetAttributes(PathOf("a.obj"), FileAttributes.ReadOnly);
        Assert.Throws<UnauthorizedAccessException>(() => MeshFile.Write(new Mesh(), PathOf("a.obj")));
        Assert.Equal("old", File.ReadAllText(PathOf("a.obj")));
        File.SetAttributes(PathOf("a.obj"), FileAttributes.Normal);
    }

    [Fact]
    public void Write_Cancelled_LeavesTheOldFileAndNothingElse()
    {
        File.WriteAllText(PathOf("a.obj"), "old");
        using CancellationTokenSource source = new();
        source.Cancel();
        Mesh cube = Read(CubeObj, MeshFormat.Obj);
        Assert.Throws<OperationCanceledException>(() => MeshFile.Write(cube, PathOf("a.obj"), cancellationToken: source.Token));
        Assert.Equal("old", File.ReadAllText(PathOf("a.obj")));
        Assert.Single(folder.GetFiles());
    }

    [Theory]
    [InlineData(MeshFormat.Obj, CubeObj)]
    [InlineData(MeshFormat.Off, CubeOff)]
    public void Read_Cancelled_Throws(MeshFormat format, string text)
    {
        using CancellationTokenSource source = new();
        source.Cancel();
        Assert.Throws<OperationCanceledException>(
            () => MeshFile.Read(new MemoryStream(Encoding.UTF8.GetBytes(text)), format, out _, cancellationToken: source.Token));
    }

    [Fact]
    public void Read_LargeFile_ReportsProgressUpToOne()
    {
        StringBuilder text = new();
        for (int i = 0; i < 200_000; i++)
            text.Append("v 0.125 0.25 0.5\n");
        List<double> steps = [];
        MeshFile.Read(new MemoryStream(Encoding.UTF8.GetBytes(text.ToString())), MeshFormat.Obj, out _, progress: new Steps(steps));
        Assert.True(steps.Count > 3);
        Assert.Equal(steps.Order(), steps);
        Assert.Equal(1, steps[^1]);
    }

    [Fact]
    public void Write_ThroughALink_KeepsTheLink()
    {
        File.WriteAllText(PathOf("real.obj"), "old");
        File.CreateSymbolicLink(PathOf("link.obj"), PathOf("real.obj"));
        MeshFile.Write(Read(CubeObj, MeshFormat.Obj), PathOf("link.obj"));
        Assert.NotNull(new FileInfo(PathOf("link.obj")).LinkTarget);
        Assert.Equal(12, MeshFile.Read(PathOf("real.obj")).Faces.Count);
    }

    [Theory]
    [InlineData(MeshFormat.Obj, MeshEncoding.BinaryLittleEndian)]
    [InlineData(MeshFormat.Off, MeshEncoding.BinaryBigEndian)]
    [InlineData(MeshFormat.Stl, MeshEncoding.BinaryBigEndian)]
    [InlineData(MeshFormat.Glb, MeshEncoding.Text)]
    public void Write_ImpossibleEncoding_Throws(MeshFormat format, MeshEncoding encoding) =>
        Assert.Throws<ArgumentException>(() => MeshFile.Write(new Mesh(), new MemoryStream(), format, new MeshWriteOptions { Encoding = encoding }));

    [Fact]
    public void Write_MaterialLibraries_AreNamed()
    {
        Mesh mesh = Read("mtllib a b.mtl\nusemtl m\n" + CubeObj, MeshFormat.Obj);
        MeshFile.Write(mesh, PathOf("a.obj"), new MeshWriteOptions { MaterialLibraries = ["a b.mtl"] });
        MeshFile.Read(PathOf("a.obj"), out MeshReadReport report);
        Assert.Equal(["a b.mtl"], report.MaterialLibraries);
    }

    [Fact]
    public void Write_Glb_IsWellFormed()
    {
        MeshData data = ReadData(CubeObj.Replace("v 1 1 1\n", "v 1 1 1 .5 0 0 1\n"), MeshFormat.Obj);
        byte[] glb = Write(data, MeshFormat.Glb);
        Assert.Equal("glTF"u8, glb.AsSpan(0, 4));
        Assert.Equal(2, BitConverter.ToInt32(glb, 4));
        Assert.Equal(glb.Length, BitConverter.ToInt32(glb, 8));
        int jsonLength = BitConverter.ToInt32(glb, 12);
        Assert.Equal(0, jsonLength % 4);
        JsonElement json = JsonDocument.Parse(glb.AsMemory(20, jsonLength)).RootElement;
        int binaryLength = BitConverter.ToInt32(glb, 20 + jsonLength);
        Assert.Equal(glb.Length, 20 + jsonLength + 8 + binaryLength);
        Assert.Equal(binaryLength, json.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32());
        Assert.Equal(binaryLength, json.GetProperty("bufferViews").EnumerateArray().Sum(v => v.GetProperty("byteLength").GetInt32()));
        Assert.Equal(36, json.GetProperty("accessors")[0].GetProperty("count").GetInt32());
        Assert.Equal("[0,0,0]", json.GetProperty("accessors")[1].GetProperty("min").GetRawText());
        Assert.Equal(3, json.GetProperty("meshes")[0].GetProperty("primitives")[0].GetProperty("attributes").GetProperty("COLOR_0").GetInt32());
        int positions = 20 + jsonLength + 8 + 36 * 4;
        Assert.Equal(1f, BitConverter.ToSingle(glb, positions + 12));
        for (int v = 0; v < 8; v++)
        {
            int normal = positions + 96 + 12 * v;
            double length = Math.Sqrt(Enumerable.Range(0, 3).Sum(k => Math.Pow(BitConverter.ToSingle(glb, normal + 4 * k), 2)));
            Assert.Equal(1, length, 6);
        }
    }

    [Fact]
    public void ToMesh_WrongSizes_NamesThem()
    {
        MeshData data = ReadData(CubeObj, MeshFormat.Obj);
        data.VertexNormals = new MeshLab.Numerics.Vector3D[3];
        Assert.Contains("VertexNormals", Assert.Throws<ArgumentException>(() => data.ToMesh()).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => MeshFile.Write(null!, "a.obj"));
        Assert.Throws<ArgumentNullException>(() => MeshFile.Read((Stream)null!, MeshFormat.Obj));
        Assert.Throws<ArgumentException>(() => MeshFile.Read(new MemoryStream(), MeshFormat.Glb));
    }

    private sealed class Steps(List<double> steps) : IProgress<double>
    {
        public void Report(double value) => steps.Add(value);
    }

    [SkippableFact]
    public void Write_OverAFile_KeepsItsPermissions()
    {
        Skip.If(OperatingSystem.IsWindows(), "Windows has other permissions.");
#pragma warning disable CA1416 // Skipped above.
        File.WriteAllText(PathOf("mine.obj"), "old");
        File.SetUnixFileMode(PathOf("mine.obj"), UnixFileMode.UserRead | UnixFileMode.UserWrite);
        MeshFile.Write(Read(CubeObj, MeshFormat.Obj), PathOf("mine.obj"));
        Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite, File.GetUnixFileMode(PathOf("mine.obj")));
#pragma warning restore CA1416
    }
}
