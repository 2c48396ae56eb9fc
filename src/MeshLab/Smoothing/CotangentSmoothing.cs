using MeshLab.LinearAlgebra;
using MeshLab.Structure;

namespace MeshLab.Smoothing;

/// <summary>How cotangent smoothing works.</summary>
public sealed record CotangentSmoothingOptions : SmoothingOptions
{
    private readonly double factor = 0.5;

    /// <summary>The part of the way to the neighbours' weighted mean, in (0, 1]; 0.5 unless set.</summary>
    public double Factor
    {
        get => factor;
        init => factor = Checked(value, 0, 1, nameof(Factor));
    }
}

/// <summary>余切权光顺 (cotangent smoothing): vertices move along the mean-curvature normal, so that the shape smooths but the triangles stay as they are.</summary>
/// <remarks>
/// x_i ← x_i + λ Σ_j w_ij (x_j − x_i) / Σ_j w_ij with w_ij = max(0, (cot α + cot β)/2), computed anew in each step. Negative weights would push a vertex
/// away from its neighbour, so they count as zero. Desbrun, Meyer, Schröder, Barr 1999, §5. O(H) per step, in parallel.
/// </remarks>
public static class CotangentSmoothing
{
    extension(Mesh mesh)
    {
        /// <summary>Smooths with cotangent weights.</summary>
        /// <param name="options">Steps, factor and boundary.</param>
        /// <param name="progress">The part of the steps done.</param>
        /// <param name="cancellationToken">Stops the work; the mesh is then left as it was.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public SmoothingResult SmoothByCotangents(
            CotangentSmoothingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new CotangentSmoothingOptions();
            OppositeCotangents.RequireTriangles(mesh);
            var positions = new MovingPositions(mesh);
            for (int step = 0; step < options.Steps; step++)
            {
                cancellationToken.ThrowIfCancellationRequested();
                double[] weights = Laplacian.CotangentWeights(OppositeCotangents.Of(mesh, positions.Current, out _), smallest: 0);
                positions.Step(options.Factor, weights, options.Boundary);
                progress?.Report((step + 1.0) / options.Steps);
            }
            return positions.Finish(options.Steps);
        }
    }
}
