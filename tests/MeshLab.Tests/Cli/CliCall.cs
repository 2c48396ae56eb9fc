using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>What a call of <c>mlab</c> gave: exit status, standard output, standard error.</summary>
internal sealed record CliCall(int Status, string Output, string Error)
{
    /// <summary>Runs the program within the test.</summary>
    public static CliCall Run(params string[] args) => Run(CancellationToken.None, args);

    public static CliCall Run(CancellationToken cancellationToken, params string[] args)
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        int status = MlabApp.Run(args, output, error, cancellationToken);
        return new(status, output.ToString(), error.ToString());
    }

    /// <summary>Runs with <c>--json</c>, expects the status, and returns the one object on standard output.</summary>
    public static JsonElement Json(int status, params string[] args)
    {
        CliCall call = Run([.. args, "--json"]);
        Assert.True(status == call.Status, $"{string.Join(' ', args)}: exit status {call.Status}. {call.Error}{call.Output}");
        return call.Object();
    }

    /// <summary>Standard output as one JSON object on one line, with nothing before or behind it.</summary>
    public JsonElement Object()
    {
        Assert.EndsWith(Environment.NewLine, Output, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', Output.TrimEnd());
        using JsonDocument document = JsonDocument.Parse(Output);
        Assert.Equal(JsonValueKind.Object, document.RootElement.ValueKind);
        return document.RootElement.Clone();
    }

    /// <summary>The object under <c>error</c>; nothing stands beside it.</summary>
    public JsonElement ErrorObject()
    {
        JsonElement whole = Object();
        Assert.Equal("error", Assert.Single(whole.EnumerateObject()).Name);
        return whole.GetProperty("error");
    }
}

/// <summary>A folder for the files of a test.</summary>
internal sealed class CliFolder : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab").FullName;

    public string Root => folder;

    public void Dispose() => Directory.Delete(folder, true);

    public string PathOf(string name) => Path.Combine(folder, name);

    public string Text(string name, string text)
    {
        File.WriteAllText(PathOf(name), text);
        return PathOf(name);
    }

    public string Save(string model, string extension = ".obj") => Save(Models.Create(model), model + extension);

    public string Save(Mesh mesh, string name)
    {
        MeshFile.Write(mesh, PathOf(name));
        return PathOf(name);
    }

    public string[] Files() => [.. Directory.GetFileSystemEntries(folder).Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal)];
}
