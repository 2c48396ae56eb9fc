using MeshLab.IO;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Segmentation;
using MeshLab.Structure;
using MeshLab.Tests.Morse;
using Xunit;

namespace MeshLab.Tests.Segmentation;

[Trait("Section", "13.1")]
public class WatershedTests
{
    [Theory]
    [InlineData(WatershedForm.Basins)]
    [InlineData(WatershedForm.Hills)]
    public void Segment_ToOneSegmentPerComponent_GivesTheComponents(WatershedForm form)
    {
        MorseFunction function = MorseCase.Noise(Models.Create("torus"), 20);

        FaceSegmentation whole = Watershed.Segment(function, new WatershedOptions { Form = form, Persistence = double.PositiveInfinity });

        Assert.Equal(1, whole.Count);
    }

    [Fact]
    public void Segment_NumberWanted_IsReached()
    {
        MorseFunction function = MorseCase.Noise(Models.Create("bumpy-sphere"), 21);

        foreach (int wanted in (int[])[2, 3, 4])
        {
            int[] minima = [.. MorseComplex.Of(FunctionSimplification.Simplify(function, Threshold(function, wanted)).Function).MinimumOf.Distinct()];
            Assert.Equal(wanted, minima.Length);
        }
    }

    [Fact]
    public void Segment_CreatureByGeodesicDistance_SplitsIntoBodyAndLimbs()
    {
        string? path = FindModel("creature.obj");
        Assert.NotNull(path);
        Mesh mesh = MeshFile.Read(path);
        Vector3D mean = mesh.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / mesh.Vertices.Count;
        Vertex middle = mesh.Vertices.MinBy(v => (v.Position - mean).LengthSquared);

        FaceSegmentation limbs = Watershed.Segment(mesh.GeodesicFunction(middle), new WatershedOptions { Segments = 9 });

        // Four legs, two horns, head and tail around the body, which is the largest.
        Assert.Equal(9, limbs.Count);
        Assert.Equal(limbs.Sizes.Max(), limbs.Sizes[0]);
        Relabeling.Pieces(mesh, [.. limbs.Labels.Select(label => label == 0 ? -1 : label)], out int pieces);
        Assert.Equal(8, pieces);
    }

    [Fact]
    public void Measures_OfKnownSegmentations_HaveTheKnownValues()
    {
        Assert.Equal(1, SegmentationMeasures.RandIndex([0, 0, 1, 1], [5, 5, 2, 2]));
        Assert.Equal(1, SegmentationMeasures.AdjustedRandIndex([0, 0, 1, 1], [5, 5, 2, 2]));
        // Of six pairs two agree (the pairs across both cuts); expected agreement by chance makes it negative.
        Assert.Equal(2.0 / 6, SegmentationMeasures.RandIndex([0, 0, 1, 1], [0, 1, 0, 1]), 12);
        Assert.Equal(-0.5, SegmentationMeasures.AdjustedRandIndex([0, 0, 1, 1], [0, 1, 0, 1]), 12);
        Assert.Throws<ArgumentException>(() => SegmentationMeasures.RandIndex([0], [0, 1]));
    }

    [Fact]
    public void CutDiscrepancy_OfCubeSides_IsZeroForEqualAndPositiveForOthers()
    {
        Mesh mesh = Models.Create("cube");
        int[] sides = RegionGrowing.ByFaces(mesh).Labels, none = new int[mesh.FaceSlots], halves = [.. sides.Select(label => label % 2)];

        Assert.Equal(0, SegmentationMeasures.CutDiscrepancy(mesh, sides, sides));
        Assert.Equal(0, SegmentationMeasures.CutDiscrepancy(mesh, none, none));
        Assert.Equal(double.PositiveInfinity, SegmentationMeasures.CutDiscrepancy(mesh, sides, none));
        Assert.True(SegmentationMeasures.CutDiscrepancy(mesh, sides, halves) >= 0);
    }

    [Theory]
    [InlineData("torus")]
    [InlineData("bumpy-sphere")]
    public void BorderSmoothing_OfNoisyLabels_ShortensTheBorders(string model)
    {
        Mesh mesh = Models.Create(model);
        FaceSegmentation rough = KMeans.Segment(mesh, 5, new KMeansOptions { NormalWeight = 2 });

        FaceSegmentation smooth = BorderSmoothing.Smooth(mesh, rough);

        Assert.True(BorderSmoothing.BorderLength(mesh, smooth.Labels) <= BorderSmoothing.BorderLength(mesh, rough.Labels));
        Assert.All(smooth.Sizes, size => Assert.True(size > 0));
    }

    private static double Threshold(MorseFunction function, int minima)
    {
        double[] sorted = [.. PersistencePairs.Of(function).Pairs.Where(p => p.Kind == PairKind.MinimumSaddle).Select(p => p.Persistence).OrderDescending()];
        return sorted[minima - 1];
    }

    private static string? FindModel(string name)
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            string path = Path.Combine(folder.FullName, "models", name);
            if (File.Exists(path))
                return path;
        }
        return null;
    }
}
