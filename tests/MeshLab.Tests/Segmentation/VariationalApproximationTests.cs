using MeshLab.Segmentation;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Segmentation;

[Trait("Section", "13.3")]
public class VariationalApproximationTests
{
    [Theory]
    [InlineData("cube", 6)]
    [InlineData("tetrahedron", 4)]
    [InlineData("octahedron", 8)]
    public void Segment_Polyhedron_FindsItsSidesExactly(string model, int sides)
    {
        VariationalResult result = VariationalApproximation.Segment(Models.Create(model), sides);

        Assert.Equal(sides, result.Segmentation.Count);
        Assert.Equal(0, result.Segmentation.Objective, 12);
        Assert.All(result.Proxies, proxy => Assert.Equal(1, proxy.Normal.Length, 12));
    }

    [Theory]
    [InlineData("bumpy-sphere")]
    [InlineData("torus")]
    [InlineData("holes")]
    public void Segment_AnyModel_GivesConnectedRegions(string model)
    {
        Mesh mesh = Models.Create(model);

        VariationalResult result = VariationalApproximation.Segment(mesh, 6);

        Relabeling.Pieces(mesh, result.Segmentation.Labels, out int pieces);
        Assert.Equal(6, pieces);
        Assert.Equal(6, result.Segmentation.Count);
    }

    [SkippableTheory]
    [InlineData("fandisk", 100)]
    [InlineData("featuretype", 120)]
    public void Segment_CadModels_GiveTheRegionsBetweenSharpEdges(string model, int regions)
    {
        ReferenceData.SkipIfMissing();
        Mesh mesh = ReferenceData.Load(model);
        int[] expected = CadRegions.Between(mesh, 20, out _);

        VariationalResult result = VariationalApproximation.Segment(mesh, regions, new VariationalOptions { MergeAngle = 20 * Math.PI / 180, MaxTeleports = 5 });

        double agreement = SegmentationMeasures.AdjustedRandIndex(expected, result.Segmentation.Labels);
        Assert.True(agreement >= 0.95, $"adjusted Rand index {agreement}, {result.Segmentation.Count} segments");
    }

    [Fact]
    public void Segment_BadInput_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => VariationalApproximation.Segment(Models.Create("tetrahedron"), 5));
        Assert.Throws<ArgumentException>(() => VariationalApproximation.Segment(Models.Create("components"), 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => VariationalApproximation.Segment(Models.Create("cube"), 0));
    }
}
