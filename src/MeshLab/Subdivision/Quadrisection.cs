using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>The connectivity of Loop's, the butterfly and the midpoint scheme: each triangle is cut into four.</summary>
/// <remarks>
/// <code>
///            v2                    children of half-edge h of edge e:
///           /  \                     First(h)  = 4e + 3 (h and 1)        source → middle
///         m2 ── m1                   Second(h) = 4e + 2 − (h and 1)      middle → target
///        /  \  /  \                so that twins stay neighbours (h ^ 1)
///      v0 ── m0 ── v1              corner faces 4f + k, the middle one 4f + 3
///          h0 →                    inner edge k, half-edges 4E + 6f + 2k: m(k) → m(k−1), and back
/// </code>
/// All numbers follow from the old ones by arithmetic, so one pass over the faces writes every link: no map, no search for twins. Old vertices keep
/// their indices, the middle of edge e is vertex V + e.
/// </remarks>
internal static class Quadrisection
{
    private const int BlockSize = 8192;

    public static int First(int h) => 4 * (h >> 1) + 3 * (h & 1);

    public static int Second(int h) => 4 * (h >> 1) + 2 - (h & 1);

    /// <summary>Makes the finer mesh; its positions are still to be written.</summary>
    public static Mesh Connect(Mesh mesh, CancellationToken cancellationToken)
    {
        int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots, faces = mesh.FaceSlots, halfEdges = 4 * edges + 6 * faces;
        var finer = new Mesh(
            GC.AllocateUninitializedArray<Vector3D>(vertices + edges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(halfEdges),
            GC.AllocateUninitializedArray<int>(vertices + edges),
            GC.AllocateUninitializedArray<int>(4 * faces));
        Parallelism.ForBlocks(faces, BlockSize, (from, to) =>
        {
            cancellationToken.ThrowIfCancellationRequested();
            LinkFaces(mesh, finer, from, to);
        });
        Parallelism.ForBlocks(edges, BlockSize, (from, to) => LinkEdges(mesh, finer, from, to));
        Parallelism.ForBlocks(vertices, BlockSize, (from, to) => LinkVertices(mesh, finer, from, to));
        return finer;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void LinkFaces(Mesh mesh, Mesh finer, int from, int to)
    {
        int firstMiddle = mesh.VertexSlots, firstInner = 4 * mesh.EdgeSlots;
        fixed (int* oldNext = mesh.next, oldTarget = mesh.target, oldFirst = mesh.halfEdgeOf)
        fixed (int* next = finer.next, previous = finer.previous, target = finer.target, face = finer.face, first = finer.halfEdgeOf)
        {
            var links = new LinkColumns(next, previous, face);
            for (int f = from; f < to; f++)
            {
                int h0 = oldFirst[f], h1 = oldNext[h0], h2 = oldNext[h1];
                int m0 = firstMiddle + (h0 >> 1), m1 = firstMiddle + (h1 >> 1), m2 = firstMiddle + (h2 >> 1);
                int a0 = firstInner + 6 * f, a1 = a0 + 2, a2 = a0 + 4, child = 4 * f;
                int leaving0 = First(h0), leaving1 = First(h1), leaving2 = First(h2);
                int arriving0 = Second(h2), arriving1 = Second(h0), arriving2 = Second(h1);

                links.Triangle(leaving0, a0, arriving0, child);
                links.Triangle(leaving1, a1, arriving1, child + 1);
                links.Triangle(leaving2, a2, arriving2, child + 2);
                links.Triangle(a0 + 1, a1 + 1, a2 + 1, child + 3);

                target[leaving0] = target[a0 + 1] = target[a1] = m0;
                target[leaving1] = target[a1 + 1] = target[a2] = m1;
                target[leaving2] = target[a2 + 1] = target[a0] = m2;
                target[arriving0] = oldTarget[h2];
                target[arriving1] = oldTarget[h0];
                target[arriving2] = oldTarget[h1];

                first[child] = leaving0;
                first[child + 1] = leaving1;
                first[child + 2] = leaving2;
                first[child + 3] = a1 + 1;
            }
        }
    }

    private static void LinkEdges(Mesh mesh, Mesh finer, int from, int to)
    {
        int firstMiddle = mesh.VertexSlots;
        ReadOnlySpan<int> face = mesh.face;
        for (int e = from; e < to; e++)
        {
            int h = 2 * e;
            if ((face[h] | face[h + 1]) >= 0)
            {
                finer.outgoing[firstMiddle + e] = 4 * e + 2;
                continue;
            }
            int hole = face[h] < 0 ? h : h + 1, first = First(hole), second = Second(hole);
            finer.face[first] = finer.face[second] = -1;
            finer.target[first] = firstMiddle + e;
            finer.target[second] = mesh.target[hole];
            finer.next[first] = second;
            finer.previous[second] = first;
            finer.next[second] = First(mesh.next[hole]);
            finer.previous[first] = Second(mesh.previous[hole]);
            finer.outgoing[firstMiddle + e] = second;
        }
    }

    private static void LinkVertices(Mesh mesh, Mesh finer, int from, int to)
    {
        for (int v = from; v < to; v++)
        {
            int h = mesh.outgoing[v];
            finer.outgoing[v] = h < 0 ? h : First(h);
        }
    }
}
