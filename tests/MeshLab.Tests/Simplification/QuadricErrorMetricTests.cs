using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class QuadricErrorMetricTests
{
    public static TheoryData<string, QuadricMode> ModelsAndModes()
    {
        var data = new TheoryData<string, QuadricMode>();
        foreach (QuadricMode mode in Enum.GetValues<QuadricMode>())
        {
            foreach (string name in (string[])["sheet", "torus", "cube", "wave"])
                data.Add(name, mode);
        }
        return data;
    }

    private static Mesh Make(string name) => name switch
    {
        "sheet" => Shapes.Sheet(12),
        "torus" => Shapes.Torus(24, 16),
        "cube" => Shapes.Cube(8),
        _ => Wave(16),
    };

    private static Mesh Wave(int n) => Shapes.Sheet(n, (x, y) => 0.1 * Math.Sin(9 * x + 1) * Math.Cos(7 * y));

    [Theory]
    [MemberData(nameof(ModelsAndModes))]
    public void Simplify_ToAQuarter_ReachesTheTargetAndKeepsTheTopology(string name, QuadricMode mode)
    {
        Mesh mesh = Make(name);
        int faces = mesh.Faces.Count, euler = Shapes.EulerCharacteristic(mesh), loops = Shapes.BoundaryLoops(mesh);

        SimplificationResult result = mesh.Simplify(new() { TargetFaces = faces / 4, Mode = mode });

        Assert.Equal(StopReason.TargetReached, result.StopReason);
        Assert.InRange(mesh.Faces.Count, faces / 4 - 1, faces / 4);
        Assert.Equal(mesh.Faces.Count, result.FacesAfter);
        Assert.Equal(faces, result.FacesBefore);
        Assert.Equal(euler, Shapes.EulerCharacteristic(mesh));
        Assert.Equal(loops, Shapes.BoundaryLoops(mesh));
        Assert.True(mesh.IsCompact);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    [InlineData(QuadricMode.Textbook)]
    public void Simplify_CubeToTwelveFaces_IsTheCube(QuadricMode mode)
    {
        Mesh mesh = Shapes.Cube(6);

        SimplificationResult result = mesh.Simplify(new() { TargetFaces = 12, Mode = mode });

        Assert.Equal(8, mesh.Vertices.Count);
        foreach (Vertex v in mesh.Vertices)
        {
            foreach (double x in (double[])[v.Position.X, v.Position.Y, v.Position.Z])
                Assert.Equal(0, x * (1 - x), 1e-12);
        }
        Assert.InRange(result.MaxError, 0, 1e-7);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_FlatSheet_KeepsItsOutline()
    {
        Mesh mesh = Shapes.Sheet(10);

        mesh.Simplify(new() { TargetFaces = 2 });

        Assert.Equal(2, mesh.Faces.Count);
        Assert.Equal(new BoundingBox(new(0, 0, 0), new(1, 1, 0)).Diagonal, mesh.BoundingBox.Diagonal, 1e-9);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    [InlineData(QuadricMode.Textbook)]
    public void Simplify_LockedBoundary_KeepsEveryBoundaryPositionBitForBit(QuadricMode mode)
    {
        Mesh mesh = Wave(16);
        var before = mesh.Vertices.Where(v => v.IsBoundary).Select(v => v.Position).ToHashSet();

        SimplificationResult result = mesh.Simplify(new() { Mode = mode, TargetFaces = 100, Boundary = BoundaryTreatment.Locked });

        Assert.Equal(StopReason.TargetReached, result.StopReason);
        Assert.Equal(before, mesh.Vertices.Where(v => v.IsBoundary).Select(v => v.Position).ToHashSet());
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_LockedBoundaryForbidsTheTarget_SaysSo()
    {
        Mesh mesh = Shapes.Sheet(8);

        SimplificationResult result = mesh.Simplify(new() { TargetFaces = 2, Boundary = BoundaryTreatment.Locked });

        Assert.Equal(StopReason.NothingCollapsible, result.StopReason);
        Assert.True(result.Refusals.Constraint > 0);
        Assert.Equal(32, mesh.Vertices.Count(v => v.IsBoundary));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_Tetrahedron_HasNothingCollapsible()
    {
        Mesh mesh = Shapes.Tetrahedron();
        ulong before = mesh.StateHash();

        SimplificationResult result = mesh.Simplify(new() { TargetFaces = 2 });

        Assert.Equal(StopReason.NothingCollapsible, result.StopReason);
        Assert.Equal(6, result.Refusals.Topology);
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void Simplify_TetrahedraBesideASheet_KeepsTheComponents()
    {
        Mesh mesh = Wave(8);
        for (int i = 0; i < 5; i++)
            mesh.Append(Shapes.Moved(Shapes.Tetrahedron(), p => p * 0.2 + new Vector3D(2 + i, 0, 0)));

        mesh.Simplify(new() { TargetFaces = 25 });

        Assert.Equal(6, Shapes.Components(mesh));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_MaxError_StopsBeforeItIsExceeded()
    {
        Mesh mesh = Shapes.Torus(48, 32);

        SimplificationResult result = mesh.Simplify(new() { MaxError = 0.01 });

        Assert.Equal(StopReason.MaxErrorReached, result.StopReason);
        Assert.InRange(result.MaxError, 0.001, 0.01);
        Assert.InRange(mesh.Faces.Count, 50, 1000);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_NothingMoves_KeepsTheBitsOfUntouchedVertices()
    {
        Mesh mesh = Wave(16);
        var before = mesh.Vertices.Select(v => v.Position).ToHashSet();

        mesh.Simplify(new() { TargetRatio = 0.5, Placement = VertexPlacement.Endpoint });

        Assert.All(mesh.Vertices, v => Assert.Contains(v.Position, before));
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    public void Simplify_AnyNumberOfThreads_GivesTheSameBits(QuadricMode mode)
    {
        Mesh mesh = Shapes.Torus(200, 120);
        var hashes = new List<ulong>();
        foreach (int threads in (int[])[1, 2, 3, 0])
        {
            Mesh copy = mesh.Clone();
            Parallelism.MaxThreads = threads;
            try
            {
                copy.Simplify(new() { TargetRatio = 0.1, Mode = mode });
            }
            finally
            {
                Parallelism.MaxThreads = 0;
            }
            hashes.Add(copy.StateHash());
            Assert.Empty(copy.Validate());
        }
        Assert.Single(hashes.Distinct());
    }

    [Theory]
    [InlineData(1e-6)]
    [InlineData(1e6)]
    public void Simplify_OtherSizes_GiveTheSameConnectivity(double size)
    {
        Mesh mesh = Wave(24), scaled = Shapes.Moved(mesh, p => p * size);

        mesh.Simplify(new() { TargetRatio = 0.2 });
        scaled.Simplify(new() { TargetRatio = 0.2 });

        Assert.Equal(mesh.Target.ToArray(), scaled.Target.ToArray());
        Assert.Equal(mesh.Next.ToArray(), scaled.Next.ToArray());
    }

    [Fact]
    public void Simplify_FarFromTheOrigin_GivesTheSameConnectivity()
    {
        var offset = new Vector3D(1e6, -1e6, 1e6);
        // Positions that survive the sum exactly.
        Mesh mesh = Shapes.Moved(Wave(24), p => p + offset - offset), far = Shapes.Moved(mesh, p => p + offset);

        mesh.Simplify(new() { TargetRatio = 0.2 });
        far.Simplify(new() { TargetRatio = 0.2 });

        Assert.Equal(mesh.Target.ToArray(), far.Target.ToArray());
    }

    [Fact]
    public void Simplify_FeatureAngle_KeepsTheCreasesOfACube()
    {
        Mesh mesh = Shapes.Cube(6);

        mesh.Simplify(new() { TargetFaces = 60, FeatureAngle = Math.PI / 4, AreaWeights = false });

        double length = 0;
        foreach (Edge e in mesh.Edges)
        {
            Vector3D n = Normal(e.Face0), m = Normal(e.Face1);
            if (Vector3D.Dot(n, m) < 0.5)
                length += Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position);
        }
        Assert.Equal(12, length, 1e-9);
        Assert.Empty(mesh.Validate());

        static Vector3D Normal(Face f)
        {
            Vector3D a = f.HalfEdge.Source.Position;
            return Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a).Normalized();
        }
    }

    [Fact]
    public void Simplify_TextureThatIsLinear_StaysLinearOnBothSidesOfASeam()
    {
        Mesh mesh = Wave(16);
        HalfEdgeTrait<Vector2D> texture = mesh.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear);
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            if (!h.IsBoundary)
                texture[h] = new(h.Target.Position.X + (IsRight(h.Face) ? 5 : 0), h.Target.Position.Y);
        }

        mesh.Simplify(new() { TargetRatio = 0.2, Placement = VertexPlacement.Segment, Boundary = BoundaryTreatment.Locked });

        int seamEdges = 0;
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            if (h.IsBoundary)
                continue;
            Vector2D uv = texture[h];
            double jump = uv.X - h.Target.Position.X;
            Assert.True(Math.Abs(jump) < 1e-9 || Math.Abs(jump - 5) < 1e-9, $"{h} has {uv} at {h.Target.Position}");
            Assert.Equal(h.Target.Position.Y, uv.Y, 1e-9);
            Assert.Equal(IsRight(h.Face), jump > 1);
            if (!h.Edge.IsBoundary && IsRight(h.Face) != IsRight(h.Twin.Face))
                seamEdges++;
        }
        Assert.True(seamEdges > 0);
        Assert.Empty(mesh.Validate());

        static bool IsRight(Face f) => f.Vertices.Average(v => v.Position.X) > 0.5;
    }

    [Fact]
    public void Simplify_VertexTraits_AreBlendedWithThePosition()
    {
        Mesh mesh = Wave(16);
        VertexTrait<double> height = mesh.AddVertexTrait("x", 0.0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            height[v] = v.Position.X;

        mesh.Simplify(new() { TargetRatio = 0.2, Placement = VertexPlacement.Segment });

        Assert.All(mesh.Vertices, v => Assert.Equal(v.Position.X, height[v], 1e-9));
    }

    [Fact]
    public void Simplify_TraitWithNaN_LeavesTheConnectivityAlone()
    {
        Mesh plain = Wave(12), marked = Wave(12);
        VertexTrait<double> trait = marked.AddVertexTrait("x", double.NaN, Blend.Linear);
        HalfEdgeTrait<Vector2D> texture = marked.AddHalfEdgeTrait(TraitNames.TextureCoordinate, new Vector2D(double.NaN, double.NaN), Blend.Linear);

        plain.Simplify(new() { TargetRatio = 0.3 });
        marked.Simplify(new() { TargetRatio = 0.3 });

        Assert.Equal(plain.Target.ToArray(), marked.Target.ToArray());
        Assert.Equal(marked.VertexSlots, trait.Count);
        Assert.Equal(marked.HalfEdgeSlots, texture.Count);
    }

    [Fact]
    public void Simplify_FaceLabels_StayWithTheirFacesAndKeepTheirBorder()
    {
        Mesh mesh = Shapes.Sheet(12);
        FaceLabels labels = mesh.GetOrAddFaceLabels("material");
        int left = labels.Number("left"), right = labels.Number("right");
        foreach (Face f in mesh.Faces)
            labels.Labels[f] = f.Vertices.Average(v => v.Position.X) < 0.5 ? left : right;

        mesh.Simplify(new() { TargetFaces = 30 });

        foreach (Face f in mesh.Faces)
            Assert.Equal(f.Vertices.Average(v => v.Position.X) < 0.5 ? "left" : "right", labels.NameOf(f));
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    public void Simplify_LabelOfOneFace_StaysAsFarAsSimplificationGoes(QuadricMode mode)
    {
        foreach (int marked in (int[])[100, 101, 130, 131])
        {
            Mesh mesh = Shapes.Sheet(12);
            FaceLabels labels = mesh.GetOrAddFaceLabels("material");
            int one = labels.Number("one"), rest = labels.Number("rest");
            foreach (Face f in mesh.Faces)
                labels.Labels[f] = f.Index == marked ? one : rest;
            Vector3D[] corners = [.. mesh.Faces[marked].Vertices.Select(v => v.Position)];

            mesh.Simplify(new() { TargetFaces = 1, Mode = mode });

            Face kept = Assert.Single(mesh.Faces, f => labels.NameOf(f) == "one");
            Assert.Equal(corners.ToHashSet(), kept.Vertices.Select(v => v.Position).ToHashSet());
            Assert.Empty(mesh.Validate());
        }
    }

    [Fact]
    public void Simplify_Cancelled_LeavesTheMeshAsItWas()
    {
        Mesh mesh = Shapes.Torus(120, 80);
        ulong before = mesh.StateHash();
        using var source = new CancellationTokenSource();
        var progress = new CancelAt(source, 0.3);

        Assert.ThrowsAny<OperationCanceledException>(() => mesh.Simplify(new() { TargetRatio = 0.1 }, progress, source.Token));

        Assert.Equal(before, mesh.StateHash());
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_WithDeletedElements_GivesTheSameAsAfterCompacting()
    {
        Mesh mesh = Wave(16);
        mesh.AddVertex(new(5, 5, 5));
        Mesh compact = mesh.Clone();
        compact.Compact();

        mesh.Simplify(new() { TargetRatio = 0.3 });
        compact.Simplify(new() { TargetRatio = 0.3 });

        Assert.Equal(compact.StateHash(), mesh.StateHash());
        Assert.Contains(mesh.Vertices, v => v.IsIsolated);
    }

    [Fact]
    public void Simplify_Trace_IsOneLinePerCollapse()
    {
        Mesh mesh = Wave(8);
        using var trace = new StringWriter();

        SimplificationResult result = mesh.Simplify(new() { TargetFaces = 40, Trace = trace });

        string[] lines = trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(result.Collapses, lines.Length);
        Assert.Equal(Enumerable.Range(0, lines.Length), lines.Select(line => System.Text.Json.JsonDocument.Parse(line).RootElement.GetProperty("step").GetInt32()));
    }

    [Fact]
    public void Simplify_BadArguments_AreNamed()
    {
        Mesh mesh = Shapes.Sheet(2), squares = MeshBuilder.FromFaces(4, [0, 1, 2, 3]);

        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { TargetFaces = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { TargetFaces = -5 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { TargetRatio = 1.5 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { TargetRatio = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { MaxError = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadricOptions { FeatureAngle = 0 });
        Assert.Throws<ArgumentException>(() => mesh.Simplify(new()));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Simplify(new() { TargetFaces = 9 }));
        Assert.Throws<ArgumentException>(() => mesh.Simplify(new() { TargetFaces = 4, FeatureEdges = [1000] }));
        ArgumentException polygons = Assert.Throws<ArgumentException>(() => squares.Simplify(new() { TargetFaces = 1 }));
        Assert.Contains("f0", polygons.Message, StringComparison.Ordinal);
        using OperationHistory history = mesh.StartRecording();
        Assert.Throws<InvalidOperationException>(() => mesh.Simplify(new() { TargetFaces = 4 }));
    }

    private sealed class CancelAt(CancellationTokenSource source, double at) : IProgress<double>
    {
        public void Report(double value)
        {
            if (value > at)
                source.Cancel();
        }
    }
}
