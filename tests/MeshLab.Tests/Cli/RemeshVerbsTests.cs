using System.Text.Json;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs distance and remesh, as their JSON says it.</summary>
[Trait("Section", "7.4")]
[Trait("Section", "L4")]
public sealed class RemeshVerbsTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab-remesh").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [Fact]
    public void Distance_MovedCopy_HasTheFieldsOfTheContract()
    {
        Mesh mesh = Models.Create("grid");
        string a = Save(mesh, "a.obj");
        foreach (Vertex v in mesh.Vertices)
            v.Position += new MeshLab.Numerics.Vector3D(0, 0, 0.5);
        JsonElement result = Run(0, "distance", a, Save(mesh, "b.obj"), "--samples", "1000", "--seed", "7");
        foreach (string way in new[] { "forward", "backward" })
        {
            foreach (string name in new[] { "mean", "rms", "max" })
                Assert.Equal(0.5, result.GetProperty(way).GetProperty(name).GetDouble(), 1e-12);
        }
        Assert.Equal(0.5, result.GetProperty("hausdorff").GetDouble(), 1e-12);
        Assert.Equal(mesh.BoundingBox.Diagonal, result.GetProperty("diagonal").GetDouble(), 1e-12);
    }

    [Theory]
    [InlineData("--relative", "0.7")]
    [InlineData("--edge-length", "0.3")]
    [InlineData("--feature-angle", "30")]
    [InlineData("--laboratory", null)]
    [InlineData("--no-projection", null)]
    public void Remesh_Options_WriteAMeshAndItsFigures(string option, string? value)
    {
        string output = Path.Combine(folder, "out.obj");
        string[] options = value is null ? [option] : [option, value];
        JsonElement result = Run(0, ["remesh", Save(Models.Create("torus"), "in.obj"), output, .. options]);

        Mesh mesh = MeshFile.Read(output);
        Assert.Empty(mesh.Validate());
        Assert.Equal(mesh.Faces.Count, result.GetProperty("output").GetProperty("faces").GetInt32());
        Assert.True(result.GetProperty("edgeLength").GetDouble() > 0);
        Assert.Equal(mesh.Vertices.Count, result.GetProperty("valence").GetProperty("histogram").EnumerateObject().Sum(p => p.Value.GetInt32()));
        Assert.InRange(result.GetProperty("angle").GetProperty("min").GetDouble(), 0, result.GetProperty("angle").GetProperty("mean").GetDouble());
        Assert.InRange(result.GetProperty("angle").GetProperty("mean").GetDouble(), 0.5, Math.PI / 3);
    }

    [Theory]
    [InlineData("remesh", "passes-done")]
    [InlineData("remesh", "passes-done", "--laboratory")]
    [InlineData("five-six-seven", "reached")]
    [InlineData("five-six-seven", "reached", "--textbook")]
    [InlineData("subdivide", "steps-done", "--steps", "2")]
    public void Trace_IsWrittenAndTheStopReasonSaid(string verb, string stopReason, params string[] options)
    {
        string trace = Path.Combine(folder, "steps.ndjson");
        JsonElement result = Run(0, [verb, Save(Models.Create("bumpy-sphere"), "in.obj"), Path.Combine(folder, "out.obj"), "--trace", trace, .. options]);
        Assert.Equal(stopReason, result.GetProperty("stopReason").GetString());
        string[] lines = File.ReadAllLines(trace);
        Assert.True(lines.Length >= 2);
        for (int i = 0; i < lines.Length; i++)
            Assert.Equal(i, JsonDocument.Parse(lines[i]).RootElement.GetProperty("step").GetInt32());
    }

    [Theory]
    [InlineData("--feature-angle 200: not in (0, 180]", "remesh", "--feature-angle", "200")]
    [InlineData("--relative 0: not a positive number", "remesh", "--relative", "0")]
    [InlineData("--iterations 0: not positive", "remesh", "--iterations", "0")]
    [InlineData("exclude each other", "remesh", "--edge-length", "1", "--relative", "2")]
    [InlineData("--feature-angle does not go with --laboratory", "remesh", "--laboratory", "--feature-angle", "30")]
    [InlineData("--curvature-tolerance does not go with --laboratory", "remesh", "--laboratory", "--curvature-tolerance", "0.1")]
    [InlineData("--crease-angle NaN: not in [0, 180]", "subdivide", "--crease-angle", "NaN")]
    [InlineData("--crease-angle -5: not in [0, 180]", "subdivide", "--crease-angle", "-5")]
    [InlineData("--feature-angle 200: not in [0, 180]", "five-six-seven", "--feature-angle", "200")]
    [InlineData("--faces -5: not positive", "five-six-seven", "--faces", "-5")]
    public void BadOption_IsWrongUsageAndNamed(string message, string verb, params string[] options) => Assert.Contains(
        message,
        Run(2, [verb, Save(Models.Create("cube"), "in.obj"), Path.Combine(folder, "out.obj"), .. options]).GetProperty("error").GetProperty("message").GetString(),
        StringComparison.Ordinal);

    [Theory]
    [InlineData("at least 20 faces", "sphere", "five-six-seven", "--faces", "18")]
    [InlineData("14 of 40 steps would make", "cube", "subdivide", "--steps", "40", "--scheme", "sqrt3")]
    [InlineData("the budget is 50000000", "cube", "remesh", "--edge-length", "1e-9")]
    [InlineData("f0 has 4 corners", "cube-quads", "five-six-seven")]
    public void WhatTheMeshForbids_IsRefusedWithStatus1AndNothingWritten(string message, string model, string verb, params string[] options)
    {
        string output = Path.Combine(folder, "out.obj");
        JsonElement error = Run(1, [verb, Save(Models.Create(model), "in.obj"), output, .. options]).GetProperty("error");
        Assert.Equal("refused", error.GetProperty("kind").GetString());
        Assert.Contains(message, error.GetProperty("message").GetString(), StringComparison.Ordinal);
        Assert.False(File.Exists(output));
    }

    [Fact]
    public void FiveSixSeven_OfAMeshWithoutFaces_HasNothingToDo()
    {
        JsonElement result = Run(0, "five-six-seven", Save(new Mesh(), "in.off"), Path.Combine(folder, "out.off"));
        Assert.Equal("nothing-to-do", result.GetProperty("stopReason").GetString());
        Assert.Equal(0, result.GetProperty("hausdorff").GetDouble());
    }

    [Fact]
    public void Remesh_RelativeLengthInTheLaboratory_IsTaken()
    {
        string input = Save(Models.Create("torus"), "in.obj"), output = Path.Combine(folder, "out.obj");
        double mean = Run(0, "remesh", input, output, "--laboratory").GetProperty("edgeLength").GetDouble();
        Assert.Equal(2 * mean, Run(0, "remesh", input, output, "--laboratory", "--relative", "2").GetProperty("edgeLength").GetDouble(), 1e-12);
    }

    [Fact]
    public void Remesh_WrongUsage_HasStatus2() =>
        Run(2, "remesh", Save(Models.Create("torus"), "in.obj"), Path.Combine(folder, "out.obj"), "--relative", "-1");

    private string Save(Mesh mesh, string name)
    {
        string path = Path.Combine(folder, name);
        MeshFile.Write(mesh, path);
        return path;
    }

    private static JsonElement Run(int status, params string[] args) => CliCall.Json(status, args);
}
