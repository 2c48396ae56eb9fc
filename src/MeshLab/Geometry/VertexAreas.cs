using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>§10.1 The part of the surface that belongs to a vertex, in three ways. The parts of every way add up to the whole area.</summary>
/// <remarks>
/// <code>
///         w          Voronoi part of the corner at v, with the opposite angles α at w and β at u:
///        / \             ⅛ (|u|² cot α + |w|² cot β)
///       /   \        mixed: the same in a triangle without obtuse angle; else A/2 at the obtuse corner, A/4 at the two others
///      v─────u       barycentric: A/3
/// </code>
/// Meyer, Desbrun, Schröder, Barr 2003, §3.3–3.4. An angle is obtuse if its cotangent is negative, so a right-angled triangle still hands out
/// all of its area and Σ mixed = total area. All need triangles; isolated and deleted vertices have area 0. O(V + H), in parallel.
/// </remarks>
public static class VertexAreas
{
    extension(Mesh mesh)
    {
        /// <summary>The Voronoi area (Voronoi 面积) per vertex slot: negative parts at obtuse angles are kept.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeVoronoiAreas() => SumCorners<Voronoi>(mesh);

        /// <summary>The mixed area (混合面积) per vertex slot: Voronoi, but never negative.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeMixedAreas() => SumCorners<Mixed>(mesh);

        /// <summary>A third of the area of the faces around the vertex (重心面积), per vertex slot.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeBarycentricAreas() => SumCorners<Barycentric>(mesh);
    }

    private static double[] SumCorners<TArea>(Mesh mesh)
        where TArea : struct, IArea
    {
        mesh.RequireTriangles();
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
        Vector3D[] positions = mesh.positions;
        var areas = new double[mesh.VertexSlots];
        Parallelism.ForBlocks(areas.Length, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                int h = outgoing[v];
                if (h < 0)
                    continue;
                var sum = new AreaSum<TArea>();
                CornerSum.Around(next, target, positions, positions[v], h, face[h] < 0, ref sum);
                areas[v] = sum.Area;
            }
        });
        return areas;
    }

    /// <summary>The mixed area of one corner. <paramref name="doubleArea"/> is |u × w|, the rest are the scalar products of the two spokes.</summary>
    internal static double MixedPart(double doubleArea, double uu, double uw, double ww) => MixedPart(doubleArea, 1 / doubleArea, uu, uw, ww);

    /// <summary>The same with 1 / |u × w| at hand.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double MixedPart(double doubleArea, double inverse, double uu, double uw, double ww)
    {
        if (uw < 0)
            return doubleArea / 4;
        // The scalar products at the other two corners; at most one angle of a triangle is obtuse.
        double atU = uu - uw, atW = ww - uw;
        if (atU < 0 || atW < 0)
            return doubleArea / 8;
        return doubleArea > 0 ? (ww * atU + uu * atW) * inverse / 8 : 0;
    }

    private interface IArea
    {
        static abstract double Part(double doubleArea, double uu, double uw, double ww);
    }

    private struct AreaSum<TArea> : ICornerSum
        where TArea : struct, IArea
    {
        public double Area;

        public void Add(Vector3D u, Vector3D w) =>
            Area += TArea.Part(Vector3D.Cross(u, w).Length, u.LengthSquared, Vector3D.Dot(u, w), w.LengthSquared);
    }

    private struct Voronoi : IArea
    {
        public static double Part(double doubleArea, double uu, double uw, double ww) =>
            doubleArea > 0 ? (ww * (uu - uw) + uu * (ww - uw)) / (8 * doubleArea) : 0;
    }

    private struct Mixed : IArea
    {
        public static double Part(double doubleArea, double uu, double uw, double ww) => MixedPart(doubleArea, uu, uw, ww);
    }

    private struct Barycentric : IArea
    {
        public static double Part(double doubleArea, double uu, double uw, double ww) => doubleArea / 6;
    }
}
