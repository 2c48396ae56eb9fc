using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.8 加噪声 (noise): moves every vertex along its normal by a random amount.</summary>
/// <remarks>v ← v + t · L̄ · (U − ½) · n, with L̄ the mean edge length, U uniform on [0, 1) from the seed, in vertex order, and n the
/// area-weighted unit normal. Isolated vertices stay. The smooth variant first averages the amounts over the neighbours, so that dents
/// replace spikes, and scales them back to the same root mean square. Undone as one operation. O(V + E).</remarks>
public static class Noise
{
    /// <summary>The textbook's amplitude, in mean edge lengths.</summary>
    public const double DefaultAmplitude = 1.4;

    extension(Mesh mesh)
    {
        /// <summary>Moves every vertex along its normal by a random amount.</summary>
        /// <param name="amplitude">t: the width of the uniform distribution in mean edge lengths; finite, not negative.</param>
        /// <param name="seed">The same seed gives the same mesh.</param>
        /// <param name="smoothingSteps">How often the amounts are averaged with the neighbours'; 0 for independent noise.</param>
        /// <exception cref="ArgumentOutOfRangeException">The amplitude or the number of steps is negative or not finite.</exception>
        public void AddNoise(double amplitude = DefaultAmplitude, int seed = 0, int smoothingSteps = 0)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            if (!double.IsFinite(amplitude) || amplitude < 0)
                throw new ArgumentOutOfRangeException(nameof(amplitude), amplitude, "The amplitude is finite and not negative.");
            ArgumentOutOfRangeException.ThrowIfNegative(smoothingSteps);

            double[] amounts = RandomAmounts(mesh, seed);
            if (smoothingSteps > 0)
                Smooth(mesh, amounts, smoothingSteps);
            Displace(mesh, amounts, amplitude * MeanEdgeLength(mesh));
        }
    }

    private static double[] RandomAmounts(Mesh mesh, int seed)
    {
        var random = new Random(seed);
        var amounts = new double[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
            amounts[v.Index] = random.NextDouble() - 0.5;
        return amounts;
    }

    private static void Smooth(Mesh mesh, double[] amounts, int steps)
    {
        double before = RootMeanSquare(amounts);
        var means = new double[amounts.Length];
        for (int step = 0; step < steps; step++)
        {
            foreach (Vertex v in mesh.Vertices)
            {
                double sum = amounts[v.Index];
                int count = 1;
                foreach (Vertex w in v.Neighbors)
                {
                    sum += amounts[w.Index];
                    count++;
                }
                means[v.Index] = sum / count;
            }
            (amounts, means) = (means, amounts);
        }
        double after = RootMeanSquare(amounts), scale = after > 0 ? before / after : 1;
        for (int v = 0; v < amounts.Length; v++)
            means[v] = amounts[v] *= scale;
    }

    private static double RootMeanSquare(double[] values)
    {
        double sum = 0;
        foreach (double x in values)
            sum += x * x;
        return Math.Sqrt(sum / Math.Max(1, values.Length));
    }

    private static double MeanEdgeLength(Mesh mesh)
    {
        double sum = 0;
        foreach (Edge e in mesh.Edges)
            sum += e.Length;
        return sum / Math.Max(1, mesh.Edges.Count);
    }

    private static void Displace(Mesh mesh, double[] amounts, double scale)
    {
        Vector3D[] normals = AreaWeightedNormals(mesh);
        using OperationScope operation = mesh.BeginOperation(OperationKind.Group);
        foreach (Vertex v in mesh.Vertices)
        {
            if (!v.IsIsolated)
                mesh.SetPosition(v, v.Position + normals[v.Index] * (scale * amounts[v.Index]));
        }
        operation.Complete();
    }

    private static Vector3D[] AreaWeightedNormals(Mesh mesh)
    {
        var normals = new Vector3D[mesh.VertexSlots];
        foreach (Face f in mesh.Faces)
        {
            // Newell's sum: exact for triangles, the best plane's for polygons.
            Vector3D origin = f.HalfEdge.Source.Position, sum = default;
            foreach (HalfEdge h in f.HalfEdges)
                sum += Vector3D.Cross(h.Source.Position - origin, h.Target.Position - origin);
            foreach (HalfEdge h in f.HalfEdges)
                normals[h.Target.Index] += sum;
        }
        for (int v = 0; v < normals.Length; v++)
            normals[v] = normals[v].LengthSquared > 0 ? normals[v].Normalized() : default;
        return normals;
    }
}
