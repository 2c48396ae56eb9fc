using System.Text.Json;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verb smooth, and the values harmonic and geodesic-edges.</summary>
[Trait("Section", "12.5")]
public sealed class SolverVerbsTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab-solver").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [Theory]
    [InlineData("uniform", 10)]
    [InlineData("cotangent", 10)]
    [InlineData("taubin", 10)]
    [InlineData("implicit", 1)]
    public void Smooth_AnyMethod_WritesTheSmoothedMesh(string method, int steps)
    {
        string input = Save("bumpy-sphere"), output = Path.Combine(folder, "smooth.obj");

        JsonElement result = Run(0, "smooth", input, output, "--method", method);

        Assert.Equal(steps, result.GetProperty("steps").GetInt32());
        Assert.Equal(result.GetProperty("input").GetProperty("faces").GetInt32(), result.GetProperty("output").GetProperty("faces").GetInt32());
        Mesh before = MeshFile.Read(input), after = MeshFile.Read(output);
        double largest = before.Vertices.Max(v => Vector3D.Distance(v.Position, after.Vertices[v.Index].Position));
        Assert.Equal(largest, result.GetProperty("largestMove").GetDouble(), 1e-12);
    }

    [Fact]
    public void Smooth_BadArguments_IsWrongUsage()
    {
        string input = Save("bumpy-sphere"), output = Path.Combine(folder, "smooth.obj");
        Assert.Equal(2, CliCall.Run("smooth", input, output, "--steps", "-1").Status);
        Assert.Equal(2, CliCall.Run("smooth", input, output, "--method", "magic").Status);
        Assert.Equal(2, CliCall.Run("smooth", input, output, "--time", "0").Status);
        Assert.False(File.Exists(output));
    }

    [Fact]
    public void Values_Harmonic_TakesTheLargestComponentUnlessVerticesAreGiven()
    {
        string input = Save("components");

        double[] height = ReferenceData.Numbers(Run(0, "values", input, "--of", "harmonic").GetProperty("values"));
        Assert.All(height.Take(30), value => Assert.InRange(value, 0, 1));
        Assert.All(height.Skip(30), value => Assert.Equal(double.NaN, value));

        double[] given = ReferenceData.Numbers(Run(0, "values", input, "--of", "harmonic", "--fixed", "30=10,31=100").GetProperty("values"));
        Assert.Equal(10, given[30]);
        Assert.Equal(100, given[31]);
        Assert.Equal(55, given[32], 1e-12);
        Assert.Equal(double.NaN, given[0]);
        Assert.Equal(2, CliCall.Run("values", input, "--of", "harmonic", "--fixed", "9999=1").Status);
    }

    [Fact]
    public void Values_EdgeDistances_StartAtTheGivenVertex()
    {
        double[] distances = ReferenceData.Numbers(Run(0, "values", Save("components"), "--of", "geodesic-edges", "--from", "31").GetProperty("values"));

        Assert.Equal(0, distances[31]);
        Assert.Equal(0.4 * Math.Sqrt(2), distances[32], 1e-12);
        Assert.Equal(double.PositiveInfinity, distances[0]);
    }

    private string Save(string model)
    {
        string path = Path.Combine(folder, model + ".obj");
        MeshFile.Write(Models.Create(model), path);
        return path;
    }

    private static JsonElement Run(int status, params string[] args) => CliCall.Json(status, args);
}
