using System.Collections.Concurrent;
using System.IO.Compression;
using System.Text.Json;
using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests;

/// <summary>
/// Reference values that independent programs computed for public models, in a folder <c>shared/ref</c> beside the repository.
/// They are not part of the repository: a test that uses them is a <c>[SkippableFact]</c> or <c>[SkippableTheory]</c>, and every member here
/// that touches a file skips the test when the folder is missing.
/// </summary>
internal static class ReferenceData
{
    private static readonly Lazy<string?> FoundRoot = new(FindRoot);
    private static readonly ConcurrentDictionary<string, Lazy<Mesh>> Meshes = new(StringComparer.Ordinal);
    private static readonly ConcurrentDictionary<string, JsonDocument> Documents = new(StringComparer.Ordinal);

    /// <summary>The public models: closed and open, genus 0 to 34, several components, CAD and scans.</summary>
    public static IReadOnlyList<string> PublicModels { get; } =
    [
        "spot", "bunny_closed", "stanford_bunny", "fandisk", "rocker_arm", "three_holes", "camelhead", "reference_annulus",
        "box_assembly", "featuretype", "horse", "isosurface_large",
    ];

    /// <summary>The models below 5000 vertices, for which <see cref="Arrays"/> has every value of every element.</summary>
    public static IReadOnlyList<string> ModelsWithArrays { get; } =
        ["spot", "bunny_closed", "three_holes", "reference_annulus", "box_assembly", "featuretype"];

    /// <summary><see cref="PublicModels"/> for <c>[MemberData]</c>.</summary>
    public static TheoryData<string> PublicModelCases => new(PublicModels);

    /// <summary><see cref="ModelsWithArrays"/> for <c>[MemberData]</c>.</summary>
    public static TheoryData<string> ModelsWithArraysCases => new(ModelsWithArrays);

    /// <summary>Whether the folder is there.</summary>
    public static bool IsAvailable => FoundRoot.Value is not null;

    /// <summary>The folder; skips the test if it is missing.</summary>
    public static string Root
    {
        get
        {
            SkipIfMissing();
            return FoundRoot.Value!;
        }
    }

    /// <summary>Skips the test if the folder is missing.</summary>
    public static void SkipIfMissing() => Skip.IfNot(IsAvailable, "The reference values are not beside the repository.");

    /// <summary>A file of the folder by its parts; skips the test if it is missing.</summary>
    public static string FilePath(params ReadOnlySpan<string> parts)
    {
        string path = Path.Combine([Root, .. parts]);
        Skip.IfNot(File.Exists(path), $"No reference file {Path.GetFileName(path)}.");
        return path;
    }

    /// <summary>The model's file, of whatever format.</summary>
    public static string ModelPath(string name)
    {
        foreach (string extension in (string[])[".obj", ".off", ".obj.gz", ".off.gz"])
        {
            string path = Path.Combine(Root, "models", "public", name + extension);
            if (File.Exists(path))
                return path;
        }

        throw new SkipException($"No reference model {name}.");
    }

    /// <summary>The model as a mesh of the test's own; the file is read once.</summary>
    public static Mesh Load(string name)
    {
        string path = ModelPath(name);
        return Meshes.GetOrAdd(name, _ => new Lazy<Mesh>(() => MeshFile.Read(path))).Value.Clone();
    }

    /// <summary>The values of one kind for a model, such as <c>Json("spot", "core")</c>. Shared: do not dispose it.</summary>
    public static JsonDocument Json(string name, string kind) => Document($"{name}.{kind}", "json", $"{name}.{kind}.json");

    /// <summary>A document that is not of one model, such as <c>Json("analytic")</c>. Shared: do not dispose it.</summary>
    public static JsonDocument Json(string name) => Document(name, "json", $"{name}.json");

    /// <summary>The complete arrays of a model of <see cref="ModelsWithArrays"/>. Shared: do not dispose it.</summary>
    /// <param name="name">The model.</param>
    /// <param name="kind">Empty, <c>subdiv</c> or <c>extras</c>.</param>
    public static JsonDocument Arrays(string name, string kind = "") =>
        Document($"{name}.{kind}.arrays", "arrays", kind.Length == 0 ? $"{name}.json.gz" : $"{name}.{kind}.json.gz");

    /// <summary>A number of a document; non-finite ones are stored as the strings NaN, Infinity and -Infinity.</summary>
    public static double Number(JsonElement value) => value.ValueKind == JsonValueKind.String
        ? value.GetString() switch
        {
            "inf" => double.PositiveInfinity,
            "-inf" => double.NegativeInfinity,
            var text => double.Parse(text!, System.Globalization.CultureInfo.InvariantCulture),
        }
        : value.GetDouble();

    /// <summary>A flat array of numbers of a document; arrays within it are joined.</summary>
    public static double[] Numbers(JsonElement array)
    {
        List<double> numbers = [];
        Collect(array, numbers);
        return [.. numbers];
    }

    private static void Collect(JsonElement value, List<double> numbers)
    {
        if (value.ValueKind != JsonValueKind.Array)
        {
            numbers.Add(Number(value));
            return;
        }

        foreach (JsonElement item in value.EnumerateArray())
            Collect(item, numbers);
    }

    private static JsonDocument Document(string key, string folder, string file)
    {
        string path = FilePath(folder, file);
        return Documents.GetOrAdd(key, static (_, path) =>
        {
            using Stream raw = File.OpenRead(path);
            if (!path.EndsWith(".gz", StringComparison.Ordinal))
                return JsonDocument.Parse(raw);
            using GZipStream unpacked = new(raw, CompressionMode.Decompress);
            return JsonDocument.Parse(unpacked);
        }, path);
    }

    private static string? FindRoot()
    {
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            string candidate = Path.Combine(folder.FullName, "shared", "ref");
            if (Directory.Exists(Path.Combine(candidate, "models")))
                return candidate;
        }

        return null;
    }
}
