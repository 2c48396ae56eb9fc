using MeshLab.Curvature;
using MeshLab.Geodesics;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>§12.1 莫斯函数: the functions of the book, ready for Morse theory. Each is finite at every used vertex.</summary>
public static class MorseFunctions
{
    /// <summary>How many times a curvature is averaged with its neighbours before it is used: curvature of scans is noise otherwise.</summary>
    public const int DefaultSmoothingSteps = 10;

    extension(Mesh mesh)
    {
        /// <summary>A coordinate (坐标函数): 0 for x, 1 for y, 2 for z.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The axis is not 0, 1 or 2.</exception>
        public MorseFunction CoordinateFunction(int axis)
        {
            ArgumentOutOfRangeException.ThrowIfNegative(axis);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(axis, 2);
            return From(mesh, p => p[axis]);
        }

        /// <summary>The height in a direction (方向函数): the scalar product of the position with the unit vector.</summary>
        /// <exception cref="ArgumentException">The direction is zero or not finite.</exception>
        public MorseFunction DirectionFunction(Vector3D direction)
        {
            Vector3D unit = direction.Normalized();
            if (!direction.IsFinite || unit == Vector3D.Zero)
                throw new ArgumentException($"{direction} is no direction.", nameof(direction));
            return From(mesh, p => Vector3D.Dot(p, unit));
        }

        /// <summary>The cosine of a coordinate (余弦函数): waves over the box, <paramref name="waves"/> of them from end to end.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The axis is not 0, 1 or 2, or the number of waves is not positive.</exception>
        public MorseFunction CosineFunction(int axis = 2, double waves = 2)
        {
            ArgumentOutOfRangeException.ThrowIfNegative(axis);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(axis, 2);
            if (!(waves > 0) || !double.IsFinite(waves))
                throw new ArgumentOutOfRangeException(nameof(waves), waves, "The number of waves is positive.");
            BoundingBox box = mesh.BoundingBox;
            double size = box.Size[axis], frequency = size > 0 ? 2 * Math.PI * waves / size : 0;
            return From(mesh, p => Math.Cos((p[axis] - box.Min[axis]) * frequency));
        }

        /// <summary>The distance from a point of space (距离函数).</summary>
        /// <exception cref="ArgumentException">The point is not finite.</exception>
        public MorseFunction DistanceFunction(Vector3D point)
        {
            if (!point.IsFinite)
                throw new ArgumentException($"The point {point} is not finite.", nameof(point));
            return From(mesh, p => Vector3D.Distance(p, point));
        }

        /// <summary>The length of the shortest path along edges from a vertex (测地距离函数). Vertices that no path reaches get the largest distance there is.</summary>
        public MorseFunction GeodesicFunction(Vertex source)
        {
            double[] distances = mesh.ComputeEdgeDistances(source);
            double largest = 0;
            foreach (double d in distances)
            {
                if (double.IsFinite(d))
                    largest = Math.Max(largest, d);
            }
            return new MorseFunction(mesh, Array.ConvertAll(distances, d => double.IsFinite(d) ? d : largest), null);
        }

        /// <summary>The Gaussian curvature (高斯曲率函数), averaged over neighbours so many times.</summary>
        public MorseFunction GaussianCurvatureFunction(int smoothingSteps = DefaultSmoothingSteps) =>
            Smoothed(mesh, mesh.ComputeGaussianCurvature(), smoothingSteps);

        /// <summary>The mean curvature (平均曲率函数), averaged over neighbours so many times.</summary>
        public MorseFunction MeanCurvatureFunction(int smoothingSteps = DefaultSmoothingSteps) =>
            Smoothed(mesh, mesh.ComputeMeanCurvature(), smoothingSteps);

        /// <summary>§12.5 调和函数: the function that is harmonic but at vertices with given values; extrema are there only, if all weights are positive.
        /// Components without such a vertex are constant 0.</summary>
        /// <param name="fixedValues">Vertices and their values; without any, the book's: 10 at the lowest and 100 at the highest vertex of the largest component.</param>
        /// <param name="weights">Cotangent (default), intrinsic Delaunay, clamped, mean value or uniform.</param>
        /// <param name="cancellationToken">Stops the work.</param>
        public MorseFunction HarmonicFunction(
            IReadOnlyCollection<(Vertex Vertex, double Value)>? fixedValues = null,
            LaplacianWeights weights = LaplacianWeights.Cotangent,
            CancellationToken cancellationToken = default)
        {
            fixedValues ??= TextbookFixedValues(mesh);
            var options = new HarmonicOptions { Weights = weights, AllowUndetermined = true };
            double[] values = mesh.ComputeHarmonicFunction(fixedValues, options, cancellationToken);
            return new MorseFunction(mesh, Array.ConvertAll(values, x => double.IsNaN(x) ? 0 : x), null);
        }

        /// <summary>An eigenvector of the Laplacian (拉普拉斯特征向量): 0 is the constant one, 1 the slowest wave, and so on.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The index is negative, or there are not so many.</exception>
        public MorseFunction EigenvectorFunction(int index, CancellationToken cancellationToken = default)
        {
            ArgumentOutOfRangeException.ThrowIfNegative(index);
            double[] vector = mesh.ComputeSmallestEigenpairs(index + 1, cancellationToken: cancellationToken).Vectors[index];
            return new MorseFunction(mesh, Array.ConvertAll(vector, x => double.IsNaN(x) ? 0 : x), null);
        }
    }

    private static MorseFunction From(Mesh mesh, Func<Vector3D, double> f)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        var values = new double[mesh.VertexSlots];
        ReadOnlySpan<Vector3D> positions = mesh.Positions;
        for (int v = 0; v < values.Length; v++)
            values[v] = f(positions[v]);
        return new MorseFunction(mesh, values, null);
    }

    /// <summary>Averages every value with those of the neighbours; values that are not numbers (vertices without area) count as 0.</summary>
    private static MorseFunction Smoothed(Mesh mesh, double[] values, int steps)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(steps);
        double[] old = Array.ConvertAll(values, x => double.IsFinite(x) ? x : 0), fresh = new double[old.Length];
        for (int step = 0; step < steps; step++)
        {
            Parallelism.ForBlocks(old.Length, (first, end) =>
            {
                ReadOnlySpan<int> outgoing = mesh.Outgoing, next = mesh.Next, target = mesh.Target;
                for (int v = first; v < end; v++)
                {
                    double sum = old[v];
                    int count = 1, start = outgoing[v], h = start;
                    if (start >= 0)
                    {
                        do
                        {
                            sum += old[target[h]];
                            count++;
                            h = next[h ^ 1];
                        }
                        while (h != start);
                    }
                    fresh[v] = sum / count;
                }
            });
            (old, fresh) = (fresh, old);
        }
        return new MorseFunction(mesh, old, null);
    }

    private static (Vertex Vertex, double Value)[] TextbookFixedValues(Mesh mesh)
    {
        int[] component = LargestComponent(mesh);
        if (component.Length < 2)
            throw new ArgumentException("The mesh has no component with two vertices.", nameof(mesh));
        int lowest = component[0], highest = component[0];
        foreach (int v in component)
        {
            if (mesh.Positions[v].Z < mesh.Positions[lowest].Z)
                lowest = v;
            if (mesh.Positions[v].Z > mesh.Positions[highest].Z)
                highest = v;
        }
        if (lowest == highest)
            highest = component[^1];
        return [(mesh.Vertices[lowest], 10), (mesh.Vertices[highest], 100)];
    }

    /// <summary>The vertices of the component with the most of them, in index order; of several the one with the lowest vertex.</summary>
    private static int[] LargestComponent(Mesh mesh)
    {
        var seen = new bool[mesh.VertexSlots];
        int[] best = [];
        var stack = new Stack<int>();
        foreach (Vertex seed in mesh.Vertices)
        {
            if (seen[seed.Index] || seed.IsIsolated)
                continue;
            var found = new List<int>();
            seen[seed.Index] = true;
            stack.Push(seed.Index);
            while (stack.TryPop(out int v))
            {
                found.Add(v);
                foreach (Vertex w in mesh.Vertices[v].Neighbors)
                {
                    if (seen[w.Index])
                        continue;
                    seen[w.Index] = true;
                    stack.Push(w.Index);
                }
            }
            if (found.Count > best.Length)
                best = [.. found.Order()];
        }
        return best;
    }
}
