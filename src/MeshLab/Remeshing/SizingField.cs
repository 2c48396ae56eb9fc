using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>The edge length wanted at every vertex (尺寸场): one everywhere, or shorter where the surface is curved.</summary>
/// <remarks>
/// An edge of length l on a circle of curvature κ is off by ε at most if l = √(6ε/κ − 3ε²) (Dunyach et al. 2013, eq. 1, for equilateral
/// triangles). κ is the largest |2 n·(q − p)| / |q − p|² over the neighbours q of p. Neighbours' lengths differ by at most half their distance.
/// </remarks>
internal static class SizingField
{
    private const double Gradation = 0.5;

    /// <summary>Per vertex of the input, the length wanted.</summary>
    public static double[] Of(Mesh mesh, RemeshingOptions options, double length)
    {
        var sizes = new double[mesh.VertexSlots];
        sizes.AsSpan().Fill(length);
        if (options.CurvatureTolerance is not { } tolerance)
            return sizes;

        double error = tolerance * length, shortest = options.SmallestRelativeLength * length;
        foreach (Vertex v in mesh.Vertices)
        {
            double curvature = LargestCurvature(v);
            if (curvature > 0)
                sizes[v.Index] = Math.Clamp(Math.Sqrt(Math.Max(0, 6 * error / curvature - 3 * error * error)), shortest, length);
        }
        LimitGradation(mesh, sizes);
        return sizes;
    }

    private static double LargestCurvature(Vertex v)
    {
        Vector3D p = v.Position, normal = default;
        foreach (HalfEdge h in v.OutgoingHalfEdges)
        {
            if (!h.IsBoundary)
                normal += Vector3D.Cross(h.Target.Position - p, h.Previous.Source.Position - p);
        }
        normal = normal.Normalized();
        double largest = 0;
        foreach (Vertex w in v.Neighbors)
        {
            Vector3D edge = w.Position - p;
            double squared = edge.LengthSquared;
            if (squared > 0)
                largest = Math.Max(largest, Math.Abs(2 * Vector3D.Dot(normal, edge)) / squared);
        }
        return largest;
    }

    // Dijkstra from the shortest lengths outward: size(w) ≤ size(v) + Gradation · |vw|.
    private static void LimitGradation(Mesh mesh, double[] sizes)
    {
        var queue = new PriorityQueue<int, (double Size, int Vertex)>();
        for (int v = 0; v < sizes.Length; v++)
            queue.Enqueue(v, (sizes[v], v));
        while (queue.TryDequeue(out int v, out (double Size, int Vertex) key))
        {
            if (key.Size > sizes[v] || mesh.Vertices[v].IsIsolated)
                continue;
            foreach (Vertex w in mesh.Vertices[v].Neighbors)
            {
                double limit = sizes[v] + Gradation * Vector3D.Distance(mesh.Positions[v], w.Position);
                if (limit < sizes[w.Index])
                {
                    sizes[w.Index] = limit;
                    queue.Enqueue(w.Index, (limit, w.Index));
                }
            }
        }
    }
}
