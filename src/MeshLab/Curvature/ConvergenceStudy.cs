using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>One curvature on one mesh of a family, compared with the exact values.</summary>
/// <param name="Quantity">What is compared: <c>K</c>, <c>H</c>, or <c>k1</c> and <c>k2</c> by a method.</param>
/// <param name="Size">The parameter of the family.</param>
/// <param name="EdgeLength">The mean edge length h.</param>
/// <param name="RmsError">The root mean square error over the compared vertices.</param>
/// <param name="MaxError">The largest error.</param>
/// <param name="Order">The order p of the root mean square error, ≈ hᵖ, from the mesh before and this one; NaN on the first, and where nothing but rounding is left.</param>
public readonly record struct ConvergenceStep(string Quantity, int Size, double EdgeLength, double RmsError, double MaxError, double Order);

/// <summary>§10.7–10.8 How fast discrete curvatures approach the exact ones as the mesh gets finer.</summary>
/// <remarks>
/// If the error behaves like hᵖ with the mean edge length h, halving h divides it by 2ᵖ: p = log(e₁/e₂) / log(h₁/h₂). Vertices within two rings of a
/// boundary are left out: their neighbourhoods are one-sided. At the few vertices of irregular valence the largest error may stay (Xu 2006).
/// </remarks>
public static class ConvergenceStudy
{
    private const int RingsFromBoundary = 2;

    /// <summary>Measures Gaussian, mean, and principal curvatures by all methods on a family of meshes.</summary>
    /// <param name="surface">The exact surface.</param>
    /// <param name="sizes">Sizes of the family, rising.</param>
    /// <returns>All sizes of one quantity after the other.</returns>
    public static IReadOnlyList<ConvergenceStep> Measure(AnalyticSurface surface, params IReadOnlyList<int> sizes)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(sizes);
        var steps = new List<ConvergenceStep>();
        foreach (int size in sizes)
        {
            Mesh mesh = surface.Mesh(size);
            double edge = mesh.MeanEdgeLength;
            foreach (var (quantity, values, exact) in Quantities(mesh, surface))
                steps.Add(Step(quantity, size, edge, mesh, values, exact, steps.FindLast(s => s.Quantity == quantity)));
        }
        return [.. steps.GroupBy(s => s.Quantity, StringComparer.Ordinal).SelectMany(group => group)];
    }

    private static IEnumerable<(string Quantity, double[] Values, Func<Vector3D, double> Exact)> Quantities(Mesh mesh, AnalyticSurface surface)
    {
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        yield return ("K", curvatures.Gaussian, surface.Gaussian);
        yield return ("H", curvatures.Mean, surface.Mean);
        foreach (PrincipalCurvatureMethod method in Enum.GetValues<PrincipalCurvatureMethod>())
        {
            PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(method);
            yield return ($"k1 {method}", principal.Max, surface.MaxCurvature);
            yield return ($"k2 {method}", principal.Min, surface.MinCurvature);
        }
    }

    private static ConvergenceStep Step(
        string quantity, int size, double edge, Mesh mesh, double[] values, Func<Vector3D, double> exact, ConvergenceStep before)
    {
        double squares = 0, max = 0;
        int count = 0;
        var walk = new RingWalk(mesh);
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated || IsNearBoundary(mesh, walk.Collect(v.index, RingsFromBoundary)))
                continue;
            double error = Math.Abs(values[v.index] - exact(v.Position));
            squares += error * error;
            max = Math.Max(max, error);
            count++;
        }
        double rms = Math.Sqrt(squares / count);
        // Angles and normals are rounded at 1e-16 and divided by h for normal curvatures, by h² for K.
        bool isRounding = rms < 1e-13 / (edge * edge);
        double order = before.Quantity is null || isRounding ? double.NaN : Math.Log(before.RmsError / rms) / Math.Log(before.EdgeLength / edge);
        return new(quantity, size, edge, rms, max, order);
    }

    private static bool IsNearBoundary(Mesh mesh, ReadOnlySpan<int> vertices)
    {
        foreach (int v in vertices)
        {
            if (mesh.face[mesh.outgoing[v]] < 0)
                return true;
        }
        return false;
    }
}
