using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

[Trait("Section", "10.1")]
public class PolygonTriangulationTests
{
    [Theory]
    [InlineData("convex", new double[] { 0, 0, 2, 0, 3, 2, 1, 3, -1, 1 })]
    [InlineData("ell", new double[] { 0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2 })]
    [InlineData("arrow", new double[] { 0, 0, 2, 1, 0, 2, 0.5, 1 })]
    [InlineData("comb", new double[] { 0, 0, 5, 0, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3 })]
    public void Triangulate_SimplePolygon_TrianglesFillItInItsOrientation(string name, double[] coordinates)
    {
        int n = coordinates.Length / 2;
        foreach (Func<double, double, Vector3D> place in (Func<double, double, Vector3D>[])[(x, y) => new(x, y, 7), (x, y) => new(3, x, y), (x, y) => new(y, 1, x), (x, y) => new(y, x, x + y)])
        {
            Vector3D[] points = [.. Enumerable.Range(0, n).Select(i => place(coordinates[2 * i], coordinates[2 * i + 1]))];
            var triangles = new List<int>();
            PolygonTriangulation.Triangulate(points, Enumerable.Range(0, n).ToArray(), triangles);

            Assert.Equal(3 * (n - 2), triangles.Count);
            Vector3D area = default;
            for (int i = 0; i < n; i++)
                area += 0.5 * Vector3D.Cross(points[i], points[(i + 1) % n]);
            double sum = 0;
            for (int t = 0; t < triangles.Count; t += 3)
            {
                double signed = 0.5 * Vector3D.Dot(Vector3D.Cross(points[triangles[t + 1]] - points[triangles[t]], points[triangles[t + 2]] - points[triangles[t]]), area.Normalized());
                Assert.True(signed > -1e-12, $"{name}: a triangle is turned over");
                sum += signed;
            }
            Assert.Equal(area.Length, sum, 9);
        }
    }

    [Fact]
    public void Triangulate_CrossingOutline_EndsWithAllTriangles()
    {
        var triangles = new List<int>();
        PolygonTriangulation.Triangulate([new(0, 0, 0), new(2, 2, 0), new(2, 0, 0), new(0, 2, 0), new(1, 5, 0)], [0, 1, 2, 3, 4], triangles);
        Assert.Equal(9, triangles.Count);
    }

    [Fact]
    public void Triangulate_ConvexQuad_TakesTheDiagonalWithTheLargerAngles()
    {
        var triangles = new List<int>();
        PolygonTriangulation.Triangulate([new(0, 0, 0), new(4, 0, 0), new(5, 1, 0), new(1, 1, 0)], [0, 1, 2, 3], triangles);
        Assert.Equal([3, 0, 1, 1, 2, 3], triangles);
    }

    [Fact]
    public void Triangulate_LargePolygon_IsWholeAndWithoutSlivers()
    {
        const int N = 2000;
        Vector3D[] points = [.. Enumerable.Range(0, N).Select(i => new Vector3D(Math.Cos(2 * Math.PI * i / N), Math.Sin(2 * Math.PI * i / N), 0))];
        var triangles = new List<int>();
        PolygonTriangulation.Triangulate(points, [.. Enumerable.Range(0, N)], triangles);
        Assert.Equal(3 * (N - 2), triangles.Count);
        // A fan would use the first corner in every triangle.
        Assert.True(triangles.Count(corner => corner == 0) < 100);
    }

    [Fact]
    public void Triangulate_TwoCorners_Throws() =>
        Assert.Throws<ArgumentException>(() => PolygonTriangulation.Triangulate([default, default], [0, 1], []));
}
