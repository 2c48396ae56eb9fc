using System.Text.Json;
using MeshLab.IO;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class HarmonicFunctionTests
{
    [Fact]
    public void ComputeHarmonicHeight_Components_TakesTheLargest()
    {
        Mesh mesh = Models.Create("components");
        double[] u = mesh.ComputeHarmonicHeight();

        Assert.All(u.Take(30), value => Assert.InRange(value, 0, 1));
        Assert.All(u.Skip(30), value => Assert.Equal(double.NaN, value));
        Assert.Equal(0, u[Enumerable.Range(0, 30).MinBy(v => mesh.Positions[v].Z)]);
        Assert.Equal(1, u[Enumerable.Range(0, 30).MaxBy(v => mesh.Positions[v].Z)]);
    }

    [Fact]
    public void ComputeHarmonicHeight_NothingToTellLowFromHigh_Throws()
    {
        Assert.Throws<ArgumentException>(() => Models.Create("annulus").ComputeHarmonicHeight());
        Assert.Throws<ArgumentException>(() => new Mesh().ComputeHarmonicHeight());
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.ModelsWithArraysCases), MemberType = typeof(ReferenceData))]
    public void ComputeHarmonicHeight_ReferenceModel_GivesEveryReferenceValue(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        double[] expected = ReferenceData.Numbers(ReferenceData.Arrays(name).RootElement.GetProperty("harmonic_z"));

        double[] u = mesh.ComputeHarmonicHeight();

        // The reference marks vertices outside the component by −1.
        Assert.All(expected.Zip(u), pair => Assert.Equal(pair.First, double.IsNaN(pair.Second) ? -1 : pair.Second, 1e-9));
        JsonElement harmonic = ReferenceData.Json(name, "core").RootElement.GetProperty("harmonic");
        Assert.Equal(
            harmonic.GetProperty("dirichlet_energy_uTLu").GetDouble(),
            mesh.ComputeLaplacian().QuadraticForm([.. u.Select(x => double.IsNaN(x) ? 0 : x)]), 1e-9);
    }
}
