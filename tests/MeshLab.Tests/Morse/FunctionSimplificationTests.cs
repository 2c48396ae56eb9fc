using MeshLab.Morse;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.6")]
public class FunctionSimplificationTests
{
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Simplify_Noise_KeepsExactlyThePersistentMinima(string model)
    {
        MorseFunction function = MorseCase.Noise(Models.Create(model), 8);
        foreach (double threshold in (double[])[0, 0.1, 0.5, double.PositiveInfinity])
            Check(function, threshold);
    }

    [SkippableTheory]
    [InlineData("three_holes")]
    [InlineData("reference_annulus")]
    [InlineData("rocker_arm")]
    public void Simplify_HeightOfPublicModels_KeepsExactlyThePersistentMinima(string model)
    {
        ReferenceData.SkipIfMissing();
        MorseFunction function = MorseCase.Height(ReferenceData.Load(model));
        Check(function, 0.02 * MorseCase.Range(function));
    }

    [Fact]
    public void Simplify_WithoutLimitOnATorus_LeavesOneOfEach()
    {
        SimplifiedFunction simplified = FunctionSimplification.Simplify(MorseCase.Noise(Models.Create("torus"), 9), double.PositiveInfinity);

        CriticalPoints critical = CriticalPoints.Of(simplified.Function);
        Assert.Equal((1, 2, 1), (critical.Minima.Count, critical.SaddleCount, critical.Maxima.Count));
    }

    [Theory]
    [InlineData("torus")]
    [InlineData("genus-2")]
    [InlineData("bumpy-sphere")]
    public void Simplify_NoiseOnAClosedSurface_KeepsExactlyThePersistentMaxima(string model)
    {
        MorseFunction function = MorseCase.Noise(Models.Create(model), 17);
        PersistencePairs before = PersistencePairs.Of(function);
        HashSet<Vertex> kept =
        [
            .. before.EssentialMaxima,
            .. before.Pairs.Where(p => p.Kind == PairKind.SaddleMaximum && p.Persistence > 0.3).Select(p => p.Death),
        ];

        CriticalPoints after = CriticalPoints.Of(FunctionSimplification.Simplify(function, 0.3).Function);

        Assert.True(kept.SetEquals(after.Maxima), "other maxima than the persistent ones");
    }

    private static void Check(MorseFunction function, double threshold)
    {
        PersistencePairs before = PersistencePairs.Of(function);
        HashSet<Vertex> kept =
        [
            .. before.EssentialMinima,
            .. before.Pairs.Where(p => p.Kind == PairKind.MinimumSaddle && p.Persistence > threshold).Select(p => p.Birth),
        ];

        SimplifiedFunction simplified = FunctionSimplification.Simplify(function, threshold);

        CriticalPoints after = CriticalPoints.Of(simplified.Function);
        Assert.True(kept.SetEquals(after.Minima), "other minima than the persistent ones");
        Assert.Equal(after.EulerCharacteristic, after.IndexSum);
        Assert.True(simplified.LargestChange <= threshold);
        // The order agrees with the values: it only decides between equal ones.
        int[] sorted = simplified.Function.Sorted();
        for (int i = 1; i < sorted.Length; i++)
            Assert.True(simplified.Function.Data[sorted[i - 1]] <= simplified.Function.Data[sorted[i]]);
    }
}
