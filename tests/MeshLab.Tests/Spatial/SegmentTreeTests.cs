using MeshLab.Numerics;
using MeshLab.Spatial;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class SegmentTreeTests
{
    [Fact]
    public void FindClosest_RandomSegments_IsTheBestOfAll()
    {
        var random = new Random(1);
        Vector3D[] positions = [.. Enumerable.Range(0, 300).Select(_ => TriangleSoups.Point(random))];
        int[] ends = [.. Enumerable.Range(0, 400).Select(_ => random.Next(300))];
        SegmentTree tree = SegmentTree.Build(positions, ends);
        Assert.Equal(200, tree.Count);
        for (int i = 0; i < 300; i++)
        {
            Vector3D query = TriangleSoups.Point(random) * 2;
            ClosestSegmentPoint found = tree.FindClosest(query);

            double[] distances = [.. Enumerable.Range(0, 200).Select(s => Distance(query, positions[ends[2 * s]], positions[ends[2 * s + 1]]))];
            Assert.Equal(distances.Min(), found.Distance, 1e-14);
            Assert.Equal(found.Distance, Vector3D.Distance(query, found.Point), 1e-14);
            Vector3D a = positions[ends[2 * found.Segment]], b = positions[ends[2 * found.Segment + 1]];
            Assert.Equal(0, Vector3D.Distance(Vector3D.Lerp(a, b, found.Parameter), found.Point), 1e-14);
            Assert.True(tree.FindClosest(query, found.DistanceSquared * 0.99).IsNone);
        }
    }

    [Fact]
    public void FindClosest_SharedEnd_TakesTheLowerSegment()
    {
        SegmentTree tree = SegmentTree.Build([new(0, 0, 0), new(1, 0, 0), new(2, 1, 0)], [1, 2, 0, 1]);
        Assert.Equal(new ClosestSegmentPoint(0, 0, new(1, 0, 0), 1), tree.FindClosest(new(1, 0, 1)));
    }

    [Fact]
    public void Build_BadInput_NamesTheArgument()
    {
        Assert.Throws<ArgumentException>("ends", () => SegmentTree.Build([default], [0]));
        Assert.Throws<ArgumentException>("ends", () => SegmentTree.Build([default], [0, 1]));
        Assert.True(SegmentTree.Build([], []).FindClosest(default).IsNone);
    }

    private static double Distance(Vector3D p, Vector3D a, Vector3D b)
    {
        double t = a == b ? 0 : Math.Clamp(Vector3D.Dot(p - a, b - a) / (b - a).LengthSquared, 0, 1);
        return Vector3D.Distance(p, a + (b - a) * t);
    }
}
