using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Visualization;
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

    public static TheoryData<string, QuadricOptions> Options
    {
        get
        {
            var half = new QuadricOptions { TargetRatio = 0.3 };
            return new()
            {
                { "--method qem-accurate", half with { Mode = QuadricMode.Accurate } },
                { "--method qem-textbook", half with { Mode = QuadricMode.Textbook } },
                { "--max-error 0.001", new QuadricOptions { MaxError = 0.001 } },
                { "--boundary free", half with { Boundary = BoundaryTreatment.Free } },
                { "--boundary locked", half with { Boundary = BoundaryTreatment.Locked } },
                { "--boundary-weight 0.01", half with { BoundaryWeight = 0.01 } },
                { "--allow-flips", half with { AllowFlips = true } },
                { "--feature-angle 10", half with { FeatureAngle = double.DegreesToRadians(10) } },
                { "--placement segment", half with { Placement = VertexPlacement.Segment } },
                { "--placement endpoint", half with { Placement = VertexPlacement.Endpoint } },
                { "--no-area-weights", half with { AreaWeights = false } },
                { "--ignore-seams", half with { KeepTextureSeams = false } },
                { "--ignore-labels", half with { KeepLabelBorders = false } },
            };
        }
    }

    /// <summary>An uneven, crumpled sheet with a seam down the middle and two materials across it.</summary>
    private string SaveSheet()
    {
        var random = new Random(3);
        Mesh mesh = Simplification.Shapes.Sheet(12, (x, y) => 0.2 * random.NextDouble() * x);
        HalfEdgeTrait<Vector2D> texture = mesh.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear);
        FaceLabels labels = mesh.GetOrAddFaceLabels("material");
        foreach (Face f in mesh.Faces)
        {
            Vector3D center = f.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / 3;
            labels.Labels[f] = labels.Number(center.Y > 0.5 ? "upper" : "lower");
            foreach (HalfEdge h in f.HalfEdges)
                texture[h] = new(h.Target.Position.X + (center.X > 0.5 ? 5 : 0), h.Target.Position.Y);
        }
        foreach (Vertex v in mesh.Vertices)
            v.Position = new(v.Position.X * v.Position.X + 0.1 * v.Position.X, v.Position.Y, v.Position.Z);
        string path = PathOf("sheet.obj");
        MeshFile.Write(mesh, path);
        return path;
    }

    [Theory]
    [MemberData(nameof(Options))]
    public void Simplify_Option_IsThatOfTheLibrary(string option, QuadricOptions options)
    {
        string input = SaveSheet(), output = PathOf("small.obj");
        Mesh expected = MeshFile.Read(input), plain = MeshFile.Read(input);
        expected.Simplify(options);
        plain.Simplify(new() { TargetRatio = 0.3 });

        string[] target = options.TargetRatio is null ? [] : ["--ratio", "0.3"];
        Run(0, ["simplify", input, output, .. target, .. option.Split(' ')]);

        Assert.Equal(expected.Positions.ToArray(), MeshFile.Read(output).Positions.ToArray());
        Assert.NotEqual(plain.Positions.ToArray(), expected.Positions.ToArray());
    }

    [Theory]
    [InlineData("--placement", "endpoint")]
    [InlineData("--boundary-weight", "2")]
    [InlineData("--no-area-weights", null)]
    [InlineData("--ignore-seams", null)]
    [InlineData("--ignore-labels", null)]
    public void Simplify_OptionOfAnotherMethod_IsWrongUsage(string option, string? value)
    {
        string[] more = value is null ? [option] : [option, value];
        Assert.Equal(2, Call(["simplify", Save("bumpy-sphere"), PathOf("small.obj"), "--ratio", "0.5", "--method", "shortest-edge", .. more]).Status);
    }

    [Fact]
    public void Distance_Colors_ShowTheDistanceOfEveryVertex()
    {
        string input = Save("bumpy-sphere"), small = PathOf("small.obj"), colored = PathOf("error.ply");
        Run(0, "simplify", input, small, "--ratio", "0.1");

        JsonElement result = Run(0, "distance", input, small, "--samples", "100", "--colors", colored);

        Mesh mesh = MeshFile.Read(colored), original = MeshFile.Read(input);
        double[] distances = original.VertexDistancesTo(MeshFile.Read(small));
        VertexTrait<Color> colors = mesh.GetOrAddVertexTrait<Color>(TraitNames.Color, default);
        Assert.Equal(distances.Max(), result.GetProperty("farthestVertex").GetDouble());
        Assert.Equal(original.Positions.ToArray(), mesh.Positions.ToArray());
        foreach (Vertex v in mesh.Vertices)
        {
            Color expected = ColorMap.Viridis.Sample(distances[v.Index] / distances.Max());
            Assert.Equal(expected.R, colors[v].R, 0.003);
            Assert.Equal(expected.G, colors[v].G, 0.003);
            Assert.Equal(expected.B, colors[v].B, 0.003);
        }
    }

    [Theory]
    [InlineData("--faces", "0")]
    [InlineData("--faces", "100000")]
    [InlineData("--ratio", "1.5")]
    [InlineData("--max-error", "-1")]
    [InlineData("--boundary-weight", "-1")]
    [InlineData("--placement", "nowhere")]
    [InlineData("--cell-size", "1")]
    [InlineData("--method", "clustering")]
    [InlineData("--method", "magic")]
    [InlineData("--faces", "100", "--ratio", "0.5")]
    [InlineData("--method", "clustering", "--cells", "4", "--cell-size", "0.1")]
    [InlineData("--method", "clustering", "--cells", "4", "--faces", "100")]
    public void Simplify_BadArguments_IsWrongUsage(params string[] options)
    {
        string output = PathOf("small.obj");

        Assert.Equal(2, Call(["simplify", Save("bumpy-sphere"), output, .. options]).Status);

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
