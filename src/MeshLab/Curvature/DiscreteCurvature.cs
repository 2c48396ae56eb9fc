using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>Gaussian and mean curvature per vertex slot; NaN for isolated and deleted vertices, and where the faces around have no area.</summary>
/// <param name="Gaussian">K, in 1/length².</param>
/// <param name="Mean">H, in 1/length, positive where the surface is convex.</param>
public sealed record VertexCurvatures(double[] Gaussian, double[] Mean);

/// <summary>§10.7 高斯曲率 and 平均曲率: Gaussian and mean curvature of a triangle mesh (Meyer, Desbrun, Schröder, Barr 2003, eqs. 8 and 9).</summary>
/// <remarks>
/// <code>
///            p          K = (2π − Σ θ) / A                          (π − Σ θ on the boundary)
///          α/ \
///          /θ  \        mean-curvature normal (平均曲率法向量)
///         v─────q       𝐊(v) = 1/(2A) Σ (cot α + cot β)(v − p) = 2 H n
///          \   /
///          β\ /         H = ½|𝐊|, with the sign of 𝐊 · n, n the angle-weighted normal:
///            r          positive on a sphere whose normals point outward
/// </code>
/// A is the mixed area (§10.1). On the boundary 𝐊 is the sum over the faces that are there: it also contains the bending of the boundary curve and
/// is no approximation of the mean curvature. One walk around each vertex gives everything: the scalar products of neighbouring spokes hold the
/// angle at v and the cotangents at the other two corners; angles are added as in <see cref="CornerAngles"/>. O(V + H), in parallel.
/// </remarks>
public static class DiscreteCurvature
{
    extension(Vertex vertex)
    {
        /// <summary>K = angle defect / mixed area. O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted, or a face at it is not a triangle.</exception>
        public double GaussianCurvature => Around(vertex).Gaussian;

        /// <summary>H, positive where the surface is convex. O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted, or a face at it is not a triangle.</exception>
        public double MeanCurvature => Around(vertex).Mean;

        /// <summary>The mean-curvature normal 2Hn (平均曲率法向量). O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted, or a face at it is not a triangle.</exception>
        public Vector3D MeanCurvatureNormal => Around(vertex).MeanNormal;
    }

    extension(Mesh mesh)
    {
        /// <summary>Gaussian and mean curvature in one pass.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public VertexCurvatures ComputeCurvatures()
        {
            mesh.RequireTriangles();
            var result = new VertexCurvatures(new double[mesh.VertexSlots], new double[mesh.VertexSlots]);
            Parallelism.ForBlocks(mesh.VertexSlots, (from, to) => Block(mesh, result.Gaussian, result.Mean, from, to));
            return result;
        }

        /// <summary>K per vertex slot: angle defect over mixed area.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeGaussianCurvature() => mesh.ComputeCurvatures().Gaussian;

        /// <summary>H per vertex slot, positive where the surface is convex.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeMeanCurvature() => mesh.ComputeCurvatures().Mean;

        /// <summary>2Hn per vertex slot; NaN where there is none.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public Vector3D[] ComputeMeanCurvatureNormals()
        {
            mesh.RequireTriangles();
            int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
            Vector3D[] positions = mesh.positions;
            var normals = new Vector3D[mesh.VertexSlots];
            Parallelism.ForBlocks(normals.Length, (from, to) =>
            {
                for (int v = from; v < to; v++)
                {
                    int h = outgoing[v];
                    CurvatureSum sum = h < 0 ? default : Around(next, target, positions, positions[v], h, face[h] < 0);
                    normals[v] = sum.MeanNormal;
                }
            });
            return normals;
        }
    }

    /// <summary>Fills a block; its arrays are locals, because those of a closure would be read again at every step.</summary>
    private static void Block(Mesh mesh, double[] gaussian, double[] mean, int from, int to)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
        Vector3D[] positions = mesh.positions;
        for (int v = from; v < to; v++)
        {
            int h = outgoing[v];
            if (h < 0)
            {
                gaussian[v] = mean[v] = double.NaN;
                continue;
            }
            CurvatureSum sum = Around(next, target, positions, positions[v], h, face[h] < 0);
            gaussian[v] = sum.Gaussian;
            mean[v] = sum.Mean;
        }
    }

    private static CurvatureSum Around(Vertex vertex)
    {
        vertex.ThrowIfDead();
        foreach (Face f in vertex.Faces)
            _ = f.Triangle;
        Mesh mesh = vertex.mesh;
        return vertex.IsIsolated ? default : Around(mesh.next, mesh.target, mesh.positions, vertex.Position, vertex.Outgoing.index, vertex.IsBoundary);
    }

    /// <summary>One walk around a vertex. The sums are locals, so that they stay in registers; one root and one division per corner.</summary>
    private static CurvatureSum Around(int[] next, int[] target, Vector3D[] positions, Vector3D center, int outgoing, bool isBoundary)
    {
        var angles = new AngleSumByRotation();
        double mixedArea = 0, cotX = 0, cotY = 0, cotZ = 0;
        // All face normals lie within a cone around the first one; this is the cosine of its opening.
        Vector3D firstNormal = default;
        double cone = 1;
        int h = outgoing;
        Vector3D w = positions[target[h]] - center;
        double ww = w.LengthSquared;
        do
        {
            h = next[h ^ 1];
            // Turning clockwise from the hole, the last corner is the hole itself.
            if (isBoundary && h == outgoing)
                break;
            Vector3D u = positions[target[h]] - center;
            Vector3D cross = Vector3D.Cross(u, w);
            double doubleArea = cross.Length, uu = u.LengthSquared, uw = Vector3D.Dot(u, w);
            angles.Add(uw, doubleArea);
            if (doubleArea > 0)
            {
                // The cotangent at u's end belongs to the spoke w, and the other way round.
                double scale = 1 / doubleArea, ofU = (ww - uw) * scale, ofW = (uu - uw) * scale;
                mixedArea += VertexAreas.MixedPart(doubleArea, scale, uu, uw, ww);
                cotX -= u.X * ofU + w.X * ofW;
                cotY -= u.Y * ofU + w.Y * ofW;
                cotZ -= u.Z * ofU + w.Z * ofW;
                if (firstNormal == default)
                    firstNormal = cross * scale;
                cone = Math.Min(cone, Vector3D.Dot(firstNormal, cross) * scale);
            }
            w = u;
            ww = uu;
        }
        while (h != outgoing);

        Vector3D cotangents = new(cotX, cotY, cotZ);
        double along = Vector3D.Dot(cotangents, firstNormal);
        // If the mean-curvature normal is less than a right angle from every normal of the cone, no weights can change the sign.
        bool isSure = cone > 0 && along * along > (1 - cone * cone) * cotangents.LengthSquared * (1 + 1e-12);
        if (!isSure)
            along = Vector3D.Dot(cotangents, AngleWeightedNormal(next, target, positions, center, outgoing, isBoundary));
        return new(angles.MissingTo(isBoundary ? 1 : 2), mixedArea, cotangents, along < 0);
    }

    private static Vector3D AngleWeightedNormal(int[] next, int[] target, Vector3D[] positions, Vector3D center, int outgoing, bool isBoundary)
    {
        var sum = new VertexNormals.AngleSum();
        CornerSum.Around(next, target, positions, center, outgoing, isBoundary, ref sum);
        return sum.Normal;
    }

    /// <summary>What the corners around a vertex add up to.</summary>
    private readonly record struct CurvatureSum(double Defect, double MixedArea, Vector3D Cotangents, bool IsConcave)
    {
        public double Gaussian => MixedArea > 0 ? Defect / MixedArea : double.NaN;

        public Vector3D MeanNormal => MixedArea > 0 ? Cotangents / (2 * MixedArea) : new(double.NaN, double.NaN, double.NaN);

        public double Mean
        {
            get
            {
                if (!(MixedArea > 0))
                    return double.NaN;
                double size = Cotangents.Length / (4 * MixedArea);
                return IsConcave ? -size : size;
            }
        }
    }
}
