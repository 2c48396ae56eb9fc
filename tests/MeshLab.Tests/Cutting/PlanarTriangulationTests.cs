using MeshLab.Cutting;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.2")]
public class PlanarTriangulationTests
{
    [Fact]
    public void Triangulate_SquareWithTwoHolesAndAnIsland_CoversItsArea()
    {
        var points = new List<Vector2D>();
        int[][] loops =
        [
            Square(points, 0, 0, 10), [.. Square(points, 1, 1, 3).Reverse()], [.. Square(points, 5, 4, 5).Reverse()], Square(points, 6, 5, 2),
        ];
        AssertTriangulation([.. points], loops, 100 - 9 - 25 + 4, triangles: 4 + 8 + 2 * 2 - 2 + 2);
    }

    [Fact]
    public void Triangulate_HoleThatTouchesTheOutline_CoversItsArea()
    {
        // The hole has the outline's corner point, as a vertex of its own.
        Vector2D[] points = [new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(0, 0), new(1, 2), new(2, 1)];
        AssertTriangulation(points, [[0, 1, 2, 3], [4, 5, 6]], 16 - 1.5, triangles: 7);
    }

    [Fact]
    public void Triangulate_HolesThatTouchVerticesOfAnything_CoverTheirArea()
    {
        // Each with a vertex of its own where it touches: a wall's middle, both ends of a diagonal, by its rightmost vertex, another hole.
        AssertTriangulation([new(0, 0), new(2, 0), new(4, 0), new(4, 4), new(0, 4), new(2, 0), new(1, 2), new(3, 2)], [[0, 1, 2, 3, 4], [5, 6, 7]], 14, triangles: 8);
        AssertTriangulation([new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(0, 0), new(1, 3), new(4, 4), new(3, 1)], [[0, 1, 2, 3], [4, 5, 6, 7]], 8, triangles: 8);
        AssertTriangulation([new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(4, 4), new(2, 1), new(1, 2)], [[0, 1, 2, 3], [4, 5, 6]], 13.5, triangles: 7);
        AssertTriangulation(
            [new(0, 0), new(4, 0), new(4, 4), new(0, 4), new(1, 1), new(1, 2), new(2, 2), new(2, 1), new(2, 2), new(2, 3), new(3, 3), new(3, 2)],
            [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]], 14, triangles: 14);
    }

    [Fact]
    public void Triangulate_IslandWithAHoleOfItsOwn_JoinsItToTheIsland()
    {
        foreach (int[] order in (int[][])[[0, 1, 2, 3], [3, 2, 1, 0], [2, 3, 0, 1]])
        {
            var points = new List<Vector2D>();
            int[][] loops = [Square(points, 0, 0, 9), [.. Square(points, 1, 1, 7).Reverse()], Square(points, 2, 2, 5), [.. Square(points, 3, 3, 3).Reverse()]];
            AssertTriangulation([.. points], [.. order.Select(i => loops[i])], 81 - 49 + 25 - 9, triangles: 16);
        }
    }

    [Fact]
    public void Triangulate_HolesWhoseViewIsHidden_AreJoinedToWhatHides()
    {
        Vector2D[] hole = [new(1, 5.25), new(2, 5), new(1, 4.75)];
        // A tip between the hole and the corner that the ray would choose; two tips in one line; the same from below, where the wall leans.
        AssertHole([new(0, 0), new(10, 0), new(10, 10), new(7, 10), new(6, 6), new(5, 10), new(0, 10)], hole);
        AssertHole([new(0, 0), new(10, 0), new(10, 10), new(7, 10), new(6, 6), new(5, 10), new(4.5, 10), new(4, 5.5), new(3.5, 10), new(0, 10)], hole);
        AssertHole([new(0, 0), new(5, 0), new(6, 4), new(7, 0), new(11, 0), new(10, 10), new(0, 10)], hole);
        AssertHole([new(0, 0), new(3.5, 0), new(4, 4.5), new(4.5, 0), new(5, 0), new(6, 4), new(7, 0), new(11, 0), new(10, 10), new(0, 10)], hole);
        // A wall that leans so far that its lower end lies behind the hole.
        AssertHole([new(0, 0), new(10, 10), new(0, 10)], (Vector2D[])[new(3, 8), new(2.9, 4), new(1, 3)]);
    }

    [Fact]
    public void Triangulate_TwoHolesJoinedToOneTip_AreJoinedOnTheirOwnSides()
    {
        Vector2D[] first = [new(1, 5.25), new(2, 5), new(1, 4.75)], above = [new(0.5, 6.5), new(1.5, 6), new(0.5, 5.8)], below = [new(0.5, 4.2), new(1.5, 4), new(0.5, 3.5)];
        Vector2D[] fromBelow = [new(0, 0), new(5, 0), new(6, 4), new(7, 0), new(11, 0), new(10, 10), new(0, 10)];
        Vector2D[] fromAbove = [new(0, 0), new(10, 0), new(11, 10), new(7, 10), new(6, 6), new(5, 10), new(0, 10)];
        foreach (Vector2D[] outline in (Vector2D[][])[fromBelow, fromAbove])
        {
            AssertHole(outline, first, above);
            AssertHole(outline, first, below);
            AssertHole(outline, first, above, below);
        }
    }

    private static void AssertHole(Vector2D[] outline, params Vector2D[][] holes)
    {
        Vector2D[] points = [.. outline, .. holes.SelectMany(hole => hole)];
        List<int[]> loops = [[.. Enumerable.Range(0, outline.Length)]];
        double area = PlanarPolygons.DoubleArea(outline) / 2;
        int first = outline.Length;
        foreach (Vector2D[] hole in holes)
        {
            double own = PlanarPolygons.DoubleArea(hole) / 2;
            Assert.True(own < 0, "Holes run clockwise.");
            area += own;
            loops.Add([.. Enumerable.Range(first, hole.Length)]);
            first += hole.Length;
        }
        AssertTriangulation(points, [.. loops], area, points.Length - 2 + (2 * holes.Length));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void Triangulate_RandomStars_CoverTheirArea(int seed)
    {
        var random = new Random(seed);
        const int n = 400;
        var points = new Vector2D[2 * n];
        for (int i = 0; i < n; i++)
        {
            (double s, double c) = Math.SinCos(2 * Math.PI * i / n);
            double outer = 2 + random.NextDouble(), inner = 0.5 + random.NextDouble();
            points[i] = new(outer * c, outer * s);
            points[n + i] = new(inner * c, inner * s);
        }
        int[] outline = [.. Enumerable.Range(0, n)], hole = [.. Enumerable.Range(n, n).Reverse()];
        double area = (PlanarPolygons.DoubleArea(points.AsSpan(0, n)) - PlanarPolygons.DoubleArea(points.AsSpan(n, n))) / 2;
        AssertTriangulation(points, [outline, hole], area, triangles: 2 * n);
    }

    [Fact]
    public void Triangulate_ColumnOfPointsOnALine_UsesAllOfThem()
    {
        Vector2D[] points = [new(0, 0), new(1, 0), new(2, 0), new(3, 0), new(3, 1), new(2, 1), new(1, 1), new(0, 1)];
        AssertTriangulation(points, [[0, 1, 2, 3, 4, 5, 6, 7]], 3, triangles: 6);
    }

    [Fact]
    public void Triangulate_OutlineThatCrossesItself_SaysSoAndKeepsTheSignedArea()
    {
        Vector2D[] points = [new(0, 0), new(4, 3), new(4, 0), new(0, 2)];
        var corners = new List<int>();
        Assert.False(PlanarTriangulation.Triangulate(points, [[0, 1, 2, 3]], corners));
        Assert.Equal(PlanarPolygons.DoubleArea(points), corners.Chunk(3).Sum(t => Cross(points, t)), 1e-12);
        Assert.Equal(6, corners.Count);
    }

    [Fact]
    public void Contains_PointsBesideVertices_IsExact()
    {
        Vector2D[] diamond = [new(1, 0), new(2, 1), new(1, 2), new(0, 1)];
        Assert.True(PlanarPolygons.Contains(diamond, new(1, 1)));
        Assert.False(PlanarPolygons.Contains(diamond, new(-1, 1)));
        Assert.False(PlanarPolygons.Contains(diamond, new(3, 1)));
        Assert.False(PlanarPolygons.Contains(diamond, new(0, 0)));
    }

    private static void AssertTriangulation(Vector2D[] points, int[][] loops, double area, int triangles)
    {
        var corners = new List<int>();
        Assert.True(PlanarTriangulation.Triangulate(points, loops, corners));
        Assert.Equal(triangles, corners.Count / 3);
        double[] areas = [.. corners.Chunk(3).Select(t => Cross(points, t) / 2)];
        Assert.All(areas, a => Assert.True(a >= 0));
        Assert.Equal(area, areas.Sum(), 1e-12 * area);
        AssertEdges(loops, corners);
    }

    private static void AssertEdges(int[][] loops, List<int> corners)
    {
        // Every edge of a loop once, every other edge in both directions.
        var edges = new HashSet<(int, int)>();
        foreach (int[] t in corners.Chunk(3))
        {
            for (int k = 0; k < 3; k++)
                Assert.True(edges.Add((t[k], t[(k + 1) % 3])));
        }
        foreach (int[] loop in loops)
        {
            for (int i = 0; i < loop.Length; i++)
                Assert.True(edges.Remove((loop[i], loop[(i + 1) % loop.Length])));
        }
        Assert.All(edges, e => Assert.Contains((e.Item2, e.Item1), edges));
    }

    private static double Cross(Vector2D[] points, int[] t) => Vector2D.Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);

    private static int[] Square(List<Vector2D> points, double x, double y, double side)
    {
        int first = points.Count;
        points.AddRange([new(x, y), new(x + side, y), new(x + side, y + side), new(x, y + side)]);
        return [first, first + 1, first + 2, first + 3];
    }
}
