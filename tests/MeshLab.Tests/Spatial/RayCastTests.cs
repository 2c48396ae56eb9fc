using MeshLab.Numerics;
using MeshLab.Spatial;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class RayCastTests
{
    [Fact]
    public void CastRay_OneTriangle_FindsParameterAndWeights()
    {
        FaceTree tree = FaceTree.Build([new(0, 0, 0), new(4, 0, 0), new(0, 4, 0)], [0, 1, 2]);

        Assert.Equal(new RayHit(0, 0, 1.5, new(0.5, 0.25, 0.25)), tree.CastRay(new(1, 1, 3), new(0, 0, -2)));
        Assert.Equal(1.5, tree.CastRay(new(1, 1, -3), new(0, 0, 2)).Parameter); // from behind too
        Assert.True(tree.CastRay(new(1, 1, 3), new(0, 0, 2)).IsNone); // behind the origin
        Assert.True(tree.CastRay(new(3, 3, 3), new(0, 0, -2)).IsNone);
        Assert.True(tree.CastRay(new(-1, 1, 0), new(1, 0, 0)).IsNone); // edge-on
        Assert.True(tree.CastRay(new(1, 1, 3), new(0, 0, -2), 1.4).IsNone);
        Assert.False(tree.CastRay(new(1, 1, 3), new(0, 0, -2), 1.5).IsNone);
        Assert.Equal(0, tree.CastRay(new(1, 1, 0), new(0, 1e-9, 1)).Parameter); // starts on it
    }

    [Theory]
    [MemberData(nameof(TriangleSoups.Names), MemberType = typeof(TriangleSoups))]
    public void CastRay_AnySoup_IsTheFirstOfAllTriangles(string name)
    {
        // Rounding decides whether triangles without area are hit.
        if (name == "collinear")
            return;
        TriangleSoups.Soup soup = TriangleSoups.Make(name);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        // One triangle at a time: the same arithmetic without the tree.
        FaceTree[] singles = [.. Enumerable.Range(0, soup.Count).Select(t => FaceTree.Build(soup.Positions, soup.Corners.AsSpan(3 * t, 3)))];
        Vector3D[] points = [.. TriangleSoups.Queries(soup, 60, 21)];
        int some = 0;
        for (int i = 0; i + 1 < points.Length; i++)
        {
            Vector3D direction = points[i + 1] - points[i];
            if (i % 4 == 3)
                direction = (i % 3) switch { 0 => Vector3D.UnitX, 1 => -Vector3D.UnitY, _ => Vector3D.UnitZ };
            if (direction == default)
                continue;
            RayHit[] expected = [.. singles
                .Select((s, t) => s.CastRay(points[i], direction) with { Triangle = t, Face = t })
                .Where(h => h.Parameter < double.PositiveInfinity).OrderBy(h => h.Parameter).ThenBy(h => h.Triangle)];

            Assert.Equal(expected, tree.CastRayThrough(points[i], direction));
            Assert.Equal(expected.Length > 0, tree.HitsAny(points[i], direction));
            if (expected.Length > 0)
                Assert.Equal(expected[0], tree.CastRay(points[i], direction));
            else
                Assert.True(tree.CastRay(points[i], direction).IsNone);
            some += expected.Length;
        }
        Assert.True(some > 0 || name is "one" or "points" or "slivers");
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(1e-6, 0)]
    [InlineData(1e6, 0)]
    [InlineData(1, 1e6)]
    public void CastRay_ThroughEdgesAndVerticesOfASphere_NeverSlipsThrough(double scale, double offset)
    {
        TriangleSoups.Soup soup = TriangleSoups.Sphere(16).Moved(scale, new(offset, offset, -offset));
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        Vector3D center = new(offset, offset, -offset);
        for (int t = 0; t < soup.Count; t++)
        {
            (Vector3D a, Vector3D b, _) = soup[t];
            Assert.False(tree.CastRay(center, a - center).IsNone);
            Assert.False(tree.CastRay(center, (a + b) * 0.5 - center).IsNone);
            Assert.False(tree.CastRay(center + (a - center) * 1e3, center - a).IsNone);
        }
    }

    [Fact]
    public void CastRay_EquallyFarTriangles_TakesTheLowest()
    {
        TriangleSoups.Soup soup = TriangleSoups.Grid(20);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        for (int v = 0; v < soup.Positions.Length; v++)
            Assert.Equal(Array.IndexOf(soup.Corners, v) / 3, tree.CastRay(soup.Positions[v] + new Vector3D(0, 0, 2), new(0, 0, -1)).Face);
    }

    [Fact]
    public void CastRay_BadInput_NamesTheArgument()
    {
        FaceTree tree = FaceTree.Build([new(0, 0, 0), new(4, 0, 0), new(0, 4, 0)], [0, 1, 2]);
        Assert.Throws<ArgumentOutOfRangeException>("direction", () => tree.CastRay(default, default));
        Assert.Throws<ArgumentOutOfRangeException>("direction", () => tree.CastRay(default, new(double.PositiveInfinity, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>("origin", () => tree.CastRay(new(0, double.NaN, 0), Vector3D.UnitX));
        Assert.Throws<ArgumentOutOfRangeException>("maxParameter", () => tree.HitsAny(default, Vector3D.UnitX, double.NaN));
        Assert.True(FaceTree.Build([], []).CastRay(default, Vector3D.UnitX).IsNone);
        Assert.Empty(FaceTree.Build([], []).CastRayThrough(default, Vector3D.UnitX));
    }
}
