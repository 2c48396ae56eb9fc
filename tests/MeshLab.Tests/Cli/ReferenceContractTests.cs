using System.Globalization;
using System.Text.Json;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs' numbers beside the reference values of the public models.</summary>
[Trait("Section", "command line")]
public sealed class ReferenceContractTests
{
    public static TheoryData<string> PublicModels => ReferenceData.PublicModelCases;

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void Info_PublicModel_EqualsTheReferenceValues(string name)
    {
        JsonElement info = CliCall.Json(0, "info", ReferenceData.ModelPath(name));
        JsonElement core = ReferenceData.Json(name, "core").RootElement;
        JsonElement topology = core.GetProperty("topology"), measures = core.GetProperty("measures");

        foreach ((string field, string reference) in ((string, string)[])
        [
            ("vertices", "V"), ("edges", "E"), ("faces", "F"), ("eulerCharacteristic", "chi"), ("boundaryEdges", "boundary_edges"), ("boundaryLoops", "boundary_loops"),
            ("components", "components"), ("genus", "genus_total"),
        ])
        {
            Assert.True(topology.GetProperty(reference).GetInt32() == info.GetProperty(field).GetInt32(), $"{name}: {field}");
        }
        Assert.Equal(topology.GetProperty("closed").GetBoolean(), info.GetProperty("isClosed").GetBoolean());
        Assert.True(info.GetProperty("isTriangleMesh").GetBoolean());
        Assert.Equal(2 * topology.GetProperty("E").GetInt32(), info.GetProperty("halfEdges").GetInt32());
        Assert.Equal(topology.GetProperty("F").GetInt32(), info.GetProperty("faceDegrees").GetProperty("3").GetInt32());
        Assert.Equal(topology.GetProperty("manifold").GetProperty("unreferenced_vertices").GetInt32(), info.GetProperty("isolatedVertices").GetInt32());
        foreach (string end in (string[])["min", "max"])
            Assert.Equal(topology.GetProperty("valence").GetProperty(end).GetInt32(), info.GetProperty("valence").GetProperty(end).GetDouble());

        double diagonal = measures.GetProperty("bbox_diagonal").GetDouble();
        Near(measures.GetProperty("area"), info.GetProperty("area"), 0);
        Near(measures.GetProperty("volume_signed"), info.GetProperty("volume"), 0);
        Near(measures.GetProperty("centroid_surface"), info.GetProperty("centroidSurface"), diagonal);
        if (measures.TryGetProperty("centroid_volume", out JsonElement centroid) && centroid.ValueKind == JsonValueKind.Array)
            Near(centroid, info.GetProperty("centroidVolume"), diagonal);
        Near(measures.GetProperty("bbox_min"), info.GetProperty("boundingBox").GetProperty("min"), 0);
        Near(measures.GetProperty("bbox_max"), info.GetProperty("boundingBox").GetProperty("max"), 0);
        Near(measures.GetProperty("bbox_diagonal"), info.GetProperty("boundingBox").GetProperty("diagonal"), 0);
        foreach (string statistic in (string[])["min", "mean", "max"])
            Near(measures.GetProperty("edge_length").GetProperty(statistic), info.GetProperty("edgeLength").GetProperty(statistic), 0);
        Near(core.GetProperty("gauss_bonnet").GetProperty("two_pi_chi"), info.GetProperty("angleDefectSum"), topology.GetProperty("V").GetInt32() * 1e-3);

        void Near(JsonElement expected, JsonElement actual, double scale)
        {
            double[] wanted = ReferenceData.Numbers(expected), found = ReferenceData.Numbers(actual);
            Assert.Equal(wanted.Length, found.Length);
            for (int i = 0; i < wanted.Length; i++)
            {
                double bound = 1e-9 * Math.Max(scale, Math.Abs(wanted[i]));
                Assert.True(Math.Abs(wanted[i] - found[i]) <= bound, string.Create(CultureInfo.InvariantCulture, $"{name}: expected {wanted[i]:R}, got {found[i]:R}"));
            }
        }
    }

    [SkippableTheory]
    [InlineData("reference_annulus")]
    [InlineData("box_assembly")]
    [InlineData("three_holes")]
    public void TopologyAndBoundary_PublicModel_EqualTheReferenceValues(string name)
    {
        JsonElement reference = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        JsonElement[] components = [.. CliCall.Json(0, "topology", ReferenceData.ModelPath(name)).GetProperty("components").EnumerateArray()];
        JsonElement[] expected = [.. reference.GetProperty("component_list").EnumerateArray()];
        Assert.Equal(expected.Length, components.Length);
        foreach (JsonElement wanted in expected)
        {
            JsonElement found = components.Single(c => c.GetProperty("firstVertex").GetInt32() == wanted.GetProperty("first_vertex").GetInt32());
            foreach ((string field, string other) in ((string, string)[])
                [("vertices", "V"), ("edges", "E"), ("faces", "F"), ("eulerCharacteristic", "chi"), ("boundaryLoops", "boundary_loops"), ("genus", "genus")])
            {
                Assert.Equal(wanted.GetProperty(other).GetInt32(), found.GetProperty(field).GetInt32());
            }
        }
        double[] lengths = [.. ReferenceData.Numbers(reference.GetProperty("boundary_loop_lengths")).Order()];
        double[] loops = [.. CliCall.Json(0, "boundary", ReferenceData.ModelPath(name)).GetProperty("loops").EnumerateArray().Select(l => l.GetProperty("length").GetDouble()).Order()];
        Assert.Equal(lengths.Length, loops.Length);
        Assert.All(lengths.Zip(loops), pair => Assert.Equal(pair.First, pair.Second, pair.First * 1e-12));
    }
}
