using System.Text.Json;
using MeshLab.Editing;
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

    /// <summary>A pyramid over a regular hexagon with radius 1; its sides rise at an angle of the given cosine. The tip can only go into the locked base.</summary>
    private static Mesh Pyramid(double cosine, Vector3D tipOffset = default)
    {
        double apothem = Math.Sqrt(0.75), height = apothem * Math.Sqrt(1 / (cosine * cosine) - 1);
        Vector3D[] positions = [tipOffset + new Vector3D(0, 0, height), .. Enumerable.Range(0, 6).Select(Corner)];
        return MeshBuilder.FromTriangles(positions, [.. Enumerable.Range(0, 6).SelectMany(i => new[] { 0, 1 + i, 1 + (i + 1) % 6 })]);
    }

    private static Vector3D Corner(int i) => new(Math.Cos(i * Math.PI / 3), Math.Sin(i * Math.PI / 3), 0);

    private static JsonElement[] Lines(StringWriter trace) =>
        [.. trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonDocument.Parse(line).RootElement)];

    [Theory]
    [InlineData(DeletionMeasure.ShortestEdge, 0.25, false, 1)]
    [InlineData(DeletionMeasure.ShortestEdge, 0.15, false, 0)]
    [InlineData(DeletionMeasure.ShortestEdge, 0.15, true, 1)]
    [InlineData(DeletionMeasure.LowestCurvature, 0.25, false, 1)]
    [InlineData(DeletionMeasure.LowestCurvature, 0.15, false, 0)]
    [InlineData(DeletionMeasure.LowestCurvature, 0.15, true, 1)]
    public void DeleteElements_SidesThatWouldTurn_TurnUpToAFifthUnlessFlipsAreAllowed(DeletionMeasure measure, double cosine, bool allowFlips, int collapses)
    {
        Mesh mesh = Pyramid(cosine);

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 4, Measure = measure, LockBoundary = true, AllowFlips = allowFlips });

        Assert.Equal((collapses, 6 - 2 * collapses), (result.Collapses, mesh.Faces.Count));
        Assert.Equal(Enumerable.Range(0, 6).Select(Corner), mesh.Vertices.Where(v => v.IsBoundary).Select(v => v.Position));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void DeleteElements_ShortestEdgeToALockedBoundary_GoesIntoIt()
    {
        for (int nearest = 0; nearest < 6; nearest++)
        {
            Mesh mesh = Pyramid(0.9, Corner(nearest) * 0.3);
            using var trace = new StringWriter();

            mesh.DeleteElements(new() { TargetFaces = 4, LockBoundary = true, Trace = trace });

            JsonElement line = Assert.Single(Lines(trace));
            Assert.Equal((0, 1 + nearest), (line.GetProperty("removed").GetInt32(), line.GetProperty("kept").GetInt32()));
            Assert.Equal(Enumerable.Range(0, 6).Select(Corner), mesh.Vertices.Select(v => v.Position));
            Assert.Empty(mesh.Validate());
        }
    }

    /// <summary>At a tetrahedron nothing can go any more: every element that is left was refused, once.</summary>
    [Theory]
    [InlineData(DeletionMeasure.ShortestEdge, 6)]
    [InlineData(DeletionMeasure.SmallestTriangle, 4)]
    [InlineData(DeletionMeasure.LowestCurvature, 4)]
    public void DeleteElements_AsFarAsPossible_CountsWhatIsLeftAsRefused(DeletionMeasure measure, int refused)
    {
        Mesh mesh = Models.Create("octahedron");
        mesh.AddVertex(new(5, 5, 5));

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 1, Measure = measure, AllowFlips = true });

        Assert.Equal((StopReason.NothingCollapsible, 4, 2, refused), (result.StopReason, result.FacesAfter, result.Collapses, result.Refusals.Total));
        Assert.Equal(5, mesh.Vertices.Count);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(4)]
    [InlineData(2)]
    public void DeleteElements_SmallestTriangle_GoesToItsBarycentreUnlessHalfOfItIsEnough(int facesToRemove)
    {
        Mesh mesh = Shapes.Sheet(6);
        Vertex[] corners = [.. mesh.Faces[30].Vertices];
        Assert.All(corners, v => Assert.False(v.IsBoundary));
        Vector3D middle = (corners[0].Position + corners[1].Position + corners[2].Position) / 3;
        foreach (Vertex v in corners)
            v.Position = Vector3D.Lerp(middle, v.Position, 0.125);
        Vector3D[] small = [.. corners.Select(v => v.Position)];
        double area = Vector3D.Cross(small[1] - small[0], small[2] - small[0]).Length / 2;

        SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 72 - facesToRemove, Measure = DeletionMeasure.SmallestTriangle });

        Assert.Equal((StopReason.TargetReached, 72 - facesToRemove, facesToRemove / 2), (result.StopReason, mesh.Faces.Count, result.Collapses));
        Vertex merged = Assert.Single(mesh.Vertices, v => Vector3D.Distance(v.Position, middle) < 1e-12);
        Assert.Equal(3 - facesToRemove / 2 - 1, mesh.Vertices.Count(v => v != merged && small.Contains(v.Position)));
        Assert.Equal(area, result.MaxError, 1e-15);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void DeleteElements_LowestCurvatureOfAFlatSheet_KeepsItsOutline()
    {
        Mesh mesh = Shapes.Sheet(6);

        mesh.DeleteElements(new() { TargetFaces = 2, Measure = DeletionMeasure.LowestCurvature });

        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(1, 1, 0)], mesh.Vertices.Select(v => v.Position));
        Assert.Equal(2, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    /// <summary>Vertex 0 lies nearly between its neighbours 1 and 2 and would turn least towards them; but 1, 2 and 0 are a ring without a face.</summary>
    [Fact]
    public void DeleteElements_LowestCurvature_GoesElsewhereIfTheBestNeighbourIsImpossible()
    {
        Mesh mesh = MeshBuilder.FromTriangles(
            [new(0.1, 0, 0), new(0, -1, 0), new(0, 1, 0), new(-1, 0, 2), new(-1, 0, -2)],
            [3, 1, 0, 3, 0, 2, 3, 2, 1, 4, 0, 1, 4, 2, 0, 4, 1, 2]);
        using var trace = new StringWriter();

        mesh.DeleteElements(new() { TargetFaces = 4, Measure = DeletionMeasure.LowestCurvature, AllowFlips = true, Trace = trace });

        JsonElement line = Assert.Single(Lines(trace));
        Assert.Equal(0, line.GetProperty("removed").GetInt32());
        Assert.Contains(line.GetProperty("kept").GetInt32(), (int[])[3, 4]);
        Assert.Empty(mesh.Validate());
    }

    /// <summary>Does the steps again on a copy: each removes what it says at that time, and the error is the largest of them.</summary>
    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_EveryStep_HasTheMeasureOfItsElementAtThatTime(DeletionMeasure measure)
    {
        var random = new Random(4);
        foreach (Mesh mesh in (Mesh[])[Shapes.Sheet(8, (_, _) => 0.05 * random.NextDouble()), Shapes.Moved(Shapes.Torus(12, 8), p => p * (1 + 0.1 * random.NextDouble()))])
        {
            Mesh copy = mesh.Clone();
            using var trace = new StringWriter();

            SimplificationResult result = mesh.DeleteElements(new() { TargetFaces = 20, Measure = measure, Trace = trace });

            double last = double.NaN;
            foreach (JsonElement line in Lines(trace))
            {
                HalfEdge h = copy.FindHalfEdge(copy.Vertices[line.GetProperty("removed").GetInt32()], copy.Vertices[line.GetProperty("kept").GetInt32()]);
                double cost = line.GetProperty("cost").GetDouble();
                // Of the two contractions of a triangle, the second has the measure of the first.
                if (cost != last)
                    Assert.Equal(Measured(copy, h, measure, cost), cost, 1e-12);
                last = cost;
                if (measure == DeletionMeasure.LowestCurvature)
                    AssertTurnsLeast(h);
                double[] p = [.. line.GetProperty("position").EnumerateArray().Select(x => x.GetDouble())];
                h.Collapse(new(p[0], p[1], p[2]));
            }
            Assert.Equal(Lines(trace).Max(line => line.GetProperty("cost").GetDouble()), result.MaxError);
            copy.Compact();
            Assert.Equal(copy.StateHash(), mesh.StateHash());
        }
    }

    /// <summary>No neighbour into which the source could go as well would turn the faces that stay less.</summary>
    private static void AssertTurnsLeast(HalfEdge chosen)
    {
        foreach (HalfEdge h in chosen.Source.OutgoingHalfEdges)
        {
            if (h.CanCollapse(out _) && !h.CollapseFlips(h.Target.Position, 0.2))
                Assert.True(LeastCosine(h) <= LeastCosine(chosen) + 1e-12, $"{h} instead of {chosen}");
        }

        static double LeastCosine(HalfEdge h)
        {
            double least = 1;
            foreach (Face f in h.Source.Faces.Where(f => !f.Vertices.Contains(h.Target)))
            {
                Vector3D[] old = [.. f.Vertices.Select(v => v.Position)], then = [.. f.Vertices.Select(v => v == h.Source ? h.Target.Position : v.Position)];
                least = Math.Min(least, Math.Cos(Vector3D.Angle(Vector3D.Cross(old[1] - old[0], old[2] - old[0]), Vector3D.Cross(then[1] - then[0], then[2] - then[0]))));
            }
            return least;
        }
    }

    [Theory]
    [MemberData(nameof(Measures))]
    public void DeleteElements_FurtherAndFurther_HasAnErrorThatNeverFalls(DeletionMeasure measure)
    {
        double last = 0;
        for (int faces = 120; faces > 8; faces -= 2)
        {
            var random = new Random(9);
            Mesh mesh = Shapes.Sheet(8, (_, _) => 0.2 * random.NextDouble());
            double error = mesh.DeleteElements(new() { TargetFaces = faces, Measure = measure }).MaxError;
            Assert.True(error >= last, $"{error} at {faces} faces after {last}");
            last = error;
        }
    }

    private static double Measured(Mesh mesh, HalfEdge h, DeletionMeasure measure, double near)
    {
        Vector3D p = h.Source.Position;
        switch (measure)
        {
            case DeletionMeasure.ShortestEdge:
                return Vector3D.Distance(p, h.Target.Position);
            case DeletionMeasure.SmallestTriangle:
                double[] areas = [.. h.Edge.Faces.Select(f => f.HalfEdge).Select(g =>
                    Vector3D.Cross(g.Target.Position - g.Source.Position, g.Next.Target.Position - g.Source.Position).Length / 2)];
                return areas.MinBy(area => Math.Abs(area - near));
            default:
                double angles = h.Source.Faces.Sum(f =>
                {
                    Vector3D[] others = [.. f.Vertices.Where(v => v.Index != h.Source.Index).Select(v => v.Position - p)];
                    return Vector3D.Angle(others[0], others[1]);
                });
                return Math.Abs((h.Source.IsBoundary ? Math.PI : 2 * Math.PI) - angles);
        }
    }
}
