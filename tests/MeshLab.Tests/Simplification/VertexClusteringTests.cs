using System.Text.Json;
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

    [Fact]
    public void ClusterVertices_QuadricOptimum_FindsTheCornersOfACube()
    {
        ClusteringResult result = Shapes.Cube(9).ClusterVertices(new() { Cells = 2, Representative = CellRepresentative.QuadricOptimum });

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
        Assert.Throws<ArgumentOutOfRangeException>(() => new ClusteringOptions { Cells = 0 });
        Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new()));
        ArgumentException small = Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new() { CellSize = 1e-9 }));
        Assert.Contains("1E+09", small.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => mesh.ClusterVertices(new() { Cells = int.MaxValue }));
        Assert.Throws<ArgumentException>(() => MeshBuilder.FromFaces(4, [0, 1, 2, 3]).ClusterVertices(new() { CellSize = 1 }));
    }

    [Fact]
    public void ClusterVertices_OneCell_LeavesNoFace()
    {
        ClusteringResult result = Shapes.Cube(4).ClusterVertices(new() { CellSize = 10 });

        Assert.Equal(1, result.Cells);
        Assert.Equal(0, result.Mesh.Faces.Count);
    }
}
