using MeshLab.Numerics;
using MeshLab.Segmentation;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Segmentation;

[Trait("Section", "13.3")]
public class KMeansTests
{
    [Fact]
    public void Segment_ComponentsFarApart_AreTheClusters()
    {
        Mesh mesh = Models.Create("tetrahedron");
        Mesh other = mesh.Clone();
        foreach (Vertex v in other.Vertices)
            v.Position += new Vector3D(100, 0, 0);
        mesh.Append(other);

        FaceSegmentation two = KMeans.Segment(mesh, 2);

        Assert.Equal([4, 4], two.Sizes);
        Assert.Single(two.Labels.Take(4).Distinct());
        Assert.Equal(SegmentationStop.Converged, two.StopReason);
    }

    [Fact]
    public void Segment_CubeByNormals_GivesItsSixSides()
    {
        FaceSegmentation sides = KMeans.Segment(Models.Create("cube"), 6, new KMeansOptions { NormalWeight = 100 });

        Assert.All(sides.Sizes, size => Assert.Equal(2, size));
        Assert.Equal(0, KMeans.Segment(Models.Create("cube"), 12).Objective, 12);
    }

    [Theory]
    [InlineData("bumpy-sphere", SeedingMethod.FarthestPoint, 0)]
    [InlineData("bumpy-sphere", SeedingMethod.PlusPlus, 0.5)]
    [InlineData("torus", SeedingMethod.PlusPlus, 0)]
    [InlineData("genus-2", SeedingMethod.FarthestPoint, 1)]
    [InlineData("slivers", SeedingMethod.FarthestPoint, 0)]
    public void Segment_AnyModel_NeverRaisesTheObjective(string model, SeedingMethod seeding, double normalWeight)
    {
        var options = new KMeansOptions { Seeding = seeding, NormalWeight = normalWeight };

        FaceSegmentation result = KMeans.Segment(Models.Create(model), 7, options);

        for (int i = 1; i < result.History.Count; i++)
            Assert.True(result.History[i] <= result.History[i - 1] * (1 + 1e-12), $"round {i}");
        Assert.All(result.Sizes, size => Assert.True(size > 0));
    }

    [Fact]
    public void Segment_OneAndManyThreads_GiveTheSameBits()
    {
        Mesh mesh = Models.Create("bipyramid-1200");
        FaceSegmentation many = KMeans.Segment(mesh, 9);
        int before = Parallelism.MaxThreads;
        Parallelism.MaxThreads = 1;
        FaceSegmentation one = KMeans.Segment(mesh, 9);
        Parallelism.MaxThreads = before;

        Assert.Equal(one.Labels, many.Labels);
        Assert.Equal(BitConverter.DoubleToInt64Bits(one.Objective), BitConverter.DoubleToInt64Bits(many.Objective));
    }

    [Fact]
    public void Segment_Connect_LeavesOnePiecePerCluster()
    {
        Mesh mesh = Models.Create("torus");

        FaceSegmentation result = KMeans.Segment(mesh, 5, new KMeansOptions { Connect = true, NormalWeight = 1 });

        Relabeling.Pieces(mesh, result.Labels, out int pieces);
        Assert.Equal(result.Count, pieces);
    }

    [Fact]
    public void JoinStrayPieces_TwoOfThemAloneOnAComponent_JoinAndEnd()
    {
        Mesh mesh = Models.Create("tetrahedron");
        Mesh smaller = mesh.Clone();
        foreach (Vertex v in smaller.Vertices)
            v.Position = v.Position * 0.5 + new Vector3D(100, 0, 0);
        mesh.Append(smaller);
        int[] labels = [0, 0, 1, 1, 0, 0, 1, 1];

        Relabeling.JoinStrayPieces(mesh, labels, [.. mesh.Faces.Select(f => f.Index < 4 ? 1.0 : 0.25)]);

        Assert.Equal([0, 0, 1, 1, 1, 1, 1, 1], labels);
    }

    [Fact]
    public void Segment_BadInput_IsRefused()
    {
        Mesh mesh = Models.Create("tetrahedron");
        Assert.Throws<ArgumentException>(() => KMeans.Segment(mesh, 5));
        Assert.Throws<ArgumentOutOfRangeException>(() => KMeans.Segment(mesh, 0));
        Assert.Throws<ArgumentException>(() => KMeans.Segment(mesh, 2, new KMeansOptions { Seeds = [0, 0] }));
        Assert.Throws<ArgumentException>(() => KMeans.Segment(mesh, 2, new KMeansOptions { Seeds = [0, 99] }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new KMeansOptions { NormalWeight = -1 });
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();
        Assert.Throws<OperationCanceledException>(() => KMeans.Segment(mesh, 2, cancellationToken: cancelled.Token));
    }
}
