using System.Text.Json;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>Remeshing of public models beside what CGAL makes of them in ten passes (reference values).</summary>
[Trait("Section", "L4")]
[Trait("Speed", "Slow")]
public class RemeshingReferenceTests
{
    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("bunny_closed")]
    [InlineData("rocker_arm")]
    [InlineData("three_holes")]
    [InlineData("camelhead")]
    [InlineData("reference_annulus")]
    public void Remesh_SmoothModelAtTheReferencesFaceCount_IsNoWorse(string name)
    {
        JsonElement reference = ReferenceData.Json(name, "remesh").RootElement.GetProperty("peers").GetProperty("CGAL isotropic_remeshing 10 it");
        int faces = reference.GetProperty("F").GetInt32();
        Mesh input = ReferenceMesh.Load(name), mesh = AtFaceCount(input, faces);

        Assert.Empty(mesh.Validate());
        Assert.InRange(mesh.Faces.Count, 0, faces);
        RemeshingQuality quality = RemeshingQuality.Of(mesh);
        JsonElement expected = reference.GetProperty("quality");
        Assert.InRange(quality.MeanSmallestAngle * 180 / Math.PI, expected.GetProperty("mean_of_face_min_angle_deg").GetDouble(), 60);
        Assert.InRange(quality.Valence6, expected.GetProperty("valence6_fraction").GetDouble(), 1);
        MeshDistanceReport distance = input.DistanceTo(mesh);
        // Sampling is good for 0.3 %.
        Assert.InRange(distance.SymmetricRms / distance.Diagonal, 0, 1.003 * reference.GetProperty("distance").GetProperty("rms_rel_diag").GetDouble());
        Assert.False(FaceTree.Build(mesh).HasSelfIntersections());
    }

    [SkippableTheory]
    [InlineData("fandisk", 40, 1)]
    [InlineData("fandisk", 60, 2)]
    [InlineData("box_assembly", 40, 1)]
    [InlineData("featuretype", 40, 1)]
    [InlineData("featuretype", 60, 1)]
    [InlineData("rocker_arm", 60, 1)]
    public void Remesh_ModelWithFeatures_KeepsSharpEdges(string name, double degrees, double relative)
    {
        double sharp = degrees * Math.PI / 180;
        Mesh input = ReferenceMesh.Load(name);
        Mesh mesh = input.RemeshIsotropically(new() { FeatureAngle = sharp, RelativeLength = relative }).Mesh;

        Assert.Empty(mesh.Validate());
        FeatureChecks.AssertOnFeatures(input, mesh, sharp);
        // No face is flatter than the input's flattest; or with longer edges, where faces must span rims that are kept, at least far from flat.
        double flattest = RemeshingQuality.Of(input).SmallestAngle;
        Assert.True(RemeshingQuality.Of(mesh).SmallestAngle >= (relative == 1 ? 0.99 * flattest : Math.Min(0.1, 0.99 * flattest)));
    }

    /// <summary>Of results with at most so many faces, and less than a hundredth fewer, the one nearest to the input: lengths that differ by a thousandth give
    /// distances that differ by a hundredth.</summary>
    private static Mesh AtFaceCount(Mesh input, int faces)
    {
        double relative = 1, least = double.PositiveInfinity;
        Mesh? best = null;
        int near = 0;
        for (int i = 0; i < 12 && near < 4; i++)
        {
            Mesh mesh = input.RemeshIsotropically(new() { RelativeLength = relative, Passes = 10 }).Mesh;
            if (mesh.Faces.Count <= faces && mesh.Faces.Count > 0.99 * faces)
            {
                near++;
                double rms = input.DistanceTo(mesh).SymmetricRms;
                if (rms < least)
                    (best, least) = (mesh, rms);
            }
            // A little below, a little less so every time.
            relative *= Math.Sqrt(mesh.Faces.Count / ((0.998 + 0.0002 * i) * faces));
        }
        Assert.NotNull(best);
        return best;
    }
}

internal static class FeatureChecks
{
    /// <summary>Every ninth of every edge of the input that is sharper than an angle is within 0.1 % of the diagonal of such an edge of the result.</summary>
    public static void AssertOnFeatures(Mesh input, Mesh mesh, double angle)
    {
        SegmentTree lines = SegmentTree.Build(mesh.Positions, [.. Sharp(mesh, angle).SelectMany(e => new[] { e.Vertex0.Index, e.Vertex1.Index })]);
        double allowed = 1e-3 * input.BoundingBox.Diagonal;
        foreach (Edge e in Sharp(input, angle))
        {
            for (int i = 0; i <= 8; i++)
                Assert.True(lines.IsWithin(Vector3D.Lerp(e.Vertex0.Position, e.Vertex1.Position, i / 8.0), allowed), $"{e}, {i}/8");
        }
    }

    private static Edge[] Sharp(Mesh mesh, double angle) => [.. mesh.Edges.Where(e => e.IsBoundary || Vector3D.Angle(Normal(e.Face0), Normal(e.Face1)) > angle)];

    private static Vector3D Normal(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
    }
}
