using MeshLab.Numerics;
using MeshLab.Spatial;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class ClosestPointTests
{
    [Fact]
    public void FindClosest_OneTriangle_FindsInsideEdgeAndCorner()
    {
        FaceTree tree = FaceTree.Build([new(0, 0, 0), new(4, 0, 0), new(0, 4, 0)], [0, 1, 2]);

        Assert.Equal(new ClosestPoint(0, 0, new(1, 1, 0), new(0.5, 0.25, 0.25), 9), tree.FindClosest(new(1, 1, 3)));
        Assert.Equal(new ClosestPoint(0, 0, new(1, 0, 0), new(0.75, 0.25, 0), 5), tree.FindClosest(new(1, -1, 2)));
        Assert.Equal(new ClosestPoint(0, 0, new(4, 0, 0), new(0, 1, 0), 2), tree.FindClosest(new(5, -1, 0)));
    }

    [Theory]
    [MemberData(nameof(TriangleSoups.Names), MemberType = typeof(TriangleSoups))]
    public void FindClosest_AnySoup_IsTheBestOfAllTriangles(string name)
    {
        TriangleSoups.Soup soup = TriangleSoups.Make(name);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        foreach (Vector3D query in TriangleSoups.Queries(soup, 200, 7))
        {
            ClosestPoint found = tree.FindClosest(query);

            (int expected, double squared) = BruteForce(soup, query);
            Assert.Equal(expected, found.Face);
            Assert.Equal(squared, found.DistanceSquared);

            Assert.Equal(1, found.Barycentric.X + found.Barycentric.Y + found.Barycentric.Z, 12);
            Assert.True(Math.Min(found.Barycentric.X, Math.Min(found.Barycentric.Y, found.Barycentric.Z)) >= -1e-12);
            double size = BoundingBox.Of(soup.Positions).Including(query).Including(default(Vector3D)).Diagonal;
            Assert.Equal(found.Distance, Vector3D.Distance(query, found.Point), 1e-14 * size);
        }
    }

    [Fact]
    public void FindClosest_FarFromASphere_IsTheDistanceToTheSphere()
    {
        TriangleSoups.Soup soup = TriangleSoups.Sphere(60);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        foreach (double distance in new[] { 2, 1e3, 1e9, 1e15, 1e30, 1e100 })
            Assert.Equal(distance, tree.FindClosest(new Vector3D(0, 0, 1) * distance).Distance + 1, 1e-12 * distance);
    }

    [Fact]
    public void FindClosest_AllVerticesInOnePlace_IsTheDistanceToIt()
    {
        // Of many faces, so that there are boxes without size to choose from.
        ClosestPoint found = FaceTree.Build([.. Enumerable.Repeat(new Vector3D(1, 2, 3), 300)], [.. Enumerable.Range(0, 300)]).FindClosest(new(4, 6, 3));
        Assert.Equal(0, found.Face);
        Assert.Equal(5, found.Distance);
        Assert.Equal(new Vector3D(1, 2, 3), found.Point);
    }

    [Fact]
    public void FindClosest_EquallyFarTriangles_TakesTheLowest()
    {
        TriangleSoups.Soup soup = TriangleSoups.Make("repeated");
        Assert.Equal(0, FaceTree.Build(soup.Positions, soup.Corners).FindClosest(new(0.2, 0.2, 1)).Face);

        soup = TriangleSoups.Grid(20);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        for (int v = 0; v < soup.Positions.Length; v++)
            Assert.Equal(Array.IndexOf(soup.Corners, v) / 3, tree.FindClosest(soup.Positions[v] + new Vector3D(0, 0, 2)).Face);
    }

    [Fact]
    public void FindClosest_WithBound_FindsNothingBeyondIt()
    {
        TriangleSoups.Soup soup = TriangleSoups.Sphere(24);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        foreach (Vector3D query in TriangleSoups.Queries(soup, 200, 3))
        {
            ClosestPoint free = tree.FindClosest(query);
            Assert.Equal(free, tree.FindClosest(query, free.DistanceSquared));
            Assert.Equal(free, tree.FindClosest(query, 2 * free.DistanceSquared));
            if (free.DistanceSquared > 0)
                Assert.True(tree.FindClosest(query, Math.BitDecrement(free.DistanceSquared)).IsNone);
        }
    }

    [Theory]
    [MemberData(nameof(TriangleSoups.Names), MemberType = typeof(TriangleSoups))]
    public void IsWithin_AroundTheDistance_AgreesWithIt(string name)
    {
        TriangleSoups.Soup soup = TriangleSoups.Make(name);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        foreach (Vector3D query in TriangleSoups.Queries(soup, 50, 11))
        {
            double distance = tree.FindClosest(query).Distance;
            Assert.True(tree.IsWithin(query, distance * (1 + 1e-12)));
            Assert.True(distance == 0 || !tree.IsWithin(query, distance * (1 - 1e-12)));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    public void FindClosest_Batch_IsTheSameOnEveryThreadCount(int threads)
    {
        TriangleSoups.Soup soup = TriangleSoups.Random(3000, 5);
        FaceTree one = FaceTree.Build(soup.Positions, soup.Corners);
        Vector3D[] queries = [.. TriangleSoups.Queries(soup, 1000, 5)];
        var results = new ClosestPoint[queries.Length];
        FaceTree many;
        try
        {
            Parallelism.MaxThreads = threads;
            many = FaceTree.Build(soup.Positions, soup.Corners);
            many.FindClosest(queries, results);
        }
        finally
        {
            Parallelism.MaxThreads = 0;
        }

        Assert.Equal(one.Hash(), many.Hash());
        Assert.Equal(queries.Select(q => one.FindClosest(q)), results);
    }

    [Fact]
    public void FindClosest_EmptyTree_IsNone()
    {
        FaceTree tree = FaceTree.Build([new(1, 2, 3)], []);
        Assert.Equal(0, tree.TriangleCount);
        Assert.True(tree.Bounds.IsEmpty);
        Assert.True(tree.FindClosest(default).IsNone);
        Assert.False(tree.IsWithin(default, 1e300));
    }

    [Fact]
    public void Build_BadInput_NamesTheArgument()
    {
        Vector3D[] positions = [new(0, 0, 0), new(1, 0, 0), new(0, double.NaN, 0)];
        Assert.Equal("corners", Assert.Throws<ArgumentException>(() => FaceTree.Build(positions, [0, 1])).ParamName);
        Assert.Equal("corners", Assert.Throws<ArgumentException>(() => FaceTree.Build(positions, [0, 1, 3])).ParamName);
        Assert.Equal("corners", Assert.Throws<ArgumentException>(() => FaceTree.Build(positions, [0, 1, -1])).ParamName);
        Assert.Contains("v2", Assert.Throws<ArgumentException>(() => FaceTree.Build(positions, [0, 1, 2])).Message);
        Assert.Equal(1, FaceTree.Build(positions, [0, 1, 1]).TriangleCount); // an unused vertex does no harm
    }

    [Fact]
    public void Queries_BadInput_NameTheArgument()
    {
        TriangleSoups.Soup soup = TriangleSoups.Make("one");
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        Assert.Throws<ArgumentOutOfRangeException>("query", () => tree.FindClosest(new Vector3D(double.NaN, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>("maxDistanceSquared", () => tree.FindClosest(default(Vector3D), double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>("distance", () => tree.IsWithin(default, -1));
        Assert.Throws<ArgumentException>("results", () => tree.FindClosest(new Vector3D[2], new ClosestPoint[1]));
        Assert.True(tree.FindClosest(new(0, 0, 1), -1).IsNone);
    }

    // The reference: every triangle, in index order, by the scalar function.
    private static (int Triangle, double Squared) BruteForce(TriangleSoups.Soup soup, Vector3D query)
    {
        int best = -1;
        double bestSquared = double.PositiveInfinity;
        for (int t = 0; t < soup.Count; t++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = soup[t];
            double squared = TriangleMath.ClosestDistanceSquared(query, a, b, c, out _);
            if (squared < bestSquared)
                (best, bestSquared) = (t, squared);
        }
        return (best, bestSquared);
    }
}
