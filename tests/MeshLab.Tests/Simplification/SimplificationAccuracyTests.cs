using System.Collections.Concurrent;
using System.Text.Json;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>Distances to the original beside the best of the recorded simplifiers that reach the target on a clean mesh.</summary>
[Trait("Section", "7.2")]
[Trait("Speed", "Slow")]
public class SimplificationAccuracyTests
{
    /// <summary>Where the best of the recorded programs is closer than that, and what is asked instead. All faces of the box assembly lie in planes at half their
    /// number: what is measured there is rounding, 4E-11 of the diagonal.</summary>
    private static readonly Dictionary<string, double> FastExceptions = new(StringComparer.Ordinal)
    {
        ["reference_annulus 10%"] = 1.07, ["box_assembly 10%"] = 1.068, ["box_assembly 50%"] = 1.92,
    };

    private static readonly ConcurrentDictionary<string, ReferenceDistance> Distances = new(StringComparer.Ordinal);

    [Fact]
    public void NumpyRandom_Seed12345_IsNumPys()
    {
        // The first number in NumPy's own documentation of default_rng(12345).
        Assert.Equal(0.22733602246716966, new ReferenceDistance.NumpyRandom(12345).NextDouble());
    }

    [SkippableFact]
    public void Simplify_Accurate_IsAtLeastAsCloseAsTheBestOfAllInEveryCase()
    {
        var rms = new List<double>();
        var hausdorff = new List<double>();
        foreach ((string name, string percent, JsonElement limits) in Cases())
        {
            (double r, double h) = Measure(name, limits, QuadricMode.Accurate);
            // All faces of that one lie in planes already; what is measured is rounding.
            if ((name, percent) == ("box_assembly", "50%"))
                continue;
            Assert.True(r <= 1, $"{name} {percent}: rms {r:F3} times the best");
            rms.Add(r);
            hausdorff.Add(h);
        }
        Assert.True(GeometricMean(rms) <= 0.80, $"rms {GeometricMean(rms):F3}");
        Assert.True(GeometricMean(hausdorff) <= 1.25, $"Hausdorff {GeometricMean(hausdorff):F3}");
    }

    [SkippableFact]
    public void Simplify_Fast_IsNearlyAsCloseAsTheBestOfAll()
    {
        foreach ((string name, string percent, JsonElement limits) in Cases())
        {
            (double r, _) = Measure(name, limits, QuadricMode.Fast);
            double limit = FastExceptions.GetValueOrDefault($"{name} {percent}", 1.03);
            Assert.True(r <= limit, $"{name} {percent}: rms {r:F3} times the best, limit {limit}");
        }
    }

    private static IEnumerable<(string Name, string Percent, JsonElement Limits)> Cases()
    {
        JsonElement models = ReferenceData.Json("limits.public").RootElement.GetProperty("models");
        foreach (JsonProperty model in models.EnumerateObject())
        {
            foreach (JsonProperty target in model.Value.EnumerateObject())
                yield return (model.Name, target.Name, target.Value);
        }
    }

    private static (double Rms, double Hausdorff) Measure(string name, JsonElement limits, QuadricMode mode)
    {
        Mesh original = ReferenceMesh.Load(name), mesh = original.Clone();
        int target = limits.GetProperty("target_faces").GetInt32();

        mesh.Simplify(new() { TargetFaces = target, Mode = mode });

        Assert.InRange(mesh.Faces.Count, target - 1, target);
        Assert.Equal(Shapes.EulerCharacteristic(original), Shapes.EulerCharacteristic(mesh));
        Assert.Equal(Shapes.BoundaryLoops(original), Shapes.BoundaryLoops(mesh));
        Assert.Equal(Shapes.Components(original), Shapes.Components(mesh));
        Assert.Empty(mesh.Validate());
        (double rms, double hausdorff) = Distances.GetOrAdd(name, _ => new ReferenceDistance(original)).To(mesh);
        return (
            rms / limits.GetProperty("sampled_rms_clean").GetProperty("value").GetDouble(),
            hausdorff / limits.GetProperty("sampled_hausdorff_clean").GetProperty("value").GetDouble());
    }

    private static double GeometricMean(List<double> values) => Math.Exp(values.Average(Math.Log));
}
