using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Spatial;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Spatial;
using Xunit;

namespace MeshLab.Tests.Remeshing;

[Trait("Section", "L4")]
public class IsotropicRemeshingTests
{
    private static Mesh Sphere(int n = 24) => MeshOf(TriangleSoups.Sphere(n));

    private static Mesh MeshOf(TriangleSoups.Soup soup) => MeshBuilder.FromTriangles(soup.Positions, soup.Corners);

    private static int Euler(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    [Theory]
    [InlineData(0.5)]
    [InlineData(1)]
    [InlineData(2)]
    public void Remesh_Sphere_IsRegularAndOnTheSphere(double relative)
    {
        Mesh input = Sphere(40);
        RemeshingResult result = input.RemeshIsotropically(new() { RelativeLength = relative, Passes = 8 });
        Mesh mesh = result.Mesh;

        Assert.Empty(mesh.Validate());
        Assert.Equal(2, Euler(mesh));
        RemeshingQuality quality = RemeshingQuality.Of(mesh);
        // A sphere of meridians is regular but uneven, and valences leave little to flip.
        Assert.InRange(quality.MeanSmallestAngle * 180 / Math.PI, 45, 60);
        Assert.InRange(quality.SmallestAngle * 180 / Math.PI, 25, 60);
        Assert.InRange(quality.Valence567, 0.99, 1);
        Assert.All(mesh.Vertices, v => Assert.Equal(1, v.Position.Length, 4e-3));
        Assert.Equal(result.EdgeLength, mesh.Edges.Average(e => (e.Vertex0.Position - e.Vertex1.Position).Length), 0.1 * result.EdgeLength);
        Assert.Empty(FaceTree.Build(mesh).FindSelfIntersections());
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Remesh_AnyModel_KeepsTopologyAndInput(string name)
    {
        Mesh input = Models.Create(name);
        ulong before = input.StateHash();
        foreach (double relative in new[] { 0.4, 1, 2.5 })
        {
            foreach (double angle in new[] { Math.PI, 0.7 })
            {
                Mesh mesh = input.RemeshIsotropically(new() { RelativeLength = relative, FeatureAngle = angle, Passes = 3 }).Mesh;
                Assert.Empty(mesh.Validate());
                Assert.Equal(Euler(input), Euler(mesh));
                Assert.Equal(input.IsClosed, mesh.IsClosed);
            }
        }
        Assert.Equal(before, input.StateHash());
    }

    [Theory]
    [InlineData(0.3)]
    [InlineData(1)]
    [InlineData(3)]
    public void Remesh_Square_KeepsCornersBoundaryAndArea(double length)
    {
        Mesh mesh = MeshOf(TriangleSoups.Grid(12)).RemeshIsotropically(new() { EdgeLength = length }).Mesh;
        Assert.Empty(mesh.Validate());
        foreach (Vector3D corner in new Vector3D[] { new(0, 0, 0), new(12, 0, 0), new(0, 12, 0), new(12, 12, 0) })
            Assert.Contains(mesh.Vertices, v => v.Position == corner);
        Assert.Equal(48, mesh.Edges.Where(e => e.IsBoundary).Sum(e => (e.Vertex0.Position - e.Vertex1.Position).Length), 1e-9);
        Assert.Equal(144, mesh.Faces.Sum(f => SignedArea(f)), 1e-8);
        Assert.All(mesh.Faces, f => Assert.True(SignedArea(f) > 0));
    }

    [Fact]
    public void Remesh_CubeWithFeatures_StaysACube()
    {
        RemeshingResult result = Models.Create("cube").RemeshIsotropically(new() { EdgeLength = 0.15, FeatureAngle = 0.7, Passes = 6 });
        Mesh mesh = result.Mesh;
        Assert.Empty(mesh.Validate());
        Assert.Equal((12, 8), (result.FeatureEdges, result.Corners));
        BoundingBox box = Models.Create("cube").BoundingBox;
        Assert.Equal(box.Size.X * box.Size.Y * box.Size.Z, mesh.Faces.Sum(f => Volume(f)), 1e-10);
        for (int i = 0; i < 8; i++)
            Assert.Contains(mesh.Vertices, v => v.Position == box.Corner(i));
        Assert.InRange(RemeshingQuality.Of(mesh).MeanSmallestAngle * 180 / Math.PI, 47, 60);
    }

    /// <summary>The border of a disc is a line without corners: its vertices slide, but not off.</summary>
    [Theory]
    [InlineData(0.5)]
    [InlineData(2)]
    public void Remesh_Disc_KeepsItsRim(double relative)
    {
        Mesh input = RemeshSurfaces.Fan(default, RemeshSurfaces.Polygon(36)).Subdivide(SubdivisionScheme.Midpoint, new() { Steps = 2 });
        RemeshingResult result = input.RemeshIsotropically(new() { RelativeLength = relative, Passes = 6 });
        Assert.Empty(result.Mesh.Validate());
        Assert.Equal(0, result.Corners);
        SegmentTree rim = SegmentTree.Build(input.Positions, [.. input.Edges.Where(e => e.IsBoundary).SelectMany(e => new[] { e.Vertex0.Index, e.Vertex1.Index })]);
        Assert.All(result.Mesh.Vertices.Where(v => v.IsBoundary), v => Assert.True(rim.IsWithin(v.Position, 1e-10), $"{v}"));
        Assert.InRange(result.Mesh.Faces.Sum(SignedArea) / input.Faces.Sum(SignedArea), 1 - 1e-3, 1 + 1e-10);
        // And they do slide: edges along the rim are even.
        double[] lengths = [.. result.Mesh.Edges.Where(e => e.IsBoundary).Select(e => (e.Vertex0.Position - e.Vertex1.Position).Length)];
        Assert.InRange(lengths.Max() / lengths.Min(), 1, 2.1);
    }

    /// <summary>Folds hardly sharper than the feature angle, on a rough sheet: all of them are features of the result too.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Remesh_FoldsAtTheFeatureAngle_StaySharp(int seed)
    {
        const double Angle = 0.33;
        Mesh input = RemeshSurfaces.Sheet(14, seed, 0.4, x => 0.4 * Math.Max(0, Math.Abs(x - 7) - 3));
        var random = new Random(seed);
        foreach (Vertex v in input.Vertices)
            v.Position += new Vector3D(0, 0, 0.06 * random.NextDouble());
        foreach (double relative in new[] { 0.7, 1.4 })
        {
            RemeshingResult result = input.RemeshIsotropically(new() { RelativeLength = relative, FeatureAngle = Angle });
            Assert.Empty(result.Mesh.Validate());
            Assert.InRange(result.FeatureEdges, 10, 28);
            FeatureChecks.AssertOnFeatures(input, result.Mesh, Angle);
        }
    }

    [Fact]
    public void Remesh_Needle_DoesNotFillItWithFans()
    {
        // Two triangles of 1000 × 0.001: halving makes n^1.6 pieces of them, fans would make a million.
        Mesh needle = MeshBuilder.FromTriangles([new(0, 0, 0), new(1000, 0, 0), new(1000, 1e-3, 0), new(0, 1e-3, 0)], [0, 1, 2, 0, 2, 3]);
        RemeshingResult result = needle.RemeshIsotropically(new() { EdgeLength = 1, Passes = 2 });
        Assert.Empty(result.Mesh.Validate());
        Assert.InRange(result.Splits, 1000, 100_000);
    }

    [Fact]
    public void Remesh_CurvatureTolerance_MakesShorterEdgesWhereItIsCurved()
    {
        // An ellipsoid with half axes 3, 1, 1: most curved at the tips.
        TriangleSoups.Soup soup = TriangleSoups.Sphere(40);
        Mesh input = MeshOf(soup with { Positions = [.. soup.Positions.Select(p => new Vector3D(p.X, p.Y, 3 * p.Z))] });
        Mesh mesh = input.RemeshIsotropically(new() { EdgeLength = 0.4, CurvatureTolerance = 0.03 }).Mesh;
        Assert.Empty(mesh.Validate());
        double tip = MeanLength(e => Math.Abs(e.Vertex0.Position.Z) > 2.7), belly = MeanLength(e => Math.Abs(e.Vertex0.Position.Z) < 0.5);
        Assert.InRange(tip, 0.02, 0.7 * belly);

        double MeanLength(Func<Edge, bool> chosen) => mesh.Edges.Where(chosen).Average(e => (e.Vertex0.Position - e.Vertex1.Position).Length);
    }

    [Fact]
    public void Remesh_ThreadsAndRuns_GiveTheSameBits()
    {
        Mesh input = Sphere(50);
        foreach (RemeshingOptions options in new RemeshingOptions[] { new() { RelativeLength = 0.7 }, new() { HighQuality = true, FeatureAngle = 0.3 } })
        {
            ulong expected = input.RemeshIsotropically(options).Mesh.StateHash();
            try
            {
                Parallelism.MaxThreads = 1;
                Assert.Equal(expected, input.RemeshIsotropically(options).Mesh.StateHash());
                Parallelism.MaxThreads = 3;
                Assert.Equal(expected, input.RemeshIsotropically(options).Mesh.StateHash());
            }
            finally
            {
                Parallelism.MaxThreads = 0;
            }
        }
    }

    [Theory]
    [InlineData(1e-6)]
    [InlineData(1e6)]
    public void Remesh_OtherSize_GivesTheSameConnectivity(double scale)
    {
        // Random places, so that no two lengths are equal but for rounding.
        TriangleSoups.Soup soup = TriangleSoups.Sphere(20);
        var random = new Random(1);
        soup = soup with { Positions = [.. soup.Positions.Select(p => p + TriangleSoups.Point(random) * 0.02)] };
        Mesh one = MeshOf(soup).RemeshIsotropically().Mesh, other = MeshOf(soup.Moved(scale, default)).RemeshIsotropically().Mesh;
        Assert.Equal(one.Target.ToArray(), other.Target.ToArray());
        Mesh far = MeshOf(soup.Moved(1, new(1e6, -1e6, 1e6))).RemeshIsotropically().Mesh;
        Assert.Equal(one.Target.ToArray(), far.Target.ToArray());
    }

    [Fact]
    public void Remesh_WithoutProjection_LeavesTheSurface()
    {
        Mesh input = Sphere(16);
        Mesh with = input.RemeshIsotropically(new() { Passes = 10 }).Mesh, without = input.RemeshIsotropically(new() { Passes = 10, Projection = false }).Mesh;
        // Places are rounded to 2⁻³⁶ of the diagonal.
        Assert.InRange(with.VertexDistancesTo(input).Max(), 0, 1e-10);
        Assert.InRange(without.VertexDistancesTo(input).Max(), 1e-3, 1);
    }

    [Fact]
    public void Remesh_Cancelled_ThrowsAndLeavesTheInput()
    {
        Mesh input = Sphere();
        ulong before = input.StateHash();
        using var source = new CancellationTokenSource();
        var progress = new Reporter(share =>
        {
            if (share > 0.3)
                source.Cancel();
        });
        Assert.Throws<OperationCanceledException>(() => input.RemeshIsotropically(null, progress, source.Token));
        Assert.Equal(before, input.StateHash());
    }

    [Fact]
    public void Remesh_BadInput_NamesIt()
    {
        Assert.Throws<ArgumentException>("mesh", () => Models.Create("cube-quads").RemeshIsotropically());
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { EdgeLength = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { EdgeLength = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { RelativeLength = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { Passes = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { FeatureAngle = 4 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { CurvatureTolerance = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { SmallestRelativeLength = 2 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RemeshingOptions { FaceBudget = 0 });
        // A unit cube has six squares, in triangles of side 0.1 about 1386.
        Mesh cube = Models.Create("cube");
        Assert.Contains("1.39E+03 faces; the budget is 1380", Assert.Throws<ArgumentException>("options", () => cube.RemeshIsotropically(new() { EdgeLength = 0.1, FaceBudget = 1380 })).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>("options", () => cube.RemeshIsotropically(new() { EdgeLength = 1e-9 }));
        Assert.Throws<ArgumentException>("options", () => cube.RemeshInLaboratory(new() { EdgeLength = 1e-9 }));
        Assert.Equal(0, new Mesh().RemeshIsotropically().Mesh.Faces.Count);
    }

    [SkippableFact]
    [Trait("Speed", "Slow")]
    public void Remesh_StanfordBunny_IsBetterThanTheReference()
    {
        Mesh input = ReferenceMesh.Load("stanford_bunny");
        Mesh mesh = input.RemeshIsotropically().Mesh;
        RemeshingQuality quality = RemeshingQuality.Of(mesh);
        MeshDistanceReport distance = input.DistanceTo(mesh);
        Assert.Empty(mesh.Validate());
        Assert.InRange(mesh.Faces.Count, 60_000, input.Faces.Count);
        Assert.InRange(quality.MeanSmallestAngle * 180 / Math.PI, 46.5, 60);
        Assert.InRange(quality.Valence6, 0.80, 1);
        Assert.InRange(quality.Valence567, 0.995, 1);
        Assert.InRange(distance.Rms / distance.Diagonal, 0, 1.08e-4);
        Assert.InRange(distance.Hausdorff / distance.Diagonal, 0, 2.9e-3);
        Assert.False(FaceTree.Build(mesh).HasSelfIntersections());
    }

    private static double SignedArea(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position).Z / 2;
    }

    private static double Volume(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Determinant(h.Source.Position, h.Target.Position, h.Next.Target.Position) / 6;
    }

    private sealed class Reporter(Action<double> report) : IProgress<double>
    {
        public void Report(double value) => report(value);
    }
}
