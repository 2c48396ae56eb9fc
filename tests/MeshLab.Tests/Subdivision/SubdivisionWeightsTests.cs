using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Subdivision;

/// <summary>The weights at extraordinary vertices: their moments, and their use where valences are beyond every table.</summary>
[Trait("Section", "8")]
public class SubdivisionWeightsTests
{
    [Fact]
    public void NeighborWeight_OfWarren_IsThreeEighthsTogetherButForTriangles()
    {
        Assert.Equal(3.0 / 16, LoopSubdivision.NeighborWeight(3, LoopWeights.Warren));
        // For n = 3 both agree, for 6 as well: 1/16.
        Assert.Equal(LoopSubdivision.NeighborWeight(3), LoopSubdivision.NeighborWeight(3, LoopWeights.Warren), 1e-15);
        Assert.Equal(LoopSubdivision.NeighborWeight(6), LoopSubdivision.NeighborWeight(6, LoopWeights.Warren), 1e-15);
        for (int n = 4; n < 100; n++)
            Assert.Equal(0.375, n * LoopSubdivision.NeighborWeight(n, LoopWeights.Warren), 1e-14);
    }

    /// <summary>Together with ¾ at the vertex the weights reproduce constants and linear functions, from valence 5 on quadratic ones (Zorin et al. 1996, §3).</summary>
    [Fact]
    public void ExtraordinaryWeights_Moments_AreAQuarterAHalfAndAQuarter()
    {
        for (int k = 3; k < 40; k++)
        {
            double[] weights = ButterflySubdivision.ExtraordinaryWeights(k);
            Assert.Equal(k, weights.Length);
            Assert.Equal(0.25, Moment(0), 1e-14);
            Assert.Equal(0.5, Moment(1), 1e-14);
            if (k > 4)
                Assert.Equal(0.25, Moment(2), 1e-14);
            for (int j = 1; j < k; j++)
                Assert.Equal(weights[j], weights[k - j], 1e-15);

            double Moment(int m) => weights.Select((w, j) => w * Math.Cos(2 * Math.PI * m * j / k)).Sum();
        }
    }

    [Theory]
    [InlineData(63)]
    [InlineData(64)]
    [InlineData(65)]
    [InlineData(300)]
    public void Subdivide_HubOfHighValence_TakesItsOwnWeights(int n)
    {
        // The hub is above the middle of a ring at height 0.
        Mesh mesh = Remeshing.RemeshSurfaces.Fan(new(0, 0, 1), Remeshing.RemeshSurfaces.Polygon(n));
        double cosine = Math.Cos(2 * Math.PI / n), c = 0.375 + 0.25 * cosine;
        Assert.Equal(0.375 + c * c, mesh.Subdivide(SubdivisionScheme.Loop).Positions[0].Z, 1e-12);
        Assert.Equal(0.625, mesh.Subdivide(SubdivisionScheme.Loop, new() { Weights = LoopWeights.Warren }).Positions[0].Z, 1e-12);
        Assert.Equal(1 - (4 - 2 * cosine) / 9, mesh.Subdivide(SubdivisionScheme.Sqrt3).Positions[0].Z, 1e-12);
        Assert.Equal(1, mesh.Subdivide(SubdivisionScheme.ModifiedButterfly).Positions[0].Z);
    }

    /// <summary>From a rim vertex, which counts as regular, to a hub of another valence: the hub's stencil alone, whatever the valence at the rim.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(7)]
    [InlineData(10)]
    public void Butterfly_EdgeFromHubToRim_TakesTheHubsStencil(int k)
    {
        var random = new Random(k);
        Vector3D[] rim = [.. Remeshing.RemeshSurfaces.Polygon(k).Select(p => p + 0.3 * new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble()))];
        Mesh mesh = Remeshing.RemeshSurfaces.Fan(new(0.1, 0, 0.4), rim), finer = mesh.Subdivide(SubdivisionScheme.ModifiedButterfly);
        double[] weights = ButterflySubdivision.ExtraordinaryWeights(k);
        for (int i = 0; i < k; i++)
        {
            Vector3D expected = 0.75 * mesh.Positions[0];
            for (int j = 0; j < k; j++)
                expected += weights[j] * rim[(i + j) % k];
            Edge edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1 + i]);
            Assert.True(Vector3D.Distance(expected, finer.Positions[mesh.VertexSlots + edge.Index]) < 1e-14, $"{edge}");
        }
    }
}
