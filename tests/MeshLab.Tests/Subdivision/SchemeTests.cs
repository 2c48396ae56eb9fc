using System.Text.Json;
using MeshLab.Editing;
using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Generation;
using Xunit;

namespace MeshLab.Tests.Subdivision;

/// <summary>What holds for every scheme.</summary>
[Trait("Section", "8")]
public class SchemeTests
{
    /// <summary>Every scheme.</summary>
    public static TheoryData<SubdivisionScheme> Schemes => [.. Enum.GetValues<SubdivisionScheme>()];

    public static TheoryData<SubdivisionScheme, string> TriangleCases => Cases(Models.TriangleMeshes, SubdivisionScheme.Loop, SubdivisionScheme.ModifiedButterfly, SubdivisionScheme.Sqrt3, SubdivisionScheme.Midpoint);

    public static TheoryData<SubdivisionScheme, string> PolygonCases => Cases(Models.All, SubdivisionScheme.CatmullClark, SubdivisionScheme.DooSabin);

    [Theory]
    [MemberData(nameof(TriangleCases))]
    [MemberData(nameof(PolygonCases))]
    public void Subdivide_TwoSteps_KeepsTopologyAndIsValid(SubdivisionScheme scheme, string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();

        Mesh finer = mesh.Subdivide(scheme, new SubdivisionOptions { Steps = 2 });

        Assert.Empty(finer.Validate());
        Assert.Equal(before, mesh.StateHash());
        int isolated = mesh.Vertices.Count(v => v.IsIsolated), kept = finer.Vertices.Count(v => v.IsIsolated);
        Assert.Equal(Measure.EulerCharacteristic(mesh) - isolated, Measure.EulerCharacteristic(finer) - kept);
        Assert.Equal(Measure.BoundaryLoops(mesh), Measure.BoundaryLoops(finer));
        Assert.Equal(Measure.Components(mesh) - isolated, Measure.Components(finer) - kept);
        if (scheme is SubdivisionScheme.CatmullClark)
            Assert.All(finer.Faces, f => Assert.Equal(4, f.Degree));
        Assert.Equal(finer.StateHash(), mesh.Subdivide(scheme, new SubdivisionOptions { Steps = 2 }).StateHash());
    }

    [Theory]
    [MemberData(nameof(Schemes))]
    public void Subdivide_OfAnAffineImage_IsTheAffineImage(SubdivisionScheme scheme)
    {
        static Vector3D Map(Vector3D p) => new(2 * p.X - p.Y + 3, p.X + 0.5 * p.Z, p.Y - 4 * p.Z - 1);
        foreach (string name in new[] { "torus", "holes", "bumpy-sphere" })
        {
            Mesh mesh = Models.Create(name), image = mesh.Clone();
            foreach (ref Vector3D p in image.Positions)
                p = Map(p);
            var twice = new SubdivisionOptions { Steps = 2 };
            Mesh first = mesh.Subdivide(scheme, twice), second = image.Subdivide(scheme, twice);
            for (int v = 0; v < first.VertexSlots; v++)
                Assert.True(Vector3D.Distance(Map(first.Positions[v]), second.Positions[v]) < 1e-12);
        }
    }

    public static TheoryData<SubdivisionScheme, double, double> SizesAndPlaces
    {
        get
        {
            var cases = new TheoryData<SubdivisionScheme, double, double>();
            foreach (SubdivisionScheme scheme in Enum.GetValues<SubdivisionScheme>())
            {
                cases.Add(scheme, 1e-6, 0);
                cases.Add(scheme, 1e6, 0);
                cases.Add(scheme, 1, 1e6);
            }
            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(SizesAndPlaces))]
    public void Subdivide_OtherSizeOrPlace_HasTheSameConnectivityAndShape(SubdivisionScheme scheme, double scale, double offset)
    {
        Mesh mesh = Models.Create("bumpy-sphere"), other = mesh.Clone();
        var shift = new Vector3D(offset, -offset, offset);
        foreach (ref Vector3D p in other.Positions)
            p = p * scale + shift;
        var twice = new SubdivisionOptions { Steps = 2 };
        Mesh first = mesh.Subdivide(scheme, twice), second = other.Subdivide(scheme, twice);
        Assert.Equal(first.Next.ToArray(), second.Next.ToArray());
        Assert.Equal(first.Target.ToArray(), second.Target.ToArray());
        double tolerance = 1e-14 * (scale + 10 * offset) * 10;
        for (int v = 0; v < first.VertexSlots; v++)
            Assert.True(Vector3D.Distance(first.Positions[v] * scale + shift, second.Positions[v]) <= tolerance, $"v{v}");
    }

    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.ModifiedButterfly)]
    [InlineData(SubdivisionScheme.Midpoint)]
    [InlineData(SubdivisionScheme.Sqrt3)]
    public void Subdivide_OfAFlatGrid_StaysFlatWithoutFolds(SubdivisionScheme scheme)
    {
        Mesh grid = Grids.Grid(6, 6);
        Mesh finer = grid.Subdivide(scheme, new SubdivisionOptions { Steps = 2 });
        Assert.All(finer.Faces, f => Assert.True(Measure.VectorArea(f).Z > 0));
        Assert.All(finer.Vertices, v => Assert.Equal(0, v.Position.Z));
        if (scheme == SubdivisionScheme.Midpoint)
            Assert.Equal(1, Measure.Area(finer), 1e-12);
    }

    [Theory]
    [InlineData(SubdivisionScheme.Loop, "3 steps would make 642 vertices, 1920 edges and 1280 faces; the budget is 1000 faces.")]
    [InlineData(SubdivisionScheme.Sqrt3, null)]
    public void Subdivide_BeyondTheBudget_IsRefusedWithTheCounts(SubdivisionScheme scheme, string? message)
    {
        var options = new SubdivisionOptions { Steps = 3, FaceBudget = 1000 };
        if (message is null)
        {
            Assert.Equal(540, Polyhedra.Icosahedron().Subdivide(scheme, options).Faces.Count);
            return;
        }
        Assert.Contains(message, Assert.Throws<ArgumentException>(() => Polyhedra.Icosahedron().Subdivide(scheme, options)).Message, StringComparison.Ordinal);
        string first = Assert.Throws<ArgumentException>(() => Polyhedra.Icosahedron().Subdivide(scheme, options with { Steps = 9 })).Message;
        Assert.StartsWith("3 of 9 steps would make 642 vertices", first, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => Polyhedra.Icosahedron().Subdivide(scheme, new SubdivisionOptions { Steps = 1000, FaceBudget = long.MaxValue }));
    }

    [Theory]
    [MemberData(nameof(Schemes))]
    public void Budget_KnowsTheCounts(SubdivisionScheme scheme)
    {
        Mesh mesh = Models.Create("holes");
        for (int steps = 1; steps <= 3; steps++)
        {
            Mesh finer = mesh.Subdivide(scheme, new SubdivisionOptions { Steps = steps });
            var options = new SubdivisionOptions { Steps = steps, FaceBudget = finer.Faces.Count - 1 };
            string message = Assert.Throws<ArgumentException>(() => mesh.Subdivide(scheme, options)).Message;
            Assert.Contains($"{finer.Vertices.Count} vertices, {finer.Edges.Count} edges and {finer.Faces.Count} faces", message, StringComparison.Ordinal);
            Assert.Equal(finer.Faces.Count, mesh.Subdivide(scheme, options with { FaceBudget = finer.Faces.Count }).Faces.Count);
        }
    }

    /// <summary>Deleting faces leaves holes whose half-edges have even numbers too; builders make odd ones.</summary>
    [Theory]
    [MemberData(nameof(Schemes))]
    public void Subdivide_AfterDeletions_IsValid(SubdivisionScheme scheme)
    {
        Mesh mesh = Models.Create("torus");
        foreach (int f in new[] { 0, 20, 21, 47, 90 })
            mesh.Faces[f].Delete();
        Assert.Equal([0, 1], mesh.HalfEdges.Where(h => h.IsBoundary).Select(h => h.Index & 1).Distinct().Order());
        ulong before = mesh.StateHash();
        int loops = Measure.BoundaryLoops(mesh);

        Mesh finer = mesh.Subdivide(scheme, new() { Steps = 2 });

        Assert.Empty(finer.Validate());
        Assert.Equal(loops, Measure.BoundaryLoops(finer));
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void BadArguments_Throw()
    {
        Mesh quads = Polyhedra.Cube();
        foreach (SubdivisionScheme scheme in new[] { SubdivisionScheme.Loop, SubdivisionScheme.ModifiedButterfly, SubdivisionScheme.Sqrt3, SubdivisionScheme.Midpoint })
        {
            Assert.Contains("f0", Assert.Throws<ArgumentException>(() => quads.Subdivide(scheme)).Message, StringComparison.Ordinal);
            Assert.Throws<ArgumentNullException>(() => ((Mesh)null!).Subdivide(scheme));
        }
        Assert.Throws<ArgumentOutOfRangeException>(() => new SubdivisionOptions { Steps = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new SubdivisionOptions { FaceBudget = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => quads.Subdivide((SubdivisionScheme)99));
        Assert.Throws<ArgumentOutOfRangeException>(() => LoopSubdivision.NeighborWeight(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => ButterflySubdivision.ExtraordinaryWeights(2));
        Assert.Equal(quads.StateHash(), quads.Subdivide(SubdivisionScheme.CatmullClark, new SubdivisionOptions { Steps = 0 }).StateHash());
    }

    [Fact]
    public void Subdivide_Cancelled_Throws()
    {
        foreach (SubdivisionScheme scheme in Enum.GetValues<SubdivisionScheme>())
            Assert.ThrowsAny<OperationCanceledException>(() => Cones.Cone().Subdivide(scheme, cancellationToken: new CancellationToken(canceled: true)));
    }

    [Fact]
    public void Subdivide_Progress_RisesToOne()
    {
        var told = new List<double>();
        Cones.Cone().Subdivide(SubdivisionScheme.Loop, new SubdivisionOptions { Steps = 3 }, new Teller(told.Add));
        Assert.Equal(told.Order(), told);
        Assert.Equal(1, told[^1]);
    }

    [Theory]
    [MemberData(nameof(Schemes))]
    public void Subdivide_Report_SaysWhatWasDoneAndWhyItEnded(SubdivisionScheme scheme)
    {
        Mesh mesh = Models.Create("torus");
        Mesh finer = mesh.Subdivide(scheme, new() { Steps = 2 }, out SubdivisionReport report);
        Assert.Equal(new(SubdivisionStop.StepsDone, 2, mesh.Faces.Count, finer.Faces.Count), report);
        Assert.Equal(mesh.Subdivide(scheme, new() { Steps = 2 }).StateHash(), finer.StateHash());
        mesh.Subdivide(scheme, null, out report);
        Assert.Equal(1, report.Steps);
        mesh.Subdivide(scheme, new() { Steps = 0 }, out report);
        Assert.Equal(new(SubdivisionStop.NothingToDo, 0, mesh.Faces.Count, mesh.Faces.Count), report);
        new Mesh().Subdivide(scheme, null, out report);
        Assert.Equal(new(SubdivisionStop.NothingToDo, 0, 0, 0), report);
    }

    [Fact]
    public void Subdivide_WithOneThread_HasTheSameBits()
    {
        Mesh mesh = Spheres.Icosphere(5);
        int threads = Parallelism.MaxThreads;
        foreach (SubdivisionScheme scheme in Enum.GetValues<SubdivisionScheme>())
        {
            ulong several = mesh.Subdivide(scheme).StateHash();
            try
            {
                Parallelism.MaxThreads = 1;
                Assert.Equal(several, mesh.Subdivide(scheme).StateHash());
            }
            finally
            {
                Parallelism.MaxThreads = threads == Environment.ProcessorCount ? 0 : threads;
            }
        }
    }

    private static TheoryData<SubdivisionScheme, string> Cases(TheoryData<string> models, params SubdivisionScheme[] schemes)
    {
        var cases = new TheoryData<SubdivisionScheme, string>();
        foreach (SubdivisionScheme scheme in schemes)
        {
            foreach (string model in models)
                cases.Add(scheme, model);
        }
        return cases;
    }

    private sealed class Teller(Action<double> tell) : IProgress<double>
    {
        public void Report(double value) => tell(value);
    }
}

/// <summary>Equality with values that independent programs computed.</summary>
[Trait("Section", "8")]
public class SubdivisionReferenceTests
{
    [SkippableTheory]
    [MemberData(nameof(ReferenceData.ModelsWithArraysCases), MemberType = typeof(ReferenceData))]
    public void Subdivide_Once_HasTheReferencePositions(string name)
    {
        JsonElement arrays = ReferenceData.Arrays(name, "subdiv").RootElement;
        Mesh mesh = ReferenceData.Load(name);
        int[] edgeOrder = LexicographicEdges(mesh);

        AssertEqual(arrays, "loop1_loop1987", mesh, LoopSubdivision.Subdivide(mesh), edgeOrder);
        AssertEqual(arrays, "loop1_warren", mesh, LoopSubdivision.Subdivide(mesh, new SubdivisionOptions { Weights = LoopWeights.Warren }), edgeOrder);
        if (mesh.IsClosed)
        {
            AssertEqual(arrays, "butterfly1", mesh, ButterflySubdivision.Subdivide(mesh), edgeOrder);
            AssertEqual(arrays, "sqrt3_1", mesh, Sqrt3Subdivision.Subdivide(mesh), [.. Enumerable.Range(0, mesh.FaceSlots)]);
        }
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Subdivide_TwoLevels_HasTheReferenceSums(string name)
    {
        JsonElement json = ReferenceData.Json(name, "subdiv").RootElement;
        Mesh mesh = ReferenceData.Load(name);
        foreach ((string scheme, string own, Func<SubdivisionOptions, Mesh> subdivide) in new (string, string, Func<SubdivisionOptions, Mesh>)[]
        {
            ("loop", "own_loop1987", options => LoopSubdivision.Subdivide(mesh, options)),
            ("loop", "own_warren", options => LoopSubdivision.Subdivide(mesh, options with { Weights = LoopWeights.Warren })),
            ("butterfly", "own_modified_butterfly", options => ButterflySubdivision.Subdivide(mesh, options)),
            ("sqrt3", "own", options => Sqrt3Subdivision.Subdivide(mesh, options)),
        })
        {
            if (!json.TryGetProperty(scheme, out JsonElement levels))
                continue;
            for (int steps = 1; steps <= 2; steps++)
            {
                // Two steps of the largest models would take most of the suite's time.
                if (steps == 2 && mesh.Faces.Count > 30_000)
                    continue;
                if (levels.TryGetProperty($"level{steps}", out JsonElement level) && level.TryGetProperty(own, out JsonElement expected))
                    AssertSums(expected, subdivide(new SubdivisionOptions { Steps = steps }));
            }
        }
    }

    private static void AssertSums(JsonElement expected, Mesh finer)
    {
        Assert.Equal(expected.GetProperty("V").GetInt32(), finer.Vertices.Count);
        Assert.Equal(expected.GetProperty("E").GetInt32(), finer.Edges.Count);
        Assert.Equal(expected.GetProperty("F").GetInt32(), finer.Faces.Count);
        Assert.Equal(1, Measure.Area(finer) / expected.GetProperty("area").GetDouble(), 1e-11);
        BoundingBox box = finer.BoundingBox;
        double[] minimum = ReferenceData.Numbers(expected.GetProperty("bbox_min")), maximum = ReferenceData.Numbers(expected.GetProperty("bbox_max"));
        double[] sum = ReferenceData.Numbers(expected.GetProperty("sum"));
        Vector3D own = default;
        foreach (Vector3D p in finer.Positions)
            own += p;
        for (int axis = 0; axis < 3; axis++)
        {
            Assert.Equal(minimum[axis], box.Min[axis], 1e-12 * box.Diagonal);
            Assert.Equal(maximum[axis], box.Max[axis], 1e-12 * box.Diagonal);
            Assert.Equal(sum[axis], own[axis], 1e-11 * finer.Vertices.Count * box.Diagonal);
        }
    }

    /// <summary>Our vertex V + newOrder[i] is the reference's V + i.</summary>
    private static void AssertEqual(JsonElement arrays, string key, Mesh mesh, Mesh finer, int[] newOrder)
    {
        if (!arrays.TryGetProperty(key, out JsonElement array))
            return;
        double[] expected = ReferenceData.Numbers(array);
        Assert.Equal(expected.Length, 3 * finer.VertexSlots);
        double tolerance = 1e-12 * mesh.BoundingBox.Diagonal;
        for (int i = 0; i < finer.VertexSlots; i++)
        {
            int v = i < mesh.VertexSlots ? i : mesh.VertexSlots + newOrder[i - mesh.VertexSlots];
            Vector3D reference = new(expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]);
            Assert.True(Vector3D.Distance(reference, finer.Positions[v]) <= tolerance, $"{key} v{v}: {finer.Positions[v]} instead of {reference}");
        }
    }

    private static int[] LexicographicEdges(Mesh mesh) =>
        [.. mesh.Edges.OrderBy(e => Math.Min(e.Vertex0.Index, e.Vertex1.Index)).ThenBy(e => Math.Max(e.Vertex0.Index, e.Vertex1.Index)).Select(e => e.Index)];
}
