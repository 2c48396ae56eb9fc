using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>How strongly the Laplacian ties a vertex to its neighbour.</summary>
public enum LaplacianWeights
{
    /// <summary>(cot α + cot β)/2 with the angles opposite the edge: the finite-element Laplacian. Negative where α + β &gt; π.</summary>
    Cotangent,

    /// <summary>The cotangent weights with everything below 1e-6 raised to it: never negative, but no longer exact for linear functions.</summary>
    ClampedCotangent,

    /// <summary>The cotangent weights of the intrinsic Delaunay triangulation (<see cref="IntrinsicDelaunay"/>): exact and never negative.</summary>
    IntrinsicDelaunay,

    /// <summary>(tan(δ/2) + tan(γ/2))/|e| with the angles at the vertex beside the edge: always positive, but not symmetric.</summary>
    MeanValue,

    /// <summary>1 for every edge: the graph Laplacian, blind to the shape. The only one for polygons.</summary>
    Uniform,
}

/// <summary>§12.5 拉普拉斯矩阵 (Laplace matrix): (L u)_i = Σ_j w_ij (u_i − u_j) over the neighbours j of vertex i.</summary>
/// <remarks>
/// <code>
///           c                  cotangent: w_ij = (cot α + cot β)/2, α at c and β at d
///         /α  \                mean value: w_ij = (tan(γ/2) + tan(δ/2))/|e|, γ and δ the angles at i on both sides of e
///        /     \
///     γ i ── e ── j            L_ij = −w_ij, L_ii = Σ_j w_ij: rows sum to zero
///     δ  \     /
///         \β  /                Σ over x, y, z of xᵀ L x = 2 · area for cotangent weights
///           d
/// </code>
/// <para>
/// With this sign L is positive semidefinite. Pinkall, Polthier 1993, Experiment. Math. 2(1) (cotangent); Floater 2003, CAGD 20(1) (mean value).
/// Rows are vertex slots; those of deleted and isolated vertices are empty. O(V + H), in parallel.
/// </para>
/// </remarks>
public static class Laplacian
{
    private const double SmallestClampedWeight = 1e-6;

    extension(Mesh mesh)
    {
        /// <summary>(cot α + cot β)/2 per edge slot. Faces without area add nothing.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeCotangentWeights() => CotangentWeights(OppositeCotangents.Of(mesh, out _), double.NegativeInfinity);

        /// <summary>The mean-value weight of each half-edge slot, seen from its source.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeMeanValueWeights() => MeanValueWeights(mesh);

        /// <summary>The Laplace matrix over the vertex slots, positive semidefinite.</summary>
        /// <param name="weights">The weights.</param>
        /// <exception cref="ArgumentException">A face is not a triangle, and the weights are not uniform.</exception>
        public SparseMatrix ComputeLaplacian(LaplacianWeights weights = LaplacianWeights.Cotangent)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            return weights switch
            {
                LaplacianWeights.Cotangent => Assemble(mesh, mesh.ComputeCotangentWeights(), perHalfEdge: false),
                LaplacianWeights.ClampedCotangent =>
                    Assemble(mesh, CotangentWeights(OppositeCotangents.Of(mesh, out _), SmallestClampedWeight), perHalfEdge: false),
                LaplacianWeights.IntrinsicDelaunay => IntrinsicDelaunay.Of(mesh).ComputeLaplacian(),
                LaplacianWeights.MeanValue => Assemble(mesh, MeanValueWeights(mesh), perHalfEdge: true),
                LaplacianWeights.Uniform => Assemble(mesh, UniformWeights(mesh), perHalfEdge: false),
                _ => throw new ArgumentOutOfRangeException(nameof(weights), weights, "No such weights."),
            };
        }
    }

    internal static double[] CotangentWeights(double[] cotangent, double smallest)
    {
        var weight = new double[cotangent.Length / 2];
        Parallelism.ForBlocks(weight.Length, (from, to) =>
        {
            Span<double> w = weight;
            ReadOnlySpan<double> cot = cotangent;
            for (int e = from; e < to; e++)
                w[e] = Math.Max(smallest, 0.5 * (cot[2 * e] + cot[2 * e + 1]));
        });
        return weight;
    }

    internal static SparseMatrix Assemble(Mesh mesh, double[] weight, bool perHalfEdge)
    {
        SparseMatrix laplacian = PlacesOf(mesh, isSymmetric: !perHalfEdge);
        Fill(laplacian, mesh, weight);
        return laplacian;
    }

    /// <summary>The places of the entries; the values are not set yet. Row i lists the neighbours of vertex i as they are met turning around it.</summary>
    internal static SparseMatrix PlacesOf(Mesh mesh, bool isSymmetric = true)
    {
        int n = mesh.VertexSlots;
        var rowStart = new int[n + 1];
        Parallelism.ForBlocks(n, (from, to) => CountNeighbors(mesh, rowStart, from, to));
        for (int v = 0; v < n; v++)
            rowStart[v + 1] += rowStart[v];
        var columns = GC.AllocateUninitializedArray<int>(rowStart[n]);
        Parallelism.ForBlocks(n, (from, to) => ListNeighbors(mesh, rowStart, columns, from, to));
        return new SparseMatrix(rowStart, columns, GC.AllocateUninitializedArray<double>(columns.Length), new double[n], isSymmetric);
    }

    /// <summary>Sets the values; weights are per edge if the matrix is symmetric, otherwise per half-edge.</summary>
    internal static void Fill(SparseMatrix places, Mesh mesh, double[] weight) =>
        Parallelism.ForBlocks(places.Size, (from, to) => FillRows(places, mesh, weight, places.IsSymmetric ? 1 : 0, from, to));

    private static void CountNeighbors(Mesh mesh, Span<int> rowStart, int from, int to)
    {
        ReadOnlySpan<int> next = mesh.Next, outgoing = mesh.Outgoing;
        for (int v = from; v < to; v++)
        {
            int first = outgoing[v], valence = 0;
            if (first >= 0)
            {
                int h = first;
                do
                {
                    valence++;
                    h = next[h ^ 1];
                }
                while (h != first);
            }
            rowStart[v + 1] = valence;
        }
    }

    private static void ListNeighbors(Mesh mesh, ReadOnlySpan<int> rowStart, Span<int> columns, int from, int to)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, outgoing = mesh.Outgoing;
        for (int v = from; v < to; v++)
        {
            int h = outgoing[v];
            for (int k = rowStart[v]; k < rowStart[v + 1]; k++)
            {
                columns[k] = target[h];
                h = next[h ^ 1];
            }
        }
    }

    private static void FillRows(SparseMatrix places, Mesh mesh, ReadOnlySpan<double> weight, int shift, int from, int to)
    {
        ReadOnlySpan<int> rowStart = places.RowStart, next = mesh.Next, outgoing = mesh.Outgoing;
        Span<double> values = places.Values, diagonal = places.Diagonal;
        for (int v = from; v < to; v++)
        {
            int h = outgoing[v];
            double sum = 0;
            for (int k = rowStart[v]; k < rowStart[v + 1]; k++)
            {
                double w = weight[h >> shift];
                values[k] = -w;
                sum += w;
                h = next[h ^ 1];
            }
            diagonal[v] = sum;
        }
    }

    private static double[] UniformWeights(Mesh mesh)
    {
        var weight = new double[mesh.EdgeSlots];
        Array.Fill(weight, 1);
        return weight;
    }

    private static double[] MeanValueWeights(Mesh mesh)
    {
        OppositeCotangents.RequireTriangles(mesh);
        int[] next = mesh.next, target = mesh.target, face = mesh.face;
        Vector3D[] position = mesh.positions;
        var weight = new double[mesh.HalfEdgeSlots];
        Parallelism.ForBlocks(weight.Length, (from, to) =>
        {
            for (int h = from; h < to; h++)
            {
                if (next[h] < 0)
                    continue;
                Vector3D p = position[target[h ^ 1]], edge = position[target[h]] - p;
                double sum = 0;
                if (face[h] >= 0)
                    sum += TangentOfHalfAngle(edge, position[target[next[h]]] - p);
                if (face[h ^ 1] >= 0)
                    sum += TangentOfHalfAngle(edge, position[target[next[h ^ 1]]] - p);
                double length = edge.Length;
                weight[h] = length > 0 ? sum / length : 0;
            }
        });
        return weight;
    }

    // tan(θ/2) = sin θ / (1 + cos θ) = |a × b| / (|a||b| + a·b). For angles near π the other form, (1 − cos θ)/ sin θ, does not cancel.
    private static double TangentOfHalfAngle(Vector3D a, Vector3D b)
    {
        double sine = Vector3D.Cross(a, b).Length, cosine = Vector3D.Dot(a, b), lengths = a.Length * b.Length;
        if (cosine >= 0)
            return lengths > 0 ? sine / (lengths + cosine) : 0;
        return sine > 0 ? (lengths - cosine) / sine : 0;
    }
}
