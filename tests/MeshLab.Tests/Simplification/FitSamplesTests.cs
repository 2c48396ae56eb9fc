using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class FitSamplesTests
{
    private static FaceSums[] Project(Mesh mesh, FitSurface surface, int[] survivors) =>
        new FitSamples(mesh, new WorkingMesh(mesh).Positions, survivors, surface).Project().Items;

    private static int[] Themselves(Mesh mesh) => [.. Enumerable.Range(0, mesh.VertexSlots).Select(v => mesh.Outgoing[v] < 0 ? -1 : v)];

    /// <summary>Centroids lie in the middle of their faces with three quarters of the area, vertices at corners with the rest.</summary>
    [Fact]
    public void Project_OnTheOriginalItself_WeighsByAreaAndFindsNoDistance()
    {
        Mesh mesh = Shapes.Torus(12, 8);
        FitSurface surface = FitSurfaceTests.SurfaceOf(mesh);

        FaceSums[] sums = Project(mesh, surface, Themselves(mesh));

        double area = 0, diagonal = 0;
        for (int f = 0; f < sums.Length; f++)
        {
            double own = surface.DoubledArea(f).Length / 2;
            area += own;
            diagonal += sums[f].M00 + sums[f].M11 + sums[f].M22;
            foreach (double mixed in (double[])[sums[f].M01, sums[f].M02, sums[f].M12])
                Assert.Equal(0.75 * own / 9, mixed, 1e-8);
            Assert.Equal(0, sums[f].Largest, 1e-30);
        }
        Assert.Equal(0.75 * area / 3 + 0.25 * area, diagonal, 1e-6);
        Assert.Equal(area, new FitSamples(mesh, new WorkingMesh(mesh).Positions, Themselves(mesh), surface).TotalWeight, 1e-6);
    }

    [Fact]
    public void Project_OriginalAboveTheResult_PullsItUp()
    {
        Mesh mesh = Shapes.Sheet(4);
        FitSurface surface = FitSurfaceTests.SurfaceOf(mesh);
        for (int v = 0; v < surface.VertexCount; v++)
            surface.Positions[v] -= new Vector3D(0, 0, 0.125);

        FaceSums[] sums = Project(mesh, surface, Themselves(mesh));

        // Half of the square of diagonal 1 in working units.
        Assert.Equal(0.5 * 0.125, sums.Sum(s => s.G0 + s.G1 + s.G2), 1e-7);
        Assert.Equal(0.5 * 0.125 * 0.125, sums.Sum(s => s.Energy), 1e-7);
        Assert.All(sums, s => Assert.True(s.Largest is 0 or 0.015625));
    }

    /// <summary>From the other of two parts no walk comes back; who is far away compared with the rest is looked up.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(5)]
    public void Project_VerticesThatSeemToHaveGoneToAnotherPart_AreFoundAgain(int count)
    {
        Mesh mesh = Shapes.Torus(16, 10);
        int part = mesh.VertexSlots;
        mesh.Append(Shapes.Moved(Shapes.Torus(16, 10), p => p + new Vector3D(0, 0, 4)));
        mesh.AddVertex(new(1, 1, 1));
        int[] survivors = Themselves(mesh);
        for (int i = 0; i < count; i++)
            survivors[30 * i] += part;

        FaceSums[] sums = Project(mesh, FitSurfaceTests.SurfaceOf(mesh), survivors);

        Assert.All(sums, s => Assert.Equal(0, s.Largest, 1e-30));
    }
}
