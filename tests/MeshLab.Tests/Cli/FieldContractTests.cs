using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.IO;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>Every field that the contract names is there, of the right kind; streams, help and examples.</summary>
[Trait("Section", "command line")]
public sealed class FieldContractTests : IDisposable
{
    private readonly CliFolder folder = new();

    public void Dispose() => folder.Dispose();

    // A path: [] goes into every item of an array, which has at least one.
    public static TheoryData<string, string> Fields => new()
    {
        {
            "info {mesh}",
            "vertices edges faces halfEdges isolatedVertices components boundaryLoops boundaryEdges eulerCharacteristic genus isClosed isTriangleMesh faceDegrees.3 area volume " +
            "centroidSurface[] centroidVolume[] boundingBox.min[] boundingBox.max[] boundingBox.diagonal edgeLength.min edgeLength.mean edgeLength.max " +
            "valence.min valence.mean valence.max valence.histogram.6 angleDefectSum dihedral.min dihedral.max"
        },
        { "validate {mesh}", "valid violations" },
        { "convert {mesh} {out}.ply", "output.vertices output.edges output.faces" },
        { "generate torus {out}.obj", "parameters output.vertices output.edges output.faces" },
        { "dual {mesh} {out}.obj", "output.faces" },
        { "values {mesh} --of valence", "element count components values[] skipped zeroAreaFaces" },
        { "values {mesh} --of length", "element count components pairs[][] values[] skipped zeroAreaFaces" },
        { "rings {mesh} --vertex 9 --k 2", "vertices[] spokeEdges[] linkEdges[] faces[] ring[] disk[]" },
        { "rings {mesh} --edge 9", "vertices[] loopEdges[] faces[]" },
        { "rings {mesh} --face 9", "facesSharingVertex[] facesSharingEdge[] vertices[] ringEdges[]" },
        { "boundary {mesh}", "loops[].vertices[] loops[].length" },
        { "cut {mesh} {out}.obj --to-disk", "components boundaryLoops genus output.faces" },
        { "distance {mesh} {mesh} --samples 100", "forward.mean forward.rms forward.max backward.mean backward.rms backward.max hausdorff diagonal" },
        { "remesh {mesh} {out}.obj", "edgeLength valence angle.min angle.mean output.faces" },
        { "smooth {mesh} {out}.obj", "output.vertices" },
        {
            "topology {mesh} --generators --cut-graph",
            "components[].vertices components[].edges components[].faces components[].eulerCharacteristic components[].boundaryLoops components[].genus generators"
        },
        { "simplify {closed} {out}.obj --faces 100", "stopReason maxError output.faces" },
        { "subdivide {mesh} {out}.obj --scheme loop --steps 1", "output.vertices" },
        { "section {closed} --plane 0,0,1,0.05", "length segments closedLoops openChains area" },
        {
            "morse {closed} --function z --persistence 0.01 --complex",
            "minima saddles maxima indexSum eulerCharacteristic critical[].vertex critical[].kind critical[].multiplicity critical[].value pairs arcs cells"
        },
        { "segment {closed} {out}.obj --method k-means --segments 3", "segments labels[] sizes[] objective" },
        { "render {mesh} {out}.png --size 60x40 --values valence --wireframe --view 10,20", "" },
    };

    [Theory]
    [MemberData(nameof(Fields))]
    public void Json_Verb_HasTheFieldsOfTheContract(string line, string paths)
    {
        string[] args = Arguments(line);
        JsonElement result = CliCall.Json(0, args);

        Assert.Equal(args[0], result.GetProperty("command").GetString());
        Assert.True(result.GetProperty("seconds").GetDouble() >= 0);
        foreach (string path in (string[])["input.vertices", "input.edges", "input.faces", .. paths.Split(' ', StringSplitOptions.RemoveEmptyEntries)])
            Assert.True(Has(result, path.Replace("[]", ".[]", StringComparison.Ordinal).Split('.')), $"{line}: no {path}");
        Assert.Equal(line.Contains("{out}", StringComparison.Ordinal) && !line.Contains(".png", StringComparison.Ordinal), result.TryGetProperty("output", out _));
        Assert.DoesNotContain(folder.Files(), name => name.EndsWith(".tmp", StringComparison.Ordinal));
    }

    [Theory]
    [MemberData(nameof(Fields))]
    public void Run_WithoutJson_SpeaksToPeople(string line, string paths)
    {
        CliCall call = CliCall.Run(Arguments(line));
        Assert.Equal(0, call.Status);
        Assert.Equal("", call.Error);
        Assert.True(paths.Length == 0 || call.Output.Length > 20);
        Assert.DoesNotContain("{\"", call.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Verbs_OfTheseTests_AreAllVerbs()
    {
        string[] tested = [.. Fields.Select(row => ((string)row[0]).Split(' ')[0]).Distinct(StringComparer.Ordinal)];
        // A verb of the contract comes with a row above.
        string[] contract = ["info", "validate", "convert", "generate", "dual", "values", "rings", "boundary", "cut", "distance", "remesh", "smooth", "topology", "render", "simplify", "subdivide", "section", "morse", "segment"];
        Assert.Empty(contract.Except(tested, StringComparer.Ordinal));
        Assert.Empty(contract.Except(MlabApp.Verbs.Select(verb => verb.Name), StringComparer.Ordinal));
    }

    [Fact]
    public void Info_EmptyMesh_WritesWhatIsNotANumberAsText()
    {
        CliCall call = CliCall.Run("info", folder.Text("points.obj", "v 0 0 0\nv 1 0 0\n"), "--json");
        Assert.Equal(0, call.Status);
        Assert.Equal("NaN", call.Object().GetProperty("edgeLength").GetProperty("mean").GetString());
        Assert.Equal(2, call.Object().GetProperty("isolatedVertices").GetInt32());
    }

    [Fact]
    public void Values_UnreachableVertices_AreInfinityAsText()
    {
        JsonElement values = CliCall.Json(0, "values", folder.Save("components"), "--of", "geodesic-edges", "--from", "31").GetProperty("values");
        Assert.Equal("Infinity", values[0].GetString());
    }

    [Fact]
    public void Run_Streams_ReadsAndWritesMeshesNamedMinus()
    {
        byte[] obj = File.ReadAllBytes(folder.Save("torus"));
        using var written = new MemoryStream();
        var streams = new StandardStreams(() => new MemoryStream(obj), () => written);
        using var output = new StringWriter();
        using var error = new StringWriter();

        int status = MlabApp.Run(["convert", "-", "-", "--input-format", "obj", "--output-format", "off", "--json"], output, error, streams);

        Assert.Equal(0, status);
        Assert.Equal("", output.ToString());
        // The mesh has standard output, so the result is on standard error.
        Assert.Equal("convert", new CliCall(0, error.ToString(), "").Object().GetProperty("command").GetString());
        using var back = new MemoryStream(written.ToArray());
        Assert.Equal(Models.Create("torus").StateHash(), MeshFile.Read(back, MeshFormat.Off).StateHash());

        Assert.Equal(0, MlabApp.Run(["info", "-", "--input-format", "obj", "--json"], output, error, streams));
        Assert.Equal(0, new CliCall(0, output.ToString(), "").Object().GetProperty("eulerCharacteristic").GetInt32());
    }

    [Fact]
    public void Convert_MaterialsAndGroups_SurviveOrAreListed()
    {
        string input = folder.Text("full.obj", "mtllib colours.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left\nusemtl red\nf 1 2 3\nusemtl green\nf 1 3 4\nl 1 2\nl 2 3\n");

        JsonElement same = CliCall.Json(0, "convert", input, folder.PathOf("again.obj"));
        Assert.Equal(2, same.GetProperty("ignored").GetProperty("l").GetInt32());
        Assert.False(same.TryGetProperty("leftOut", out _));
        string[] lines = File.ReadAllLines(folder.PathOf("again.obj"));
        Assert.All((string[])["mtllib colours.mtl", "g left", "usemtl red", "usemtl green"], line => Assert.Contains(line, lines, StringComparer.Ordinal));

        CliCall.Json(0, "convert", folder.PathOf("again.obj"), folder.PathOf("through.ply"));
        CliCall.Json(0, "convert", folder.PathOf("through.ply"), folder.PathOf("back.obj"));
        Assert.Equal(lines.Where(line => !line.StartsWith("mtllib", StringComparison.Ordinal)), File.ReadAllLines(folder.PathOf("back.obj")), StringComparer.Ordinal);

        foreach (string name in (string[])["lost.off", "lost.stl", "lost.glb"])
        {
            JsonElement left = CliCall.Json(0, "convert", folder.PathOf("again.obj"), folder.PathOf(name)).GetProperty("leftOut");
            Assert.Equal(2, left.GetProperty("labels of material").GetInt32());
            Assert.Equal(2, left.GetProperty("labels of group").GetInt32());
            Assert.Contains("labels of material", CliCall.Run("convert", folder.PathOf("again.obj"), folder.PathOf(name)).Output, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Run_DamagedStandardInput_IsNamedMinus()
    {
        var streams = new StandardStreams(() => new MemoryStream("v 0 0\n"u8.ToArray()), () => Stream.Null);
        using var output = new StringWriter();
        using var error = new StringWriter();
        Assert.Equal(3, MlabApp.Run(["info", "-", "--input-format", "obj"], output, error, streams));
        Assert.StartsWith("-:1:", error.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_AnyNumberOfThreads_GivesTheSameResult()
    {
        string mesh = folder.Save("bumpy-sphere");
        string[] results = [.. ((string[])["1", "3"]).Select(threads =>
        {
            CliCall call = CliCall.Run("values", mesh, "--of", "mean", "--threads", threads, "--json");
            return call.Object().GetProperty("values").GetRawText();
        })];
        Assert.Equal(results[0], results[1]);
    }

    [Fact]
    public void Help_FromManyThreads_IsThatOfOne()
    {
        string alone = CliCall.Run("values", "--help").Output;
        Parallel.For(0, 400, i =>
        {
            CliCall call = CliCall.Run(i % 2 == 0 ? "values" : "render", "--help");
            Assert.Equal(0, call.Status);
            if (i % 2 == 0)
                Assert.Equal(alone, call.Output);
        });
    }

    public static TheoryData<string> VerbNames => [.. MlabApp.Verbs.Select(verb => verb.Name)];

    [Theory]
    [MemberData(nameof(VerbNames))]
    public void Help_OfEachVerb_ShowsOptionsAndTheExample(string name)
    {
        Verb verb = MlabApp.Verbs.Single(v => v.Name == name);
        CliCall help = CliCall.Run(name, "--help");
        Assert.Equal(0, help.Status);
        Assert.Contains("mlab " + verb.Example, help.Output, StringComparison.Ordinal);
        Assert.Contains(verb.Summary.Split('\n')[0][..20], help.Output, StringComparison.Ordinal);
        Assert.Contains("--json", help.Output, StringComparison.Ordinal);
        Assert.EndsWith(".", verb.Summary, StringComparison.Ordinal);
        Assert.StartsWith(name + " ", verb.Example, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(VerbNames))]
    public void Example_OfEachVerb_Parses(string name)
    {
        string example = MlabApp.Verbs.Single(v => v.Name == name).Example.Split(" >")[0];
        Assert.Empty(MlabApp.BuildRoot((_, _) => { }).Parse(example.Split(' ')).Errors);
        foreach (string word in example.Split(' ').Where(word => word.StartsWith("models/", StringComparison.Ordinal)))
            Assert.True(RepositoryFiles.Exists(word), $"{name}: the example's {word} is not in the repository");
    }

    [Fact]
    public void Help_OfTheProgram_ListsTheVerbs()
    {
        CliCall help = CliCall.Run("--help");
        Assert.Equal(0, help.Status);
        Assert.All(MlabApp.Verbs, verb => Assert.Contains(verb.Name, help.Output, StringComparison.Ordinal));
        Assert.Equal(0, CliCall.Run("--version").Status);
    }

    [Theory]
    [InlineData("bash", "complete -o default")]
    [InlineData("zsh", "compdef")]
    [InlineData("pwsh", "Register-ArgumentCompleter")]
    public void Completion_EachShell_IsAScriptAlone(string shell, string part)
    {
        CliCall call = CliCall.Run("completion", shell);
        Assert.Contains(part, call.Output, StringComparison.Ordinal);
        Assert.Contains(part, CliCall.Json(0, "completion", shell).GetProperty("script").GetString(), StringComparison.Ordinal);
        CliCall suggestions = CliCall.Run("[suggest:8]", "mlab inf");
        Assert.Contains("info", suggestions.Output, StringComparison.Ordinal);
    }

    private string[] Arguments(string line) =>
    [
        .. line.Replace("{mesh}", folder.Save("grid"), StringComparison.Ordinal).Replace("{closed}", folder.Save("bumpy-sphere"), StringComparison.Ordinal).Replace("{out}", folder.PathOf("out"), StringComparison.Ordinal).Split(' '),
    ];

    private static bool Has(JsonElement value, ReadOnlySpan<string> path)
    {
        if (path.IsEmpty)
            return true;
        if (path[0] != "[]")
            return value.ValueKind == JsonValueKind.Object && value.TryGetProperty(path[0], out JsonElement inner) && Has(inner, path[1..]);
        if (value.ValueKind != JsonValueKind.Array || value.GetArrayLength() == 0)
            return false;
        foreach (JsonElement item in value.EnumerateArray())
        {
            if (!Has(item, path[1..]))
                return false;
        }
        return true;
    }
}
