using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Chapter 8: every scheme by its name.</summary>
public static class SubdivisionSchemes
{
    extension(Mesh mesh)
    {
        /// <summary>Subdivides (细分) with a scheme; the mesh is not changed.</summary>
        /// <param name="scheme">Which.</param>
        /// <param name="options">Steps, weights, budget, creases.</param>
        /// <param name="progress">Told the part done.</param>
        /// <param name="cancellationToken">Stops the work; nothing is returned then.</param>
        /// <exception cref="ArgumentException">The scheme takes triangles and a face is none, or the result would have more faces than the budget.</exception>
        public Mesh Subdivide(
            SubdivisionScheme scheme,
            SubdivisionOptions? options = null,
            IProgress<double>? progress = null,
            CancellationToken cancellationToken = default) => scheme switch
        {
            SubdivisionScheme.Loop => LoopSubdivision.Subdivide(mesh, options, progress, cancellationToken),
            SubdivisionScheme.ModifiedButterfly => ButterflySubdivision.Subdivide(mesh, options, progress, cancellationToken),
            SubdivisionScheme.Sqrt3 => Sqrt3Subdivision.Subdivide(mesh, options, progress, cancellationToken),
            SubdivisionScheme.CatmullClark => CatmullClarkSubdivision.Subdivide(mesh, options, progress, cancellationToken),
            SubdivisionScheme.DooSabin => DooSabinSubdivision.Subdivide(mesh, options, progress, cancellationToken),
            SubdivisionScheme.Midpoint => MidpointSubdivision.Subdivide(mesh, options, progress, cancellationToken),
            _ => throw new ArgumentOutOfRangeException(nameof(scheme), scheme, "There is no such scheme."),
        };

        /// <summary>Subdivides with a scheme and says what was done; the mesh is not changed.</summary>
        /// <param name="scheme">Which.</param>
        /// <param name="options">Steps, weights, budget, creases.</param>
        /// <param name="report">What was done, and why it ended.</param>
        /// <param name="progress">Told the part done.</param>
        /// <param name="cancellationToken">Stops the work; nothing is returned then.</param>
        /// <exception cref="ArgumentException">The scheme takes triangles and a face is none, or the result would have more faces than the budget.</exception>
        public Mesh Subdivide(
            SubdivisionScheme scheme,
            SubdivisionOptions? options,
            out SubdivisionReport report,
            IProgress<double>? progress = null,
            CancellationToken cancellationToken = default)
        {
            Mesh result = mesh.Subdivide(scheme, options, progress, cancellationToken);
            options ??= SubdivisionOptions.Default;
            SubdivisionStop stop = (options.Steps > 0 || options.ToLimit) && mesh.Faces.Count > 0 ? SubdivisionStop.StepsDone : SubdivisionStop.NothingToDo;
            report = new(stop, stop == SubdivisionStop.StepsDone ? options.Steps : 0, mesh.Faces.Count, result.Faces.Count);
            return result;
        }
    }
}
