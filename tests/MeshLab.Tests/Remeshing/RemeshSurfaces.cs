using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;

namespace MeshLab.Tests.Remeshing;

/// <summary>Surfaces made by hand for single steps.</summary>
internal static class RemeshSurfaces
{
    /// <summary>The surface of a mesh with its lines marked and one length wanted everywhere.</summary>
    public static (RemeshSurface Surface, FeatureLines Lines) Of(Mesh mesh, double length = 1, double featureAngle = Math.PI, StringWriter? trace = null)
    {
        var surface = new RemeshSurface(mesh) { Trace = StepTrace.Into(trace) };
        FeatureLines lines = FeatureLines.Mark(mesh, surface, featureAngle, length);
        surface.Size.AsSpan().Fill(length);
        return (surface, lines);
    }

    /// <summary>Vertex 0 with triangles all around, over the rim given counter-clockwise: vertices 1 …</summary>
    public static Mesh Fan(Vector3D center, params Vector3D[] rim) =>
        MeshBuilder.FromTriangles([center, .. rim], [.. Enumerable.Range(0, rim.Length).SelectMany(i => new[] { 0, 1 + i, 1 + (i + 1) % rim.Length })]);

    /// <summary>The corners of a regular polygon in the plane z = 0.</summary>
    public static Vector3D[] Polygon(int n, double radius = 1) =>
        [.. Enumerable.Range(0, n).Select(i => radius * new Vector3D(Math.Cos(2 * Math.PI * i / n), Math.Sin(2 * Math.PI * i / n), 0))];

    /// <summary>A sheet of triangles, n × n squares over [0, n]², with inner vertices and diagonals at random; bent by a height over x.</summary>
    public static Mesh Sheet(int n, int seed, double shake, Func<double, double>? height = null)
    {
        var random = new Random(seed);
        var positions = new List<Vector3D>();
        for (int y = 0; y <= n; y++)
        {
            for (int x = 0; x <= n; x++)
            {
                // Whole columns stay in their folds: x is shaken where the sheet is flat only.
                bool inner = x > 0 && x < n && y > 0 && y < n;
                double px = x + (inner && height is null ? shake * (random.NextDouble() - 0.5) : 0), py = y + (inner ? shake * (random.NextDouble() - 0.5) : 0);
                positions.Add(new(px, py, height?.Invoke(px) ?? 0));
            }
        }
        var corners = new List<int>();
        for (int y = 0; y < n; y++)
        {
            for (int x = 0; x < n; x++)
            {
                int a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
                corners.AddRange(random.Next(2) == 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d]);
            }
        }
        return MeshBuilder.FromTriangles([.. positions], [.. corners]);
    }

    /// <summary>The place of every vertex that is there.</summary>
    public static Vector3D[] Places(RemeshSurface s) => [.. Enumerable.Range(0, s.VertexSlots).Where(s.IsLiveVertex).Select(v => s.Positions[v])];

    /// <summary>The half-edge between two vertices.</summary>
    public static int HalfEdge(RemeshSurface s, int from, int to) =>
        Enumerable.Range(0, s.HalfEdgeSlots).First(h => !s.IsFreeEdge(h & ~1) && s.Target[h] == to && s.Target[h ^ 1] == from);
}
