using System.Text.Json;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class SelfIntersectionsTests
{
    [Theory]
    [InlineData("sphere")]
    [InlineData("grid")]
    [InlineData("sphere-far")]
    [InlineData("sphere-tiny")]
    [InlineData("sphere-huge")]
    [InlineData("one")]
    public void FindSelfIntersections_EmbeddedSurface_FindsNone(string name)
    {
        TriangleSoups.Soup soup = TriangleSoups.Make(name);
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        Assert.Empty(tree.FindSelfIntersections());
        Assert.False(tree.HasSelfIntersections());
    }

    [Theory]
    [InlineData(3, 40)]
    [InlineData(5, 40)]
    [InlineData(20, 50)]
    public void FindSelfIntersections_RandomGrids_FindsThePairsOfTheDefinition(int grid, int triangles)
    {
        var random = new Random(grid);
        (long X, long Y, long Z)[] points = [.. Enumerable.Range(0, triangles / 2).Select(_ => ((long)random.Next(grid), (long)random.Next(grid), (long)random.Next(grid)))];
        var corners = new List<int>();
        while (corners.Count < 3 * triangles)
        {
            int a = random.Next(points.Length), b = random.Next(points.Length), c = random.Next(points.Length);
            if (a != b && b != c && c != a)
                corners.AddRange([a, b, c]);
        }
        var expected = new List<FacePair>();
        for (int f = 0; f < triangles; f++)
        {
            for (int g = f + 1; g < triangles; g++)
            {
                if (ByDefinition(points, corners.GetRange(3 * f, 3), corners.GetRange(3 * g, 3)))
                    expected.Add(new(f, g));
            }
        }

        FaceTree tree = FaceTree.Build([.. points.Select(p => new Vector3D(p.X, p.Y, p.Z))], [.. corners]);

        Assert.Equal(expected, tree.FindSelfIntersections());
        Assert.True(tree.HasSelfIntersections());
    }

    [Fact]
    public void FacePair_Order_IsLexicographic()
    {
        FacePair[] sorted = [new(0, 1), new(0, 2), new(1, 2)];
        for (int i = 0; i < sorted.Length; i++)
        {
            for (int j = 0; j < sorted.Length; j++)
            {
                Assert.Equal(i.CompareTo(j), sorted[i].CompareTo(sorted[j]));
                Assert.Equal((i < j, i <= j, i > j, i >= j), (sorted[i] < sorted[j], sorted[i] <= sorted[j], sorted[i] > sorted[j], sorted[i] >= sorted[j]));
            }
        }
    }

    [Fact]
    public void FindSelfIntersections_FoldedFlat_NamesTheTwoFacesAtTheEdge()
    {
        // 2 is on the same side of the edge 0-1 as 3, in one plane.
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(1, 2, 0), new(1, 1, 0)], [0, 1, 2, 1, 0, 3]);
        Assert.Equal([new FacePair(0, 1)], FaceTree.Build(mesh).FindSelfIntersections());

        mesh.Positions[3] = new(1, -1, 0);
        Assert.Empty(FaceTree.Build(mesh).FindSelfIntersections());
        mesh.Positions[3] = new(1, 1, 1e-9);
        Assert.Empty(FaceTree.Build(mesh).FindSelfIntersections());
    }

    [Fact]
    public void FindSelfIntersections_TwoCrossingQuads_NamesThePairOnce()
    {
        Mesh mesh = MeshBuilder.FromPolygons(
            [new(-1, -1, 0), new(1, -1, 0), new(1, 1, 0), new(-1, 1, 0), new(-0.9, 0, -1), new(0.9, 0, -1), new(0.9, 0, 1), new(-0.9, 0, 1)],
            [[0, 1, 2, 3], [4, 5, 6, 7]]);
        FaceTree tree = FaceTree.Build(mesh);
        Assert.Equal(4, tree.TriangleCount);
        Assert.Equal([new FacePair(0, 1)], tree.FindSelfIntersections());
        Assert.Equal(1, tree.FindClosest(new(0, 0, 5)).Face);
    }

    [Fact]
    public void Build_MeshWithDeletedFaces_LeavesThemOut()
    {
        Mesh mesh = MeshBuilder.FromPolygons(
            [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(0, 0, 1), new(1, 0, 1), new(1, 1, 1), new(0, 1, 1)],
            [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]);
        FaceTree tree = FaceTree.Build(mesh);
        Assert.Equal(12, tree.TriangleCount);
        Assert.Equal(1, tree.FindClosest(new(0.5, 0.4, 1.5)).Face);
        Assert.Equal(5, tree.CastRay(new(-1, 0.3, 0.6), Vector3D.UnitX).Face);
        Assert.Equal([0, 2, 5], tree.FindInBox(new(default, default)));
        Assert.True(tree.Contains(new(0.5, 0.5, 0.5)));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void FindSelfIntersections_PublicModel_FindsWhatTheReferenceFinds(string name)
    {
        FacePair[] pairs = FaceTree.Build(ReferenceMesh.Load(name)).FindSelfIntersections();

        JsonElement expected = ReferenceData.Json(name, "extras").RootElement.GetProperty("self_intersections").GetProperty("CGAL_does_self_intersect");
        if (expected.ValueKind != JsonValueKind.Null)
            Assert.Equal(expected.GetBoolean(), pairs.Length > 0);
        // The numbers of CGAL 5.5.1.
        Assert.Equal(name switch { "box_assembly" => 4665, "camelhead" => 5, "horse" => 4, _ => 0 }, pairs.Length);
    }

    [Fact]
    public void FindSelfIntersections_Cancelled_Throws()
    {
        TriangleSoups.Soup soup = TriangleSoups.Make("sphere");
        FaceTree tree = FaceTree.Build(soup.Positions, soup.Corners);
        Assert.Throws<OperationCanceledException>(() => tree.FindSelfIntersections(new CancellationToken(true)));
    }

    // The definition in the documentation, by another method.
    private static bool ByDefinition((long X, long Y, long Z)[] points, List<int> f, List<int> g)
    {
        List<int> shared = [.. f.Intersect(g)];
        switch (shared.Count)
        {
            case 0:
                return ConvexHullOracle.Meet([.. f.Select(v => points[v])], [.. g.Select(v => points[v])]);
            case 1:
                return ConvexHullOracle.Meet([.. f.Except(shared).Select(v => points[v])], [.. g.Select(v => points[v])])
                    || ConvexHullOracle.Meet([.. f.Select(v => points[v])], [.. g.Except(shared).Select(v => points[v])]);
            case 2:
                // On one side of the common edge in one plane: the products with the edge are parallel and point the same way.
                var (a, b) = (points[shared[0]], points[shared[1]]);
                var n = Cross(a, b, points[f.Except(shared).Single()]);
                var m = Cross(a, b, points[g.Except(shared).Single()]);
                bool parallel = n.X * m.Y == n.Y * m.X && n.Y * m.Z == n.Z * m.Y && n.Z * m.X == n.X * m.Z;
                return parallel && n.X * m.X + n.Y * m.Y + n.Z * m.Z > 0;
            default:
                return true;
        }
    }

    private static (long X, long Y, long Z) Cross((long X, long Y, long Z) a, (long X, long Y, long Z) b, (long X, long Y, long Z) c)
    {
        var (ux, uy, uz, vx, vy, vz) = (b.X - a.X, b.Y - a.Y, b.Z - a.Z, c.X - a.X, c.Y - a.Y, c.Z - a.Z);
        return (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
    }
}
