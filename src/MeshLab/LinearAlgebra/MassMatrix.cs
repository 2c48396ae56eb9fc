using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>How the area of the surface is given to the vertices.</summary>
public enum MassKind
{
    /// <summary>Lumped, mixed areas (Meyer et al. 2003): Voronoi areas, but halves and quarters in obtuse triangles. Always positive.</summary>
    Mixed,

    /// <summary>Lumped, a third of each face to each of its vertices.</summary>
    Barycentric,

    /// <summary>Lumped, Voronoi areas ⅛ Σ (cot α + cot β)|e|²; negative parts in obtuse triangles are kept.</summary>
    Voronoi,

    /// <summary>The full matrix of linear finite elements: A/6 on the diagonal and A/12 beside it for each face.</summary>
    Full,
}

/// <summary>质量矩阵 (mass matrix): M with uᵀ M v ≈ ∫ u v over the surface; its entries sum to the area.</summary>
/// <remarks>Rows are vertex slots; those of deleted and isolated vertices are empty. O(V + H).</remarks>
public static class MassMatrix
{
    extension(Mesh mesh)
    {
        /// <summary>The mass matrix over the vertex slots.</summary>
        /// <param name="kind">Which one. <see cref="MassKind.Full"/> has entries in the same places and order as the Laplacian.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public SparseMatrix ComputeMassMatrix(MassKind kind = MassKind.Mixed)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            return kind == MassKind.Full ? Full(mesh) : SparseMatrix.FromDiagonal(mesh.ComputeLumpedMasses(kind));
        }

        /// <summary>The diagonal of a lumped mass matrix: an area per vertex slot.</summary>
        /// <param name="kind">Any but <see cref="MassKind.Full"/>.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeLumpedMasses(MassKind kind = MassKind.Mixed)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            double[] cotangent = OppositeCotangents.Of(mesh, out double[] doubleArea);
            return Lumped(mesh, cotangent, doubleArea, kind);
        }
    }

    internal static double[] Lumped(Mesh mesh, double[] cotangent, double[] doubleArea, MassKind kind)
    {
        if (kind is not (MassKind.Mixed or MassKind.Barycentric or MassKind.Voronoi))
            throw new ArgumentOutOfRangeException(nameof(kind), kind, "No lumped mass.");
        var mass = new double[mesh.VertexSlots];
        if (kind == MassKind.Barycentric)
            Parallelism.ForBlocks(mass.Length, (from, to) => FillThirds(mesh, doubleArea, mass, from, to));
        else
            Parallelism.ForBlocks(mass.Length, (from, to) => FillVoronoi(mesh, cotangent, doubleArea, kind == MassKind.Mixed, mass, from, to));
        return mass;
    }

    private static void FillThirds(Mesh mesh, ReadOnlySpan<double> doubleArea, Span<double> mass, int from, int to)
    {
        ReadOnlySpan<int> next = mesh.Next, outgoing = mesh.Outgoing, face = mesh.FaceOf;
        for (int v = from; v < to; v++)
        {
            int first = outgoing[v], h = first;
            if (first < 0)
                continue;
            double sum = 0;
            do
            {
                int f = face[h];
                if (f >= 0)
                    sum += doubleArea[f] / 6;
                h = next[h ^ 1];
            }
            while (h != first);
            mass[v] = sum;
        }
    }

    private static void FillVoronoi(Mesh mesh, double[] cotangent, double[] doubleArea, bool isMixed, Span<double> mass, int from, int to)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
        Vector3D[] position = mesh.positions;
        for (int v = from; v < to; v++)
        {
            int first = outgoing[v], h = first;
            if (first < 0)
                continue;
            double sum = 0;
            do
            {
                if (face[h] >= 0)
                    sum += VoronoiPart(h, next, target, position, cotangent, doubleArea[face[h]], isMixed);
                h = next[h ^ 1];
            }
            while (h != first);
            mass[v] = sum;
        }
    }

    // The part of the face left of h that belongs to h's source.
    private static double VoronoiPart(
        int h, int[] next, int[] target, Vector3D[] position, double[] cotangent, double doubleArea, bool isMixed)
    {
        int opposite = next[h], last = next[opposite];
        // The angle at the source is opposite the next half-edge.
        if (isMixed && cotangent[opposite] < 0)
            return doubleArea / 4;
        if (isMixed && (cotangent[h] < 0 || cotangent[last] < 0))
            return doubleArea / 8;
        Vector3D p = position[target[last]];
        return (cotangent[h] * Vector3D.DistanceSquared(p, position[target[h]])
            + cotangent[last] * Vector3D.DistanceSquared(p, position[target[opposite]])) / 8;
    }

    private static SparseMatrix Full(Mesh mesh)
    {
        OppositeCotangents.Of(mesh, out double[] doubleArea);
        int[] face = mesh.face;
        var weight = new double[mesh.EdgeSlots];
        for (int e = 0; e < weight.Length; e++)
            weight[e] = (Area(2 * e) + Area(2 * e + 1)) / 24;
        // Over the edges around an interior vertex every face is counted twice: Σ (A + A')/12 = Σ A/6. On the boundary the same.
        SparseMatrix matrix = Laplacian.Assemble(mesh, weight, perHalfEdge: false);
        Span<double> values = matrix.Values;
        for (int k = 0; k < values.Length; k++)
            values[k] = -values[k];
        return matrix;

        double Area(int h) => face[h] < 0 ? 0 : doubleArea[face[h]];
    }
}
