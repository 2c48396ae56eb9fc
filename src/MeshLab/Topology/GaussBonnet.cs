using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>Both sides of the theorem.</summary>
/// <param name="InteriorDefects">Σ (2π − Σθ) over the interior vertices: the total Gaussian curvature.</param>
/// <param name="BoundaryTurning">Σ (π − Σθ) over the boundary vertices: the total geodesic curvature of the boundary.</param>
/// <param name="EulerCharacteristic">χ.</param>
public sealed record GaussBonnetReport(double InteriorDefects, double BoundaryTurning, int EulerCharacteristic)
{
    /// <summary>The sum of all defects.</summary>
    public double DefectSum => InteriorDefects + BoundaryTurning;

    /// <summary>2πχ.</summary>
    public double Expected => 2 * Math.PI * EulerCharacteristic;

    /// <summary>What rounding has left between the two sides.</summary>
    public double Difference => DefectSum - Expected;
}

/// <summary>§11.4 高斯–博内定理 (Gauss–Bonnet theorem): Σ defects = 2πχ, with and without boundary.</summary>
/// <remarks>
/// Every triangle has an angle sum of π, so Σ angles = πF. Summing 2π − Σθ inside and π − Σθ on the boundary gives 2πV − πV_b − πF = 2π(V − E + F), because
/// 3F = 2E − E_b and E_b = V_b. Holds for flat polygons too; bent polygons miss it. O(V + H).
/// </remarks>
public static class GaussBonnet
{
    /// <summary>Evaluates both sides.</summary>
    public static GaussBonnetReport Check(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        double[] defects = mesh.ComputeAngleDefects();
        double interior = 0, boundary = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsBoundary)
                boundary += defects[v.index];
            else if (!v.IsIsolated)
                interior += defects[v.index];
        }
        return new(interior, boundary, mesh.EulerCharacteristic);
    }
}
