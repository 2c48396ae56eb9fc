using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Tests.Spatial;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.4")]
public class MeshDistanceTests
{
    private static Mesh MeshOf(TriangleSoups.Soup soup) => MeshBuilder.FromTriangles(soup.Positions, soup.Corners);

    [Fact]
    public void Measure_ParallelSquares_IsTheirDistanceEverywhere()
    {
        TriangleSoups.Soup grid = TriangleSoups.Grid(6);
        MeshDistanceReport report = MeshDistance.Measure(MeshOf(grid), MeshOf(grid.Moved(1, new(0, 0, 0.25))));

        Assert.Equal(new DistanceStatistics(0.25, 0.25, 0.25), report.Forward);
        Assert.Equal(report.Forward, report.Backward);
        Assert.Equal(0.25, report.Hausdorff);
        Assert.Equal(6 * Math.Sqrt(2), report.Diagonal, 1e-14);
    }

    [Fact]
    public void Measure_SquareShiftedInItsPlane_FollowsTheOverhang()
    {
        // A strip of width s sticks out on one side: d falls linearly from s to 0 over it, and is 0 elsewhere.
        const double s = 1.5, size = 6;
        TriangleSoups.Soup grid = TriangleSoups.Grid(6);
        MeshDistanceReport report = MeshOf(grid).DistanceTo(MeshOf(grid.Moved(1, new(s, 0, 0))), new() { Samples = 200_000 });
        foreach (DistanceStatistics way in new[] { report.Forward, report.Backward })
        {
            Assert.Equal(s, way.Max, 1e-12);
            Assert.Equal(s * s / 2 / size, way.Mean, 1e-3);
            Assert.Equal(Math.Sqrt(s * s * s / 3 / size), way.Rms, 1e-3);
        }
    }

    [Fact]
    public void Report_OfBothWays_TakesTheLarger()
    {
        var one = new DistanceStatistics(1, 3, 8);
        var two = new DistanceStatistics(2, 4, 6);
        foreach (MeshDistanceReport report in new[] { new MeshDistanceReport(one, two, 10), new MeshDistanceReport(two, one, 10) })
        {
            Assert.Equal((2, 4, 8), (report.Mean, report.Rms, report.Hausdorff));
            Assert.Equal(Math.Sqrt(12.5), report.SymmetricRms, 1e-15);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Measure_ConcentricSpheres_IsTheDifferenceOfTheirRadii(bool deterministic)
    {
        Mesh inner = MeshOf(TriangleSoups.Sphere(80)), outer = MeshOf(TriangleSoups.Sphere(80).Moved(1.5, default));
        MeshDistanceReport report = MeshDistance.Measure(inner, outer, new() { Samples = 20_000, Deterministic = deterministic });
        // Faces lie inside the spheres by at most 1 − cos(π/80) of the radius.
        foreach (DistanceStatistics way in new[] { report.Forward, report.Backward })
        {
            Assert.Equal(0.5, way.Mean, 2e-3);
            Assert.Equal(0.5, way.Rms, 2e-3);
            Assert.Equal(0.5, way.Max, 2e-3);
        }
        Assert.Equal(2 * Math.Sqrt(3), report.Diagonal, 1e-2);
    }

    [Fact]
    public void Measure_Deterministic_TakesBarycentresForTheMeanAndCornersForTheLargest()
    {
        // A triangle with the barycentre (1, 1, 0), and a large one in the plane x = 0.
        Mesh triangle = MeshBuilder.FromTriangles([new(0, 0, 0), new(3, 0, 0), new(0, 3, 0)], [0, 1, 2]);
        Mesh wall = MeshBuilder.FromTriangles([new(0, -100, -100), new(0, 100, -100), new(0, 0, 100)], [0, 1, 2]);

        DistanceStatistics forward = triangle.DistanceTo(wall, new() { Deterministic = true }).Forward;

        Assert.Equal(1, forward.Mean, 1e-12);
        Assert.Equal(1, forward.Rms, 1e-12);
        Assert.Equal(3, forward.Max, 1e-12);
    }

    /// <summary>Three parts of the area lie at distance 1, one at 2.</summary>
    [Theory]
    [InlineData(true, 1e-12)]
    [InlineData(false, 1e-3)]
    public void Measure_FacesOfDifferentSize_CountByTheirArea(bool deterministic, double tolerance)
    {
        Mesh steps = MeshBuilder.FromTriangles(
            [new(0, 0, 1), new(6, 0, 1), new(0, 1, 1), new(0, 0, 2), new(2, 0, 2), new(0, 1, 2)], [0, 1, 2, 3, 4, 5]);
        Mesh floor = MeshBuilder.FromTriangles([new(-100, -100, 0), new(100, -100, 0), new(0, 100, 0)], [0, 1, 2]);

        DistanceStatistics forward = steps.DistanceTo(floor, new() { Deterministic = deterministic }).Forward;

        Assert.Equal(1.25, forward.Mean, tolerance);
        Assert.Equal(Math.Sqrt(7 / 4.0), forward.Rms, tolerance);
        Assert.Equal(2, forward.Max, 1e-12);
    }

    /// <summary>The other mesh begins at the three corners: the middles of the longer sides are farthest from it.</summary>
    [Fact]
    public void Measure_Deterministic_LooksAtTheMiddlesOfEdges()
    {
        Mesh triangle = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(2, 1, 0)], [0, 1, 2]);
        Mesh corners = MeshBuilder.FromTriangles(
            [new(0, 0, 0), new(-1, 0, 0), new(-1, 1, 0), new(4, 0, 0), new(5, 0, 0), new(5, 1, 0), new(2, 1, 0), new(2, 2, 0), new(1.75, 2, 0)],
            [0, 1, 2, 3, 4, 5, 6, 7, 8]);

        Assert.Equal(Math.Sqrt(1.25), triangle.DistanceTo(corners, new() { Deterministic = true }).Forward.Max, 1e-12);
    }

    /// <summary>Without an area to spread points on there are the corners, and in the deterministic way the middles.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Measure_NeedlesOnly_IsTheMeanOverTheirPoints(bool deterministic)
    {
        // At heights 0, 1, 3; middles at ½, 2, 1½; the barycentre at 4/3.
        Mesh needle = MeshBuilder.FromTriangles([new(0, 0, 0), new(0, 0, 1), new(0, 0, 3)], [0, 1, 2]);
        Mesh floor = MeshBuilder.FromTriangles([new(-100, -100, 0), new(100, -100, 0), new(0, 100, 0)], [0, 1, 2]);
        double mean = deterministic ? (0 + 1 + 3 + 0.5 + 2 + 1.5 + 4 / 3.0) / 7 : (0 + 1 + 3) / 3.0;

        Assert.Equal(mean, needle.DistanceTo(floor, new() { Deterministic = deterministic }).Forward.Mean, 1e-12);
    }

    [Fact]
    public void VertexDistancesTo_DeletedVertex_IsNotANumber()
    {
        Mesh mesh = Shapes.Sheet(2);
        mesh.Faces[0].HalfEdge.Collapse();
        Assert.False(mesh.IsCompact);

        double[] distances = mesh.VertexDistancesTo(Shapes.Sheet(2));

        for (int v = 0; v < distances.Length; v++)
            Assert.Equal(mesh.IsDeletedVertex(v), double.IsNaN(distances[v]));
    }

    [Fact]
    public void Measure_OneSidedDifference_DependsOnTheDirection()
    {
        // A far away part counts from the mesh that has it only.
        TriangleSoups.Soup grid = TriangleSoups.Grid(6), far = grid.Moved(1, new(0, 0, 10));
        Mesh one = MeshOf(grid), two = MeshOf(grid);
        two.Append(MeshOf(far));
        MeshDistanceReport report = MeshDistance.Measure(one, two);
        Assert.Equal(0, report.Forward.Max, 1e-14);
        Assert.Equal(10, report.Backward.Max);
        Assert.Equal(5, report.Backward.Mean, 1e-3);
        Assert.Equal(Math.Sqrt(50), report.Backward.Rms, 1e-3);
        Assert.Equal(10, report.Hausdorff);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Measure_AgainstItself_IsZero(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Faces.Count == 0)
            return;
        MeshDistanceReport report = MeshDistance.Measure(mesh, mesh, new() { Samples = 500 });
        // Slivers of width 1e-5 lose five digits.
        Assert.InRange(report.Hausdorff, 0, (name is "slivers" or "fan-1200" ? 1e-10 : 1e-15) * (report.Diagonal + mesh.BoundingBox.Including(default(Vector3D)).Diagonal * 10));
        double[] distances = mesh.VertexDistancesTo(mesh);
        Assert.All(mesh.Vertices.Where(v => !v.IsIsolated), v => Assert.Equal(0, distances[v.Index]));
    }

    [Fact]
    public void Measure_SeedAndThreads_DecideTheBits()
    {
        Mesh one = MeshOf(TriangleSoups.Sphere(30)), two = MeshOf(TriangleSoups.Sphere(9));
        MeshDistanceOptions options = new() { Samples = 5000, Seed = 3 };
        MeshDistanceReport expected = MeshDistance.Measure(one, two, options);
        try
        {
            Parallelism.MaxThreads = 1;
            Assert.Equal(expected, MeshDistance.Measure(one, two, options));
            Assert.NotEqual(expected, MeshDistance.Measure(one, two, options with { Seed = 4 }));
        }
        finally
        {
            Parallelism.MaxThreads = 0;
        }
    }

    [Fact]
    public void VertexDistancesTo_DeletedAndIsolatedVertices_KeepTheirSlots()
    {
        Mesh mesh = Models.Create("isolated-vertices");
        double[] distances = mesh.VertexDistancesTo(MeshOf(TriangleSoups.Grid(2).Moved(100, new(-100, -100, -7))));
        Assert.Equal(mesh.VertexSlots, distances.Length);
        for (int v = 0; v < distances.Length; v++)
            Assert.Equal(mesh.Positions[v].Z + 7, distances[v], 1e-12);
    }

    [Fact]
    public void Measure_Progress_RisesToOneAndCancelsOnTheWay()
    {
        Mesh one = MeshOf(TriangleSoups.Sphere(30)), two = MeshOf(TriangleSoups.Sphere(9));
        MeshDistanceOptions options = new() { Samples = 100_000 };
        var told = new List<double>();

        MeshDistance.Measure(one, two, options, new ProgressTeller(told.Add));
        Assert.True(told.Count > 4);
        Assert.Equal(told.Order(), told);
        Assert.Equal(1, told[^1]);
        two.VertexDistancesTo(one, new ProgressTeller(told.Add));
        Assert.Equal(1, told[^1]);

        using var source = new CancellationTokenSource();
        told.Clear();
        Assert.Throws<OperationCanceledException>(() => MeshDistance.Measure(one, two, options, new ProgressTeller(value =>
        {
            told.Add(value);
            source.Cancel();
        }), source.Token));
        Assert.Single(told);
        Assert.Throws<OperationCanceledException>(() => one.VertexDistancesTo(two, null, new CancellationToken(true)));
    }

    [Fact]
    public void Measure_BadInput_NamesTheArgument()
    {
        Mesh mesh = Models.Create("tetrahedron"), empty = new();
        Assert.Throws<ArgumentException>("first", () => MeshDistance.Measure(empty, mesh));
        Assert.Throws<ArgumentException>("other", () => MeshDistance.Measure(mesh, empty));
        Assert.Throws<ArgumentException>("other", () => mesh.VertexDistancesTo(empty));
        Assert.Throws<ArgumentOutOfRangeException>(() => new MeshDistanceOptions { Samples = 0 });
        Assert.Throws<OperationCanceledException>(() => MeshDistance.Measure(mesh, mesh, null, null, new CancellationToken(true)));
    }
}
