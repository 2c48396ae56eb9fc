using MeshLab.FiveSixSeven;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

[Trait("Section", "9.6")]
public class FiveSixSevenTests
{
    public static TheoryData<string, FiveSixSevenEngine> Pathological
    {
        get
        {
            var data = new TheoryData<string, FiveSixSevenEngine>();
            foreach (string name in PathologicalMeshes.Names)
            {
                data.Add(name, FiveSixSevenEngine.Repair);
                data.Add(name, FiveSixSevenEngine.Textbook);
            }
            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Pathological))]
    public void ToFiveSixSeven_Pathological_HasOnlyValencesFiveSixSeven(string name, FiveSixSevenEngine engine)
    {
        Mesh mesh = PathologicalMeshes.Create(name);
        ulong before = mesh.StateHash();

        FiveSixSevenResult result = mesh.ToFiveSixSeven(new() { Engine = engine });

        Assert.Equal(before, mesh.StateHash());
        CheckTopology(mesh, result);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void ToFiveSixSeven_EveryModel_HasOnlyValencesFiveSixSeven(string name)
    {
        // The largest hubs are among the pathological ones.
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count <= 1000)
            CheckTopology(mesh, mesh.ToFiveSixSeven());
    }

    internal static void CheckTopology(Mesh mesh, FiveSixSevenResult result)
    {
        Assert.Empty(result.Mesh.Validate());
        Assert.True(result.IsComplete);
        Assert.All(result.After.Keys, valence => Assert.InRange(valence, 5, 7));
        Assert.Equal(result.After, result.Mesh.CountInnerValences());
        Assert.Equal(Characteristic(mesh), Characteristic(result.Mesh));
        Assert.Equal(Loops(mesh), Loops(result.Mesh));
        if (result.Mesh.IsClosed)
            Assert.Equal(6 * Characteristic(mesh), result.After.Sum(v => (6 - v.Key) * v.Value));
    }

    private static int Characteristic(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    private static int Loops(Mesh mesh)
    {
        var seen = new HashSet<HalfEdge>();
        return mesh.HalfEdges.Count(h => h.IsBoundary && !seen.Contains(h) && h.Loop.All(seen.Add));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void ToFiveSixSeven_PublicModel_KeepsCountShapeAndQuality(string name)
    {
        Skip.If(name is "isosurface_large" or "horse", "Too large for a unit test; measured beside the others.");
        Mesh mesh = ReferenceMesh.Load(name);

        FiveSixSevenResult result = mesh.ToFiveSixSeven();

        CheckTopology(mesh, result);
        Assert.InRange(result.Mesh.Faces.Count / (double)mesh.Faces.Count, 0.995, 1.005);
        MeshDistanceReport distance = mesh.DistanceTo(result.Mesh, new MeshDistanceOptions { Samples = 30_000 });
        Assert.InRange(distance.Hausdorff / distance.Diagonal, 0, 0.0075);
        Assert.InRange(distance.Rms / distance.Diagonal, 0, 0.001);
        Assert.InRange(result.Mesh.ComputeFaceQualities().Average(), 0.85, 1);
    }

    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("featuretype")]
    public void ToFiveSixSeven_TextbookOnPublicModel_IsValid(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        CheckTopology(mesh, mesh.ToFiveSixSeven(new() { Engine = FiveSixSevenEngine.Textbook }));
    }

    [Fact]
    public void ToFiveSixSeven_TwiceAndMovedFarAway_HasTheSameConnectivity()
    {
        Mesh mesh = Models.Create("bumpy-sphere"), far = mesh.Clone();
        foreach (Vertex v in far.Vertices)
            v.Position = v.Position * 1024 + new Vector3D(1 << 20, 0, 0);
        Mesh first = mesh.ToFiveSixSeven().Mesh, again = mesh.ToFiveSixSeven().Mesh, moved = far.ToFiveSixSeven().Mesh;
        Assert.Equal(first.StateHash(), again.StateHash());
        Assert.Empty(moved.Validate());
        Assert.Equal(first.Faces.Count, moved.Faces.Count);
    }

    [Fact]
    public void ToFiveSixSeven_AskedForACount_ReachesIt()
    {
        Mesh mesh = Models.Sphere(20, 24);
        FiveSixSevenResult result = mesh.ToFiveSixSeven(new() { TargetFaces = 600 });
        Assert.InRange(result.Mesh.Faces.Count, 597, 603);
        CheckTopology(mesh, result);
    }

    [Theory]
    [InlineData("sphere", 19)]
    [InlineData("sphere", 22)]
    [InlineData("torus", 13)]
    [InlineData("genus-2", 27)]
    public void ToFiveSixSeven_FewerFacesThanPossible_Throws(string name, int faces) =>
        Assert.Throws<ArgumentException>(() => Models.Create(name).ToFiveSixSeven(new() { TargetFaces = faces }));

    [Fact]
    public void ToFiveSixSeven_BadArguments_Throw()
    {
        Assert.Throws<ArgumentException>(() => Models.Create("cube-quads").ToFiveSixSeven());
        Assert.Throws<ArgumentOutOfRangeException>(() => new FiveSixSevenOptions { TargetFaces = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new FiveSixSevenOptions { FeatureAngle = 4 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new FiveSixSevenOptions { NoiseEdges = -1 });
        Assert.Throws<ArgumentNullException>(() => ((Mesh)null!).ToFiveSixSeven());
    }

    [Fact]
    public void ToFiveSixSeven_Cancelled_Throws()
    {
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.Throws<OperationCanceledException>(() => Models.Create("bumpy-sphere").ToFiveSixSeven(cancellationToken: source.Token));
    }
}

/// <summary>Meshes whose valences are as bad as they can be.</summary>
internal static class PathologicalMeshes
{
    private static readonly SortedDictionary<string, Func<Mesh>> Recipes = new(StringComparer.Ordinal)
    {
        ["tetrahedron"] = Models.Tetrahedron,
        ["cube"] = () => Models.Create("cube"),
        ["octahedron"] = () => Models.Bipyramid(4),
        ["bipyramid-3"] = () => Models.Bipyramid(3),
        ["bipyramid-12"] = () => Models.Bipyramid(12),
        ["bipyramid-100"] = () => Models.Bipyramid(100),
        ["bipyramid-1000"] = () => Models.Bipyramid(1000),
        ["fan-3"] = () => Models.Fan(3),
        ["fan-50"] = () => Models.Fan(50),
        ["torus-3-3"] = () => Models.Torus(3, 3),
        ["torus-3-7"] = () => Models.Torus(3, 7),
        ["genus-2"] = () => Models.Create("genus-2"),
        ["boxes"] = Boxes,
        ["wrecked-sphere"] = () => Wrecked(Models.Sphere(12, 16), 1),
        ["wrecked-torus"] = () => Wrecked(Models.Torus(16, 10), 2),
        ["wrecked-grid"] = () => Wrecked(Models.Triangulated(Models.QuadGrid(14, 14)), 3),
    };

    public static IEnumerable<string> Names => Recipes.Keys;

    public static Mesh Create(string name) => Recipes[name]();

    private static Mesh Boxes()
    {
        Mesh mesh = Models.Create("cube");
        for (int i = 1; i < 30; i++)
        {
            Mesh box = Models.Create("cube");
            foreach (Vertex v in box.Vertices)
                v.Position += new Vector3D(2 * (i % 6), 2 * (i / 6), 0);
            mesh.Append(box);
        }
        return mesh;
    }

    /// <summary>Random flips, whatever they do to valences and shape.</summary>
    private static Mesh Wrecked(Mesh mesh, int seed)
    {
        var random = new Random(seed);
        for (int i = 0; i < mesh.EdgeSlots; i++)
            MeshLab.Editing.EdgeFlip.TryFlip(mesh.Edges[random.Next(mesh.EdgeSlots)], out _);
        return mesh;
    }
}
