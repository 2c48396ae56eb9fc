using System.Text.Json;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>Which edges are flipped: single quadrilaterals, then whole sheets flip by flip.</summary>
[Trait("Section", "L4")]
public class ValenceFlipsTests
{
    /// <summary>Whether the edge ab between the triangles abc and bad is flipped; with extra triangles at b, each of which is a reason more. All other edges are held.</summary>
    private static bool IsFlipped(Vector3D a, Vector3D b, Vector3D c, Vector3D d, int reasons = 0, double length = 10)
    {
        List<Vector3D> positions = [a, b, c, d];
        List<int> corners = [0, 1, 2, 1, 0, 3];
        int last = 2;
        // The first one hangs on the side bc and counts for both.
        for (int i = 0; i <= reasons && reasons > 0; i++)
        {
            corners.AddRange([1, positions.Count, last]);
            last = positions.Count;
            positions.Add(b + new Vector3D(3 + i, 3 - i, 0));
        }
        RemeshSurface s = RemeshSurfaces.Of(MeshBuilder.FromTriangles([.. positions], [.. corners]), length).Surface;
        int edge = RemeshSurfaces.HalfEdge(s, 0, 1) >> 1;
        for (int e = 0; e < s.HalfEdgeSlots / 2; e++)
            s.OnLine[e] = e != edge;
        var flips = new ValenceFlips(s, null);
        flips.Run();
        bool done = !Enumerable.Range(0, s.HalfEdgeSlots).Any(h => s.Target[h ^ 1] == 0 && s.Target[h] == 1);
        Assert.Equal(done ? 1 : 0, flips.Flips);
        return done;
    }

    // The quadrilateral −1 … 1 along the edge, with c and d at x and ±y, folded at the edge.
    private static bool IsKiteFlipped(double x, double y, int reasons = 0, double length = 10, double foldDegrees = 0)
    {
        double fold = foldDegrees * Math.PI / 360;
        Vector3D c = new(x, y * Math.Cos(fold), -y * Math.Sin(fold));
        return IsFlipped(new(-1, 0, 0), new(1, 0, 0), c, new(c.X, -c.Y, c.Z), reasons, length);
    }

    [Theory]
    [InlineData(0.99, true)]
    [InlineData(1.01, false)]
    [InlineData(1.0, false)] // a square: neither diagonal is better, and the edge stays
    public void Run_ValencesTie_TakesTheDiagonalOfLargerAngles(double y, bool expected) => Assert.Equal(expected, IsKiteFlipped(0, y));

    /// <summary>The angles themselves count, not their cosines weighted by the lengths: one right angle more and one less, on unequal sides.</summary>
    [Fact]
    public void Run_ValencesTie_AddsTheAngles()
    {
        Vector3D a = new(-1, 0, 0), b = new(1, 0, 0);
        // 130° and 55° at far and near: 185° together. Then 125° and 50°.
        Assert.True(IsFlipped(a, b, Opposite(130, 1), Opposite(55, -1)));
        Assert.False(IsFlipped(a, b, Opposite(125, 1), Opposite(50, -1)));
        Assert.True(IsFlipped(a, b, Opposite(55, 1), Opposite(130, -1)));
        Assert.False(IsFlipped(a, b, Opposite(50, 1), Opposite(125, -1)));

        // Over the middle of ab, where it is seen under the angle.
        static Vector3D Opposite(double degrees, int side) => new(0, side / Math.Tan(degrees * Math.PI / 360), 0);
    }

    [Fact]
    public void Run_BetterValences_FlipsAgainstTheAngles()
    {
        Assert.False(IsKiteFlipped(0, 1.2, reasons: 0));
        Assert.True(IsKiteFlipped(0, 1.2, reasons: 1));
    }

    [Theory]
    [InlineData(29, true)]
    [InlineData(31, false)]
    public void Run_Fold_IsNotCutAway(double degrees, bool expected)
    {
        Assert.Equal(expected, IsKiteFlipped(0, 0.6, foldDegrees: degrees));
        Assert.Equal(expected, IsKiteFlipped(0, 0.6, reasons: 3, foldDegrees: -degrees));
    }

    /// <summary>Where the new edge would pass close to an end of the old one, a little fold turns the small face about it by more than 63°.</summary>
    [Theory]
    [InlineData(0.95, false)]
    [InlineData(0.85, true)]
    public void Run_FaceThatTurns_IsNotMade(double x, bool expected)
    {
        Assert.Equal(expected, IsKiteFlipped(x, 0.6, reasons: 3, foldDegrees: 25));
        Assert.Equal(expected, IsKiteFlipped(-x, 0.6, reasons: 3, foldDegrees: 25));
    }

    [Fact]
    public void Run_ConcaveQuadrilateral_IsKept()
    {
        Assert.False(IsKiteFlipped(1.5, 0.6, reasons: 5));
        Assert.False(IsKiteFlipped(-1.5, 0.6, reasons: 5));
        // The quality of the faces that would lie upside down is good enough.
        Assert.False(IsKiteFlipped(2.5, 1.5, reasons: 5));
    }

    /// <summary>Quality 0.15 is the least of a new triangle: here 2√3 · 1.2 h / (1.44 + 2 (0.36 + h²)), h its height over the new edge.</summary>
    [Theory]
    [InlineData(0.076, false)]
    [InlineData(0.081, true)]
    [InlineData(0.3, true)]
    public void Run_PoorTriangle_IsNotMade(double height, bool expected)
    {
        Assert.Equal(expected, IsKiteFlipped(1 - height, 0.6, reasons: 3));
        Assert.Equal(expected, IsKiteFlipped(height - 1, 0.6, reasons: 3));
    }

    [Theory]
    [InlineData(1.10, false)] // 1.6 > 1.4 · 1.1
    [InlineData(1.20, true)]
    public void Run_LongEdge_IsNotMade(double length, bool expected)
    {
        Assert.Equal(expected, IsFlipped(new(-0.5, 0, 0), new(0.5, 0, 0), new(0, 0.8, 0), new(0, -0.8, 0), reasons: 3, length));
        // But one too long may take the place of a longer one.
        Assert.True(IsKiteFlipped(0, 0.8, length: 0.1));
    }

    /// <summary>A triangle that is hardly more than a segment goes although the valences are the best that there are; if that makes none as poor.</summary>
    [Theory]
    [InlineData(0.06, true)]
    [InlineData(0.08, false)] // quality 0.18: there valences count
    public void Run_PoorTriangle_GoesWhateverTheValences(double height, bool expected)
    {
        // Inner a and b of valence 6, c and d on the boundary of valence 4.
        RemeshSurface s = RemeshSurfaces.Of(TwoHexagons(height), 10).Surface;
        var flips = new ValenceFlips(s, null);
        flips.Run();
        Assert.Equal(expected ? 1 : 0, flips.Flips);
    }

    [Fact]
    public void Run_PoorTriangles_AreNotReplacedByPoorer()
    {
        // Of a thin rhombus the short diagonal is the better one, although poor too.
        Assert.True(IsKiteFlipped(0, 0.04));
        Assert.False(IsFlipped(new(0, 0.04, 0), new(0, -0.04, 0), new(1, 0, 0), new(-1, 0, 0)));
        // From quality 0.115 to 0.143 is not enough, to 0.195 is.
        Assert.False(IsFlipped(new(-1, 0, 0), new(1, 0, 0), new(0, 0.1, 0), new(-1.5, -0.2, 0)));
        Assert.True(IsFlipped(new(-1, 0, 0), new(1, 0, 0), new(0, 0.1, 0), new(-1.5, -0.3, 0)));
    }

    /// <summary>The poor triangle leans over: the small one of the two new faces would lean over too.</summary>
    [Fact]
    public void Run_PoorTriangle_StaysIfANewFaceWouldLookElsewhere()
    {
        Vector3D a = new(-1, 0, 0), b = new(1, 0, 0), d = new(0, -1, 0);
        Assert.False(IsFlipped(a, b, new(0.9, 0.02, 0.1), d));
        Assert.False(IsFlipped(a, b, new(-0.9, 0.02, 0.1), d));
        Assert.True(IsFlipped(a, b, new(0.9, 0.02, 0.01), d));
        Assert.True(IsFlipped(a, b, new(-0.9, 0.02, 0.01), d));
    }

    /// <summary>On the boundary valence 4 is regular: two inner vertices of valence 6 and their neighbours stay, and come back from 5 and 5.</summary>
    [Fact]
    public void Run_RegularBoundary_HasValence4()
    {
        RemeshSurface s = RemeshSurfaces.Of(TwoHexagons(Math.Sqrt(3) / 2), 10).Surface;
        var flips = new ValenceFlips(s, null);
        flips.Run();
        Assert.Equal(0, flips.Flips);

        int h = RemeshSurfaces.HalfEdge(s, 0, 1);
        s.Flip(h);
        Assert.Equal((5, 5, 5, 5), (s.Valence[0], s.Valence[1], s.Valence[2], s.Valence[5]));
        flips.Run();
        Assert.Equal(1, flips.Flips);
        Assert.Equal((6, 6, 4, 4), (s.Valence[0], s.Valence[1], s.Valence[2], s.Valence[5]));
    }

    // a and b in a ring of eight; c (vertex 2) and d (vertex 5) see both.
    private static Mesh TwoHexagons(double y)
    {
        double w = Math.Sqrt(3) / 2;
        Vector3D[] positions =
        [
            new(-0.5, 0, 0), new(0.5, 0, 0), new(0, y, 0), new(-1, w, 0), new(-1.5, 0, 0), new(0, -w, 0), new(1.5, 0, 0), new(1, w, 0), new(-1, -w, 0), new(1, -w, 0),
        ];
        return MeshBuilder.FromTriangles(positions, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 8, 0, 8, 5, 0, 5, 1, 1, 5, 9, 1, 9, 6, 1, 6, 7, 1, 7, 2]);
    }

    public static TheoryData<int, bool> Sheets
    {
        get
        {
            var cases = new TheoryData<int, bool>();
            for (int seed = 0; seed < 6; seed++)
            {
                cases.Add(seed, false);
                cases.Add(seed, true);
            }
            return cases;
        }
    }

    /// <summary>
    /// Every flip lowers Σ (valence − ideal)², 4 on the boundary and 6 on features as inside; or keeps it and makes the angles larger. The four edges around a flip are
    /// looked at again; and when a run finds nothing to do, no fine flip is left.
    /// </summary>
    [Theory]
    [MemberData(nameof(Sheets))]
    public void Run_Sheet_FlipByFlipLowersTheEnergyUntilNoneDoes(int seed, bool folded)
    {
        // Folded: a trough with two creases of 45°.
        Mesh mesh = RemeshSurfaces.Sheet(12, seed, 0.5, folded ? x => Math.Max(0, Math.Abs(x - 6) - 2) : null);
        using var trace = new StringWriter();
        RemeshSurface s = RemeshSurfaces.Of(mesh, 10, 0.6, trace).Surface;
        var flips = new ValenceFlips(s, null);

        flips.Run();
        Assert.InRange(flips.Flips, 20, 400);
        AssertLookedAtAgain(mesh, s, Replay(mesh, trace, flips.Flips));

        for (int before = -1, runs = 0; before < flips.Flips; runs++)
        {
            Assert.InRange(runs, 0, 20);
            before = flips.Flips;
            flips.Run();
            Replay(mesh, trace, flips.Flips - before);
        }
        Assert.DoesNotContain(mesh.Edges, e => IsFineFlip(e, s));
        Assert.All(mesh.Faces, f => Assert.True(Normal(f).Z > 0));
    }

    // Does the flips in the mesh too; returns their edges.
    private static Edge[] Replay(Mesh mesh, StringWriter trace, int count)
    {
        string[] lines = trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries);
        trace.GetStringBuilder().Clear();
        Assert.Equal(count, lines.Length);
        Edge[] edges = [.. lines.Select(line => mesh.Edges[JsonDocument.Parse(line).RootElement.GetProperty("edge").GetInt32()])];
        int energy = Energy(mesh);
        foreach (Edge edge in edges)
        {
            double angles = OppositeAngles(edge);
            edge.Flip();
            int after = Energy(mesh);
            Assert.True(after < energy || (after == energy && angles > Math.PI), $"{edge}: {energy} {after} {angles}");
            energy = after;
        }
        return edges;
    }

    // Of the edges beside the last flips, those with nothing new around since.
    private static void AssertLookedAtAgain(Mesh mesh, RemeshSurface s, Edge[] flips)
    {
        var changed = new HashSet<Vertex>();
        int seen = 0;
        foreach (Edge flip in flips.Reverse())
        {
            // The quadrilateral was the same then, or else a later flip has changed its corners.
            HalfEdge h = flip.HalfEdge0, t = flip.HalfEdge1;
            if (Corners(flip).Any(changed.Contains))
            {
                changed.UnionWith(Corners(flip));
                continue;
            }
            foreach (Edge beside in new[] { h.Next.Edge, h.Previous.Edge, t.Next.Edge, t.Previous.Edge })
            {
                if (beside.IsBoundary || Corners(beside).Any(changed.Contains))
                    continue;
                seen++;
                Assert.False(IsFineFlip(beside, s), $"{beside} beside {flip}");
            }
            changed.UnionWith(Corners(flip));
        }
        Assert.InRange(seen, 4, 400);
    }

    private static Vertex[] Corners(Edge e) => [e.Vertex0, e.Vertex1, e.HalfEdge0.Next.Target, e.HalfEdge1.Next.Target];

    // Whether a flip would be right and make good faces.
    private static bool IsFineFlip(Edge edge, RemeshSurface s)
    {
        if (edge.IsBoundary || s.OnLine[edge.Index] || !edge.CanFlip(out _))
            return false;
        Mesh mesh = edge.Mesh;
        double angles = OppositeAngles(edge);
        int energy = Energy(mesh);
        edge.Flip();
        int after = Energy(mesh);
        bool good = new[] { edge.Face0, edge.Face1 }.All(f => Normal(f).Z > 0 && Quality(f) > 0.2);
        for (int back = 0; back < 3; back++)
            edge.Flip();
        return good && (after < energy || (after == energy && angles > Math.PI + 1e-6));
    }

    private static int Energy(Mesh mesh) => mesh.Vertices.Sum(v => (v.Valence - (v.IsBoundary ? 4 : 6)) * (v.Valence - (v.IsBoundary ? 4 : 6)));

    private static double OppositeAngles(Edge e)
    {
        Vector3D a = e.Vertex0.Position, b = e.Vertex1.Position, c = e.HalfEdge0.Next.Target.Position, d = e.HalfEdge1.Next.Target.Position;
        return Vector3D.Angle(a - c, b - c) + Vector3D.Angle(a - d, b - d);
    }

    private static Vector3D Normal(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
    }

    private static double Quality(Face f) =>
        2 * Math.Sqrt(3) * Normal(f).Length / f.HalfEdges.ToArray().Sum(h => Vector3D.DistanceSquared(h.Source.Position, h.Target.Position));
}
