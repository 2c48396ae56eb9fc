using System.Text.Json;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

/// <summary>Every geometric array and measure stored for the public models.</summary>
[Trait("Section", "10.1")]
[Trait("Section", "10.3")]
[Trait("Section", "10.4")]
[Trait("Section", "10.5")]
[Trait("Section", "10.6")]
public class GeometryReferenceTests
{
    public static TheoryData<string> AllModels => ReferenceData.PublicModelCases;

    [SkippableTheory]
    [MemberData(nameof(AllModels))]
    public void FaceArrays_PublicModels_EqualTheReferenceValues(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        ReferenceMesh.Compare(name, "face_area", mesh.ComputeFaceAreas());
        ReferenceMesh.Compare(name, "face_normal", ReferenceMesh.Flat(mesh.ComputeFaceNormals()), 1e-9, width: 3);
        ReferenceMesh.Compare(name, "interior_angles", AnglesByFace(mesh), 1e-9, width: 3);
    }

    [SkippableTheory]
    [MemberData(nameof(AllModels))]
    public void VertexArrays_PublicModels_EqualTheReferenceValues(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        ReferenceMesh.Compare(name, "vertex_normal_uniform", Normals(VertexNormalWeight.Uniform), 1e-9, width: 3);
        ReferenceMesh.Compare(name, "vertex_normal_area", Normals(VertexNormalWeight.Area), 1e-9, width: 3);
        ReferenceMesh.Compare(name, "vertex_normal_angle", Normals(VertexNormalWeight.Angle), 1e-9, width: 3);
        ReferenceMesh.Compare(name, "vertex_normal_max", Normals(VertexNormalWeight.InscribedSphere), 1e-9, width: 3);
        ReferenceMesh.Compare(name, "mixed_area", mesh.ComputeMixedAreas());
        ReferenceMesh.Compare(name, "barycentric_area", mesh.ComputeBarycentricAreas());
        ReferenceMesh.Compare(name, "gauss_integrated", mesh.ComputeAngleDefects());

        double[] Normals(VertexNormalWeight weight) => ReferenceMesh.Flat(mesh.ComputeVertexNormals(weight));
    }

    [SkippableTheory]
    [MemberData(nameof(AllModels))]
    public void DihedralAngles_PublicModels_EqualTheReferenceValues(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        double[] angles = mesh.ComputeDihedralAngles();
        double[] interior = [.. ReferenceMesh.EdgesInOrder(mesh).Where(e => !mesh.Edges[e].IsBoundary).Select(e => angles[e])];
        ReferenceMesh.Compare(name, "dihedral_signed", interior);
    }

    [SkippableTheory]
    [MemberData(nameof(AllModels))]
    public void Measures_PublicModels_EqualTheReferenceValues(string name)
    {
        JsonElement expected = ReferenceData.Json(name, "core").RootElement.GetProperty("measures");
        Mesh mesh = ReferenceMesh.Load(name);
        MeshMeasures measures = MeshMeasures.Of(mesh);
        double diagonal = expected.GetProperty("bbox_diagonal").GetDouble();

        Near(expected.GetProperty("area").GetDouble(), measures.Mass.Area, 1e-11 * measures.Mass.Area);
        Near(expected.GetProperty("volume_signed").GetDouble(), measures.Mass.Volume, 1e-9 * Math.Abs(measures.Mass.Volume));
        Near(expected.GetProperty("centroid_surface"), measures.Mass.SurfaceCentroid, 1e-9 * diagonal);
        if (expected.TryGetProperty("centroid_volume", out JsonElement centroid) && centroid.ValueKind == JsonValueKind.Array)
            Near(centroid, measures.Mass.VolumeCentroid, 1e-8 * diagonal);
        JsonElement lengths = expected.GetProperty("edge_length");
        Near(lengths.GetProperty("min").GetDouble(), measures.EdgeLength.Min, 1e-12 * diagonal);
        Near(lengths.GetProperty("max").GetDouble(), measures.EdgeLength.Max, 1e-12 * diagonal);
        Near(lengths.GetProperty("mean").GetDouble(), measures.EdgeLength.Mean, 1e-12 * diagonal);
        Assert.Equal(diagonal, measures.BoundingBox.Diagonal, 1e-12 * diagonal);
        JsonElement topology = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        Assert.Equal(topology.GetProperty("valence").GetProperty("min").GetInt32(), (int)measures.Valence.Min);
        Assert.Equal(topology.GetProperty("valence").GetProperty("max").GetInt32(), (int)measures.Valence.Max);
        Near(2 * Math.PI * topology.GetProperty("chi").GetInt32(), measures.AngleDefectSum, 1e-8);
        Near(measures.Mass.Area, mesh.ComputeMixedAreas().Sum(), 1e-11 * measures.Mass.Area);
    }

    private static double[] AnglesByFace(Mesh mesh)
    {
        double[] angles = mesh.ComputeCornerAngles();
        return [.. mesh.Faces.SelectMany(f => new[] { angles[f.HalfEdge.Previous.Index], angles[f.HalfEdge.Index], angles[f.HalfEdge.Next.Index] })];
    }

    private static void Near(double expected, double actual, double tolerance) =>
        Assert.True(Math.Abs(expected - actual) <= tolerance, $"{actual:R}, expected {expected:R}.");

    private static void Near(JsonElement expected, Vector3D actual, double tolerance)
    {
        for (int axis = 0; axis < 3; axis++)
            Near(expected[axis].GetDouble(), actual[axis], tolerance);
    }
}
