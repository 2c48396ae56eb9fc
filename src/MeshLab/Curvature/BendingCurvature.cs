using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>§10.7 Mean curvature from the bending of the edges (二面角法平均曲率): a second opinion that needs no cotangents.</summary>
/// <remarks>
/// <code>
///        q              an edge of length |e| that bends by θ is a piece of cylinder: ∫H over it is ½|e|θ,
///      / | \            half of which belongs to each end
///     ●  e  ●           H(v) = ¼ Σ |e| θ / A      over the inner edges at v, A the barycentric area
///      \ | /
///        v
/// </code>
/// The integral converges wherever the normals do (Cohen-Steiner, Morvan 2003); the value at a single vertex also feels how its edges lie, so it does not
/// converge everywhere. Signed by the dihedral angles: positive where the surface is convex. O(V + H), in parallel.
/// </remarks>
public static class BendingCurvature
{
    extension(Mesh mesh)
    {
        /// <summary>H per vertex slot; NaN where there is no area around.</summary>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public double[] ComputeBendingCurvature()
        {
            mesh.RequireTriangles();
            double[] areas = mesh.ComputeBarycentricAreas(), angles = mesh.ComputeDihedralAngles();
            int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing;
            Vector3D[] positions = mesh.positions;
            var curvature = new double[mesh.VertexSlots];
            Parallelism.ForBlocks(curvature.Length, (from, to) =>
            {
                for (int v = from; v < to; v++)
                {
                    double bending = 0;
                    int first = outgoing[v];
                    for (int h = first; h >= 0;)
                    {
                        // Boundary edges have no dihedral angle.
                        if (!double.IsNaN(angles[h >> 1]))
                            bending += Vector3D.Distance(positions[v], positions[target[h]]) * angles[h >> 1];
                        h = next[h ^ 1];
                        if (h == first)
                            break;
                    }
                    curvature[v] = areas[v] > 0 ? bending / (4 * areas[v]) : double.NaN;
                }
            });
            return curvature;
        }
    }
}
