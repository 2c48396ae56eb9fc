using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Curvature;

[Trait("Section", "10.7")]
[Trait("Section", "10.8")]
public class CurvatureReferenceTests
{
    /// <summary>Below this angle a corner is nearly degenerate: its cotangent is above 100, and the square of it in units of rounding is lost.</summary>
    private const double Needle = 0.01;

    /// <summary>The models on which that costs more than 1e-9, and how many of their vertices touch such a corner: these are compared at 1e-6.</summary>
    private static readonly Dictionary<string, int> VerticesAtNeedles = new(StringComparer.Ordinal) { ["box_assembly"] = 140, ["isosurface_large"] = 6212 };

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Curvatures_PublicModels_EqualTheReferenceValues(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(PrincipalCurvatureMethod.MeanAndGaussian);
        double[] areas = mesh.ComputeMixedAreas();
        bool[] atNeedle = VerticesAtNeedles.ContainsKey(name) ? AtNeedles(mesh) : new bool[mesh.VertexSlots];
        Assert.Equal(VerticesAtNeedles.GetValueOrDefault(name), atNeedle.Count(needle => needle));

        ReferenceMesh.Compare(name, "gauss_curvature", curvatures.Gaussian);
        ReferenceMesh.Compare(name, "mean_curvature_signed", curvatures.Mean, 1e-9, Interior, slack: AtNeedle);
        ReferenceMesh.Compare(name, "mean_curvature_magnitude", [.. curvatures.Mean.Select(Math.Abs)], 1e-9, Interior, slack: AtNeedle);
        ReferenceMesh.Compare(name, "k1", principal.Max, 1e-9, Interior, slack: OfTheRoot);
        ReferenceMesh.Compare(name, "k2", principal.Min, 1e-9, Interior, slack: OfTheRoot);
        ReferenceMesh.Compare(name, "mean_curvature_edge_based", mesh.ComputeBendingCurvature());

        bool Interior(int v) => !mesh.Vertices[v].IsBoundary;

        double AtNeedle(int v) => atNeedle[v] ? 1e-6 * Math.Abs(curvatures.Mean[v]) : 0;

        // On flat and round parts H² − K cancels: the last digits of H and of the angle defect become half as many digits of the root.
        double OfTheRoot(int v)
        {
            double h = curvatures.Mean[v], error = (1e-12 * h * h) + (2 * Math.Abs(h) * AtNeedle(v)) + (4e-15 / areas[v]);
            return Math.Min(Math.Sqrt(error), error / Math.Max(1e-300, principal.Max[v] - principal.Min[v]));
        }
    }

    private static bool[] AtNeedles(Mesh mesh)
    {
        double[] angles = mesh.ComputeCornerAngles();
        var found = new bool[mesh.VertexSlots];
        foreach (Face f in mesh.Faces)
        {
            if (!f.HalfEdges.Any(h => angles[h.Index] < Needle))
                continue;
            foreach (Vertex v in f.Vertices)
                found[v.Index] = true;
        }
        return found;
    }
}
