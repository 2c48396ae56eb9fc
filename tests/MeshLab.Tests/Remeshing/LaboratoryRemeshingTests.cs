using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using MeshLab.Tests.Spatial;
using Xunit;

namespace MeshLab.Tests.Remeshing;

[Trait("Section", "L4")]
public class LaboratoryRemeshingTests
{
    private static Mesh MeshOf(TriangleSoups.Soup soup) => MeshBuilder.FromTriangles(soup.Positions, soup.Corners);

    private static int Euler(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.6)]
    public void RemeshInLaboratory_Sphere_HasTheEdgeLengthsOfTheScript(double relative)
    {
        Mesh mesh = MeshOf(TriangleSoups.Sphere(24));
        double length = relative * mesh.Edges.Average(e => (e.Vertex0.Position - e.Vertex1.Position).Length);

        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { EdgeLength = length });

        Assert.Empty(mesh.Validate());
        Assert.Equal(2, Euler(mesh));
        Assert.Equal(length, result.EdgeLength);
        // Flips and smoothing come after the lengths, so a few edges leave the range again.
        double[] lengths = [.. mesh.Edges.Select(e => (e.Vertex0.Position - e.Vertex1.Position).Length / length)];
        Assert.InRange(lengths.Count(l => l is > 0.8 * 0.8 and < 4.0 / 3 * 1.25), 0.97 * lengths.Length, lengths.Length);
        RemeshingQuality quality = RemeshingQuality.Of(mesh);
        Assert.InRange(quality.MeanSmallestAngle * 180 / Math.PI, 44, 60);
        Assert.InRange(quality.Valence567, 0.95, 1);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void RemeshInLaboratory_AnyModel_KeepsTopology(string name)
    {
        if (name == "slivers")
            return; // thousands of pieces; the other tests have slivers enough
        Mesh mesh = Models.Create(name);
        int euler = Euler(mesh);
        bool closed = mesh.IsClosed;
        mesh.RemeshInLaboratory();
        Assert.Empty(mesh.Validate());
        Assert.Equal(euler, Euler(mesh));
        Assert.Equal(closed, mesh.IsClosed);
    }

    [Fact]
    public void RemeshInLaboratory_Recorded_CanBeUndone()
    {
        Mesh mesh = MeshOf(TriangleSoups.Sphere(8));
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 2 });
        Assert.True(result.Splits + result.Collapses + result.Flips > 0);
        Assert.NotEqual(before, mesh.StateHash());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void RemeshInLaboratory_BadInputAndCancelled_LeaveAValidMesh()
    {
        Assert.Throws<ArgumentException>("mesh", () => Models.Create("cube-quads").RemeshInLaboratory());
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { SmoothingWeight = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { EdgeLength = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { Passes = 0 });
        Mesh mesh = MeshOf(TriangleSoups.Sphere(8));
        Assert.Throws<OperationCanceledException>(() => mesh.RemeshInLaboratory(null, null, new CancellationToken(true)));
        Assert.Empty(mesh.Validate());
    }
}
