using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class FitSurfaceTests
{
    /// <summary>The surface of a mesh that nothing was taken from, in working units.</summary>
    internal static FitSurface SurfaceOf(Mesh mesh)
    {
        var surface = new FitSurface(new CompactResult(mesh, new WorkingMesh(mesh)));
        surface.UpdateNormals();
        return surface;
    }

    /// <summary>One point for each region of the plane around a triangle.</summary>
    [Theory]
    [InlineData(1, 1, 3, 0.5, 0.25, 0.25, 9)]
    [InlineData(-1, -1, 2, 1, 0, 0, 6)]
    [InlineData(6, -1, 0, 0, 1, 0, 5)]
    [InlineData(-1, 7, 1, 0, 0, 1, 11)]
    [InlineData(1, -2, 2, 0.75, 0.25, 0, 8)]
    [InlineData(-3, 2, 0, 0.5, 0, 0.5, 9)]
    [InlineData(4, 4, 1, 0, 0.5, 0.5, 9)]
    public void Closest_PointOfEachRegion_HasTheWeightsOfItsFoot(double x, double y, double z, double a, double b, double c, double squared)
    {
        double found = PointOnTriangle.Closest(new(x, y, z), default, new(4, 0, 0), new(0, 4, 0), out Vector3D weights);

        Assert.Equal((squared, new(a, b, c)), (found, weights));
    }

    /// <summary>A flat sheet has no dead ends.</summary>
    [Fact]
    public void Walk_OverAFlatSheet_FindsTheClosestFaceFromEverywhere()
    {
        FitSurface surface = SurfaceOf(Shapes.Sheet(3));
        var random = new Random(7);
        for (int i = 0; i < 40; i++)
        {
            Vector3D point = new(1.6 * random.NextDouble() - 0.8, 1.6 * random.NextDouble() - 0.8, 0.2);
            double least = Enumerable.Range(0, surface.FaceCount).Min(f => surface.DistanceSquared(f, point, out _));
            for (int start = 0; start < surface.FaceCount; start++)
            {
                int face = start;
                double distance = surface.Walk(point, ref face, out Vector3D weights);

                Assert.Equal(least, distance, 1e-14);
                Assert.Equal(distance, surface.DistanceSquared(face, point, out Vector3D expected));
                Assert.Equal(expected, weights);
            }
        }
    }

    [Fact]
    public void SearchRing_CornerOfTheBorder_LooksAtItsFacesAndKeepsWhatIsCloser()
    {
        Mesh mesh = Shapes.Sheet(2);
        FitSurface surface = SurfaceOf(mesh);
        // The lower left corner has two faces.
        Vector3D point = surface.Positions[0] + new Vector3D(0.05, 0.01, 0.1);
        Face below = mesh.FindHalfEdge(mesh.Vertices[0], mesh.Vertices[1]).Face;
        double distance = double.MaxValue;
        int face = -1;

        surface.SearchRing(0, point, ref distance, ref face);
        Assert.Equal(below.Index, face);
        Assert.Equal(0.01, distance, 1e-15);

        (distance, face) = (0.005, 5);
        surface.SearchRing(0, point, ref distance, ref face);
        Assert.Equal((0.005, 5), (distance, face));
    }
}
