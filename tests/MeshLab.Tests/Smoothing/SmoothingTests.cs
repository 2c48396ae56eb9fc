using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Smoothing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Smoothing;

/// <summary>What all ways of smoothing promise.</summary>
[Trait("Section", "L")]
public class SmoothingTests
{
    public delegate SmoothingResult Smoother(
        Mesh mesh, int steps, SmoothingBoundary boundary, IProgress<double>? progress = null, CancellationToken cancellationToken = default);

    private static readonly Dictionary<string, Smoother> Ways = new(StringComparer.Ordinal)
    {
        ["uniform"] = (mesh, steps, boundary, progress, token) =>
            mesh.SmoothUniformly(new UniformSmoothingOptions { Steps = steps, Boundary = boundary }, progress, token),
        ["cotangent"] = (mesh, steps, boundary, progress, token) =>
            mesh.SmoothByCotangents(new CotangentSmoothingOptions { Steps = steps, Boundary = boundary }, progress, token),
        ["taubin"] = (mesh, steps, boundary, progress, token) =>
            mesh.SmoothByTaubin(new TaubinSmoothingOptions { Steps = steps, Boundary = boundary }, progress, token),
        ["implicit"] = (mesh, steps, boundary, progress, token) =>
            mesh.SmoothImplicitly(new ImplicitSmoothingOptions { Steps = steps, Boundary = boundary }, progress, token),
    };

    public static TheoryData<string> WayNames => new(Ways.Keys);

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_AnyTriangleMesh_StaysValidAndFixesTheBoundary(string way)
    {
        foreach (string name in Models.Names.Where(n => Models.Create(n).IsTriangleMesh))
        {
            Mesh mesh = Models.Create(name);
            Vector3D[] before = mesh.Positions.ToArray();

            Ways[way](mesh, 3, SmoothingBoundary.Fixed);

            Assert.Empty(mesh.Validate());
            foreach (Vertex v in mesh.Vertices.Where(v => v.IsBoundary || v.IsIsolated))
                Assert.Equal(before[v.Index], v.Position);
        }
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_AnyWay_ReportsRisingSharesUpToOne(string way)
    {
        var reports = new Reports();
        Ways[way](Models.Create("bumpy-sphere"), 4, SmoothingBoundary.Fixed, reports);
        Assert.Equal(reports.Shares.Order(), reports.Shares);
        Assert.True(reports.Shares.Count >= 4 && reports.Shares[0] is > 0 and <= 0.25);
        Assert.Equal(1, reports.Shares[^1]);
    }

    private sealed class Reports : IProgress<double>
    {
        public List<double> Shares { get; } = [];

        public void Report(double value) => Shares.Add(value);
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_NoisySphere_EvensTheRadius(string way)
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        double before = Spread(mesh);

        SmoothingResult result = Ways[way](mesh, 3, SmoothingBoundary.Fixed);

        Assert.Equal(3, result.Steps);
        Assert.InRange(result.LargestMove, 1e-3, 1);
        Assert.InRange(result.MeanMove, 1e-4, result.LargestMove);
        Assert.InRange(Spread(mesh), 0, 0.8 * before);

        static double Spread(Mesh mesh)
        {
            double[] r = [.. mesh.Vertices.Select(v => v.Position.Length)];
            double mean = r.Average();
            return Math.Sqrt(r.Average(x => (x - mean) * (x - mean))) / mean;
        }
    }

    [Theory]
    [InlineData("uniform", 0.5, 0.95)]
    [InlineData("cotangent", 0.5, 0.95)]
    [InlineData("implicit", 0, 0.95)]
    [InlineData("taubin", 0.97, 1.03)]
    public void Smooth_Sphere_ShrinksUnlessTaubin(string way, double least, double most)
    {
        Mesh mesh = Models.Sphere(20, 24);
        double before = Volume(mesh);

        Ways[way](mesh, 10, SmoothingBoundary.Fixed);

        Assert.InRange(Volume(mesh) / before, least, most);
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_BoundaryRules_MoveTheBoundaryAsTheySay(string way)
    {
        Mesh fixedMesh = Models.Create("annulus"), curve = Models.Create("annulus"), free = Models.Create("annulus");
        Ways[way](fixedMesh, 2, SmoothingBoundary.Fixed);
        Ways[way](curve, 2, SmoothingBoundary.AlongCurve);
        Ways[way](free, 2, SmoothingBoundary.Free);

        // All vertices are on the two circles.
        Assert.Equal(0, Models.Create("annulus").Vertices.Max(v => Vector3D.Distance(v.Position, fixedMesh.Vertices[v.Index].Position)));
        // As curves both circles shrink and stay circles.
        Assert.All(curve.Vertices.Take(12), v => Assert.Equal(curve.Vertices[0].Position.Length, v.Position.Length, 1e-12));
        Assert.True(way == "taubin" || curve.Vertices[0].Position.Length < 1);
        Assert.True(way == "taubin" || curve.Vertices[12].Position.Length < 0.5);
        // With the surface the inner circle is pulled outwards.
        Assert.True(free.Vertices[12].Position.Length > curve.Vertices[12].Position.Length);
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_ThreadsAndRepetition_GiveTheSameBits(string way)
    {
        int threads = Parallelism.MaxThreads;
        try
        {
            Mesh many = Models.Sphere(80, 90), one = Models.Sphere(80, 90);
            Ways[way](many, 2, SmoothingBoundary.Free);
            Parallelism.MaxThreads = 1;
            Ways[way](one, 2, SmoothingBoundary.Free);
            Assert.Equal(one.StateHash(), many.StateHash());
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_Cancelled_LeavesTheMeshAsItWas(string way)
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        ulong before = mesh.StateHash();
        using var source = new CancellationTokenSource();

        Assert.Throws<OperationCanceledException>(
            () => Ways[way](mesh, 10, SmoothingBoundary.Fixed, new AtHalf(source), source.Token));

        Assert.Equal(before, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_WithHistory_CanBeUndone(string way)
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();

        Ways[way](mesh, 2, SmoothingBoundary.Fixed);

        Assert.NotEqual(before, mesh.StateHash());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_NoSteps_ChangesNothing(string way)
    {
        Mesh mesh = Models.Create("holes");
        ulong before = mesh.StateHash();
        Assert.Equal(new SmoothingResult(0, 0, 0), Ways[way](mesh, 0, SmoothingBoundary.Free));
        Assert.Equal(before, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(WayNames))]
    public void Smooth_FacesWithoutArea_StaysFinite(string way)
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 1, 0), new(1, 0, 0)], [0, 1, 2, 1, 0, 3]);
        foreach (SmoothingBoundary boundary in Enum.GetValues<SmoothingBoundary>())
        {
            Ways[way](mesh, 2, boundary);
            Assert.All(mesh.Vertices, v => Assert.True(v.Position.IsFinite));
        }
    }

    [Fact]
    public void Smooth_Polygons_OnlyWithEqualWeights()
    {
        Mesh mesh = Models.Create("mixed-polygons");
        mesh.SmoothUniformly();
        mesh.SmoothByTaubin();
        Assert.Throws<ArgumentException>(() => mesh.SmoothByCotangents());
        Assert.Throws<ArgumentException>(() => mesh.SmoothImplicitly());
    }

    [Fact]
    public void Options_OutOfRange_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new UniformSmoothingOptions { Steps = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new UniformSmoothingOptions { Factor = 1.5 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new CotangentSmoothingOptions { Factor = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new TaubinSmoothingOptions { PassBand = 1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ImplicitSmoothingOptions { Time = double.NaN });
        Assert.Throws<ArgumentException>(() => Models.Tetrahedron().SmoothImplicitly(new ImplicitSmoothingOptions { Weights = LaplacianWeights.MeanValue }));
    }

    [Fact]
    public void SmoothByCotangents_Octahedron_GoesHalfWayToTheMiddle()
    {
        // Every vertex of the octahedron has its four neighbours around the centre.
        Mesh mesh = Models.Create("octahedron");
        mesh.SmoothByCotangents(new CotangentSmoothingOptions { Steps = 1 });
        Assert.All(mesh.Vertices, v => Assert.Equal(0.5, v.Position.Length, 1e-15));
    }

    [Fact]
    public void SmoothUniformly_Octahedron_GoesHalfWayToTheMiddle()
    {
        // Every vertex of the octahedron has its four neighbours around the centre.
        Mesh mesh = Models.Create("octahedron");
        mesh.SmoothUniformly(new UniformSmoothingOptions { Steps = 1 });
        Assert.All(mesh.Vertices, v => Assert.Equal(0.5, v.Position.Length, 1e-15));
    }

    [Fact]
    public void SmoothByTaubin_Octahedron_ScalesByTheTransferFunction()
    {
        // The octahedron is a wave of frequency k = 1: each step multiplies it by (1 − λ)(1 − μ).
        Mesh mesh = Models.Create("octahedron");
        var options = new TaubinSmoothingOptions { Steps = 2 };
        mesh.SmoothByTaubin(options);
        double factor = Math.Pow((1 - options.Lambda) * (1 - options.Mu), 2);
        Assert.All(mesh.Vertices, v => Assert.Equal(factor, v.Position.Length, 1e-14));
    }

    [Fact]
    public void SmoothByTaubin_Options_FollowTheirEquation()
    {
        var options = new TaubinSmoothingOptions { Lambda = 0.33, PassBand = 0.1 };
        Assert.Equal(options.PassBand, 1 / options.Lambda + 1 / options.Mu, 1e-12);
        Assert.True(options.Mu < -options.Lambda);
    }

    [Theory]
    [InlineData(LaplacianWeights.Cotangent)]
    [InlineData(LaplacianWeights.Uniform)]
    public void SmoothImplicitly_ComponentWithoutArea_StaysAndTheOtherMovesAsIfAlone(LaplacianWeights weights)
    {
        var options = new ImplicitSmoothingOptions { Weights = weights, Boundary = SmoothingBoundary.Free, Steps = 2 };
        Vector3D[] square = [new(0, 0, 0), new(2, 0, 0), new(2, 1, 0), new(0, 1, 1)];
        Mesh alone = MeshBuilder.FromTriangles([.. square, new(5, 0, 0)], [0, 1, 2, 0, 2, 3]);
        Mesh both = MeshBuilder.FromTriangles([.. square, new(5, 0, 0), new(6, 0, 0), new(7, 0, 0)], [0, 1, 2, 0, 2, 3, 4, 5, 6]);
        both.SmoothImplicitly(options);
        Assert.Equal([new(5, 0, 0), new(6, 0, 0), new(7, 0, 0)], both.Positions[4..].ToArray());

        // The step is so many mean cell areas long: three more vertices without area make it that much shorter.
        alone.SmoothImplicitly(options with { Time = options.Time * 4 / 7 });
        Assert.All(alone.Vertices, v => Assert.True(Vector3D.Distance(v.Position, both.Positions[v.Index]) < 1e-14));
    }

    [Fact]
    public void SmoothImplicitly_RegularTetrahedron_ShrinksByTheExactFactor()
    {
        // Coordinates are an eigenvector: L x = 4/√3 x, M = a I with a the mean area, so x' = x / (1 + 4/√3).
        Mesh mesh = Models.Tetrahedron();
        mesh.SmoothImplicitly();
        Assert.All(mesh.Vertices, v => Assert.Equal(Math.Sqrt(3) / (1 + 4 / Math.Sqrt(3)), v.Position.Length, 1e-14));
    }

    [Fact]
    public void SmoothByCotangents_FlatGrid_MovesNothingButUniformDoes()
    {
        Mesh Distorted()
        {
            Mesh mesh = Models.Create("grid");
            foreach (ref Vector3D p in mesh.Positions)
                p = new(p.X + 0.2 * p.X * (1 - p.X), p.Y, 0);
            return mesh;
        }
        Assert.InRange(Distorted().SmoothUniformly(new UniformSmoothingOptions { Steps = 1 }).LargestMove, 1e-3, 1);
        Assert.InRange(Distorted().SmoothImplicitly().LargestMove, 0, 1e-14);
        Assert.InRange(Distorted().SmoothByCotangents(new CotangentSmoothingOptions { Steps = 1 }).LargestMove, 0, 1e-14);
    }

    private static double Volume(Mesh mesh) => mesh.Faces.Sum(f => Vector3D.Determinant(
        f.HalfEdge.Source.Position, f.HalfEdge.Target.Position, f.HalfEdge.Next.Target.Position)) / 6;

    private sealed class AtHalf(CancellationTokenSource source) : IProgress<double>
    {
        public void Report(double value)
        {
            if (value >= 0.5)
                source.Cancel();
        }
    }
}
