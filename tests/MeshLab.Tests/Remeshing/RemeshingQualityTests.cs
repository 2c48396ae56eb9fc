using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

[Trait("Section", "L4")]
public class RemeshingQualityTests
{
    [Theory]
    [InlineData(3, 0, 0)]
    [InlineData(4, 0, 0)]
    [InlineData(5, 0, 1)]
    [InlineData(6, 1, 1)]
    [InlineData(7, 0, 1)]
    [InlineData(8, 0, 0)]
    public void Of_Fan_CountsTheVertexInside(int valence, double six, double nearSix)
    {
        RemeshingQuality quality = RemeshingQuality.Of(RemeshSurfaces.Fan(default, RemeshSurfaces.Polygon(valence)));
        Assert.Equal((six, nearSix), (quality.Valence6, quality.Valence567));
        Assert.Equal(4.0 * valence / (valence + 1), quality.MeanValence, 1e-15);
        // Isosceles triangles, 2π/n at the tip.
        double tip = 2 * Math.PI / valence, smallest = Math.Min(tip, (Math.PI - tip) / 2);
        Assert.Equal(smallest, quality.SmallestAngle, 1e-12);
        Assert.Equal(smallest, quality.MeanSmallestAngle, 1e-12);
        Assert.Equal(valence == 3 ? new() { [3] = 4 } : new SortedDictionary<int, int> { [3] = valence, [valence] = 1 }, quality.ValenceHistogram);
    }

    [Fact]
    public void Of_TwoTriangles_TakesTheMeanOfTheirSmallestAngles()
    {
        RemeshingQuality quality = RemeshingQuality.Of(MeshBuilder.FromTriangles(
            [default, new(1, 0, 0), new(0, 1, 0), new(5, 0, 0), new(7, 0, 0), new(6, Math.Sqrt(3), 0)], [0, 1, 2, 3, 4, 5]));
        Assert.Equal(Math.PI / 4, quality.SmallestAngle, 1e-12);
        Assert.Equal(Math.PI * 7 / 24, quality.MeanSmallestAngle, 1e-12);
        Assert.True(double.IsNaN(quality.Valence6));
    }

    [Fact]
    public void Of_Icosahedron_IsAsGoodAsFiveCanBe()
    {
        RemeshingQuality quality = RemeshingQuality.Of(Polyhedra.Icosahedron());
        Assert.Equal((0.0, 1.0, 5.0), (quality.Valence6, quality.Valence567, quality.MeanValence));
        Assert.Equal(Math.PI / 3, quality.SmallestAngle, 1e-12);
    }

    /// <summary>Faces are reckoned from the area, or in slivers from the lengths of the sides.</summary>
    [Fact]
    public void Remesh_BeyondTheBudget_IsRefusedByAreaAndBySides()
    {
        Mesh sliver = MeshBuilder.FromTriangles([default, new(1000, 0, 0), new(1000, 1e-6, 0)], [0, 1, 2]);
        Assert.Throws<ArgumentException>("options", () => sliver.RemeshIsotropically(new() { EdgeLength = 0.01, FaceBudget = 1000 }));
        Mesh square = MeshBuilder.FromTriangles([default, new(10, 0, 0), new(10, 10, 0), new(0, 10, 0)], [0, 1, 2, 0, 2, 3]);
        Assert.Throws<ArgumentException>("options", () => square.RemeshIsotropically(new() { EdgeLength = 0.1, FaceBudget = 10_000 }));
        Assert.Empty(square.RemeshIsotropically(new() { EdgeLength = 1, FaceBudget = 10_000 }).Mesh.Validate());
    }
}
