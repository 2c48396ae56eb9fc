using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>§8.1 Loop 细分 (Loop's scheme): triangles, approximating, C² but for C¹ at vertices whose valence is not 6. Loop 1987.</summary>
/// <remarks>
/// <code>
///         1/8                      β   β
///        /   \                    β  1−nβ  β        boundary:  1/8 ── 3/4 ── 1/8  and  1/2 ── 1/2
///     3/8 ─●─ 3/8                  β   β
///        \   /
///         1/8
/// </code>
/// β = (5/8 − (3/8 + ¼ cos 2π/n)²)/n, or Warren's 3/(8n) with 3/16 for n = 3. On the boundary only the neighbours along it count, so that the
/// boundary curve is a cubic B-spline of the boundary polygon. Creases: <see cref="Creases"/>. F → 4F. O(F).
/// </remarks>
public static class LoopSubdivision
{
    private const int BlockSize = 8192;
    private const int TabulatedValences = 64;

    private static readonly double[] TableOfLoop = Tabulate(LoopWeights.Loop1987);
    private static readonly double[] TableOfWarren = Tabulate(LoopWeights.Warren);

    /// <summary>Subdivides a triangle mesh. Old vertices keep their indices, the vertex of edge e follows as V + e; deleted elements are compacted away first.</summary>
    /// <param name="mesh">Triangles; it is not changed.</param>
    /// <param name="options">Steps, weights, budget, creases.</param>
    /// <param name="progress">Told the part done.</param>
    /// <param name="cancellationToken">Stops the work; nothing is returned then.</param>
    /// <returns>A new mesh with the traits subdivided too.</returns>
    /// <exception cref="ArgumentException">A face is not a triangle, a sharpness is NaN, the result would have more faces than the budget, or the limit is asked for with
    /// edges of a finite sharpness left.</exception>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        Stepper.RequireTriangles(mesh);
        options ??= SubdivisionOptions.Default;
        return Stepper.Run(
            mesh,
            options,
            (size, _) => size.Quadrisected(),
            (coarse, _, token) => Step(coarse, options, token),
            SplitTraits.Quadrisected,
            (finest, part, token) => LimitSurface.OfLoop(finest, options.Weights, options.UseCreases, part, token),
            progress,
            cancellationToken);
    }

    /// <summary>The weight β of each neighbour of an interior vertex.</summary>
    /// <param name="valence">n, at least 1.</param>
    /// <param name="weights">Loop's or Warren's.</param>
    public static double NeighborWeight(int valence, LoopWeights weights = LoopWeights.Loop1987)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(valence, 1);
        if (weights == LoopWeights.Warren)
            return valence == 3 ? 3.0 / 16 : 3.0 / (8 * valence);
        double c = 0.375 + 0.25 * Math.Cos(2 * Math.PI / valence);
        return (0.625 - c * c) / valence;
    }

    private static Mesh Step(Mesh mesh, SubdivisionOptions options, CancellationToken cancellationToken)
    {
        Mesh finer = Quadrisection.Connect(mesh, cancellationToken);
        double[] table = options.Weights == LoopWeights.Warren ? TableOfWarren : TableOfLoop;
        Parallelism.ForBlocks(mesh.EdgeSlots, BlockSize, (from, to) => PlaceEdges(mesh, finer.positions, from, to));
        Parallelism.ForBlocks(mesh.VertexSlots, BlockSize, (from, to) => PlaceVertices(mesh, finer.positions, table, options.Weights, from, to));
        if (options.UseCreases)
            Creases.Sharpen(mesh, finer.positions);
        return finer;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void PlaceEdges(Mesh mesh, Vector3D[] result, int from, int to)
    {
        int vertices = mesh.VertexSlots;
        fixed (int* next = mesh.next, target = mesh.target, face = mesh.face)
        fixed (Vector3D* old = mesh.positions, placed = result)
        {
            for (int e = from; e < to; e++)
            {
                int h = 2 * e, t = h + 1;
                Vector3D ends = old[target[h]] + old[target[t]];
                placed[vertices + e] = (face[h] | face[t]) < 0
                    ? 0.5 * ends
                    : 0.375 * ends + 0.125 * (old[target[next[h]]] + old[target[next[t]]]);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void PlaceVertices(Mesh mesh, Vector3D[] result, double[] table, LoopWeights weights, int from, int to)
    {
        fixed (int* next = mesh.next, previous = mesh.previous, target = mesh.target, face = mesh.face, outgoing = mesh.outgoing)
        fixed (Vector3D* old = mesh.positions, placed = result)
        {
            for (int v = from; v < to; v++)
            {
                int start = outgoing[v];
                if (start < 0)
                {
                    placed[v] = old[v];
                    continue;
                }
                if (face[start] < 0)
                {
                    placed[v] = 0.75 * old[v] + 0.125 * (old[target[start]] + old[target[previous[start] ^ 1]]);
                    continue;
                }
                Vector3D ring = RingSum.Around(next, target, old, start, out int valence);
                double beta = valence < TabulatedValences ? table[valence] : NeighborWeight(valence, weights);
                placed[v] = (1 - valence * beta) * old[v] + beta * ring;
            }
        }
    }

    private static double[] Tabulate(LoopWeights weights)
    {
        var table = new double[TabulatedValences];
        for (int n = 1; n < table.Length; n++)
            table[n] = NeighborWeight(n, weights);
        return table;
    }
}
