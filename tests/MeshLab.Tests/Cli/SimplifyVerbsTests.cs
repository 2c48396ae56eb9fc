using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs simplify and progressive.</summary>
[Trait("Section", "7.2")]
public sealed class SimplifyVerbsTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab-simplify").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [Theory]
    [InlineData("qem")]
    [InlineData("qem-accurate")]
    [InlineData("qem-textbook")]
    [InlineData("shortest-edge")]
    [InlineData("smallest-triangle")]
    [InlineData("lowest-curvature")]
    public void Simplify_AnyMethod_ReachesTheFaces(string method)
    {
        string input = Save("bumpy-sphere"), output = PathOf("small.obj");

        JsonElement result = Run(0, "simplify", input, output, "--method", method, "--faces", "60");

        Assert.Equal("target-reached", result.GetProperty("stopReason").GetString());
        Assert.True(result.GetProperty("maxError").GetDouble() >= 0);
        Assert.InRange(MeshFile.Read(output).Faces.Count, 59, 60);
        Assert.Equal(MeshFile.Read(output).Faces.Count, result.GetProperty("output").GetProperty("faces").GetInt32());
    }

    [Fact]
    public void Simplify_Clustering_ReportsItsCells()
    {
        string input = Save("bumpy-sphere"), output = PathOf("small.obj");

        JsonElement result = Run(0, "simplify", input, output, "--method", "clustering", "--cells", "4");

        Assert.True(result.GetProperty("cells").GetInt32() > 8);
        Assert.Equal("cells", result.GetProperty("stopReason").GetString());
        Assert.True(result.GetProperty("maxError").GetDouble() > 0);
        Assert.True(result.TryGetProperty("stopReason", out _));
    }

    [Fact]
    public void Simplify_TraceAndRecord_AreWrittenAndTheRecordPlaysBack()
    {
        string input = Save("bumpy-sphere"), output = PathOf("small.obj"), trace = PathOf("steps.ndjson"), record = PathOf("levels.pm");
        Mesh original = MeshFile.Read(input);

        JsonElement result = Run(0, "simplify", input, output, "--ratio", "0.3", "--trace", trace, "--record", record);
        JsonElement level = Run(0, "progressive", record, PathOf("level.obj"), "--faces", "120");
        Run(0, "progressive", record, PathOf("finest.obj"));

        Assert.Equal(result.GetProperty("collapses").GetInt32(), File.ReadAllLines(trace).Length);
        Assert.InRange(MeshFile.Read(PathOf("level.obj")).Faces.Count, 119, 120);
        Assert.Equal(original.Faces.Count, level.GetProperty("maxFaces").GetInt32());
        Assert.Equal(original.StateHash(), MeshFile.Read(PathOf("finest.obj")).StateHash());
    }

    [Theory]
    [InlineData("--faces", "0")]
    [InlineData("--faces", "100000")]
    [InlineData("--ratio", "1.5")]
    [InlineData("--max-error", "-1")]
    [InlineData("--cell-size", "1")]
    [InlineData("--method", "clustering")]
    [InlineData("--method", "magic")]
    public void Simplify_BadArguments_IsWrongUsage(string option, string value)
    {
        string output = PathOf("small.obj");

        Assert.Equal(2, Call("simplify", Save("bumpy-sphere"), output, option, value).Status);

        Assert.False(File.Exists(output));
    }

    [Fact]
    public void Progressive_DamagedFile_CannotBeRead()
    {
        File.WriteAllText(PathOf("bad.pm"), "MLPMno");

        Assert.Equal(3, Call("progressive", PathOf("bad.pm"), PathOf("level.obj")).Status);
    }

    private string PathOf(string name) => Path.Combine(folder, name);

    private string Save(string model)
    {
        string path = Path.Combine(folder, model + ".obj");
        MeshFile.Write(Models.Create(model), path);
        return path;
    }

    private static JsonElement Run(int status, params string[] args)
    {
        (int actual, string output, string error) = Call(args);
        Assert.True(status == actual, $"{string.Join(' ', args)}: exit status {actual}. {error}");
        using JsonDocument document = JsonDocument.Parse(output);
        return document.RootElement.Clone();
    }

    private static (int Status, string Output, string Error) Call(params string[] args)
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        int status = MlabApp.Run([.. args, "--json"], output, error);
        return (status, output.ToString(), error.ToString());
    }
}
