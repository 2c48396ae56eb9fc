using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.HoleFilling;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.HoleFilling;

[Trait("Section", "6.1")]
public class HoleFillerTests
{
    private static readonly HoleFillingOptions[] Settings =
    [
        new() { Method = HoleFillingMethod.Fan },
        new() { Method = HoleFillingMethod.Centroid },
        new() { Method = HoleFillingMethod.Ear },
        new() { Method = HoleFillingMethod.MinimumWeight },
        new() { Refine = true },
        new() { Refine = true, Fair = true },
        new(),
        new() { Refine = true, Fair = true, Continuity = 0 },
        new() { Refine = true, Fair = true, Continuity = 2 },
        new() { Method = HoleFillingMethod.MinimumWeight, Weight = HoleWeight.Area },
        new() { Weight = HoleWeight.BendThenArea, Refine = true },
        new() { Method = HoleFillingMethod.Ear, Refine = true },
        new() { Method = HoleFillingMethod.Centroid, Refine = true, Fair = true },
    ];

    public static TheoryData<string, int> ModelsAndSettings()
    {
        var data = new TheoryData<string, int>();
        foreach (string name in Models.Names.Where(n => Models.Create(n) is { IsClosed: false }))
        {
            // The cubic method on 1200 edges has a test of its own.
            for (int i = 0; i < (name == "fan-1200" ? 3 : Settings.Length); i++)
                data.Add(name, i);
        }
        return data;
    }

    [Theory]
    [MemberData(nameof(ModelsAndSettings))]
    public void FillHoles_ModelsWithBoundary_ClosesOrSaysWhy(string name, int setting)
    {
        Mesh mesh = Models.Create(name);
        int loops = mesh.ComputeTopology().BoundaryLoops, euler = mesh.EulerCharacteristic, faces = mesh.Faces.Count;
        HoleFillingResult result = mesh.FillHoles(Settings[setting]);
        Assert.Empty(mesh.Validate());
        Assert.Equal(loops, result.Loops.Count);
        Assert.Equal(loops - result.Filled, mesh.ComputeTopology().BoundaryLoops);
        Assert.Equal(euler + result.Filled, mesh.EulerCharacteristic);
        Assert.Equal(faces + result.FacesAdded, mesh.Faces.Count);
        Assert.All(result.Loops, loop => Assert.Equal(loop.Filled, loop.Reason == HoleRefusal.None));
        if (Settings[setting].Method is HoleFillingMethod.Centroid or HoleFillingMethod.MinimumWeight or HoleFillingMethod.Automatic)
            Assert.True(mesh.IsClosed);
    }

    [Fact]
    public void FillHoles_BoxWithoutLid_GetsASquareOfTwoTriangles()
    {
        foreach (HoleFillingMethod method in (HoleFillingMethod[])[HoleFillingMethod.Fan, HoleFillingMethod.Ear, HoleFillingMethod.MinimumWeight])
        {
            Mesh box = Models.Create("cube");
            box.Detach(box.Faces.Where(f => f.Barycenter.Z > 0.99));
            HoleReport report = box.FillHoles(new HoleFillingOptions { Method = method }).Loops.Single();
            Assert.Equal((4, true, 2, 0), (report.Edges, report.Filled, report.FacesAdded, report.VerticesAdded));
            Assert.Equal(1, box.Volume, 1e-14);
            Assert.Equal(6, box.Area, 1e-14);
            Assert.Empty(box.Validate());
        }
    }

    [Theory]
    [InlineData(HoleFillingMethod.Ear)]
    [InlineData(HoleFillingMethod.MinimumWeight)]
    public void FillHoles_PlanarNotConvexLoop_HasNoFold(HoleFillingMethod method)
    {
        // A star-shaped hole in a flat grid: the filled grid has its old area only if nothing folds over.
        Mesh grid = MeshLab.Geometry.Triangulation.Triangulate(Models.QuadGrid(30, 30)).Mesh;
        grid.Detach(grid.Faces.Where(f => InStar(f.Barycenter)));
        int outer = grid.ComputeTopology().BoundaryLoops;
        Assert.Equal(2, outer);
        HalfEdge inner = grid.HalfEdges.First(h => h.IsBoundary && h.Source.Position.X is > 0.01 and < 0.99 && h.Source.Position.Y is > 0.01 and < 0.99);
        HoleReport report = grid.FillHole(inner, new HoleFillingOptions { Method = method });
        Assert.True(report.Filled);
        Assert.Equal(1, grid.Area, 1e-12);
        Assert.All(grid.Faces, f => Assert.True(f.Triangle.DoubleAreaVector.Z >= -1e-15));
        Assert.Empty(grid.Validate());

        static bool InStar(Vector3D p)
        {
            double x = p.X - 0.5, y = p.Y - 0.5, r = Math.Sqrt(x * x + y * y), angle = Math.Atan2(y, x);
            return r < 0.3 + 0.1 * Math.Cos(4 * angle);
        }
    }

    [Fact]
    public void FillHoles_SphereWithRefineAndFair_ComesNearTheSphere()
    {
        Mesh sphere = Models.Sphere(24, 40);
        sphere.Detach(sphere.Faces.Where(f => f.Barycenter.X > 0.8));
        sphere.Compact();
        Mesh flat = sphere.Clone();
        flat.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.MinimumWeight });
        int old = sphere.VertexSlots;
        HoleFillingResult result = sphere.FillHoles(new HoleFillingOptions { Refine = true, Fair = true });
        Assert.True(result.Loops[0].VerticesAdded > 20);
        Assert.Empty(sphere.Validate());
        double[] error = [.. Enumerable.Range(old, sphere.VertexSlots - old).Select(v => Math.Abs(sphere.Positions[v].Length - 1))];
        Assert.True(error.Max() < 0.03, $"{error.Max()}");
        Assert.True(Math.Abs(sphere.Volume - 4 * Math.PI / 3) < Math.Abs(flat.Volume - 4 * Math.PI / 3));
        // As dense as around the hole.
        double around = 4 * Math.PI / (2 * 24 * 40), patch = sphere.Faces.Where(f => f.Index >= sphere.Faces.Count - result.FacesAdded).Average(f => f.Area);
        Assert.InRange(patch / around, 0.3, 3);
    }

    [Fact]
    public void FillHoles_LimitsAndBudget_AreReported()
    {
        Mesh mesh = Models.Create("holes");
        ulong before = mesh.StateHash();
        HoleFillingResult limited = mesh.Clone().FillHoles(new HoleFillingOptions { MaxEdges = 3 });
        Assert.All(limited.Loops, loop => Assert.Equal(loop.Edges > 3 ? HoleRefusal.TooManyEdges : HoleRefusal.None, loop.Reason));
        Assert.Contains(limited.Loops, loop => !loop.Filled);
        HoleFillingResult budget = mesh.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.Centroid, MaxNewVertices = 0 });
        Assert.All(budget.Loops, loop => Assert.Equal(HoleRefusal.VertexBudget, loop.Reason));
        Assert.Equal(before, mesh.StateHash());
        HoleFillingResult some = mesh.FillHoles(new HoleFillingOptions { Refine = true, MaxNewVertices = 2 });
        Assert.True(some.Loops.Sum(loop => loop.VerticesAdded) <= 2);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void FillHole_KnotAndLoopThatTouchesItself_StaysAManifold()
    {
        foreach (HoleFillingOptions options in Settings)
        {
            foreach (bool knot in (bool[])[true, false])
            {
                Mesh band = Band(120, t => knot
                    ? new(Math.Sin(t) + 2 * Math.Sin(2 * t), Math.Cos(t) - 2 * Math.Cos(2 * t), -Math.Sin(3 * t))
                    : new(Math.Sin(t), Math.Sin(t) * Math.Cos(t), 0));
                HoleFillingResult result = band.FillHoles(options);
                Assert.Equal(2, result.Loops.Count);
                Assert.Empty(band.Validate());
                Assert.Equal(2 - result.Filled, band.ComputeTopology().BoundaryLoops);
            }
        }
    }

    [Fact]
    public void FillHole_LoopOfThousandEdges_IsFilledByMinimumWeight()
    {
        Mesh band = Band(1000, t => new(Math.Cos(t), Math.Sin(t), 0.3 * Math.Sin(5 * t)));
        HoleReport report = band.FillHole(band.HalfEdges.First(h => h.IsBoundary), new HoleFillingOptions { Method = HoleFillingMethod.MinimumWeight });
        Assert.Equal((1000, true, HoleFillingMethod.MinimumWeight, 998), (report.Edges, report.Filled, report.Method, report.FacesAdded));
        Assert.Empty(band.Validate());
    }

    [Fact]
    public void FillHole_ChordsTaken_UsesANewVertex()
    {
        // All chords of a square are edges of a tetrahedron-like ring behind it: only a new vertex can fill it.
        Mesh mesh = MeshBuilder.FromPolygons(
            [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)], [0, 1, 2], [0, 2, 3]);
        HoleReport report = mesh.FillHoles().Loops.Single();
        Assert.True(report.Filled);
        Assert.Empty(mesh.Validate());
        Assert.True(mesh.IsClosed);
    }

    [Fact]
    public void FillHole_EveryChordTaken_NeedsANewVertexOrIsRefused()
    {
        // The torus of seven vertices, each joined to all others, without the seventh: every chord of its loop is an edge.
        int[][] faces = [.. Enumerable.Range(0, 7).SelectMany(i => (int[][])[[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).Where(f => !f.Contains(6))];
        var random = new Random(1);
        Vector3D[] positions = [.. Enumerable.Range(0, 6).Select(_ => new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble()))];
        foreach (HoleFillingMethod method in Enum.GetValues<HoleFillingMethod>())
        {
            Mesh mesh = MeshBuilder.FromPolygons(positions, faces);
            ulong before = mesh.StateHash();
            bool canAdd = method is not (HoleFillingMethod.Fan or HoleFillingMethod.Ear);
            HoleReport none = mesh.FillHoles(new HoleFillingOptions { Method = method, MaxNewVertices = 0 }).Loops.Single();
            Assert.Equal((6, false, canAdd ? HoleRefusal.VertexBudget : HoleRefusal.NoTriangulation), (none.Edges, none.Filled, none.Reason));
            Assert.Equal(before, mesh.StateHash());
            HoleReport report = mesh.FillHoles(new HoleFillingOptions { Method = method }).Loops.Single();
            Assert.Equal((canAdd, canAdd ? 6 : 0, canAdd ? 1 : 0), (report.Filled, report.FacesAdded, report.VerticesAdded));
            if (canAdd)
                Assert.Equal((HoleFillingMethod.Centroid, 0), (report.Method, mesh.EulerCharacteristic));
            Assert.Empty(mesh.Validate());
        }
    }

    [Theory]
    [InlineData(HoleFillingMethod.Fan)]
    [InlineData(HoleFillingMethod.Ear)]
    [InlineData(HoleFillingMethod.MinimumWeight)]
    public void FillHole_OneChordTaken_UsesTheOther(HoleFillingMethod method)
    {
        Mesh mesh = MeshBuilder.FromPolygons([new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)], [0, 1, 2], [0, 2, 3]);
        Assert.Equal((true, 2), (mesh.FillHoles(new HoleFillingOptions { Method = method }).Loops.Single().Filled, mesh.Faces.Count - 2));
        Assert.False(mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[3]).IsNone);
        Assert.True(mesh.IsClosed);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void FillHoles_SeveralLoops_GoesByTheLowestVertexAndSharesTheBudget()
    {
        Mesh mesh = MeshBuilder.FromPolygons(
            [new(0, 0, 0), new(3, 0, 0), new(0, 3, 0), new(10, 0, 0), new(13, 0, 0), new(10, 3, 0)], [5, 3, 4], [2, 0, 1]);
        IReadOnlyList<HoleReport> loops = mesh.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.Centroid, MaxNewVertices = 1 }).Loops;
        Assert.Equal([(0, true, HoleRefusal.None), (3, false, HoleRefusal.VertexBudget)], loops.Select(loop => (loop.FirstVertex, loop.Filled, loop.Reason)));
        // The new vertex is the mean of its loop, wherever that lies.
        mesh.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.Centroid });
        Assert.Equal([new(1, 1, 0), new(11, 1, 0)], mesh.Positions[6..].ToArray());
        Assert.Empty(mesh.Validate());
        // The vertex of the fan counts too.
        Mesh grid = Models.Triangulated(Models.QuadGrid(8, 8));
        Assert.Equal(3, grid.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.Centroid, Refine = true, MaxNewVertices = 3 }).Loops.Single().VerticesAdded);
        Assert.Empty(grid.Validate());
    }

    [Fact]
    public void FillHoles_Report_SaysWhatWasDone()
    {
        Mesh sphere = Models.Sphere(24, 40);
        sphere.Detach(sphere.Faces.Where(f => f.Barycenter.X > 0.8));
        HoleReport Of(HoleFillingOptions options) => sphere.Clone().FillHoles(options).Loops.Single();
        HoleReport refined = Of(new() { Refine = true }), faired = Of(new() { Refine = true, Fair = true }), byDefault = Of(new());
        Assert.Equal((null, 1), (refined.Continuity, faired.Continuity));
        Assert.True(byDefault.Continuity is 1 or 2 && byDefault.VerticesAdded > 0);
        // Without vertices of its own there is nothing in a patch to move.
        Assert.Null(Of(new() { Fair = true }).Continuity);
        Assert.Equal(HoleFillingMethod.Ear, Of(new() { MaxEdgesForMinimumWeight = refined.Edges - 1 }).Method);
        Assert.Equal(HoleFillingMethod.MinimumWeight, Of(new() { MaxEdgesForMinimumWeight = refined.Edges }).Method);
    }

    [Fact]
    public void FillHole_LeastArea_TakesTheShorterSurface()
    {
        // A bent square: 1.366 along one diagonal, 1.414 along the other.
        Mesh box = Models.Create("cube");
        box.Detach(box.Faces.Where(f => f.Barycenter.Z > 0.99));
        Vertex At(double x, double y) => box.Vertices.Single(v => v.Position.X == x && v.Position.Y == y && v.Position.Z > 0.5);
        At(1, 1).Position = new(1, 1, 2);
        double before = box.Area;
        box.FillHoles(new HoleFillingOptions { Method = HoleFillingMethod.MinimumWeight, Weight = HoleWeight.Area });
        Assert.Equal(0.5 + (Math.Sqrt(3) / 2), box.Area - before, 1e-12);
        Assert.False(box.FindEdge(At(1, 0), At(0, 1)).IsNone);
        Assert.Empty(box.Validate());
    }

    [Fact]
    public void FillHole_Undo_RestoresEveryBit()
    {
        Mesh mesh = Models.Create("holes");
        ulong before = mesh.StateHash();
        using (OperationHistory history = mesh.StartRecording())
        {
            mesh.FillHoles(new HoleFillingOptions { Refine = true, Fair = true });
            history.UndoAll();
        }
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void FillHole_BadInput_IsNamed()
    {
        Mesh cube = Models.Create("cube");
        Assert.Contains("h0", Assert.Throws<ArgumentException>(() => cube.FillHole(cube.HalfEdges[0])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => cube.FillHole(Models.Create("grid").HalfEdges.First(h => h.IsBoundary)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new HoleFillingOptions { MaxEdges = 2 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new HoleFillingOptions { Continuity = 3 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new HoleFillingOptions { Weight = (HoleWeight)9 });
        HalfEdge gone = default;
        Assert.Throws<ArgumentException>(() => cube.FillHole(gone));
        Mesh open = Models.Create("grid");
        HalfEdge deleted = open.HalfEdges.First(h => h.IsBoundary);
        open.Detach(open.Faces);
        Assert.Throws<ArgumentException>(() => open.FillHole(deleted));
        Assert.Empty(cube.FillHoles().Loops);
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();
        Mesh grid = Models.Create("grid");
        ulong before = grid.StateHash();
        Assert.Throws<OperationCanceledException>(() => grid.FillHoles(cancellationToken: cancelled.Token));
        Assert.Equal(before, grid.StateHash());
    }

    /// <summary>A band of triangles beside a closed curve; its two rims are long loops.</summary>
    private static Mesh Band(int n, Func<double, Vector3D> curve)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < n; i++)
            builder.AddVertex(curve(2 * Math.PI * i / n));
        for (int i = 0; i < n; i++)
            builder.AddVertex(curve(2 * Math.PI * i / n) + new Vector3D(0, 0, 0.1));
        for (int i = 0; i < n; i++)
        {
            int j = (i + 1) % n;
            builder.AddFace(i, j, n + j);
            builder.AddFace(i, n + j, n + i);
        }
        return builder.Build();
    }
}
