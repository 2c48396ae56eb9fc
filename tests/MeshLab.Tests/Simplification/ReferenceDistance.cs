using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Tests.Simplification;

/// <summary>The distance as the recorded limits were measured: 100,000 points per surface, drawn by NumPy's generator from seed 12345, and all vertices. With the
/// same points as the recorded programs, chance does not prefer one of them.</summary>
internal sealed class ReferenceDistance
{
    private const int Samples = 100_000;
    private readonly FaceTree tree;
    private readonly Vector3D[] points;

    public ReferenceDistance(Mesh original)
    {
        tree = FaceTree.Build(original);
        points = PointsOn(original);
    }

    /// <summary>Root mean square over the points of both surfaces, and the Hausdorff distance over points and vertices, relative to the original's diagonal.</summary>
    public (double Rms, double Hausdorff) To(Mesh other)
    {
        (double forward, double forwardMax) = OneWay(points, FaceTree.Build(other));
        (double backward, double backwardMax) = OneWay(PointsOn(other), tree);
        double diagonal = tree.Bounds.Diagonal;
        return (Math.Sqrt((forward + backward) / 2) / diagonal, Math.Max(forwardMax, backwardMax) / diagonal);
    }

    private static (double MeanSquare, double Max) OneWay(Vector3D[] points, FaceTree to)
    {
        var closest = new ClosestPoint[points.Length];
        to.FindClosest(points, closest, default);
        return (closest.Take(Samples).Average(c => c.DistanceSquared), Math.Sqrt(closest.Max(c => c.DistanceSquared)));
    }

    private static Vector3D[] PointsOn(Mesh mesh)
    {
        var random = new NumpyRandom(12345);
        (Vector3D A, Vector3D B, Vector3D C)[] triangles = [.. mesh.Faces.Select(f => (f.HalfEdge.Source.Position, f.HalfEdge.Target.Position, f.HalfEdge.Next.Target.Position))];
        var upTo = new double[triangles.Length];
        double total = 0;
        for (int t = 0; t < triangles.Length; t++)
        {
            var (a, b, c) = triangles[t];
            upTo[t] = total += Vector3D.Cross(b - a, c - a).Length / 2;
        }
        double[] places = [.. Enumerable.Range(0, Samples).Select(_ => random.NextDouble() * total)];
        double[] u = [.. Enumerable.Range(0, Samples).Select(_ => Math.Sqrt(random.NextDouble()))];
        var points = new List<Vector3D>();
        for (int i = 0; i < Samples; i++)
        {
            double v = random.NextDouble();
            var (a, b, c) = triangles[Math.Min(FirstAbove(upTo, places[i]), triangles.Length - 1)];
            points.Add(a * (1 - u[i]) + b * (u[i] * (1 - v)) + c * (u[i] * v));
        }
        points.AddRange(mesh.Vertices.Where(x => !x.IsIsolated).Select(x => x.Position));
        return [.. points];
    }

    private static int FirstAbove(double[] sorted, double value)
    {
        int low = 0, high = sorted.Length;
        while (low < high)
        {
            int middle = (low + high) / 2;
            (low, high) = sorted[middle] <= value ? (middle + 1, high) : (low, middle);
        }
        return low;
    }

    /// <summary>NumPy's <c>default_rng(seed).random()</c>: PCG64 (O'Neill 2014, XSL-RR) with the seed spread by its SeedSequence.</summary>
    internal sealed class NumpyRandom
    {
        private static readonly UInt128 Multiplier = new(2549297995355413924, 4865540595714422341);
        private readonly UInt128 increment;
        private UInt128 state;

        public NumpyRandom(uint seed)
        {
            ulong[] words = Spread(seed);
            increment = new UInt128(words[2], words[3]) << 1 | 1;
            Step();
            state += new UInt128(words[0], words[1]);
            Step();
        }

        public double NextDouble()
        {
            Step();
            ulong word = System.Numerics.BitOperations.RotateRight((ulong)(state >> 64) ^ (ulong)state, (int)(state >> 122));
            return (word >> 11) * (1.0 / (1L << 53));
        }

        private void Step() => state = state * Multiplier + increment;

        private static ulong[] Spread(uint seed)
        {
            uint multiplier = 0x43b0d7e5;
            var pool = new uint[4];
            for (int i = 0; i < 4; i++)
                pool[i] = Hash(i == 0 ? seed : 0, ref multiplier, 0x931e8875);
            for (int from = 0; from < 4; from++)
            {
                for (int to = 0; to < 4; to++)
                {
                    if (from == to)
                        continue;
                    uint mixed = 0xca01f9dd * pool[to] - 0x4973f715 * Hash(pool[from], ref multiplier, 0x931e8875);
                    pool[to] = mixed ^ mixed >> 16;
                }
            }
            multiplier = 0x8b51f9dd;
            uint[] words = [.. Enumerable.Range(0, 8).Select(i => Hash(pool[i % 4], ref multiplier, 0x58f38ded))];
            return [.. Enumerable.Range(0, 4).Select(i => words[2 * i] | (ulong)words[2 * i + 1] << 32)];
        }

        private static uint Hash(uint value, ref uint multiplier, uint factor)
        {
            value ^= multiplier;
            multiplier *= factor;
            value *= multiplier;
            return value ^ value >> 16;
        }
    }
}
