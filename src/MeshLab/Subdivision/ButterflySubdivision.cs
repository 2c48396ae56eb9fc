using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>§8.2 改进的蝴蝶细分 (modified butterfly): triangles, interpolating, C¹. Zorin, Schröder, Sweldens 1996.</summary>
/// <remarks>
/// <code>
///   −1/16 ── 1/8 ── −1/16        both ends of valence 6: this stencil (w = 0)
///       \   /   \   /            one end of another valence k: that end's own stencil, ¾ at the end and around it
///        a ──●── b                 k = 3: 5/12, −1/12, −1/12          k = 4: 3/8, 0, −1/8, 0
///       /   \   /   \              k ≥ 5: (¼ + cos 2πj/k + ½ cos 4πj/k)/k
///   −1/16 ── 1/8 ── −1/16        both ends: the mean of the two stencils
///   a, b: 1/2                    boundary edge: −1/16, 9/16, 9/16, −1/16 along the boundary
/// </code>
/// A stencil that reaches across the boundary takes a virtual vertex there: the opposite one reflected in the middle of the boundary edge. A vertex on
/// the boundary counts as regular. Old vertices do not move. (The textbook's weights 0.4, 0.2, −0.05 do not even sum to 1.) F → 4F. O(F).
/// </remarks>
public static class ButterflySubdivision
{
    private const int BlockSize = 8192;
    private const int Regular = 6;

    /// <inheritdoc cref="LoopSubdivision.Subdivide"/>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        Stepper.RequireTriangles(mesh);
        return Stepper.Run(
            mesh, options, (size, _) => size.Quadrisected(), (coarse, _, token) => Step(coarse, token), SplitTraits.Quadrisected, null, progress, cancellationToken);
    }

    /// <summary>The weights of the neighbours of an extraordinary vertex, beginning with the other end of the edge; the vertex itself has ¾.</summary>
    /// <param name="valence">k, at least 3.</param>
    public static double[] ExtraordinaryWeights(int valence)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(valence, 3);
        if (valence == 3)
            return [5.0 / 12, -1.0 / 12, -1.0 / 12];
        if (valence == 4)
            return [3.0 / 8, 0, -1.0 / 8, 0];
        var weights = new double[valence];
        for (int j = 0; j < valence; j++)
            weights[j] = (0.25 + Math.Cos(2 * Math.PI * j / valence) + 0.5 * Math.Cos(4 * Math.PI * j / valence)) / valence;
        return weights;
    }

    private static Mesh Step(Mesh mesh, CancellationToken cancellationToken)
    {
        Mesh finer = Quadrisection.Connect(mesh, cancellationToken);
        mesh.Positions.CopyTo(finer.Positions);
        int[] valence = Valences(mesh);
        double[][] table = Tabulate(valence);
        Parallelism.ForBlocks(mesh.EdgeSlots, BlockSize, (from, to) => PlaceEdges(mesh, finer.positions, valence, table, from, to));
        return finer;
    }

    /// <summary>The valences; of boundary vertices 6, because they count as regular.</summary>
    private static int[] Valences(Mesh mesh)
    {
        var valence = new int[mesh.VertexSlots];
        ReadOnlySpan<int> target = mesh.Target, face = mesh.FaceOf;
        foreach (int v in target)
            valence[v]++;
        for (int h = 0; h < face.Length; h++)
        {
            if (face[h] < 0)
                valence[target[h]] = Regular;
        }
        return valence;
    }

    private static double[][] Tabulate(int[] valence)
    {
        var table = new double[valence.DefaultIfEmpty(0).Max() + 1][];
        foreach (int k in valence)
        {
            if (k >= 3)
                table[k] ??= ExtraordinaryWeights(k);
        }
        return table;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static unsafe void PlaceEdges(Mesh mesh, Vector3D[] result, int[] valences, double[][] table, int from, int to)
    {
        int vertices = mesh.VertexSlots;
        fixed (int* next = mesh.next, previous = mesh.previous, target = mesh.target, face = mesh.face, valence = valences)
        fixed (Vector3D* old = mesh.positions, placed = result)
        {
            var stencils = new Stencils(next, target, face, old);
            for (int e = from; e < to; e++)
            {
                int h = 2 * e, t = h + 1;
                Vector3D* place = placed + vertices + e;
                if ((face[h] | face[t]) < 0)
                {
                    // The four-point rule of Dyn, Gregory and Levin 1987 along the boundary.
                    int hole = face[h] < 0 ? h : t;
                    *place = 9.0 / 16 * (old[target[h]] + old[target[t]]) - 1.0 / 16 * (old[target[previous[hole] ^ 1]] + old[target[next[hole]]]);
                    continue;
                }
                int valenceA = valence[target[t]], valenceB = valence[target[h]];
                if (valenceA == Regular && valenceB == Regular)
                    *place = stencils.Butterfly(h);
                else if (valenceB == Regular)
                    *place = stencils.Around(h, table[valenceA]);
                else if (valenceA == Regular)
                    *place = stencils.Around(t, table[valenceB]);
                else
                    *place = 0.5 * (stencils.Around(h, table[valenceA]) + stencils.Around(t, table[valenceB]));
            }
        }
    }

    /// <summary>The stencils on the pinned columns of a mesh.</summary>
    private readonly unsafe struct Stencils(int* next, int* target, int* face, Vector3D* old)
    {
        /// <summary>The eight points around an edge between regular vertices.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3D Butterfly(int h)
        {
            int t = h ^ 1, bc = next[h], ca = next[bc], ad = next[t], db = next[ad];
            Vector3D* a = old + target[t], b = old + target[h], c = old + target[bc], d = old + target[ad];
            double x = 0, y = 0, z = 0;
            Beyond(bc, b, c, a, ref x, ref y, ref z);
            Beyond(ca, c, a, b, ref x, ref y, ref z);
            Beyond(ad, a, d, b, ref x, ref y, ref z);
            Beyond(db, d, b, a, ref x, ref y, ref z);
            return new(
                0.5 * (a->X + b->X) + 0.125 * (c->X + d->X) - 0.0625 * x,
                0.5 * (a->Y + b->Y) + 0.125 * (c->Y + d->Y) - 0.0625 * y,
                0.5 * (a->Z + b->Z) + 0.125 * (c->Z + d->Z) - 0.0625 * z);
        }

        /// <summary>The stencil around the source of a half-edge.</summary>
        public Vector3D Around(int h, double[] weights)
        {
            Vector3D* center = old + target[h ^ 1];
            double x = 0.75 * center->X, y = 0.75 * center->Y, z = 0.75 * center->Z;
            foreach (double weight in weights)
            {
                Vector3D* p = old + target[h];
                x += weight * p->X;
                y += weight * p->Y;
                z += weight * p->Z;
                h = next[h ^ 1];
            }
            return new(x, y, z);
        }

        /// <summary>Adds the vertex across a half-edge, or the reflection of the near one where there is a hole.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private void Beyond(int side, Vector3D* from, Vector3D* to, Vector3D* near, ref double x, ref double y, ref double z)
        {
            int across = side ^ 1;
            if (face[across] < 0)
            {
                x += from->X + to->X - near->X;
                y += from->Y + to->Y - near->Y;
                z += from->Z + to->Z - near->Z;
                return;
            }
            Vector3D* p = old + target[next[across]];
            x += p->X;
            y += p->Y;
            z += p->Z;
        }
    }
}
