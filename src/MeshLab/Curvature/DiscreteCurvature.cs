using System.Runtime.CompilerServices;
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
/// angle at v and the cotangents at the other two corners. O(V + H), in parallel.
/// </remarks>
public static class DiscreteCurvature
{
    extension(Vertex vertex)
    {
        /// <summary>K = angle defect / mixed area. O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted, or a face at it is not a triangle.</exception>
        public double GaussianCurvature => Around(vertex).Gaussian(vertex.IsBoundary);

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
            int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
            Vector3D[] positions = mesh.positions;
            Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
            {
                double[] gaussian = result.Gaussian, mean = result.Mean;
                for (int v = from; v < to; v++)
                {
                    int h = outgoing[v];
                    if (h < 0)
                    {
                        gaussian[v] = mean[v] = double.NaN;
                        continue;
                    }
                    var sum = new CurvatureSum();
                    bool isBoundary = CornerSum.Around(next, target, positions, positions[v], h, face[h] < 0, ref sum);
                    gaussian[v] = sum.Gaussian(isBoundary);
                    mean[v] = sum.Mean;
                }
            });
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
                    var sum = new CurvatureSum();
                    int h = outgoing[v];
                    if (h >= 0)
                        CornerSum.Around(next, target, positions, positions[v], h, face[h] < 0, ref sum);
                    normals[v] = sum.MeanNormal;
                }
            });
            return normals;
        }
    }

    private static CurvatureSum Around(Vertex vertex)
    {
        vertex.ThrowIfDead();
        foreach (Face f in vertex.Faces)
            _ = f.Triangle;
        var sum = new CurvatureSum();
        Mesh mesh = vertex.mesh;
        if (!vertex.IsIsolated)
            CornerSum.Around(mesh.next, mesh.target, mesh.positions, vertex.Position, vertex.Outgoing.index, vertex.IsBoundary, ref sum);
        return sum;
    }

    /// <summary>What the corners around a vertex add up to.</summary>
    private struct CurvatureSum : ICornerSum
    {
        private double angles;
        private double mixedArea;
        private Vector3D cotangents;
        private Vector3D normal;

        public readonly double Gaussian(bool isBoundary) =>
            mixedArea > 0 ? ((isBoundary ? Math.PI : 2 * Math.PI) - angles) / mixedArea : double.NaN;

        public readonly Vector3D MeanNormal => mixedArea > 0 ? cotangents / (2 * mixedArea) : new(double.NaN, double.NaN, double.NaN);

        public readonly double Mean
        {
            get
            {
                if (!(mixedArea > 0))
                    return double.NaN;
                double size = cotangents.Length / (4 * mixedArea);
                return Vector3D.Dot(cotangents, normal) < 0 ? -size : size;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(Vector3D u, Vector3D w)
        {
            Vector3D cross = Vector3D.Cross(u, w);
            double doubleArea = cross.Length, uu = u.LengthSquared, uw = Vector3D.Dot(u, w), ww = w.LengthSquared;
            double angle = Math.Atan2(doubleArea, uw);
            angles += angle;
            if (!(doubleArea > 0))
                return;
            mixedArea += VertexAreas.MixedPart(doubleArea, uu, uw, ww);
            double scale = 1 / doubleArea;
            // The cotangent at u's end belongs to the spoke w, and the other way round.
            cotangents -= u * ((ww - uw) * scale) + w * ((uu - uw) * scale);
            normal += cross * (angle * scale);
        }
    }
}
