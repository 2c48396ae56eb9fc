using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Midpoint subdivision (中点细分): each triangle is cut into four and nothing moves, so the surface stays the same.</summary>
public static class MidpointSubdivision
{
    private const int BlockSize = 8192;

    /// <inheritdoc cref="LoopSubdivision.Subdivide"/>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        Stepper.RequireTriangles(mesh);
        return Stepper.Run(
            mesh, options, (size, _) => size.Quadrisected(), (coarse, _, token) => Step(coarse, token), SplitTraits.Quadrisected, null, progress, cancellationToken);
    }

    private static Mesh Step(Mesh mesh, CancellationToken cancellationToken)
    {
        Mesh finer = Quadrisection.Connect(mesh, cancellationToken);
        mesh.Positions.CopyTo(finer.Positions);
        Parallelism.ForBlocks(mesh.EdgeSlots, BlockSize, (from, to) =>
        {
            ReadOnlySpan<int> target = mesh.Target;
            Span<Vector3D> positions = finer.Positions;
            for (int e = from; e < to; e++)
                positions[mesh.VertexSlots + e] = 0.5 * (positions[target[2 * e]] + positions[target[2 * e + 1]]);
        });
        return finer;
    }
}
