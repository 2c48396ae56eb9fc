using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>§10.8.3 Principal curvatures from the Laplacian of the normal.</summary>
/// <remarks>
/// On a surface Δn = −2∇H − (k₁² + k₂²) n, so S = −n · Δn is the sum of squares, and with 2H = k₁ + k₂
/// <c>k₁,₂ = (2H ± √(2S − 4H²)) / 2</c>. Discretely S(v) = 1/(2A) Σ (cot α + cot β)(1 − n_v · n_p). The textbook prints the root of S − 4H² + … with a sign
/// that makes both curvatures equal always; this is the right one. Normals are weighted after Max 1999, A is the mixed area. O(V + H), in parallel.
/// </remarks>
public static class NormalLaplacian
{
    /// <summary>The principal curvatures of every vertex, without directions.</summary>
    /// <param name="mesh">A triangle mesh.</param>
    /// <param name="weight">Which vertex normals are differentiated.</param>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static PrincipalCurvatures Compute(Mesh mesh, VertexNormalWeight weight = VertexNormalWeight.InscribedSphere)
    {
        mesh.RequireTriangles();
        Vector3D[] normals = mesh.ComputeVertexNormals(weight);
        double[] mean = mesh.ComputeMeanCurvature(), areas = mesh.ComputeMixedAreas();
        PrincipalCurvatures result = PrincipalCurvatures.Undefined(mesh.VertexSlots);
        Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                if (!(areas[v] > 0) || normals[v] == default)
                    continue;
                double squares = SumOfSquares(mesh, v, normals) / (2 * areas[v]);
                double root = Math.Sqrt(Math.Max(0, 2 * squares - 4 * mean[v] * mean[v])) / 2;
                result.Max[v] = mean[v] + root;
                result.Min[v] = mean[v] - root;
            }
        });
        return result;
    }

    /// <summary>Σ (cot α + cot β)(1 − n_v · n_p), face by face.</summary>
    private static double SumOfSquares(Mesh mesh, int v, Vector3D[] normals)
    {
        Vector3D center = mesh.positions[v];
        double sum = 0;
        int start = mesh.outgoing[v], h = start;
        do
        {
            if (mesh.face[h] >= 0)
            {
                int p = mesh.target[h], q = mesh.target[mesh.next[h]];
                Vector3D u = mesh.positions[p] - center, w = mesh.positions[q] - center;
                double doubleArea = Vector3D.Cross(u, w).Length, uw = Vector3D.Dot(u, w);
                if (doubleArea > 0)
                {
                    sum += ((w.LengthSquared - uw) * Change(normals[v], normals[p]) + (u.LengthSquared - uw) * Change(normals[v], normals[q]))
                        / doubleArea;
                }
            }
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        return sum;
    }

    /// <summary>1 − a · b for unit vectors, without cancellation; nothing is known of a neighbour without a normal.</summary>
    private static double Change(Vector3D a, Vector3D b) => b == default ? 0 : Vector3D.DistanceSquared(a, b) / 2;
}
