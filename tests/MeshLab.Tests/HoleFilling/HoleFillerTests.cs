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
