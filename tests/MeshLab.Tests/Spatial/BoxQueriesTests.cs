using MeshLab.Numerics;
using MeshLab.Spatial;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class BoxQueriesTests
{
    [Theory]
    [MemberData(nameof(TriangleSoups.Names), MemberType = typeof(TriangleSoups))]
    public void FindInBox_AnySoup_FindsEveryOverlappingBox(string name)
    {
        TriangleSoups.Soup soup = TriangleSoups.Make(name);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        Vector3D[] points = [.. TriangleSoups.Queries(soup, 60, 13)];
        for (int i = 0; i + 1 < points.Length; i++)
        {
            BoundingBox box = BoundingBox.Of(points.AsSpan(i, 2));
            int[] expected = [.. Enumerable.Range(0, soup.Count).Where(t => Overlap(box, BoxOf(soup[t])))];
            Assert.Equal(expected, tree.FindInBox(box));
        }
        Assert.Equal(soup.Count, tree.FindInBox(tree.Bounds).Length);
        Assert.Empty(tree.FindInBox(BoundingBox.Empty));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(1e-6, 0)]
    [InlineData(1e6, 0)]
    [InlineData(1, 1e6)]
    public void WindingNumber_Sphere_IsOneInsideAndZeroOutside(double scale, double offset)
    {
        var move = new Vector3D(offset, -offset, offset);
        TriangleSoups.Soup soup = TriangleSoups.Sphere(24).Moved(scale, move);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        var random = new Random(2);
        for (int i = 0; i < 500; i++)
        {
            Vector3D p = TriangleSoups.Point(random) * 1.2;
            if (p.Length is > 0.98 and < 1)
                continue;
            Assert.Equal(p.Length < 1 ? 1 : 0, tree.WindingNumber(p * scale + move));
        }
        // Straight below vertices and edges.
        for (int v = 0; v < soup.Positions.Length; v++)
        {
            Vector3D p = (soup.Positions[v] - move) * (1 / scale);
            if (Math.Abs(p.Z) > 0.1)
                Assert.Equal(1, tree.WindingNumber(soup.Positions[v] with { Z = move.Z }));
            Assert.Equal(0, tree.WindingNumber(soup.Positions[v] with { Z = move.Z - 2 * scale }));
        }
    }

    [Fact]
    public void WindingNumber_TwoNestedSpheres_Adds()
    {
        TriangleSoups.Soup outer = TriangleSoups.Sphere(8), inner = outer.Moved(0.5, default);
        int shift = outer.Positions.Length;
        FaceTree tree = FaceTree.Build([.. outer.Positions, .. inner.Positions], [.. outer.Corners, .. inner.Corners.Select(v => v + shift)]);
        Assert.Equal(2, tree.WindingNumber(new(0.01, 0.02, 0.03)));
        Assert.Equal(1, tree.WindingNumber(new(0.7, 0.02, 0.03)));
        Assert.Equal(0, tree.WindingNumber(new(1.7, 0.02, 0.03)));
        Assert.True(tree.Contains(default));
    }

    private static BoundingBox BoxOf((Vector3D A, Vector3D B, Vector3D C) t) => BoundingBox.Of([t.A, t.B, t.C]);

    private static bool Overlap(BoundingBox a, BoundingBox b) =>
        a.Min.X <= b.Max.X && a.Min.Y <= b.Max.Y && a.Min.Z <= b.Max.Z && b.Min.X <= a.Max.X && b.Min.Y <= a.Max.Y && b.Min.Z <= a.Max.Z;
}
