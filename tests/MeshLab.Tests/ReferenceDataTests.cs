using Xunit;

namespace MeshLab.Tests;

[Trait("Section", "14")]
public class ReferenceDataTests
{
    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Json_OfEveryPublicModel_HasTopology(string name)
    {
        Assert.True(File.Exists(ReferenceData.ModelPath(name)));
        Assert.True(ReferenceData.Json(name, "core").RootElement.GetProperty("topology").GetProperty("V").GetInt32() > 0);
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Load_OfEveryPublicModel_HasTheReferenceCountsAndIsValid(string name)
    {
        System.Text.Json.JsonElement topology = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        MeshLab.Structure.Mesh mesh = ReferenceData.Load(name);
        Assert.Equal(topology.GetProperty("V").GetInt32(), mesh.Vertices.Count);
        Assert.Equal(topology.GetProperty("E").GetInt32(), mesh.Edges.Count);
        Assert.Equal(topology.GetProperty("F").GetInt32(), mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.ModelsWithArraysCases), MemberType = typeof(ReferenceData))]
    public void Arrays_OfEverySmallModel_HaveOneAreaPerFace(string name)
    {
        int faces = ReferenceData.Json(name, "core").RootElement.GetProperty("topology").GetProperty("F").GetInt32();
        Assert.Equal(faces, ReferenceData.Numbers(ReferenceData.Arrays(name).RootElement.GetProperty("face_area")).Length);
    }
}
