using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Points of a surface with the share of the area that each stands for; points with no share count for maxima only.</summary>
/// <param name="Points">The points; neighbours in the list are mostly neighbours in space.</param>
/// <param name="Weights">Their shares.</param>
internal sealed record SurfaceSamples(Vector3D[] Points, double[] Weights)
{
    /// <summary>The points that the options ask for.</summary>
    /// <param name="mesh">The surface.</param>
    /// <param name="tree">Its tree, for the triangles.</param>
    /// <param name="options">The sampling.</param>
    public static SurfaceSamples Of(Mesh mesh, FaceTree tree, MeshDistanceOptions options)
    {
        var points = new List<Vector3D>();
        var weights = new List<double>();
        AddVertices(mesh, points, weights);
        double area = options.Deterministic ? AddMidpoints(mesh, tree, points, weights) : AddByArea(mesh, tree, options, points, weights);
        // A surface of needles only is measured at its corners.
        return area > 0 ? new([.. points], [.. weights]) : new([.. points], [.. points.Select(_ => 1.0)]);
    }

    private static void AddVertices(Mesh mesh, List<Vector3D> points, List<double> weights)
    {
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            points.Add(v.Position);
            weights.Add(0);
        }
    }

    // Edge midpoints without, triangle barycentres with their area as weight.
    private static double AddMidpoints(Mesh mesh, FaceTree tree, List<Vector3D> points, List<double> weights)
    {
        foreach (Edge e in mesh.Edges)
        {
            points.Add((e.Vertex0.Position + e.Vertex1.Position) * 0.5);
            weights.Add(0);
        }
        double total = 0;
        for (int t = 0; t < tree.TriangleCount; t++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = Corners(mesh, tree, t);
            points.Add((a + b + c) / 3);
            weights.Add(Vector3D.Cross(b - a, c - a).Length / 2);
            total += weights[^1];
        }
        return total;
    }

    // The triangles laid end to end by area and cut into strips of equal length; one random point in each.
    private static double AddByArea(Mesh mesh, FaceTree tree, MeshDistanceOptions options, List<Vector3D> points, List<double> weights)
    {
        var upTo = new double[tree.TriangleCount];
        double total = 0;
        for (int t = 0; t < upTo.Length; t++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = Corners(mesh, tree, t);
            upTo[t] = total += Vector3D.Cross(b - a, c - a).Length / 2;
        }
        if (!(total > 0))
            return 0;

        var random = new Random(options.Seed);
        int triangle = 0;
        for (int i = 0; i < options.Samples; i++)
        {
            double place = (i + random.NextDouble()) / options.Samples * total;
            while (triangle < upTo.Length - 1 && upTo[triangle] < place)
                triangle++;
            (Vector3D a, Vector3D b, Vector3D c) = Corners(mesh, tree, triangle);
            // Uniform on the triangle (Turk 1990).
            double s = Math.Sqrt(random.NextDouble()), r = random.NextDouble();
            points.Add(a + (b - a) * (s * (1 - r)) + (c - a) * (s * r));
            weights.Add(1);
        }
        return total;
    }

    private static (Vector3D A, Vector3D B, Vector3D C) Corners(Mesh mesh, FaceTree tree, int triangle)
    {
        (int a, int b, int c) = tree.CornersOf(triangle);
        return (mesh.Positions[a], mesh.Positions[b], mesh.Positions[c]);
    }
}
