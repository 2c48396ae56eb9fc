using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

/// <summary>A model in other units gives the same elements, also where it is symmetric, flat or on a grid and many costs are equal but for rounding.</summary>
[Trait("Section", "7.2")]
public class UnitsTests
{
    private static readonly SortedDictionary<string, Func<Mesh, Mesh>> Algorithms = new(StringComparer.Ordinal)
    {
        ["accurate"] = mesh => Simplified(mesh, QuadricMode.Accurate),
        ["fast"] = mesh => Simplified(mesh, QuadricMode.Fast),
        ["five-six-seven"] = mesh => mesh.ToFiveSixSeven().Mesh,
        ["remesh"] = mesh => mesh.RemeshIsotropically().Mesh,
        ["remesh with features"] = mesh => mesh.RemeshIsotropically(new() { FeatureAngle = 40 * Math.PI / 180, CurvatureTolerance = 0.1 }).Mesh,
    };

    // Far away, the last bits of the coordinates are the shape's.
    public static TheoryData<string, string> SmallModels =>
        Cases(Models.Names.Where(name => name != "far-away" && Models.Create(name) is { IsTriangleMesh: true, Faces.Count: > 20 and < 2000 }));

    public static TheoryData<string, string> PublicModels => Cases(["spot", "fandisk", "featuretype"]);

    private static TheoryData<string, string> Cases(IEnumerable<string> names)
    {
        var cases = new TheoryData<string, string>();
        foreach (string name in names)
        {
            foreach (string algorithm in Algorithms.Keys)
                cases.Add(name, algorithm);
        }
        return cases;
    }

    [Theory]
    [MemberData(nameof(SmallModels))]
    public void Result_SmallModelInOtherUnits_HasTheSameConnectivity(string name, string algorithm) =>
        CheckUnits(() => Models.Create(name), Algorithms[algorithm], algorithm is "fast" or "accurate" ? [1e-6, 1e6, 25.4, 1e-200, 1e200] : [1e-6, 1e6, 25.4]);

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void Result_PublicModelInOtherUnits_HasTheSameConnectivity(string name, string algorithm) =>
        CheckUnits(() => ReferenceMesh.Load(name), Algorithms[algorithm], [name is "spot" or "fandisk" ? 1e-6 : 1e6]);

    [SkippableTheory]
    [InlineData("fast")]
    [InlineData("accurate")]
    [InlineData("remesh")]
    [InlineData("five-six-seven")]
    public void Result_SymmetricModelFarAway_HasTheSameConnectivity(string algorithm)
    {
        // A shift by 10⁶ takes ten digits from the coordinates; edges alike on both sides must not be told apart by the rest.
        Mesh mesh = ReferenceMesh.Load("spot"), far = ReferenceMesh.Load("spot");
        foreach (ref Vector3D p in far.Positions)
            p += new Vector3D(1e6, 1e6, 1e6);
        Assert.Equal(Algorithms[algorithm](mesh).Target.ToArray(), Algorithms[algorithm](far).Target.ToArray());
    }

    private static void CheckUnits(Func<Mesh> create, Func<Mesh, Mesh> run, double[] scales)
    {
        Mesh expected = run(create());
        foreach (double scale in scales)
        {
            Mesh scaled = create();
            foreach (ref Vector3D p in scaled.Positions)
                p *= scale;
            Mesh actual = run(scaled);
            Assert.Empty(actual.Validate());
            Assert.Equal(expected.Target.ToArray(), actual.Target.ToArray());
        }
    }

    private static Mesh Simplified(Mesh mesh, QuadricMode mode)
    {
        mesh.Simplify(new() { Mode = mode, TargetRatio = 0.3 });
        return mesh;
    }
}
