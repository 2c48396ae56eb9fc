using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>§10.3 面法向 (face normals): the cross product of two sides, at length 1.</summary>
/// <remarks>A face of zero area has no normal: it gets the null vector and is counted. A polygon's normal is that of its vector area.</remarks>
public static class FaceNormals
{
    extension(Face face)
    {
        /// <summary>The unit normal; the null vector if the face has zero area. O(degree).</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Vector3D Normal => Areas.Unit(face.DoubleAreaVector);

        /// <summary>The mean of the corners (重心).</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Vector3D Barycenter
        {
            get
            {
                face.ThrowIfDead();
                Vector3D first = face.HalfEdge.Source.Position, sum = default;
                int corners = 0;
                foreach (Vertex v in face.Vertices)
                {
                    sum += v.Position - first;
                    corners++;
                }
                return first + sum / corners;
            }
        }
    }

    extension(Mesh mesh)
    {
        /// <summary>The unit normal per face slot; the null vector for faces of zero area and deleted ones. O(H), in parallel.</summary>
        public Vector3D[] ComputeFaceNormals() => mesh.ComputeFaceNormals(out _);

        /// <summary>The unit normal per face slot; the null vector for faces of zero area and deleted ones. O(H), in parallel.</summary>
        /// <param name="zeroAreaFaces">How many live faces have zero area.</param>
        public Vector3D[] ComputeFaceNormals(out int zeroAreaFaces)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            var normals = new Vector3D[mesh.FaceSlots];
            zeroAreaFaces = mesh.ComputeFaceNormals(normals);
            return normals;
        }

        /// <summary>Writes the unit normal of every face into an array that is there already: for callers that do it again and again.</summary>
        /// <param name="normals">One entry per face slot; those of deleted faces are left alone.</param>
        /// <returns>How many live faces have zero area.</returns>
        /// <exception cref="ArgumentException">The array has another length.</exception>
        public int ComputeFaceNormals(Vector3D[] normals)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(normals);
            if (normals.Length != mesh.FaceSlots)
                throw new ArgumentException($"There is room for {normals.Length} normals; the mesh has {mesh.FaceSlots} face slots.", nameof(normals));
            int degenerate = 0;
            Parallelism.ForBlocks(normals.Length, (from, to) => Interlocked.Add(ref degenerate, Block(mesh, normals, from, to)));
            return degenerate;
        }

        /// <summary>The mean of the corners per face slot; NaN for deleted faces. O(H), in parallel.</summary>
        public Vector3D[] ComputeFaceBarycenters()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
            Vector3D[] positions = mesh.positions;
            var centers = new Vector3D[mesh.FaceSlots];
            Parallelism.ForBlocks(centers.Length, (from, to) =>
            {
                for (int f = from; f < to; f++)
                {
                    int first = halfEdgeOf[f];
                    if (first < 0)
                    {
                        centers[f] = new(double.NaN, double.NaN, double.NaN);
                        continue;
                    }
                    Vector3D origin = positions[target[first ^ 1]], sum = default;
                    int corners = 1;
                    for (int h = first; next[h] != first; h = next[h])
                    {
                        sum += positions[target[h]] - origin;
                        corners++;
                    }
                    centers[f] = origin + sum / corners;
                }
            });
            return centers;
        }
    }

    /// <summary>Fills a block; its arrays are locals, because those of a closure would be read again at every step.</summary>
    /// <returns>How many faces have zero area.</returns>
    private static int Block(Mesh mesh, Vector3D[] normals, int from, int to)
    {
        int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
        Vector3D[] positions = mesh.positions;
        int degenerate = 0;
        for (int f = from; f < to; f++)
        {
            int h = halfEdgeOf[f];
            if (h < 0)
                continue;
            Vector3D normal = Areas.Unit(Areas.DoubleArea(next, target, positions, h));
            normals[f] = normal;
            if (normal == default)
                degenerate++;
        }
        return degenerate;
    }
}
