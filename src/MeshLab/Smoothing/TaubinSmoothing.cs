using MeshLab.Structure;

namespace MeshLab.Smoothing;

/// <summary>How Taubin smoothing works.</summary>
public sealed record TaubinSmoothingOptions : SmoothingOptions
{
    private readonly double lambda = 0.5;
    private readonly double passBand = 0.1;

    /// <summary>λ, the part of the way to the neighbours' mean in the shrinking half of a step, in (0, 1]; 0.5 unless set.</summary>
    public double Lambda
    {
        get => lambda;
        init => lambda = Checked(value, 0, 1, nameof(Lambda));
    }

    /// <summary>k_PB, the frequency (eigenvalue of the Laplacian, 0 to 2) below which nothing is lost, in (0, 1); 0.1 unless set.</summary>
    public double PassBand
    {
        get => passBand;
        init => passBand = Checked(value, 0, 0.99, nameof(PassBand));
    }

    /// <summary>μ, the negative factor of the swelling half: 1/λ + 1/μ = k_PB.</summary>
    public double Mu => 1 / (PassBand - 1 / Lambda);
}

/// <summary>Taubin λ|μ 光顺 (Taubin smoothing): one step inwards, one slightly larger step outwards, so that noise goes and the volume stays.</summary>
/// <remarks>
/// A wave of frequency k is multiplied by (1 − λ k)(1 − μ k) per step: 1 at k = 0 and at k = k_PB, between them slightly more, above less and less.
/// Taubin 1995, "A signal processing approach to fair surface design", SIGGRAPH, §3. Equal weights, so it works on polygons. A step is both halves.
/// O(H) per step, in parallel.
/// </remarks>
public static class TaubinSmoothing
{
    extension(Mesh mesh)
    {
        /// <summary>Smooths without shrinking.</summary>
        /// <param name="options">Steps, λ, pass band and boundary.</param>
        /// <param name="progress">The part of the steps done.</param>
        /// <param name="cancellationToken">Stops the work; the mesh is then left as it was.</param>
        public SmoothingResult SmoothByTaubin(
            TaubinSmoothingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new TaubinSmoothingOptions();
            var positions = new MovingPositions(mesh);
            for (int step = 0; step < options.Steps; step++)
            {
                cancellationToken.ThrowIfCancellationRequested();
                positions.Step(options.Lambda, weights: null, options.Boundary);
                positions.Step(options.Mu, weights: null, options.Boundary);
                progress?.Report((step + 1.0) / options.Steps);
            }
            return positions.Finish(options.Steps);
        }
    }
}
