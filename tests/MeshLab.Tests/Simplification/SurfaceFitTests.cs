using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>The guarded fit at the end of accurate mode: alone on small surfaces, and against the same contractions without it.</summary>
[Trait("Section", "7.2")]
public class SurfaceFitTests
{
    private const double Factor = 0.25;

    /// <summary>Fits a surface with the original's connectivity and other positions to the original; in model units, and where no vertex moved, untouched.</summary>
    private static (Vector3D[] Before, Vector3D[] After, int[] Origins) Fit(Mesh original, Func<Vertex, Vector3D> positions)
    {
        var working = new WorkingMesh(original);
        working.TrackSuccessors();
        var result = new CompactResult(original, working);
        foreach (Vertex v in original.Vertices)
            result.Positions[v.Index] = working.Normalized(positions(v));
        Vector3D[] start = [.. result.Positions];

        SurfaceFit.Run(original, working, result, default);

        Vector3D[] before = [.. start.Select(working.Restored)];
        return (before, [.. result.Positions.Select((p, v) => p == start[v] ? before[v] : working.Restored(p))], result.Origins);
    }

    /// <summary>A hexagon around a vertex.</summary>
    private static Mesh Fan(Vector3D middle) => MeshBuilder.FromTriangles(
        [middle, .. Enumerable.Range(0, 6).Select(i => new Vector3D(Math.Cos(i * Math.PI / 3), Math.Sin(i * Math.PI / 3), 0))],
        [.. Enumerable.Range(0, 6).SelectMany(i => new[] { 0, 1 + i, 1 + (i + 1) % 6 })]);

    [Fact]
    public void Run_MiddleOfAFan_GoesUpToTheTipAndTheBorderStays()
    {
        var (before, after, origins) = Fit(Fan(new(0, 0, 0.4)), v => v.IsBoundary ? v.Position : default);

        Assert.InRange(after[0].Z, 0.3, 0.5);
        Assert.Equal(0, new Vector3D(after[0].X, after[0].Y, 0).Length, 0.01);
        Assert.Equal(before[1..], after[1..]);
        // Who moved lies on no vertex of the original any more.
        Assert.Equal([-1, 1, 2, 3, 4, 5, 6], origins);
    }

    /// <summary>So near to a border edge, going up would stand a face upright.</summary>
    [Fact]
    public void Run_FaceThatWouldTurnTooFar_HoldsItsVertex()
    {
        var near = new Vector3D(0.75, Math.Sqrt(0.75) / 2, 0) * 0.95;

        var (before, after, origins) = Fit(Fan(near + new Vector3D(0, 0, 0.4)), v => v.IsBoundary ? v.Position : near);

        Assert.Equal(before, after);
        Assert.Equal([0, 1, 2, 3, 4, 5, 6], origins);
    }

    /// <summary>Where a wall stands on a floor; the original's wall pulls the vertex between them over the floor, by a quarter of its shortest edge each time.
    /// A floor that is narrower would turn over or nearly vanish.</summary>
    [Theory]
    [InlineData(0.05, 0)]
    [InlineData(0.263, 0)]
    [InlineData(3, Factor)]
    public void Run_FaceThatWouldFallTogether_HoldsItsVertex(double floor, double least)
    {
        Mesh original = MeshBuilder.FromTriangles(
            [new(2, 0, 0), new(0, -1, 0), new(0, 1, 0), new(0, -1, 3), new(0, 1, 3), new(floor, -1, 0), new(floor, 1, 0)],
            [0, 2, 4, 0, 4, 3, 0, 3, 1, 0, 1, 5, 0, 5, 6, 0, 6, 2]);

        var (before, after, _) = Fit(original, v => v.IsBoundary ? v.Position : default);

        if (least == 0)
            Assert.Equal(before, after);
        else
            Assert.InRange(after[0].X, least, 1);
    }

    /// <summary>The tip is far above: three sweeps, each a quarter of the shortest edge, which grows meanwhile.</summary>
    [Fact]
    public void Run_FarFromTheOriginal_MovesAQuarterOfTheShortestEdgePerSweep()
    {
        double height = 0;
        for (int sweep = 0; sweep < 3; sweep++)
            height += Factor * Math.Sqrt(1 + height * height);

        var (_, after, _) = Fit(Fan(new(0, 0, 10)), v => v.IsBoundary ? v.Position : default);

        Assert.InRange(after[0].Length, 0.5, height + 0.01);
    }

    [Fact]
    public void Run_AsGoodAsExact_LeavesEveryBit()
    {
        var (before, after, origins) = Fit(Shapes.Torus(12, 8), v => v.Position * (1 + 1e-9 * (v.Index % 3)));

        Assert.Equal(before, after);
        Assert.Equal(Enumerable.Range(0, 96), origins);
    }

    /// <summary>The ring around the middle rises to the original and would take the middle along, which lies on the bottom of a crater. On a large surface, that is
    /// many times the mean distance.</summary>
    [Fact]
    public void Run_VertexThatWouldLeaveTheOriginal_Stays()
    {
        const int N = 40, Middle = (N + 1) * N / 2 + N / 2;
        Mesh original = Shapes.Moved(Shapes.Sheet(N), p => p * N);
        var ring = original.Vertices[Middle].Neighbors.Select(v => v.Index).ToHashSet();
        foreach (int v in ring)
            original.Vertices[v].Position += new Vector3D(0, 0, 0.3);

        var (before, after, _) = Fit(original, v => new(v.Position.X, v.Position.Y, 0));

        Assert.All(ring, v => Assert.InRange(after[v].Z, 0.2, 0.4));
        Assert.Equal(before[Middle], after[Middle]);
    }

    [Fact]
    public void OriginalDistance_PointsAboveATorus_IsFoundFromFarStarts()
    {
        Mesh mesh = Shapes.Torus(40, 24);
        Vertex[] vertices = [.. mesh.Vertices];
        // Outwards in the round of the tube; the start is six vertices away along it and three across.
        Vector3D[] points = [.. vertices.Select(v => v.Position + 0.05 * Outwards(v.Position))];
        int[] starts = [.. vertices.Select(v => (v.Index % 40 + 6) % 40 + 40 * ((v.Index / 40 + 3) % 24))];

        double[] squared = new OriginalDistance(mesh, mesh.Positions.ToArray(), starts).DistancesSquared(points);

        FaceTree tree = FaceTree.Build(mesh);
        for (int i = 0; i < points.Length; i++)
            Assert.Equal(tree.FindClosest(points[i]).DistanceSquared, squared[i], 1e-14);

        static Vector3D Outwards(Vector3D p)
        {
            var centre = new Vector3D(p.X, p.Y, 0).Normalized();
            return (p - centre).Normalized();
        }
    }

    public static TheoryData<string, double> Shaped()
    {
        var data = new TheoryData<string, double>();
        foreach (string name in (string[])["wave", "crumpled", "torus", "needles"])
        {
            data.Add(name, 0.1);
            data.Add(name, 0.4);
        }
        return data;
    }

    private static Mesh Make(string name)
    {
        var random = new Random(3);
        return name switch
        {
            "wave" => Shapes.Sheet(24, (x, y) => 0.1 * Math.Sin(9 * x + 1) * Math.Cos(7 * y)),
            "crumpled" => Shapes.Sheet(24, (_, _) => 0.1 * random.NextDouble()),
            "needles" => Shapes.Moved(Shapes.Torus(60, 24), p => new Vector3D(p.X, p.Y, p.Z * (1 + 0.5 * random.NextDouble()))),
            _ => Shapes.Torus(40, 24),
        };
    }

    /// <summary>The record of accurate mode is without the fit.</summary>
    private static (Mesh Unfitted, Mesh Fitted) Both(Mesh mesh, QuadricOptions options)
    {
        options = options with { Mode = QuadricMode.Accurate };
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh, options);
        progressive.GoToBase();
        Mesh unfitted = progressive.Mesh, fitted = mesh.Clone();
        unfitted.Compact();
        fitted.Simplify(options);
        Assert.Equal(unfitted.Target.ToArray(), fitted.Target.ToArray());
        Assert.Empty(fitted.Validate());
        return (unfitted, fitted);
    }

    [Theory]
    [MemberData(nameof(Shaped))]
    public void Simplify_Accurate_FitIsCloserAndTurnsNothingOver(string name, double ratio)
    {
        Mesh mesh = Make(name);

        (Mesh unfitted, Mesh fitted) = Both(mesh, new() { TargetRatio = ratio });

        var options = new MeshDistanceOptions { Samples = 20_000 };
        MeshDistanceReport before = mesh.DistanceTo(unfitted, options), after = mesh.DistanceTo(fitted, options);
        Assert.True(after.Forward.Rms < 0.98 * before.Forward.Rms, $"{after.Forward.Rms} from {before.Forward.Rms}");
        double[] farBefore = unfitted.VertexDistancesTo(mesh), farAfter = fitted.VertexDistancesTo(mesh);
        foreach (Vertex v in fitted.Vertices)
        {
            Assert.True(farAfter[v.Index] <= Math.Max(farBefore[v.Index], 5.5 * after.Forward.Rms) + 1e-12, $"{v} from {farBefore[v.Index]} to {farAfter[v.Index]}");
            if (v.IsBoundary)
                Assert.Equal(unfitted.Positions[v.Index], v.Position);
        }
        foreach (Face f in fitted.Faces)
        {
            Vector3D n = Normal(f), m = Normal(unfitted.Faces[f.Index]);
            // Per sweep a tenth of the area and acos 0.8 of the turn.
            Assert.True(n.Length > 1e-3 * m.Length);
            Assert.True(Vector3D.Angle(n, m) < 3 * Math.Acos(0.8));
        }

        static Vector3D Normal(Face f)
        {
            Vector3D a = f.HalfEdge.Source.Position;
            return Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a);
        }
    }

    [Fact]
    public void Simplify_Accurate_FitLeavesFeaturesAndIsolatedVertices()
    {
        Mesh mesh = Make("wave");
        mesh.AddVertex(new(3, 4, 5));
        int[] line = [.. mesh.Edges.Where(e => e.Vertex0.Position.X == 0.5 && e.Vertex1.Position.X == 0.5).Select(e => e.Index)];

        (Mesh unfitted, Mesh fitted) = Both(mesh, new() { TargetRatio = 0.15, FeatureEdges = line });

        int kept = 0, moved = 0;
        foreach (Vertex v in fitted.Vertices)
        {
            bool same = v.Position == unfitted.Positions[v.Index];
            moved += same ? 0 : 1;
            if (Math.Abs(unfitted.Positions[v.Index].X - 0.5) > 1e-12 && !v.IsIsolated)
                continue;
            kept++;
            Assert.True(same, $"{v}");
        }
        Assert.InRange(kept, 4, 26);
        Assert.InRange(moved, 20, 200);
        Assert.Equal(new(3, 4, 5), Assert.Single(fitted.Vertices, v => v.IsIsolated).Position);
    }
}
