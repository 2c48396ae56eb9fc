using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>How principal curvatures are estimated (§10.8).</summary>
public enum PrincipalCurvatureMethod
{
    /// <summary>§10.8.1: from mean and Gaussian curvature, H ± √max(0, H² − K). No directions.</summary>
    MeanAndGaussian,

    /// <summary>§10.8.2: the tensor of each face, averaged at the vertices (Rusinkiewicz 2004). With directions.</summary>
    TensorAveraging,

    /// <summary>§10.8.3: from the mean curvature and the Laplacian of the normal. No directions.</summary>
    NormalLaplacian,

    /// <summary>A quadric fitted to the neighbours within k rings (Cazals, Pouget 2003). With directions.</summary>
    JetFitting,
}

/// <summary>Principal curvatures per vertex slot; NaN where there is none.</summary>
/// <param name="Max">k₁, the larger one, in 1/length; positive where the surface is convex.</param>
/// <param name="Min">k₂, the smaller one.</param>
/// <param name="MaxDirection">The unit tangent in which the surface bends by k₁; the null vector if the method gives none.</param>
/// <param name="MinDirection">The unit tangent in which the surface bends by k₂.</param>
public sealed record PrincipalCurvatures(double[] Max, double[] Min, Vector3D[] MaxDirection, Vector3D[] MinDirection)
{
    internal static PrincipalCurvatures Undefined(int count)
    {
        var result = new PrincipalCurvatures(new double[count], new double[count], new Vector3D[count], new Vector3D[count]);
        Array.Fill(result.Max, double.NaN);
        Array.Fill(result.Min, double.NaN);
        return result;
    }
}

/// <summary>§10.8 主曲率 (principal curvatures) by any of the book's ways, and writing them as the textbook's traits.</summary>
public static class PrincipalCurvature
{
    extension(Mesh mesh)
    {
        /// <summary>The principal curvatures of every vertex. O(V + H), in parallel.</summary>
        /// <param name="method">The way.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        /// <exception cref="ArgumentOutOfRangeException">There is no such method.</exception>
        public PrincipalCurvatures ComputePrincipalCurvatures(PrincipalCurvatureMethod method = PrincipalCurvatureMethod.JetFitting) => method switch
        {
            PrincipalCurvatureMethod.MeanAndGaussian => FromMeanAndGaussian(mesh),
            PrincipalCurvatureMethod.TensorAveraging => TensorAveraging.Compute(mesh),
            PrincipalCurvatureMethod.NormalLaplacian => NormalLaplacian.Compute(mesh),
            PrincipalCurvatureMethod.JetFitting => JetFitting.Compute(mesh, new JetFittingOptions()),
            _ => throw new ArgumentOutOfRangeException(nameof(method), method, "There is no such method."),
        };

        /// <summary>Writes the curvatures and directions into the textbook's vertex traits, for all live vertices. O(V + H).</summary>
        /// <param name="method">The way to the principal curvatures.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public void WriteCurvatureTraits(PrincipalCurvatureMethod method = PrincipalCurvatureMethod.TensorAveraging)
        {
            VertexCurvatures curvatures = mesh.ComputeCurvatures();
            PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(method);
            foreach (Vertex v in mesh.Vertices)
            {
                VertexTraits traits = v.Traits;
                traits.GaussianCurvature = curvatures.Gaussian[v.index];
                traits.MeanCurvature = curvatures.Mean[v.index];
                traits.MaxCurvature = principal.Max[v.index];
                traits.MinCurvature = principal.Min[v.index];
                traits.MaxCurvatureDirection = principal.MaxDirection[v.index];
                traits.MinCurvatureDirection = principal.MinDirection[v.index];
            }
        }
    }

    /// <summary>k₁,₂ = H ± √max(0, H² − K): on a mesh H² can be less than K, on a surface never.</summary>
    private static PrincipalCurvatures FromMeanAndGaussian(Mesh mesh)
    {
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        PrincipalCurvatures result = PrincipalCurvatures.Undefined(mesh.VertexSlots);
        for (int v = 0; v < result.Max.Length; v++)
        {
            double h = curvatures.Mean[v], root = Math.Sqrt(Math.Max(0, h * h - curvatures.Gaussian[v]));
            result.Max[v] = h + root;
            result.Min[v] = h - root;
        }
        return result;
    }
}
