using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>How eigenpairs are computed.</summary>
public sealed record EigenOptions
{
    private readonly double tolerance = 1e-11;
    private readonly int blockSize = 8;
    private readonly int maxSolutions = 5000;

    /// <summary>The weights of the Laplacian.</summary>
    public LaplacianWeights Weights { get; init; } = LaplacianWeights.Cotangent;

    /// <summary>The mass matrix.</summary>
    public MassKind Mass { get; init; } = MassKind.Mixed;

    /// <summary>An eigenpair is done when its residual under the shifted inverse falls below this part of the eigenvalue of that inverse.</summary>
    public double Tolerance
    {
        get => tolerance;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            tolerance = value;
        }
    }

    /// <summary>The vectors iterated at once; eigenvalues of up to this multiplicity are found for certain.</summary>
    public int BlockSize
    {
        get => blockSize;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            blockSize = value;
        }
    }

    /// <summary>The most systems that are solved before giving up.</summary>
    public int MaxSolutions
    {
        get => maxSolutions;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            maxSolutions = value;
        }
    }
}

/// <summary>Eigenvalues and eigenvectors, ascending.</summary>
/// <param name="Values">λ_k.</param>
/// <param name="Vectors">x_k with xᵀ M x = 1 and the entry of largest magnitude positive; NaN at vertices without mass.</param>
/// <param name="Solutions">The number of systems that were solved.</param>
public sealed record Eigenpairs(double[] Values, double[][] Vectors, int Solutions);

/// <summary>§12.1 拉普拉斯特征向量 (Laplacian eigenvectors): the smallest λ with L x = λ M x, the "frequencies" of a surface.</summary>
/// <remarks>
/// <para>
/// (L + σ M)⁻¹ M has the same eigenvectors and the eigenvalues 1/(λ + σ): the smallest λ become the largest by far. On it runs a Lanczos method with
/// blocks of vectors, so that an eigenvalue of the sphere, there 2 l + 1 times, is found that many times, with full reorthogonalization, and thick
/// restarts. Ericsson, Ruhe 1980, Math. Comp. 35 (shift and invert); Golub, Underwood 1977 (blocks); Wu, Simon 2000, SIAM J. Matrix Anal. Appl. 22(2)
/// (restarts). The start vectors come from a fixed seed: the same bits always.
/// </para>
/// <para>Cost: one factorization, and about two to six solutions per eigenpair.</para>
/// </remarks>
public static class LaplacianSpectrum
{
    extension(Mesh mesh)
    {
        /// <summary>The smallest eigenpairs of the Laplacian.</summary>
        /// <param name="count">How many; the first of each component is 0.</param>
        /// <param name="options">Weights, mass, accuracy.</param>
        /// <param name="progress">The part of the eigenpairs that is done.</param>
        /// <param name="cancellationToken">Stops the work.</param>
        /// <exception cref="ArgumentOutOfRangeException">Less than 1, or more than there are vertices with edges.</exception>
        /// <exception cref="ArgumentException">A face is not a triangle, the weights are not symmetric, or a vertex has no positive mass.</exception>
        /// <exception cref="ArithmeticException">Not converged.</exception>
        public Eigenpairs ComputeSmallestEigenpairs(
            int count, EigenOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new EigenOptions();
            SparseMatrix laplacian = mesh.ComputeLaplacian(options.Weights), mass = mesh.ComputeMassMatrix(options.Mass);
            (int[] index, List<int> slots) = NumberVertices(mesh, mass);
            ArgumentOutOfRangeException.ThrowIfLessThan(count, 1);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(count, slots.Count);

            Vector3D[] positions = [.. slots.Select(v => mesh.positions[v])];
            Eigenpairs pairs = ShiftInvertLanczos.Smallest(
                laplacian.Principal(index, slots.Count), mass.Principal(index, slots.Count), count, positions, options, progress, cancellationToken);
            return pairs with { Vectors = Array.ConvertAll(pairs.Vectors, x => Spread(x, index)) };
        }
    }

    // Leaves out vertices without edges, which have neither stiffness nor mass.
    private static (int[] Index, List<int> Slots) NumberVertices(Mesh mesh, SparseMatrix mass)
    {
        var index = new int[mesh.VertexSlots];
        var slots = new List<int>();
        for (int v = 0; v < index.Length; v++)
        {
            index[v] = mesh.outgoing[v] < 0 ? -1 : slots.Count;
            if (index[v] < 0)
                continue;
            if (!(mass.Diagonal[v] > 0))
                throw new ArgumentException($"v{v} has the mass {mass.Diagonal[v]}; all must be positive.", nameof(mesh));
            slots.Add(v);
        }
        return (index, slots);
    }

    private static double[] Spread(double[] x, int[] index) => Array.ConvertAll(index, i => i < 0 ? double.NaN : x[i]);
}
