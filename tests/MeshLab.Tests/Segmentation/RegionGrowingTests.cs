using MeshLab.Segmentation;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Segmentation;

[Trait("Section", "13.2")]
public class RegionGrowingTests
{
    [Theory]
    [InlineData(GrowingReference.Parent)]
    [InlineData(GrowingReference.Seed)]
    [InlineData(GrowingReference.RegionMean)]
    public void ByFaces_Cube_GivesItsSixSides(GrowingReference reference)
    {
        FaceSegmentation sides = RegionGrowing.ByFaces(Models.Create("cube"), new RegionGrowingOptions { Reference = reference });

        Assert.Equal(6, sides.Count);
        Assert.Equal([2, 2, 2, 2, 2, 2], sides.Sizes);
    }

    [Fact]
    public void ByFaces_ThresholdBelowEveryCosine_GivesTheComponents()
    {
        FaceSegmentation all = RegionGrowing.ByFaces(Models.Create("components"), new RegionGrowingOptions { Threshold = -1.5 });
        Relabeled(Models.Create("components"), all.Labels, out int components);

        Assert.Equal(components, all.Count);
    }

    [Fact]
    public void ByFaces_GivenSeed_GrowsItFirst()
    {
        Mesh mesh = Models.Create("cube");

        int[] labels = RegionGrowing.VertexLabels(mesh, new RegionGrowingOptions { Seeds = [5] });

        Assert.Equal(0, labels[5]);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void EveryMethod_AnyModel_LabelsEveryFace(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (FaceSegmentation s in (FaceSegmentation[])[RegionGrowing.ByFaces(mesh), RegionGrowing.ByVertices(mesh)])
        {
            Assert.All(mesh.Faces, f => Assert.InRange(s.Labels[f.Index], 0, s.Count - 1));
            Assert.All(s.Sizes, size => Assert.True(size > 0));
            Assert.Equal(mesh.Faces.Count, s.Sizes.Sum());
        }
    }

    [SkippableTheory]
    [InlineData("fandisk")]
    [InlineData("featuretype")]
    public void ByFaces_CadModelsAt26Degrees_GiveTheRegionsBetweenSharpEdges(string model)
    {
        ReferenceData.SkipIfMissing();
        Mesh mesh = ReferenceData.Load(model);

        FaceSegmentation grown = RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Threshold = 0.898 });

        int[] expected = CadRegions.Between(mesh, 30, out int count);
        Assert.Equal(ReferenceData.Json(model, "extras").RootElement.GetProperty("sharp_edge_regions").GetProperty("30_deg").GetProperty("regions").GetInt32(), count);
        Assert.True(SegmentationMeasures.AdjustedRandIndex(expected, grown.Labels) >= 0.95);
    }

    [Fact]
    public void Seeds_WrongOnes_AreRefused()
    {
        Mesh mesh = Models.Create("cube");
        Assert.Throws<ArgumentException>(() => RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Seeds = [12] }));
        Assert.Throws<ArgumentException>(() => RegionGrowing.ByFaces(mesh, new RegionGrowingOptions { Seeds = [-1] }));
        Assert.Throws<ArgumentException>(() => RegionGrowing.ByVertices(mesh, new RegionGrowingOptions { Seeds = [1, 1] }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new RegionGrowingOptions { Threshold = double.NaN });
    }

    private static void Relabeled(Mesh mesh, int[] labels, out int pieces)
    {
        int[] one = Array.ConvertAll(labels, label => label < 0 ? -1 : 0);
        Relabeling.Pieces(mesh, one, out pieces);
    }
}
