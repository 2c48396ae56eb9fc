using System.Text.Json;
using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.1")]
public class VertexClusteringTests
{
    [Fact]
    public void ClusterVertices_SheetOfFourByFour_HasTheMeansOfItsCells()
    {
        // 5 × 5 vertices at multiples of ¼; cells of ½ hold those at 0, ¼ | ½, ¾, 1.
        ClusteringResult result = Shapes.Sheet(4).ClusterVertices(new() { CellSize = 0.5 });

        Assert.Equal(4, result.Cells);
        double[] means = [0.125, 0.75];
        Assert.Equal(
            from y in means from x in means select new Vector3D(x, y, 0),
            result.Mesh.Vertices.Select(v => v.Position).OrderBy(p => p.Y).ThenBy(p => p.X));
        Assert.Equal(2, result.Mesh.Faces.Count);
        Assert.Equal(32 - 2, result.CollapsedFaces + result.DuplicateFaces);
        Assert.Equal(StopReason.CellsDone, result.StopReason);
        // The corner at (1, 1) goes to (¾, ¾).
        Assert.Equal(0.25 * Math.Sqrt(2), result.MaxError, 1e-15);
        Assert.Empty(result.Mesh.Validate());
    }

    [Theory]
    [InlineData(CellRepresentative.Mean)]
    [InlineData(CellRepresentative.QuadricOptimum)]
    public void ClusterVertices_Torus_HasOneVertexPerCellAndIsValid(CellRepresentative representative)
    {
        Mesh mesh = Shapes.Torus(80, 40);
        ulong before = mesh.StateHash();

        ClusteringResult result = mesh.ClusterVertices(new() { Cells = 3, Representative = representative });

        Assert.Equal(before, mesh.StateHash());
        Assert.InRange(result.Mesh.Vertices.Count, 50, 500);
        Assert.InRange(result.Mesh.BoundingBox.Diagonal, 0.8 * mesh.BoundingBox.Diagonal, 1.01 * mesh.BoundingBox.Diagonal);
        Assert.Empty(result.Mesh.Validate());
    }

    /// <summary>The larger cube has more faces than one thread takes.</summary>
    [Theory]
    [InlineData(9)]
    [InlineData(43)]
    public void ClusterVertices_QuadricOptimum_FindsTheCornersOfACube(int n)
    {
        ClusteringResult result = Shapes.Cube(n).ClusterVertices(new() { Cells = 2, Representative = CellRepresentative.QuadricOptimum });

        foreach (Vector3D corner in Enumerable.Range(0, 8).Select(new BoundingBox(default, new(1, 1, 1)).Corner))
            Assert.Contains(result.Mesh.Vertices, v => Vector3D.Distance(v.Position, corner) < 1e-12);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void CollapseCells_EveryModel_KeepsTheTopology(string name)
    {
        Mesh mesh = Models.Create(name);
        int components = Shapes.Components(mesh), loops = Shapes.BoundaryLoops(mesh), euler = Shapes.EulerCharacteristic(mesh);

        SimplificationResult result = mesh.CollapseCells(new() { Cells = 2 });

        Assert.Equal(components, Shapes.Components(mesh));
        Assert.Equal(loops, Shapes.BoundaryLoops(mesh));
        Assert.Equal(euler, Shapes.EulerCharacteristic(mesh));
        Assert.Equal(mesh.Faces.Count, result.FacesAfter);
        Assert.Equal(result.Refusals.Total > 0 ? StopReason.NothingCollapsible : StopReason.CellsDone, result.StopReason);
        Assert.Equal(result.Collapses > 0, result.MaxError > 0);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void ClusterVertices_Trace_IsOneLinePerCell()
    {
        using StringWriter cells = new(), contractions = new();
        Mesh mesh = Shapes.Torus(40, 20);

        ClusteringResult result = mesh.ClusterVertices(new() { Cells = 3, Trace = cells });
        SimplificationResult collapsed = mesh.CollapseCells(new() { Cells = 3, Trace = contractions });

        JsonElement[] lines = [.. cells.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonDocument.Parse(line).RootElement)];
        Assert.Equal(result.Cells, lines.Length);
        Assert.Equal(800, lines.Sum(line => line.GetProperty("vertices").GetInt32()));
        Assert.Equal(collapsed.Collapses, contractions.ToString().Count(c => c == '\n'));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void ClusterVertices_AnyNumberOfThreads_GivesTheSameBits()
    {
        Mesh mesh = Shapes.Torus(160, 80);
        var options = new ClusteringOptions { Cells = 4, Representative = CellRepresentative.QuadricOptimum };
        ulong expected = mesh.ClusterVertices(options).Mesh.StateHash();
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            Assert.Equal(expected, mesh.ClusterVertices(options).Mesh.StateHash());
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void ClusterVertices_FewVerticesInManyCells_CountsThemLikeInFew()
    {
        // So many cells that there is no table of all of them: every vertex stays alone.
        Mesh mesh = Shapes.Torus(30, 20);

        ClusteringResult result = mesh.ClusterVertices(new() { Cells = 2000 });

        Assert.Equal(mesh.Vertices.Count, result.Cells);
        Assert.Equal(mesh.Faces.Count, result.Mesh.Faces.Count);
        Assert.Equal(mesh.Vertices.Select(v => v.Position), result.Mesh.Vertices.Select(v => v.Position));
    }

    [Fact]
    public void ClusterVertices_Cancelled_LeavesTheMeshAsItWas()
    {
        Mesh mesh = Shapes.Torus(40, 20);
        ulong before = mesh.StateHash();
        using var source = new CancellationTokenSource();
        source.Cancel();

        Assert.ThrowsAny<OperationCanceledException>(() => mesh.ClusterVertices(new() { Cells = 3 }, null, source.Token));
        Assert.ThrowsAny<OperationCanceledException>(() => mesh.CollapseCells(new() { Cells = 3 }, null, source.Token));

        Assert.Equal(before, mesh.StateHash());
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void ClusterVertices_BadArguments_AreNamed()
    {
        Mesh mesh = Shapes.Sheet(4);

        Assert.Throws<ArgumentOutOfRangeException>(() => new ClusteringOptions { CellSize = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ClusteringOptions { CellSize = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ClusteringOptions { CellSize = double.PositiveInfinity });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ClusteringOptions { Cells = 0 });
        Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new()));
        ArgumentException small = Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new() { CellSize = 1e-9 }));
        Assert.Contains("1E+09", small.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new() { Cells = int.MaxValue }));
        foreach (Vector3D far in (Vector3D[])[new(3e6, 0, 0), new(0, 3e6, 0), new(0, 0, 3e6)])
            Assert.Throws<ArgumentException>(() => MeshBuilder.FromTriangles([default, new(1, 1, 1), far], [0, 1, 2]).ClusterVertices(new() { CellSize = 1 }));
        Assert.Throws<ArgumentException>(() => MeshBuilder.FromFaces(4, [0, 1, 2, 3]).ClusterVertices(new() { CellSize = 1 }));
    }

    [Fact]
    public void ClusterVertices_Traits_AreTakenByPlace()
    {
        Mesh mesh = Shapes.Sheet(8);
        VertexTrait<Vector3D> place = mesh.AddVertexTrait<Vector3D>("place", default, Blend.Linear);
        FaceTrait<int> half = mesh.AddFaceTrait("half", 0);
        foreach (Vertex v in mesh.Vertices)
            place[v] = v.Position;
        foreach (Face f in mesh.Faces)
            half[f] = f.Barycenter.X > 0.5 ? 1 : 0;

        Mesh result = mesh.ClusterVertices(new() { Cells = 4 }).Mesh;

        Assert.True(result.TryGetVertexTrait("place", out VertexTrait<Vector3D>? places));
        Assert.True(result.TryGetFaceTrait("half", out FaceTrait<int>? halves));
        Assert.All(result.Vertices, v => Assert.Equal(0, Vector3D.Distance(v.Position, places[v]), 1e-12));
        Assert.Contains(result.Faces, f => halves[f] == 1);
        Assert.Contains(result.Faces, f => halves[f] == 0);
        Assert.Empty(result.Validate());
    }

    [Fact]
    public void ClusterVertices_OneCell_LeavesNoFace()
    {
        ClusteringResult result = Shapes.Cube(4).ClusterVertices(new() { CellSize = 10 });

        Assert.Equal(1, result.Cells);
        Assert.Equal(0, result.Mesh.Faces.Count);
    }

    /// <summary>Three sides of a pyramid, cut off below its tip: their planes meet in the tip, whether that lies in the cell or not.</summary>
    [Theory]
    [InlineData(13, 0)]
    [InlineData(16, 0)]
    [InlineData(13, 1)]
    [InlineData(16, 1)]
    [InlineData(13, 2)]
    [InlineData(16, 2)]
    public void ClusterVertices_QuadricOptimum_IsTheMeanIfItLiesBesideTheCell(double tip, int axis)
    {
        double cut = 8 * (1 - 12 / tip);
        Vector3D Point(double x, double y, double z) => new Vector3D(10, 20, 30) + axis switch { 0 => new(z, x, y), 1 => new(y, z, x), _ => new(x, y, z) };
        Mesh mesh = MeshBuilder.FromTriangles(
            [Point(0, 0, 0), Point(8, 0, 0), Point(0, 8, 0), Point(0, 0, 12), Point(cut, 0, 12), Point(0, cut, 12)],
            [0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5]);

        // The cell of the three upper vertices reaches from 10 to 15.
        ClusteringResult result = mesh.ClusterVertices(new() { CellSize = 5, Representative = CellRepresentative.QuadricOptimum });

        Vector3D expected = tip < 15 ? Point(0, 0, tip) : Point(cut / 3, cut / 3, 12);
        Assert.Equal(4, result.Cells);
        Assert.Equal(0, Vector3D.Distance(expected, result.Mesh.Vertices[3].Position), 1e-9);
        Assert.Empty(result.Mesh.Validate());
    }

    /// <summary>Walls at x = ½ and y = ½ and three level triangles, that have one, two and three corners in the cell: each counts once there, by its area.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void ClusterVertices_QuadricOptimum_WeighsEachFaceAtTheCellOnceByArea(int firstCorner)
    {
        Vector3D[][] triangles =
        [
            [new(0.5, 0, 0), new(0.5, 0.5, 0), new(0.5, 0, 0.5)],
            [new(0, 0.5, 0), new(0.5, 0.5, 0), new(0, 0.5, 0.5)],
            [new(0.125, 0.125, 0.25), new(3.125, 0.125, 0.25), new(0.125, 2.125, 0.25)],
            [new(0.125, 0.125, 0.75), new(0.875, 0.125, 0.75), new(0.125, 5.125, 0.75)],
            [new(0.125, 0.125, 0.5), new(0.625, 0.125, 0.5), new(0.125, 0.625, 0.5)],
        ];
        double[] areas = [3, 0.75 * 5 / 2, 0.125], heights = [0.25, 0.75, 0.5];
        Mesh mesh = MeshBuilder.FromTriangles([.. triangles.SelectMany(t => t)], [.. Enumerable.Range(0, 15).Select(i => i / 3 * 3 + (i + firstCorner) % 3)]);

        ClusteringResult result = mesh.ClusterVertices(new() { CellSize = 1, Representative = CellRepresentative.QuadricOptimum });

        double height = areas.Zip(heights, (area, z) => area * z).Sum() / areas.Sum();
        Assert.Equal(0, Vector3D.Distance(new(0.5, 0.5, height), result.Mesh.Vertices[0].Position), 1e-12);
        // One plane alone has no unique optimum.
        Assert.Equal(new(3.125, 0.125, 0.25), result.Mesh.Vertices[1].Position);
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(0.001)]
    public void ClusterVertices_VertexWithoutFaces_HasNoCell(double size)
    {
        Mesh mesh = Shapes.Sheet(4), alone = mesh.Clone();
        alone.AddVertex(new(0.1, 0.1, 1));
        var options = new ClusteringOptions { CellSize = size };

        ClusteringResult expected = mesh.ClusterVertices(options), result = alone.ClusterVertices(options);

        Assert.Equal(expected.Cells, result.Cells);
        Assert.Equal(expected.Mesh.StateHash(), result.Mesh.StateHash());
    }

    [Fact]
    public void ClusterVertices_ThreeSheetsOnOneEdge_LeavesTheThirdOutUnlessItMustThrow()
    {
        // Apart they are three triangles; in cells of 1 they share an edge.
        Mesh mesh = MeshBuilder.FromTriangles(
            [new(0, 0, 0), new(0, 3, 0), new(3, 0, 0), new(0.25, 0, 0), new(0.25, 3, 0), new(6, 0, 0), new(0, 0, 0.25), new(0, 3, 0.25), new(0, 0, 9)],
            [0, 1, 2, 4, 3, 5, 6, 7, 8]);

        ClusteringResult result = mesh.ClusterVertices(new() { CellSize = 1 });

        Assert.Equal((2, 1), (result.Mesh.Faces.Count, result.Report.Repairs.Count));
        Assert.Empty(result.Mesh.Validate());
        Assert.Throws<TopologyException>(() => mesh.ClusterVertices(new() { CellSize = 1, NonManifold = NonManifoldPolicy.Throw }));
    }

    [Fact]
    public void CollapseCells_FourVerticesPerCell_BecomeTheirMean()
    {
        Mesh mesh = Shapes.Moved(Shapes.Sheet(7), p => p * 7);

        SimplificationResult result = mesh.CollapseCells(new() { CellSize = 2 });

        Assert.Equal((StopReason.CellsDone, 48), (result.StopReason, result.Collapses));
        double[] means = [0.5, 2.5, 4.5, 6.5];
        Vector3D[] expected = [.. from y in means from x in means select new Vector3D(x, y, 0)];
        Assert.All(expected.Zip(mesh.Vertices.Select(v => v.Position).OrderBy(p => Math.Round(p.Y)).ThenBy(p => p.X)), pair => Assert.Equal(0, Vector3D.Distance(pair.First, pair.Second), 1e-12));
        Assert.Empty(mesh.Validate());
    }

    /// <summary>What a contraction forbids may be possible after a later one: at the end no edge within a cell can be contracted.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(5)]
    [InlineData(8)]
    public void CollapseCells_Torus_LeavesNoEdgeInACellThatCouldGo(int cells)
    {
        Mesh mesh = Shapes.Torus(60, 40);
        Vector3D origin = mesh.BoundingBox.Min;
        double size = mesh.BoundingBox.Size.Z / cells;
        using var trace = new StringWriter();

        SimplificationResult result = mesh.CollapseCells(new() { Cells = cells, Trace = trace });

        int left = 0;
        foreach (Edge e in mesh.Edges)
        {
            if (CellOf(e.Vertex0) != CellOf(e.Vertex1))
                continue;
            left++;
            Assert.False(e.HalfEdge0.CanCollapse(out _), $"{e}");
        }
        Assert.Equal(left, result.Refusals.Total);
        // The longest, not the last.
        string[] lines = trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(lines.Max(line => JsonDocument.Parse(line).RootElement.GetProperty("cost").GetDouble()), result.MaxError);
        Assert.Empty(mesh.Validate());

        (double, double, double) CellOf(Vertex v)
        {
            Vector3D p = (v.Position - origin) / size;
            return (Math.Floor(p.X), Math.Floor(p.Y), Math.Min(Math.Floor(p.Z), cells - 1));
        }
    }

    [Fact]
    public void CollapseCells_Trace_NamesTheVertexThatStays()
    {
        Mesh mesh = Shapes.Moved(Shapes.Sheet(3), p => p * 3);
        using var trace = new StringWriter();
        using OperationHistory history = mesh.StartRecording();
        ulong before = mesh.StateHash();

        mesh.CollapseCells(new() { CellSize = 2, Trace = trace });

        JsonElement[] lines = [.. trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonDocument.Parse(line).RootElement)];
        int[] kept = [.. lines.Select(line => line.GetProperty("kept").GetInt32())], removed = [.. lines.Select(line => line.GetProperty("removed").GetInt32())];
        Assert.All(removed, v => Assert.True(mesh.IsDeletedVertex(v)));
        Assert.Equal(mesh.Vertices.Select(v => v.Index), kept.Except(removed).Order());
        // While it is recorded nothing is renumbered, and all can be undone.
        Assert.False(mesh.IsCompact);
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void CollapseCells_TwoSheetsInOneCell_StayTwo()
    {
        Mesh mesh = Shapes.Sheet(4);
        mesh.Append(Shapes.Moved(Shapes.Sheet(4), p => p + new Vector3D(0, 0, 0.01)));

        SimplificationResult result = mesh.CollapseCells(new() { CellSize = 10 });

        Assert.Equal((StopReason.NothingCollapsible, 2, 2), (result.StopReason, mesh.Faces.Count, Shapes.Components(mesh)));
        Assert.Empty(mesh.Validate());
    }
}
