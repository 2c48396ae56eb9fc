using MeshLab.FiveSixSeven;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Spatial;
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
        Mesh mesh = ReferenceMesh.Load(name);

        FiveSixSevenResult result = mesh.ToFiveSixSeven();

        CheckTopology(mesh, result);
        Assert.InRange(result.Mesh.Faces.Count / (double)mesh.Faces.Count, 0.995, 1.005);
        MeshDistanceReport distance = mesh.DistanceTo(result.Mesh, new MeshDistanceOptions { Samples = 30_000 });
        Assert.InRange(distance.Hausdorff / distance.Diagonal, 0, 0.0075);
        Assert.InRange(distance.Rms / distance.Diagonal, 0, 0.001);
        Assert.InRange(result.Mesh.ComputeFaceQualities().Average(), 0.85, 1);
    }

    [SkippableFact]
    public void ToFiveSixSeven_Fandisk_KeepsItsCreases()
    {
        const double Sharp = 40 * Math.PI / 180;
        Mesh mesh = ReferenceMesh.Load("fandisk"), result = mesh.ToFiveSixSeven().Mesh;
        double allowed = 0.0025 * mesh.BoundingBox.Diagonal;
        // Creases of the one lie on creases of the other, both ways; those that are just sharp may be a little less so afterwards.
        AssertNear(mesh, Sharp, CreasesOf(result, 0.75 * Sharp), allowed);
        AssertNear(result, Sharp, CreasesOf(mesh, 0.75 * Sharp), allowed);
    }

    private static SegmentTree CreasesOf(Mesh mesh, double angle) => SegmentTree.Build(
        mesh.Positions, [.. mesh.Edges.Where(e => Dihedral(e) > angle).SelectMany(e => new[] { e.Vertex0.Index, e.Vertex1.Index })]);

    private static void AssertNear(Mesh mesh, double angle, SegmentTree lines, double allowed)
    {
        foreach (Edge e in mesh.Edges.Where(e => Dihedral(e) > angle))
        {
            for (int i = 0; i <= 4; i++)
                Assert.True(lines.IsWithin(Vector3D.Lerp(e.Vertex0.Position, e.Vertex1.Position, i / 4.0), allowed), $"{e}");
        }
    }

    private static double Dihedral(Edge e) => e.IsBoundary ? 0 : Vector3D.Angle(Normal(e.Face0), Normal(e.Face1));

    private static Vector3D Normal(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
    }

    [Fact]
    public void ToFiveSixSeven_AnyNumberOfThreads_GivesTheSameBits()
    {
        Mesh mesh = PathologicalMeshes.Wrecked(Models.Sphere(14, 20), 5);
        foreach (FiveSixSevenEngine engine in Enum.GetValues<FiveSixSevenEngine>())
        {
            ulong expected = mesh.ToFiveSixSeven(new() { Engine = engine }).Mesh.StateHash();
            try
            {
                foreach (int threads in new[] { 1, 2, 3 })
                {
                    Parallelism.MaxThreads = threads;
                    Assert.Equal(expected, mesh.ToFiveSixSeven(new() { Engine = engine }).Mesh.StateHash());
                }
            }
            finally
            {
                Parallelism.MaxThreads = 0;
            }
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void ToFiveSixSeven_Crumpled_TakesItsFoldsForNoFeatures(int seed)
    {
        // Folds that were kept would leave nothing to repair but by cutting every face into nine.
        Mesh mesh = PathologicalMeshes.Wrecked(Models.Sphere(30, 40), seed);
        FiveSixSevenResult result = mesh.ToFiveSixSeven();
        CheckTopology(mesh, result);
        Assert.False(result.UsedLastResort);
        Assert.InRange(result.Walks, 0, 5000);
        Assert.InRange(result.Mesh.Faces.Count / (double)mesh.Faces.Count, 0.995, 1.005);
        Assert.InRange(result.Mesh.ComputeFaceQualities().Average(), 0.85, 1);
    }

    [Theory]
    [InlineData(1e-6, 0)]
    [InlineData(1e6, 0)]
    [InlineData(1, 1e6)]
    public void ToFiveSixSeven_OtherSizeOrPlace_HasTheSameConnectivity(double scale, double offset)
    {
        // Random places, so that no two lengths are equal but for rounding.
        Mesh mesh = Models.Sphere(16, 20);
        var random = new Random(4);
        foreach (Vertex v in mesh.Vertices)
            v.Position *= 1 + 0.05 * random.NextDouble();
        Mesh other = mesh.Clone();
        foreach (Vertex v in other.Vertices)
            v.Position = v.Position * scale + new Vector3D(offset, -offset, offset);
        Mesh first = mesh.ToFiveSixSeven().Mesh, moved = other.ToFiveSixSeven().Mesh;
        Assert.Empty(moved.Validate());
        Assert.Equal(first.Target.ToArray(), moved.Target.ToArray());
    }

    [Theory]
    [MemberData(nameof(PathologicalNames))]
    public void LastResort_Pathological_ReachesZeroAndSparesComponentsThatAreRight(string name)
    {
        // A component that is right already comes along.
        Mesh mesh = MeshLab.Generation.Polyhedra.Icosahedron();
        mesh.Append(PathologicalMeshes.Create(name));
        mesh.Compact();
        WorkMesh work = WorkMesh.From(mesh);
        bool wasRight = work.Penalty == 0;

        WorkMesh fine = LastResort.Run(work);

        Assert.Equal(0, fine.Penalty);
        (Vector3D[] positions, int[] corners, _) = fine.Export();
        Mesh result = MeshBuilder.FromTriangles(positions, corners);
        Assert.Empty(result.Validate());
        Assert.All(result.CountInnerValences().Keys, valence => Assert.InRange(valence, 5, 7));
        Assert.Equal(Characteristic(mesh), Characteristic(result));
        Assert.Equal(Loops(mesh), Loops(result));
        Assert.Equal(mesh.Positions[..12].ToArray(), result.Positions[..12].ToArray());
        Assert.All(result.Vertices.Take(12), v => Assert.Equal(5, v.Valence));
        Assert.Equal(20, result.Faces.Count(f => f.Vertices.All(v => v.Index < 12)));
        if (wasRight)
            Assert.Equal(mesh.Faces.Count, result.Faces.Count);
    }

    public static TheoryData<string> PathologicalNames => new(PathologicalMeshes.Names);

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
    public void ToFiveSixSeven_AllOnOneLine_Ends()
    {
        // No area: even triangles of any length would be endlessly many.
        Mesh mesh = PathologicalMeshes.Wrecked(Models.Torus(16, 10), 2);
        foreach (Vertex v in mesh.Vertices)
            v.Position = new(v.Position.X, 0, 0);
        CheckTopology(mesh, mesh.ToFiveSixSeven());
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
        Assert.Contains("f0", Assert.Throws<ArgumentException>("mesh", () => Models.Create("cube-quads").ToFiveSixSeven()).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>("options", () => Models.Create("cube").ToFiveSixSeven(new() { TargetFaces = 1001, FaceBudget = 1000 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FiveSixSevenOptions { FaceBudget = 0 });
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
        ["fan-300"] = () => Models.Fan(300),
        ["torus-3-3"] = () => Models.Torus(3, 3),
        ["torus-3-4"] = () => Models.Torus(3, 4),
        ["torus-4-3"] = () => Models.Torus(4, 3),
        ["torus-3-7"] = () => Models.Torus(3, 7),
        ["genus-2"] = () => Models.Create("genus-2"),
        ["boxes"] = Boxes,
        ["tetrahedra"] = Tetrahedra,
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

    // Closed components of the fewest faces there are, beside an open one.
    private static Mesh Tetrahedra()
    {
        Mesh mesh = Models.Create("grid");
        for (int i = 1; i < 5; i++)
        {
            Mesh tetrahedron = Models.Tetrahedron();
            foreach (Vertex v in tetrahedron.Vertices)
                v.Position += new Vector3D(2 * i, 0, i);
            mesh.Append(tetrahedron);
        }
        return mesh;
    }

    /// <summary>Random flips, whatever they do to valences and shape.</summary>
    public static Mesh Wrecked(Mesh mesh, int seed)
    {
        var random = new Random(seed);
        for (int i = 0; i < mesh.EdgeSlots; i++)
            MeshLab.Editing.EdgeFlip.TryFlip(mesh.Edges[random.Next(mesh.EdgeSlots)], out _);
        return mesh;
    }
}
