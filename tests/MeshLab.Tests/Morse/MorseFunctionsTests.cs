using MeshLab.LinearAlgebra;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.1")]
public class MorseFunctionsTests
{
    [Theory]
    [InlineData("torus")]
    [InlineData("genus-2")]
    [InlineData("bumpy-sphere")]
    [InlineData("annulus")]
    [InlineData("grid")]
    public void EveryFunction_SatisfiesMorsesTheorem(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in All(mesh))
            Assert.Equal(MorseCase.EulerCharacteristic(mesh), CriticalPoints.Of(function).IndexSum);
    }

    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("three_holes")]
    [InlineData("reference_annulus")]
    [InlineData("featuretype")]
    public void EveryFunction_OfPublicModels_SatisfiesMorsesTheorem(string model)
    {
        ReferenceData.SkipIfMissing();
        Mesh mesh = ReferenceData.Load(model);
        foreach (MorseFunction function in All(mesh))
            Assert.Equal(MorseCase.EulerCharacteristic(mesh), CriticalPoints.Of(function).IndexSum);
    }

    [SkippableTheory]
    [InlineData("spot", 0)]
    [InlineData("rocker_arm", 1)]
    [InlineData("three_holes", 3)]
    public void HarmonicFunction_WithPositiveWeights_HasExtremaOnlyAtTheFixedVertices(string model, int genus)
    {
        ReferenceData.SkipIfMissing();
        Mesh mesh = ReferenceData.Load(model);
        Vertex[] ends = [mesh.Vertices.MinBy(v => v.Position.X), mesh.Vertices.MaxBy(v => v.Position.X), mesh.Vertices.MaxBy(v => v.Position.Y)];
        (Vertex, double)[] fixedValues = [(ends[0], 0), (ends[1], 1), (ends[2], 2)];
        foreach (LaplacianWeights weights in (LaplacianWeights[])[LaplacianWeights.Uniform, LaplacianWeights.ClampedCotangent, LaplacianWeights.MeanValue])
        {
            CriticalPoints critical = CriticalPoints.Of(mesh.HarmonicFunction(fixedValues, weights));

            Vertex[] extrema = [.. critical.Minima, .. critical.Maxima];
            Assert.All(extrema, v => Assert.Contains(v, ends));
            // With every fixed vertex an extremum there are 2g − 2 + 3 saddles; one between the others' values need not be one.
            Assert.Equal(2 * genus - 2 + extrema.Length, critical.SaddleCount);
            Assert.Contains(ends[0], critical.Minima);
            Assert.Contains(ends[2], critical.Maxima);
        }
    }

    [Fact]
    public void Functions_BadInput_IsRefused()
    {
        Mesh mesh = Models.Create("tetrahedron");
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.CoordinateFunction(3));
        Assert.Throws<ArgumentException>(() => mesh.DirectionFunction(Vector3D.Zero));
        Assert.Throws<ArgumentException>(() => mesh.DirectionFunction(new(double.NaN, 0, 1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.CosineFunction(2, 0));
        Assert.Throws<ArgumentException>(() => mesh.DistanceFunction(new(double.PositiveInfinity, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.EigenvectorFunction(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.GaussianCurvatureFunction(-1));
        Assert.ThrowsAny<ArgumentException>(() => mesh.GeodesicFunction(default));
    }

    private static IEnumerable<MorseFunction> All(Mesh mesh)
    {
        for (int axis = 0; axis < 3; axis++)
            yield return mesh.CoordinateFunction(axis);
        yield return mesh.DirectionFunction(new(1, -2, 3));
        yield return mesh.CosineFunction();
        yield return mesh.DistanceFunction(new(1, 2, 3));
        yield return mesh.GeodesicFunction(mesh.Vertices[0]);
        yield return mesh.GaussianCurvatureFunction();
        yield return mesh.MeanCurvatureFunction();
        yield return mesh.HarmonicFunction();
        yield return mesh.EigenvectorFunction(2);
    }
}
