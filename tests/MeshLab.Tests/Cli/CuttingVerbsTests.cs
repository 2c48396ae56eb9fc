using System.Text.Json;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs split, clip and section, as their JSON and files say it.</summary>
[Trait("Section", "6.2")]
[Trait("Section", "6.5")]
public sealed class CuttingVerbsTests : IDisposable
{
    private readonly CliFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void Split_ThreeShapes_CountsAllPartsAsOutput()
    {
        Mesh mesh = Models.Create("components");
        JsonElement result = CliCall.Json(0, "split", folder.Save(mesh, "three.obj"), folder.PathOf("parts"));
        JsonElement[] parts = [.. result.GetProperty("parts").EnumerateArray()];
        Assert.Equal(3, parts.Length);
        Mesh[] files = [.. parts.Select(part => MeshFile.Read(part.GetProperty("file").GetString()!))];
        JsonElement output = result.GetProperty("output");
        Assert.Equal(files.Sum(part => part.Vertices.Count), output.GetProperty("vertices").GetInt32());
        Assert.Equal(mesh.Edges.Count, output.GetProperty("edges").GetInt32());
        Assert.Equal(mesh.Faces.Count, output.GetProperty("faces").GetInt32());
        Assert.Equal(files.Select(part => part.Faces.Count), parts.Select(part => part.GetProperty("faces").GetInt32()));
    }

    [Theory]
    [InlineData("0,0,0,1", "The normal (0, 0, 0) of a plane must be finite and not zero.")]
    [InlineData("0,NaN,1,1", "The normal (0, NaN, 1) of a plane must be finite and not zero.")]
    [InlineData("0,0,1,NaN", "The offset NaN of a plane must be finite.")]
    [InlineData("0,0,1", "expected four numbers nx,ny,nz,d")]
    public void Plane_ThatIsNone_IsToldWithoutNamesOfParameters(string plane, string message)
    {
        string cube = folder.Save("cube");
        foreach (string[] verb in (string[][])[["section", cube], ["clip", cube, folder.PathOf("out.obj")]])
        {
            CliCall call = CliCall.Run([.. verb, "--plane", plane, "--json"]);
            Assert.Equal(2, call.Status);
            Assert.Equal("usage", call.ErrorObject().GetProperty("kind").GetString());
            Assert.Equal($"--plane {plane}: {message}", call.ErrorObject().GetProperty("message").GetString());
        }
        Assert.Equal(["cube.obj"], folder.Files());
    }

    [Fact]
    public void Section_ThatMisses_IsEmptyAndNoError()
    {
        JsonElement result = CliCall.Json(0, "section", folder.Save("cube"), "--plane", "0,0,1,9");
        Assert.Equal((0, 0, 0), (result.GetProperty("segments").GetInt32(), result.GetProperty("closedLoops").GetInt32(), result.GetProperty("openChains").GetInt32()));
        Assert.Equal((0.0, 0.0), (result.GetProperty("length").GetDouble(), result.GetProperty("area").GetDouble()));
    }
}
