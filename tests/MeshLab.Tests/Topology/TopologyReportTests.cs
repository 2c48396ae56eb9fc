using System.Text.Json;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Topology;

[Trait("Section", "11.1")]
[Trait("Section", "11.2")]
[Trait("Section", "11.3")]
[Trait("Section", "11.4")]
public class TopologyReportTests
{
    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void ComputeTopology_PublicModels_EqualTheReferenceValues(string name)
    {
        JsonElement expected = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        Mesh mesh = ReferenceMesh.Load(name);
        TopologyReport report = mesh.ComputeTopology();
        Assert.Equal(expected.GetProperty("chi").GetInt32(), report.EulerCharacteristic);
        Assert.Equal(expected.GetProperty("genus_total").GetInt32(), report.Genus);
        Assert.Equal(expected.GetProperty("boundary_loops").GetInt32(), report.BoundaryLoops);
        Assert.Equal(expected.GetProperty("components").GetInt32(), mesh.ComponentCount);
        Assert.Equal(report.Genus, mesh.Genus);
        Assert.Equal(report.EulerCharacteristic, mesh.EulerCharacteristic);
        JsonElement[] parts = [.. expected.GetProperty("component_list").EnumerateArray()];
        Assert.Equal(parts.Length, report.Components.Count);
        foreach (var (part, component) in parts.Zip(report.Components))
        {
            Assert.Equal(part.GetProperty("first_vertex").GetInt32(), component.FirstVertex);
            Assert.Equal(part.GetProperty("V").GetInt32(), component.Vertices);
            Assert.Equal(part.GetProperty("E").GetInt32(), component.Edges);
            Assert.Equal(part.GetProperty("F").GetInt32(), component.Faces);
            Assert.Equal(part.GetProperty("boundary_loops").GetInt32(), component.BoundaryLoops);
            Assert.Equal(part.GetProperty("genus").GetInt32(), component.Genus);
        }
        Assert.Equal(0, GaussBonnet.Check(mesh).Difference, 1e-8);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void FindComponents_AnyMesh_AgreesWithWalkingFromEachVertex(string name)
    {
        Mesh mesh = Models.Create(name);
        MeshComponents components = mesh.FindComponents();
        int next = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
            {
                Assert.Equal(-1, components.VertexLabels[v.Index]);
                continue;
            }
            Vertex[] component = v.Component;
            if (component[0] != v)
                continue;
            Assert.All(component, w => Assert.Equal(next, components.VertexLabels[w.Index]));
            next++;
        }
        Assert.Equal(next, components.Count);
        foreach (Face f in mesh.Faces)
            Assert.Equal(components.VertexLabels[f.HalfEdge.Source.Index], components.FaceLabels[f.Index]);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void GaussBonnet_AnyMeshOfFlatFaces_HoldsToRounding(string name)
    {
        Mesh mesh = Models.Create(name);
        GaussBonnetReport report = GaussBonnet.Check(mesh);
        // Bent polygons have other angle sums, and faces whose corners lie in one point have none.
        if (name == "mixed-polygons" || (mesh.Faces.Count > 0 && mesh.Area == 0))
            return;
        Assert.Equal(2 * Math.PI * mesh.EulerCharacteristic, report.Expected);
        Assert.True(Math.Abs(report.Difference) < 1e-9, $"{name}: {report}");
    }

    [Fact]
    public void GaussBonnet_Annulus_TurnsOncePerRimInOppositeSenses()
    {
        GaussBonnetReport report = GaussBonnet.Check(Models.Create("annulus"));
        Assert.Equal(0, report.EulerCharacteristic);
        Assert.Equal(0, report.BoundaryTurning, 1e-12);
        Assert.Equal(0, report.InteriorDefects, 1e-12);
    }

    [Theory]
    [InlineData("sphere", 2, 0, 0)]
    [InlineData("torus", 0, 1, 0)]
    [InlineData("genus-2", -2, 2, 0)]
    [InlineData("genus-2-quads", -2, 2, 0)]
    [InlineData("annulus", 0, 0, 2)]
    [InlineData("one-triangle", 1, 0, 1)]
    [InlineData("empty", 0, 0, 0)]
    [InlineData("isolated-vertices", 2, 0, 0)]
    public void ComputeTopology_KnownShape_IsThat(string name, int characteristic, int genus, int loops)
    {
        Mesh mesh = Models.Create(name);
        TopologyReport report = mesh.ComputeTopology();
        Assert.Equal(characteristic, report.EulerCharacteristic);
        Assert.Equal(genus, report.Genus);
        Assert.Equal(loops, report.BoundaryLoops);
        Assert.Equal(loops == 0, report.IsClosed);
        Assert.Equal(mesh.Vertices.Count, report.Vertices + report.IsolatedVertices);
    }

    [Fact]
    public void ToString_Torus_ReadsAsEulersTheorem() => Assert.Equal(
        "V − E + F = 96 − 288 + 192 = 0 = 2·1 − 2·1 − 0 = 2C − 2g − B", Models.Create("torus").ComputeTopology().ToString());
}
