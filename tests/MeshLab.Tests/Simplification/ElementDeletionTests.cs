using System.Text.Json;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.3")]
public class ElementDeletionTests
{
    public static TheoryData<DeletionMeasure> Measures => new(Enum.GetValues<DeletionMeasure>());

    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_ToAThird_ReachesTheTargetAndKeepsTheTopology(DeletionMeasure measure)
    {
        foreach (Mesh mesh in (Mesh[])[Shapes.Torus(20, 14), Shapes.Sheet(12, (x, y) => x * x * y), Shapes.Cube(6)])
        {
            int faces = mesh.Faces.Count, euler = Shapes.EulerCharacteristic(mesh), loops = Shapes.BoundaryLoops(mesh);

            SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = faces / 3, Measure = measure });

            Assert.Equal(StopReason.TargetReached, result.StopReason);
            Assert.InRange(mesh.Faces.Count, faces / 3 - 1, faces / 3);
            Assert.Equal(euler, Shapes.EulerCharacteristic(mesh));
            Assert.Equal(loops, Shapes.BoundaryLoops(mesh));
            Assert.True(mesh.IsCompact);
            Assert.Empty(mesh.Validate());
        }
    }

    [Fact]
    public void DeleteElements_ShortestEdge_GoesFirstAndToItsMidpoint()
    {
        Mesh mesh = Models.Create("octahedron");
        Edge shortest = mesh.Edges[5];
        shortest.Vertex0.Position = Vector3D.Lerp(shortest.Vertex0.Position, shortest.Vertex1.Position, 0.8);
        Vector3D middle = (shortest.Vertex0.Position + shortest.Vertex1.Position) / 2;

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 6, AllowFlips = true });

        Assert.Equal(1, result.Collapses);
        Assert.Contains(mesh.Vertices, v => v.Position == middle);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void DeleteElements_LowestCurvature_KeepsTheCornersOfACube()
    {
        Mesh mesh = Shapes.Cube(5);

        mesh.DeleteElements(new() { TargetFaces = 12, Measure = DeletionMeasure.LowestCurvature });

        Assert.Equal(8, mesh.Vertices.Count);
        Assert.All(mesh.Vertices, v => Assert.Equal(0, v.Position.X * (1 - v.Position.X) + v.Position.Y * (1 - v.Position.Y) + v.Position.Z * (1 - v.Position.Z)));
    }

    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_Recorded_IsUndoneExactly(DeletionMeasure measure)
    {
        Mesh mesh = Shapes.Torus(12, 8);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();

        mesh.DeleteElements(new() { TargetFaces = 60, Measure = measure });
        Assert.Empty(mesh.Validate());
        history.UndoAll();

        Assert.Equal(before, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_LockedBoundary_KeepsIt(DeletionMeasure measure)
    {
        Mesh mesh = Shapes.Sheet(8, (x, y) => x * y * y);
        var before = mesh.Vertices.Where(v => v.IsBoundary).Select(v => v.Position).ToHashSet();

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 1, Measure = measure, LockBoundary = true });

        Assert.Equal(StopReason.NothingCollapsible, result.StopReason);
        Assert.True(result.Refusals.Total > 0);
        Assert.Equal(before, mesh.Vertices.Where(v => v.IsBoundary).Select(v => v.Position).ToHashSet());
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_Trace_IsOneLinePerContraction(DeletionMeasure measure)
    {
        Mesh mesh = Shapes.Torus(12, 8);
        using var trace = new StringWriter();

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 60, Measure = measure, Trace = trace });

        string[] lines = trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(result.Collapses, lines.Length);
        Assert.Equal(result.MaxError, lines.Max(line => JsonDocument.Parse(line).RootElement.GetProperty("cost").GetDouble()));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void DeleteElements_BadArguments_AreNamed()
    {
        Mesh mesh = Shapes.Sheet(2);

        Assert.Throws<ArgumentOutOfRangeException>(() => new DeletionOptions { TargetFaces = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.DeleteElements(new() { TargetFaces = 9 }));
        Assert.Throws<ArgumentException>(() => MeshBuilder.FromFaces(4, [0, 1, 2, 3]).DeleteElements(new() { TargetFaces = 1 }));
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.ThrowsAny<OperationCanceledException>(() => mesh.DeleteElements(new() { TargetFaces = 4 }, null, source.Token));
        Assert.Empty(mesh.Validate());
    }
}
