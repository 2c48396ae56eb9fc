using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>§10.5 二面角 (dihedral angles): how much the surface bends at an edge, in radians; 0 where it is flat.</summary>
/// <remarks>
/// The angle is measured between the outward normals n₀ and n₁ of the two faces: atan2(e · (n₀ × n₁), n₀ · n₁) with e the edge's direction as
/// its first half-edge runs. Positive where the surface is convex, negative where it is concave, in (−π, π]. NaN on boundary edges, beside
/// faces of zero area, and for edges of length zero, where there is no such angle.
/// </remarks>
public static class DihedralAngles
{
    extension(Edge edge)
    {
        /// <summary>The signed angle: positive where convex; NaN on the boundary.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public double DihedralAngle
        {
            get
            {
                edge.ThrowIfDead();
                if (edge.IsBoundary)
                    return double.NaN;
                return Signed(edge.Vertex1.Position - edge.Vertex0.Position, edge.Face0.Normal, edge.Face1.Normal);
            }
        }

        /// <summary>The unsigned angle between the normals, in [0, π]; NaN on the boundary.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public double UnsignedDihedralAngle => Math.Abs(edge.DihedralAngle);
    }

    extension(Mesh mesh)
    {
        /// <summary>The signed angles per edge slot; NaN on the boundary and for deleted edges. O(H), in parallel.</summary>
        public double[] ComputeDihedralAngles()
        {
            Vector3D[] normals = mesh.ComputeFaceNormals();
            int[] next = mesh.next, target = mesh.target, face = mesh.face;
            Vector3D[] positions = mesh.positions;
            var angles = new double[mesh.EdgeSlots];
            Parallelism.ForBlocks(angles.Length, (from, to) =>
            {
                for (int e = from; e < to; e++)
                {
                    int h = 2 * e, left = face[h], right = face[h + 1];
                    angles[e] = next[h] < 0 || left < 0 || right < 0
                        ? double.NaN
                        : Signed(positions[target[h]] - positions[target[h + 1]], normals[left], normals[right]);
                }
            });
            return angles;
        }

        /// <summary>The unsigned angles per edge slot, in [0, π]; NaN on the boundary and for deleted edges. O(H), in parallel.</summary>
        public double[] ComputeUnsignedDihedralAngles()
        {
            double[] angles = mesh.ComputeDihedralAngles();
            for (int e = 0; e < angles.Length; e++)
                angles[e] = Math.Abs(angles[e]);
            return angles;
        }
    }

    /// <summary>The angle from the normal on the left of an edge to that on its right.</summary>
    internal static double Signed(Vector3D edge, Vector3D left, Vector3D right)
    {
        Vector3D direction = edge.Normalized();
        if (left == default || right == default || direction == default)
            return double.NaN;
        return Math.Atan2(Vector3D.Dot(direction, Vector3D.Cross(left, right)), Vector3D.Dot(left, right));
    }
}
