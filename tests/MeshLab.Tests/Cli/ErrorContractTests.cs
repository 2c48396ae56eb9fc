using System.Globalization;
using System.Text.Json;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>Exit statuses, error objects, and what is left behind by a call that fails.</summary>
[Trait("Section", "command line")]
public sealed class ErrorContractTests : IDisposable
{
    private const string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

    // Three faces at the edge of the vertices 0 and 1.
    private const string Fins = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";

    private readonly CliFolder folder = new();

    public void Dispose() => folder.Dispose();

    public static TheoryData<string> WrongUsage =>
    [
        "",
        "dance",
        "info",
        "info {mesh} --sideways",
        "info {mesh} {mesh}",
        "info -",
        "info mesh.unknown",
        "info {mesh} --input-format word",
        "info {mesh} --threads -1",
        "info {mesh} --threads many",
        "info {mesh} --non-manifold maybe",
        "convert {mesh}",
        "convert {mesh} {out}.unknown",
        "convert {mesh} {out}.ply --ascii --binary",
        "convert {mesh} -",
        "generate",
        "generate no-such-shape {out}.obj",
        "generate torus",
        "generate torus {out}.obj --n 2.5e",
        "values {mesh}",
        "values {mesh} --of beauty",
        "values {mesh} --of geodesic-edges --from 99",
        "values {mesh} --of geodesic-edges --from -2",
        "values {mesh} --of harmonic --fixed 1",
        "values {mesh} --of harmonic --fixed 1=x",
        "values {mesh} --of harmonic --fixed 99=1",
        "rings {mesh}",
        "rings {mesh} --vertex 0 --face 0",
        "rings {mesh} --vertex 3",
        "rings {mesh} --edge -1",
        "rings {mesh} --vertex 0 --k -1",
        "cut {mesh} {out}.obj",
        "cut {mesh} {out}.obj --to-disk --edges list.txt",
        "render {mesh} {out}.jpg",
        "render {mesh} {out}.png --size 10",
        "render {mesh} {out}.png --size 0x10",
        "render {mesh} {out}.png --view 1",
        "render {mesh} {out}.png --values beauty",
        "smooth {mesh} {out}.obj --method magic",
        "smooth {mesh} {out}.obj --steps -1",
        "distance {mesh}",
        "distance {mesh} {mesh} --samples 0",
        "completion fish",
    ];

    [Theory]
    [MemberData(nameof(WrongUsage))]
    public void Run_WrongUsage_HasStatus2AndLeavesNothing(string line)
    {
        JsonElement error = Fail(2, line);
        Assert.Equal("usage", error.GetProperty("kind").GetString());
    }

    public static TheoryData<string, string> Unreadable => new()
    {
        { "info nowhere/at-all.obj", "io" },
        { "info {folder}/folder.obj", "io" },
        { "info {broken}", "format" },
        { "validate {binary}", "format" },
        { "boundary {fins}", "topology" },
        { "convert {mesh} {folder}/no/such/folder.obj", "io" },
        { "convert {mesh} {folder}/folder.obj", "io" },
        { "cut {mesh} {out}.obj --edges nowhere.txt", "io" },
        { "cut {mesh} {out}.obj --edges {broken}", "format" },
        { "render {mesh} {out}.png --labels {broken}", "format" },
        { "distance {mesh} {broken}", "format" },
    };

    [Theory]
    [MemberData(nameof(Unreadable))]
    public void Run_UnreadableFile_HasStatus3AndLeavesNothing(string line, string kind)
    {
        JsonElement error = Fail(3, line);
        Assert.Equal(kind, error.GetProperty("kind").GetString());
    }

    [Fact]
    public void Run_DamagedFile_NamesFileLineAndColumn()
    {
        string file = folder.Text("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
        CliCall call = CliCall.Run("info", file, "--json");
        JsonElement error = call.ErrorObject();
        Assert.Equal(3, call.Status);
        Assert.Equal(file, error.GetProperty("file").GetString());
        Assert.Equal(4, error.GetProperty("line").GetInt32());
        Assert.Equal(7, error.GetProperty("column").GetInt32());
        Assert.StartsWith($"{file}:4:7: ", error.GetProperty("message").GetString(), StringComparison.Ordinal);
        Assert.StartsWith($"{file}:4:7: ", call.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_NotAManifold_NamesTheElements()
    {
        string file = folder.Text("fins.obj", Fins);
        JsonElement error = CliCall.Run("info", file, "--json").ErrorObject();
        Assert.Equal("topology", error.GetProperty("kind").GetString());
        Assert.Equal(file, error.GetProperty("file").GetString());
        Assert.Contains(error.GetProperty("elements").EnumerateArray(), element => element.GetString() is ['f' or 'v' or 'e', ..]);
    }

    [Theory]
    [InlineData("skip", "skipped-face", 2)]
    [InlineData("split", "split-vertex", 3)]
    public void Run_NonManifoldPolicy_ListsTheRepairs(string policy, string kind, int faces)
    {
        JsonElement info = CliCall.Json(0, "info", folder.Text("fins.obj", Fins), "--non-manifold", policy);
        Assert.Equal(faces, info.GetProperty("faces").GetInt32());
        JsonElement[] repairs = [.. info.GetProperty("repairs").EnumerateArray()];
        Assert.NotEmpty(repairs);
        Assert.All(repairs, repair =>
        {
            Assert.Equal(kind, repair.GetProperty("kind").GetString());
            Assert.False(string.IsNullOrEmpty(repair.GetProperty("element").GetString()));
            Assert.False(string.IsNullOrEmpty(repair.GetProperty("message").GetString()));
        });
    }

    [Theory]
    [InlineData("values {points} --of geodesic-edges", "no vertex")]
    [InlineData("distance {mesh} {points}", "without faces")]
    [InlineData("values {quad} --of cotangent", "f0")]
    [InlineData("values {quad} --of harmonic", "f0")]
    public void Run_OperationRefused_HasStatus1(string line, string reason)
    {
        JsonElement error = Fail(1, line);
        Assert.Equal("refused", error.GetProperty("kind").GetString());
        Assert.Contains(reason, error.GetProperty("message").GetString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_Cancelled_HasStatus130AndLeavesNothing()
    {
        string mesh = folder.Save("bumpy-sphere");
        foreach (string[] args in (string[][])[["convert", mesh, folder.PathOf("out.ply")], ["smooth", mesh, folder.PathOf("out.obj")]])
        {
            CliCall call = CliCall.Run(new CancellationToken(canceled: true), [.. args, "--json"]);
            Assert.Equal(130, call.Status);
            Assert.Equal("cancelled", call.ErrorObject().GetProperty("kind").GetString());
            Assert.Equal(["bumpy-sphere.obj"], folder.Files());
        }
    }

    [Fact]
    public void Run_FailureBeforeWriting_KeepsTheOldOutput()
    {
        string output = folder.Text("out.obj", "# old\n");
        Assert.Equal(3, CliCall.Run("convert", folder.Text("bad.obj", "f 1 2 9\n"), output).Status);
        Assert.Equal("# old\n", File.ReadAllText(output));
    }

    [Fact]
    public void Run_Debug_ShowsTheStackTraceAndNothingElseDoes()
    {
        string bad = folder.Text("bad.obj", "f 1 2 9\n");
        Assert.DoesNotContain("   at ", CliCall.Run("info", bad).Error, StringComparison.Ordinal);
        Assert.Contains("   at ", CliCall.Run("info", bad, "--debug").Error, StringComparison.Ordinal);
    }

    /// <summary>Runs the line with and without <c>--json</c>: the same status, one line on standard error, the files of the folder as before.</summary>
    private JsonElement Fail(int status, string line)
    {
        string[] args =
        [
            .. line
                .Replace("{mesh}", folder.Text("mesh.obj", Triangle), StringComparison.Ordinal)
                .Replace("{broken}", folder.Text("broken.obj", "v 0 0\n"), StringComparison.Ordinal)
                .Replace("{binary}", folder.Text("binary.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nend_header\n"), StringComparison.Ordinal)
                .Replace("{fins}", folder.Text("fins.obj", Fins), StringComparison.Ordinal)
                .Replace("{quad}", folder.Text("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n"), StringComparison.Ordinal)
                .Replace("{points}", folder.Text("points.obj", "v 0 0 0\nv 1 0 0\n"), StringComparison.Ordinal)
                .Replace("{out}", folder.PathOf("out"), StringComparison.Ordinal)
                .Replace("{folder}", folder.Root, StringComparison.Ordinal)
                .Split(' ', StringSplitOptions.RemoveEmptyEntries),
        ];
        Directory.CreateDirectory(folder.PathOf("folder.obj"));
        string[] before = folder.Files();

        CliCall plain = CliCall.Run(args), json = CliCall.Run([.. args, "--json"]);

        foreach (CliCall call in (CliCall[])[plain, json])
        {
            Assert.True(status == call.Status, $"{line}: exit status {call.Status.ToString(CultureInfo.InvariantCulture)}. {call.Error}{call.Output}");
            Assert.Single(call.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
            Assert.DoesNotContain("Exception", call.Error, StringComparison.Ordinal);
            Assert.DoesNotContain("(Parameter", call.Error, StringComparison.Ordinal);
        }
        Assert.Equal("", plain.Output);
        Assert.Equal(before, folder.Files());
        JsonElement error = json.ErrorObject();
        Assert.Equal(json.Error.TrimEnd(), error.GetProperty("message").GetString());
        return error;
    }
}
