using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>§8.3 √3 细分 (√3 scheme): each triangle gets a vertex in its middle, then every old edge is flipped. C² but for C¹ at extraordinary vertices. Kobbelt 2000.</summary>
/// <remarks>
/// <code>
///        v2                        middle (v0 + v1 + v2)/3
///       / │ \                      old vertex (1 − α) v + α · mean of neighbours, α = (4 − 2 cos 2π/n)/9
///      /  c  \                     spoke k of face f is edge E + 3f + k; the old edge becomes the flipped one;
///     / /   \ \                    face 3f + k belongs to half-edge k of face f
///   v0 ─────── v1
/// </code>
/// Boundary edges are not flipped. In the first of two steps the boundary stays as it is; in the second each boundary edge is cut in three, with
/// (4, 19, 4)/27 for old vertices and (10, 16, 1)/27 for new ones, and its triangle into three, without a vertex in its middle: two steps are one trisection
/// of every edge. F → 3F. O(F).
/// </remarks>
public static class Sqrt3Subdivision
{
    private const int BlockSize = 8192;
    private const int TabulatedValences = 64;

    private static readonly double[] Table = Tabulate();

    /// <summary>Subdivides a triangle mesh. Old vertices keep their indices, those of the faces follow in face order (two for a face whose boundary edge is cut in three).</summary>
    /// <inheritdoc cref="LoopSubdivision.Subdivide"/>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        Stepper.RequireTriangles(mesh);
        options ??= SubdivisionOptions.Default;
        int phase = options.BeginWithBoundaryTrisection ? 1 : 0;
        return Stepper.Run(
            mesh,
            options,
            (size, number) => size.Trisected(TrisectsBoundary(number)),
            (coarse, number, token) => TrisectsBoundary(number) && !coarse.IsClosed ? BoundaryTrisection.Step(coarse, token) : Step(coarse, token),
            SplitTraits.Trisected,
            null,
            progress,
            cancellationToken);

        bool TrisectsBoundary(int number) => ((number + phase) & 1) == 1;
    }

    /// <summary>α: how far an interior vertex moves to the mean of its neighbours.</summary>
    /// <param name="valence">n, at least 1.</param>
    public static double NeighborWeight(int valence)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(valence, 1);
        return (4 - 2 * Math.Cos(2 * Math.PI / valence)) / 9;
    }

    /// <summary>The new place of an interior vertex.</summary>
    internal static unsafe Vector3D Relaxed(Mesh mesh, int v)
    {
        fixed (int* next = mesh.next, target = mesh.target)
        fixed (Vector3D* old = mesh.positions)
            return Relaxed(next, target, old, v, mesh.outgoing[v]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static unsafe Vector3D Relaxed(int* next, int* target, Vector3D* old, int v, int start)
    {
        Vector3D ring = RingSum.Around(next, target, old, start, out int valence);
        double alpha = valence < TabulatedValences ? Table[valence] : NeighborWeight(valence);
        return (1 - alpha) * old[v] + alpha / valence * ring;
    }

    private static Mesh Step(Mesh mesh, CancellationToken cancellationToken)
    {
        int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots, faces = mesh.FaceSlots, halfEdges = 2 * edges + 6 * faces;
        var finer = new Mesh(
            GC.AllocateUninitializedArray<Vector3D>(vertices + faces),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(vertices + faces),
            GC.AllocateUninitializedArray<int>(3 * faces));
        var side = GC.AllocateUninitializedArray<byte>(2 * edges);
        Parallelism.ForBlocks(faces, BlockSize, (from, to) =>
        {
            cancellationToken.ThrowIfCancellationRequested();
            PlaceMiddles(mesh, finer, side, from, to);
        });
        Parallelism.ForBlocks(faces, BlockSize, (from, to) => LinkFaces(mesh, finer, side, from, to));
        Parallelism.ForBlocks(vertices, BlockSize, (from, to) => PlaceVertices(mesh, finer, side, from, to));
        return finer;
    }

    /// <summary>The vertex in the middle of each face; and the number, in its face, of each half-edge.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void PlaceMiddles(Mesh mesh, Mesh finer, byte[] sides, int from, int to)
    {
        int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots;
        fixed (byte* side = sides)
        fixed (int* next = mesh.next, target = mesh.target, first = mesh.halfEdgeOf, outgoing = finer.outgoing)
        fixed (Vector3D* old = mesh.positions, placed = finer.positions)
        {
            for (int f = from; f < to; f++)
            {
                int h0 = first[f], h1 = next[h0], h2 = next[h1];
                side[h0] = 0;
                side[h1] = 1;
                side[h2] = 2;
                placed[vertices + f] = 1.0 / 3 * (old[target[h2]] + old[target[h0]] + old[target[h1]]);
                outgoing[vertices + f] = 2 * (edges + 3 * f);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void LinkFaces(Mesh mesh, Mesh finer, byte[] sides, int from, int to)
    {
        int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots;
        fixed (byte* side = sides)
        fixed (int* oldNext = mesh.next, oldTarget = mesh.target, oldFace = mesh.face, oldFirst = mesh.halfEdgeOf)
        fixed (int* next = finer.next, previous = finer.previous, target = finer.target, face = finer.face, first = finer.halfEdgeOf)
        {
            var links = new LinkColumns(next, previous, face);
            for (int f = from; f < to; f++)
            {
                int middle = vertices + f, h = oldFirst[f];
                for (int k = 0; k < 3; k++, h = oldNext[h])
                {
                    // The spoke's even half-edge leads from the middle to the source of h.
                    int spoke = 2 * (edges + 3 * f + k), twin = h ^ 1, beyond = oldFace[twin], child = 3 * f + k;
                    target[spoke] = oldTarget[twin];
                    target[spoke + 1] = middle;
                    first[child] = h;
                    if (beyond < 0)
                    {
                        int nextSpoke = k == 2 ? spoke - 4 : spoke + 2;
                        target[h] = oldTarget[h];
                        links.Triangle(h, nextSpoke + 1, spoke, child);
                    }
                    else
                    {
                        // h becomes the flipped edge: from the middle beyond to this one, around the source of h.
                        int j = side[twin];
                        int spokeBeyond = 2 * (edges + 3 * beyond + (j == 2 ? 0 : j + 1)) + 1;
                        target[h] = middle;
                        links.Triangle(h, spoke, spokeBeyond, child);
                    }
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void PlaceVertices(Mesh mesh, Mesh finer, byte[] side, int from, int to)
    {
        int edges = mesh.EdgeSlots;
        fixed (int* next = mesh.next, target = mesh.target, face = mesh.face, outgoing = mesh.outgoing, finerOutgoing = finer.outgoing)
        fixed (Vector3D* old = mesh.positions, placed = finer.positions)
        {
            for (int v = from; v < to; v++)
            {
                int h = outgoing[v];
                if (h >= 0 && face[h] >= 0)
                {
                    finerOutgoing[v] = 2 * (edges + 3 * face[h] + side[h]) + 1;
                    placed[v] = Relaxed(next, target, old, v, h);
                    continue;
                }
                finerOutgoing[v] = h;
                placed[v] = old[v];
                if (h < 0)
                    continue;
                // The half-edges of a hole stay as they are.
                finer.face[h] = -1;
                finer.target[h] = target[h];
                finer.next[h] = next[h];
                finer.previous[h] = mesh.previous[h];
            }
        }
    }

    private static double[] Tabulate()
    {
        var table = new double[TabulatedValences];
        for (int n = 1; n < table.Length; n++)
            table[n] = NeighborWeight(n);
        return table;
    }
}
