using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>§10.1 面积 (area) of faces and of the whole surface.</summary>
/// <remarks>
/// A triangle's area is half its cross product. A polygon's is the length of its vector area ½ Σ pᵢ × pᵢ₊₁ (Newell), taken about its first
/// corner: exact for every flat polygon, convex or not, and the area of its projection along the mean normal otherwise.
/// </remarks>
public static class Areas
{
    extension(Face face)
    {
        /// <summary>The area (面积), in square model units. O(degree).</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public double Area => 0.5 * face.DoubleAreaVector.Length;

        /// <summary>The area by Heron's formula (海伦公式) in its stable form.</summary>
        /// <exception cref="ArgumentException">The face is none, deleted, or not a triangle.</exception>
        public double HeronArea => TriangleRequirement.Triangle(face).HeronArea;

        /// <summary>The face as a triangle, from its first vertex.</summary>
        /// <exception cref="ArgumentException">The face is none, deleted, or not a triangle.</exception>
        public Triangle Triangle => TriangleRequirement.Triangle(face);

        /// <summary>The normal, as long as twice the area.</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Vector3D DoubleAreaVector
        {
            get
            {
                face.ThrowIfDead();
                return DoubleArea(face.mesh.next, face.mesh.target, face.mesh.positions, face.HalfEdge.index);
            }
        }
    }

    extension(Mesh mesh)
    {
        /// <summary>The area of the surface, in square model units. O(H), in parallel.</summary>
        public double Area
        {
            get
            {
                double[] areas = mesh.ComputeFaceAreas();
                return Sum(areas);
            }
        }

        /// <summary>The area per face slot; 0 for deleted faces. O(H), in parallel.</summary>
        public double[] ComputeFaceAreas()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
            Vector3D[] positions = mesh.positions;
            var areas = new double[mesh.FaceSlots];
            Parallelism.ForBlocks(areas.Length, (from, to) =>
            {
                for (int f = from; f < to; f++)
                {
                    int h = halfEdgeOf[f];
                    if (h >= 0)
                        areas[f] = 0.5 * DoubleArea(next, target, positions, h).Length;
                }
            });
            return areas;
        }
    }

    /// <summary>The vector area of a face, doubled. The first corner is its first half-edge's source.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector3D DoubleArea(int[] next, int[] target, Vector3D[] positions, int first)
    {
        int second = next[first], third = next[second];
        if (next[third] != first)
            return DoubleAreaOfPolygon(next, target, positions, first);
        Vector3D a = positions[target[third]];
        return Vector3D.Cross(positions[target[first]] - a, positions[target[second]] - a);
    }

    /// <summary>The unit vector in a direction; the null vector stays. One division, where <see cref="Vector3D.Normalized"/> has three.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector3D Unit(Vector3D vector)
    {
        double squared = vector.LengthSquared;
        return squared is > 1e-280 and < 1e280 ? vector * (1 / Math.Sqrt(squared)) : vector.Normalized();
    }

    private static Vector3D DoubleAreaOfPolygon(int[] next, int[] target, Vector3D[] positions, int first)
    {
        Vector3D a = positions[target[first ^ 1]];
        int second = next[first], last = next[second];
        Vector3D u = positions[target[first]] - a, v = positions[target[second]] - a;
        Vector3D sum = Vector3D.Cross(u, v);
        for (; next[last] != first; last = next[last])
        {
            u = v;
            v = positions[target[last]] - a;
            sum += Vector3D.Cross(u, v);
        }
        return sum;
    }

    /// <summary>The sum in fixed blocks, so that it does not depend on the number of threads.</summary>
    internal static double Sum(double[] values) => Parallelism.SumBlocks(values.Length, (from, to) =>
    {
        double sum = 0;
        for (int i = from; i < to; i++)
            sum += values[i];
        return sum;
    });
}
