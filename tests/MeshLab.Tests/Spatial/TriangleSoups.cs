using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Spatial;

/// <summary>Triangles as plain arrays: what a tree can be built from, also where no manifold would come out.</summary>
internal static class TriangleSoups
{
    internal sealed record Soup(Vector3D[] Positions, int[] Corners)
    {
        public int Count => Corners.Length / 3;

        public (Vector3D A, Vector3D B, Vector3D C) this[int triangle] =>
            (Positions[Corners[3 * triangle]], Positions[Corners[3 * triangle + 1]], Positions[Corners[3 * triangle + 2]]);

        public Soup Moved(double scale, Vector3D offset) => this with { Positions = [.. Positions.Select(p => p * scale + offset)] };
    }

    public static readonly TheoryData<string> Names =
        ["one", "random", "sphere", "grid", "slivers", "collinear", "points", "repeated", "sphere-far", "sphere-tiny", "sphere-huge", "far-apart"];

    public static Soup Make(string name) => name switch
    {
        "empty" => new([], []),
        "one" => new([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]),
        "random" => Random(500, 1),
        "sphere" => Sphere(24),
        "grid" => Grid(20),
        "slivers" => Slivers(300),
        "collinear" => new([.. Enumerable.Range(0, 60).Select(i => new Vector3D(i * 0.1, 0, 0))], [.. Enumerable.Range(0, 58).SelectMany(i => new[] { i, i + 1, i + 2 })]),
        "points" => new([new(1, 2, 3)], new int[3 * 37]),
        "repeated" => new([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [.. Enumerable.Range(0, 3 * 50).Select(i => i % 3)]),
        "sphere-far" => Sphere(24).Moved(1, new(1e6, -1e6, 1e6)),
        "sphere-tiny" => Sphere(24).Moved(1e-6, default),
        "sphere-huge" => Sphere(24).Moved(1e6, default),
        "far-apart" => FarApart(),
        _ => throw new ArgumentOutOfRangeException(nameof(name)),
    };

    public static Soup Random(int triangles, int seed, double size = 0.2)
    {
        var random = new Random(seed);
        var positions = new Vector3D[3 * triangles];
        for (int t = 0; t < triangles; t++)
        {
            Vector3D center = Point(random);
            for (int k = 0; k < 3; k++)
                positions[3 * t + k] = center + Point(random) * size;
        }
        return new(positions, [.. Enumerable.Range(0, 3 * triangles)]);
    }

    /// <summary>n rings of 2n vertices between two poles, radius 1.</summary>
    public static Soup Sphere(int n)
    {
        var positions = new List<Vector3D> { new(0, 0, 1) };
        for (int i = 1; i < n; i++)
        {
            for (int j = 0; j < 2 * n; j++)
            {
                (double sinT, double cosT) = Math.SinCos(Math.PI * i / n);
                (double sinP, double cosP) = Math.SinCos(Math.PI * j / n);
                positions.Add(new(sinT * cosP, sinT * sinP, cosT));
            }
        }
        positions.Add(new(0, 0, -1));
        var corners = new List<int>();
        int last = positions.Count - 1;
        for (int j = 0; j < 2 * n; j++)
        {
            int next = (j + 1) % (2 * n);
            corners.AddRange([0, 1 + j, 1 + next]);
            for (int i = 0; i < n - 2; i++)
            {
                int a = 1 + i * 2 * n + j, b = 1 + i * 2 * n + next;
                corners.AddRange([a, a + 2 * n, b, b, a + 2 * n, b + 2 * n]);
            }
            corners.AddRange([last, last - 2 * n + next, last - 2 * n + j]);
        }
        return new([.. positions], [.. corners]);
    }

    /// <summary>A flat square of n × n × 2 triangles: many equal keys, many equal distances.</summary>
    public static Soup Grid(int n)
    {
        var positions = new List<Vector3D>();
        for (int i = 0; i <= n; i++)
        {
            for (int j = 0; j <= n; j++)
                positions.Add(new(i, j, 0));
        }
        var corners = new List<int>();
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                int a = i * (n + 1) + j;
                corners.AddRange([a, a + n + 1, a + 1, a + 1, a + n + 1, a + n + 2]);
            }
        }
        return new([.. positions], [.. corners]);
    }

    private static Soup Slivers(int triangles)
    {
        Soup soup = Random(triangles, 3);
        var random = new Random(4);
        for (int t = 0; t < triangles; t++)
        {
            (Vector3D a, Vector3D b, _) = soup[t];
            soup.Positions[3 * t + 2] = Vector3D.Lerp(a, b, random.NextDouble()) + Point(random) * Math.Pow(10, -random.Next(5, 18));
        }
        return soup;
    }

    private static Soup FarApart()
    {
        Soup near = Random(50, 8), far = Random(50, 9).Moved(1e-3, new(1e9, 0, 0));
        return new([.. near.Positions, .. far.Positions], [.. Enumerable.Range(0, 300)]);
    }

    /// <summary>A point of the cube from −1 to 1.</summary>
    public static Vector3D Point(Random random) =>
        new(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);

    /// <summary>Points near, on, inside and far from the soup.</summary>
    public static IEnumerable<Vector3D> Queries(Soup soup, int count, int seed)
    {
        var random = new Random(seed);
        BoundingBox box = BoundingBox.Of(soup.Positions);
        double size = box.Diagonal > 0 ? box.Diagonal : 1;
        for (int i = 0; i < count; i++)
        {
            Vector3D p = soup.Positions[random.Next(soup.Positions.Length)];
            yield return (i % 5) switch
            {
                0 => p,
                1 => p + Point(random) * (1e-3 * size),
                2 => box.Center + Point(random) * size,
                3 => box.Center + Point(random) * (1e4 * size),
                _ => Vector3D.Lerp(p, soup.Positions[random.Next(soup.Positions.Length)], 0.5),
            };
        }
    }
}
