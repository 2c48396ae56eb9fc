using MeshLab.Structure;

namespace MeshLab.Smoothing;

/// <summary>How uniform smoothing works.</summary>
public sealed record UniformSmoothingOptions : SmoothingOptions
{
    private readonly double factor = 0.5;

    /// <summary>The part of the way to the neighbours' mean, in (0, 1]; 0.5 unless set.</summary>
    public double Factor
    {
        get => factor;
        init => factor = Checked(value, 0, 1, nameof(Factor));
    }
}

/// <summary>均匀拉普拉斯光顺 (uniform Laplacian smoothing): every vertex moves towards the mean of its neighbours.</summary>
/// <remarks>
/// x_i ← x_i + λ (1/d_i Σ_j x_j − x_i), all vertices at once. Also evens out the triangles, since it moves vertices within the surface; shrinks.
/// Field 1988, Comm. Appl. Numer. Meth. 4. Works on polygons. O(H) per step, in parallel.
/// </remarks>
public static class UniformSmoothing
{
    extension(Mesh mesh)
    {
        /// <summary>Smooths with equal weights.</summary>
        /// <param name="options">Steps, factor and boundary.</param>
        /// <param name="progress">The part of the steps done.</param>
        /// <param name="cancellationToken">Stops the work; the mesh is then left as it was.</param>
        public SmoothingResult SmoothUniformly(
            UniformSmoothingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new UniformSmoothingOptions();
            var positions = new MovingPositions(mesh);
            for (int step = 0; step < options.Steps; step++)
            {
                cancellationToken.ThrowIfCancellationRequested();
                positions.Step(options.Factor, weights: null, options.Boundary);
                progress?.Report((step + 1.0) / options.Steps);
            }
            return positions.Finish(options.Steps);
        }
    }
}
