using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.Generation;
using MeshLab.IO;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs generate and subdivide, as their JSON and files say it.</summary>
[Trait("Section", "2")]
[Trait("Section", "8")]
public sealed class ShapeVerbsTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab-shapes").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [Fact]
    public void Generate_Torus_WritesItAndNamesItsParameters()
    {
        string path = Path.Combine(folder, "torus.off");

        JsonElement result = Run(0, "generate", "torus", path, "--m", "9", "--n", "7", "--quads", "1");

        Assert.Equal(63, result.GetProperty("output").GetProperty("faces").GetInt32());
        Assert.Equal(9, result.GetProperty("parameters").GetProperty("m").GetInt32());
        Assert.Equal(0.4, result.GetProperty("parameters").GetProperty("minor").GetDouble());
        Assert.Equal(Tori.Torus(m: 9, n: 7, faces: PatchFaces.Quads).Positions.ToArray(), MeshFile.Read(path).Positions.ToArray());
    }

    [Fact]
    public void Generate_List_NamesEveryShape()
    {
        JsonElement result = Run(0, "generate", "--list");

        string[] kinds = [.. result.GetProperty("kinds").EnumerateArray().Select(kind => kind.GetProperty("kind").GetString()!)];
        Assert.Equal([.. ShapeCatalog.Shapes.Select(shape => shape.Name)], kinds);
    }

    [Fact]
    public void Generate_BadInput_IsToldByStatusAndKind()
    {
        string path = Path.Combine(folder, "x.obj");
        Assert.Equal("usage", Error(2, "generate", "donut", path));
        Assert.Equal("usage", Error(2, "generate", "torus"));
        Assert.Equal("usage", Error(2, "generate", "torus", path, "--genus", "3"));
        Assert.Equal("usage", Error(2, "generate", "polygon", path, "--n", "2"));
        Assert.Equal("refused", Error(1, "generate", "moebius", path));
        Assert.False(File.Exists(path));
        Assert.NotEqual(0, Run(0, "generate", "moebius", path, "--non-manifold", "split").GetProperty("repairs").GetArrayLength());
    }

    [Fact]
    public void Subdivide_EveryScheme_WritesWhatTheLibraryMakes()
    {
        string input = Path.Combine(folder, "cube.obj"), output = Path.Combine(folder, "fine.obj");
        MeshFile.Write(Prisms.Cube(), input);
        Mesh cube = MeshFile.Read(input);
        foreach ((string name, SubdivisionScheme scheme) in new[]
        {
            ("loop", SubdivisionScheme.Loop), ("butterfly", SubdivisionScheme.ModifiedButterfly), ("sqrt3", SubdivisionScheme.Sqrt3),
            ("catmull-clark", SubdivisionScheme.CatmullClark), ("doo-sabin", SubdivisionScheme.DooSabin), ("midpoint", SubdivisionScheme.Midpoint),
        })
        {
            JsonElement result = Run(0, "subdivide", input, output, "--scheme", name, "--steps", "2");
            Mesh expected = cube.Subdivide(scheme, new SubdivisionOptions { Steps = 2 });
            Assert.Equal(12, result.GetProperty("input").GetProperty("faces").GetInt32());
            Assert.Equal(expected.Faces.Count, result.GetProperty("output").GetProperty("faces").GetInt32());
            Assert.Equal(expected.Positions.ToArray(), MeshFile.Read(output).Positions.ToArray());
        }
        Run(0, "subdivide", input, output, "--scheme", "loop-warren", "--limit");
        Mesh limit = LoopSubdivision.Subdivide(cube, new SubdivisionOptions { Weights = LoopWeights.Warren });
        Assert.Equal(LimitSurface.OfLoop(limit, LoopWeights.Warren).Positions, MeshFile.Read(output).Positions.ToArray());
        Assert.Equal(12, Run(0, "subdivide", input, output, "--crease-angle", "60").GetProperty("creases").GetInt32());
    }

    [Fact]
    public void Subdivide_BadInput_IsToldByStatusAndKind()
    {
        string input = Path.Combine(folder, "quads.obj"), output = Path.Combine(folder, "fine.obj");
        MeshFile.Write(Polyhedra.Cube(), input);
        Assert.Equal("refused", Error(1, "subdivide", input, output, "--scheme", "loop"));
        Assert.Equal("usage", Error(2, "subdivide", input, output, "--scheme", "cubic"));
        Assert.Equal("usage", Error(2, "subdivide", input, output, "--scheme", "sqrt3", "--limit"));
        Assert.Equal("usage", Error(2, "subdivide", input, output, "--scheme", "catmull-clark", "--steps", "-1"));
        Assert.Equal("refused", Error(1, "subdivide", input, output, "--scheme", "catmull-clark", "--steps", "40"));
        Assert.False(File.Exists(output));
    }

    private static string? Error(int exitStatus, params string[] arguments) =>
        Run(exitStatus, arguments).GetProperty("error").GetProperty("kind").GetString();

    private static JsonElement Run(int status, params string[] args)
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        int actual = MlabApp.Run([.. args, "--json"], output, error);
        Assert.True(status == actual, $"{string.Join(' ', args)}: exit status {actual}. {error}");
        using JsonDocument document = JsonDocument.Parse(output.ToString());
        return document.RootElement.Clone();
    }
}
