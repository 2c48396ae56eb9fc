using System.Collections.Concurrent;
using System.Globalization;
using System.IO.Compression;
using System.Text.Json;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests;

/// <summary>The reference models as meshes, in file order, read apart from the library's own readers; and comparison with the stored arrays.</summary>
internal static class ReferenceMesh
{
    private static readonly ConcurrentDictionary<string, (Vector3D[] Positions, int[] Corners)> Loaded = new(StringComparer.Ordinal);

    /// <summary>A fresh mesh of a public model; skips the test if it is missing.</summary>
    public static Mesh Load(string name)
    {
        var (positions, corners) = Loaded.GetOrAdd(ReferenceData.ModelPath(name), Read);
        return MeshBuilder.FromTriangles(positions, corners);
    }

    /// <summary>Edge indices as the reference counts them: pairs i &lt; j in lexicographic order.</summary>
    public static int[] EdgesInOrder(Mesh mesh) =>
        [.. mesh.Edges.OrderBy(e => Math.Min(e.Vertex0.Index, e.Vertex1.Index)).ThenBy(e => Math.Max(e.Vertex0.Index, e.Vertex1.Index)).Select(e => e.Index)];

    /// <summary>Compares values with an array of <c>core.json</c>: all of them if stored, else the sample; and if all are compared the least, the largest, and the sum.</summary>
    /// <param name="name">The model.</param>
    /// <param name="array">The name of the array.</param>
    /// <param name="values">In reference order; <paramref name="width"/> per element.</param>
    /// <param name="tolerance">Relative to the element; on top of it 1e-13 of the largest, for what is left of it where terms cancel.</param>
    /// <param name="compare">Which elements are compared; all if null.</param>
    /// <param name="width">Values per element.</param>
    /// <param name="slack">By how much more an element may differ; by nothing if null.</param>
    public static void Compare(
        string name, string array, double[] values, double tolerance = 1e-9, Func<int, bool>? compare = null, int width = 1, Func<int, double>? slack = null)
    {
        JsonElement stored = ReferenceData.Json(name, "core").RootElement.GetProperty("arrays").GetProperty(array), stats = stored.GetProperty("stats");
        Assert.Equal(stats.GetProperty("n").GetInt32(), values.Length / width);
        double rounding = 1e-13 * values.Where(double.IsFinite).Select(Math.Abs).DefaultIfEmpty().Max();
        if (compare is null)
            CompareStatistics(stats);
        if (stored.TryGetProperty("sample_index", out JsonElement sampled))
        {
            double[] index = ReferenceData.Numbers(sampled), sample = ReferenceData.Numbers(stored.GetProperty("sample"));
            for (int i = 0; i < index.Length; i++)
                CompareElement((int)index[i], sample.AsSpan(i * width, width));
            return;
        }
        double[] all = ReferenceData.Numbers(ReferenceData.Arrays(name).RootElement.GetProperty(array));
        for (int i = 0; i < values.Length / width; i++)
            CompareElement(i, all.AsSpan(i * width, width));

        void CompareElement(int element, ReadOnlySpan<double> expected)
        {
            if (compare is not null && !compare(element))
                return;
            double size = 0;
            foreach (double e in expected)
                size = Math.Max(size, Math.Abs(e));
            double bound = (tolerance * size) + rounding + (slack?.Invoke(element) ?? 0);
            for (int k = 0; k < width; k++)
            {
                double actual = values[(element * width) + k];
                Assert.True(
                    Math.Abs(actual - expected[k]) <= bound || (double.IsNaN(actual) && double.IsNaN(expected[k])),
                    $"{name}.{array}[{element}][{k}]: {actual:R}, expected {expected[k]:R}.");
            }
        }

        void CompareStatistics(JsonElement stats)
        {
            for (int k = 0; k < width; k++)
            {
                double[] column = [.. values.Where((value, i) => i % width == k && double.IsFinite(value))];
                double added = column.Sum(Math.Abs);
                Near("min", column.Min(), tolerance * Math.Abs(column.Min()));
                Near("max", column.Max(), tolerance * Math.Abs(column.Max()));
                Near("sum", column.Sum(), tolerance * added);

                void Near(string statistic, double actual, double bound)
                {
                    JsonElement found = stats.GetProperty(statistic);
                    double expected = ReferenceData.Number(found.ValueKind == JsonValueKind.Array ? found[k] : found);
                    Assert.True(Math.Abs(actual - expected) <= bound + rounding, $"{name}.{array}, {statistic}: {actual:R}, expected {expected:R}.");
                }
            }
        }
    }

    /// <summary>Three numbers per vector.</summary>
    public static double[] Flat(Vector3D[] vectors) => [.. vectors.SelectMany(v => new[] { v.X, v.Y, v.Z })];

    private static (Vector3D[] Positions, int[] Corners) Read(string path)
    {
        using Stream raw = File.OpenRead(path);
        using Stream plain = path.EndsWith(".gz", StringComparison.Ordinal) ? new GZipStream(raw, CompressionMode.Decompress) : raw;
        using var reader = new StreamReader(plain);
        return path.Contains(".off", StringComparison.Ordinal) ? ReadOff(reader) : ReadObj(reader);
    }

    private static (Vector3D[] Positions, int[] Corners) ReadObj(TextReader reader)
    {
        var positions = new List<Vector3D>();
        var corners = new List<int>();
        while (reader.ReadLine() is string line)
        {
            string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (words is ["v", ..])
                positions.Add(new(Number(words[1]), Number(words[2]), Number(words[3])));
            else if (words is ["f", ..])
                corners.AddRange(words.Skip(1).Take(3).Select(w => int.Parse(w.Split('/')[0], CultureInfo.InvariantCulture) - 1));
        }
        return ([.. positions], [.. corners]);
    }

    private static (Vector3D[] Positions, int[] Corners) ReadOff(TextReader reader)
    {
        reader.ReadLine();
        int[] counts = [.. reader.ReadLine()!.Split(' ').Select(w => int.Parse(w, CultureInfo.InvariantCulture))];
        var positions = new Vector3D[counts[0]];
        for (int i = 0; i < positions.Length; i++)
        {
            string[] words = reader.ReadLine()!.Split(' ');
            positions[i] = new(Number(words[0]), Number(words[1]), Number(words[2]));
        }
        var corners = new int[3 * counts[1]];
        for (int f = 0; f < counts[1]; f++)
        {
            string[] words = reader.ReadLine()!.Split(' ');
            for (int k = 0; k < 3; k++)
                corners[(3 * f) + k] = int.Parse(words[k + 1], CultureInfo.InvariantCulture);
        }
        return (positions, corners);
    }

    private static double Number(string word) => double.Parse(word, CultureInfo.InvariantCulture);
}
