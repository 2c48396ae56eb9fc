using System.Text.Json;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>Which edges are split and which are collapsed, and to where.</summary>
[Trait("Section", "L4")]
public class LengthStepsTests
{
    private static LengthSteps Collapse(RemeshSurface s, FeatureLines lines)
    {
        var steps = new LengthSteps(s, lines, null);
        steps.CollapseShort();
        Assert.Empty(s.ToMesh().Validate());
        return steps;
    }

    // Both ways round, so that the first half-edge of an inner edge leads from either end.
    private static IEnumerable<Mesh> BothWays(Vector3D[] positions, int[] corners)
    {
        yield return MeshBuilder.FromTriangles(positions, corners);
        yield return MeshBuilder.FromTriangles(positions, [.. corners.Chunk(3).Reverse().SelectMany(f => f)]);
    }

    private static void AssertHas(RemeshSurface s, params Vector3D[] places) => Assert.All(places, p => Assert.Contains(p, RemeshSurfaces.Places(s)));

    [Theory]
    [InlineData(1.41, 1)]
    [InlineData(1.39, 0)]
    public void SplitLong_Edge_BeyondOnePointFour(double length, int expected)
    {
        // Only the edge on the x-axis is so long.
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(MeshBuilder.FromTriangles([new(0, 0, 0), new(length, 0, 0), new(length / 2, 0.9, 0)], [0, 1, 2]));
        var steps = new LengthSteps(s, lines, null);
        steps.SplitLong();
        Assert.Equal(expected, steps.Splits);
        if (expected > 0)
            AssertHas(s, new Vector3D(length / 2, 0, 0));
    }

    [Fact]
    public void SplitLong_UnevenSizes_SplitsByTheMeanOfBothEnds()
    {
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Sheet(10, 3, 0.5));
        for (int v = 0; v < s.VertexSlots; v++)
            s.Size[v] = 0.2 + 0.1 * s.Positions[v].X;
        var steps = new LengthSteps(s, lines, null);
        steps.SplitLong();
        Assert.Empty(s.ToMesh().Validate());
        Assert.True(steps.Splits > 500);
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            int a = s.Target[h], b = s.Target[h + 1];
            Assert.True(Math.Sqrt(s.LengthSquared(h)) <= 1.4 * (s.Size[a] + s.Size[b]) / 2 + 1e-12);
            // Positions are linear, and so are the sizes: the middle of an edge has the middle of the lengths.
            Assert.Equal(0.2 + 0.1 * s.Positions[a].X, s.Size[a], 1e-12);
        }
    }

    /// <summary>In a needle, halving the longest edges first makes fewer pieces than halving in any order.</summary>
    [Fact]
    public void SplitLong_Needle_HasNoFans()
    {
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(MeshBuilder.FromTriangles([new(0, 0, 0), new(300, 0, 0), new(300, 0.01, 0)], [0, 1, 2]));
        new LengthSteps(s, lines, null).SplitLong();
        Assert.InRange(s.Valence.Max(), 4, 40);
    }

    [Fact]
    public void CollapseShort_FreeEdge_GoesToItsMiddle()
    {
        // Two inner vertices in a ring of eight, 0.6 apart; all other edges are longer than 0.7.
        Vector3D[] ring = [new(-0.3, 0, 0), new(0.3, 0, 0), new(0, 0.9, 0), new(-0.9, 0.8, 0), new(-1.2, 0, 0), new(-0.9, -0.8, 0), new(0, -0.9, 0), new(0.9, -0.8, 0), new(1.2, 0, 0), new(0.9, 0.8, 0)];
        foreach (Mesh mesh in BothWays(ring, [0, 1, 2, 1, 0, 6, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 1, 6, 7, 1, 7, 8, 1, 8, 9, 1, 9, 2]))
        {
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh);
            Assert.Equal(1, Collapse(s, lines).Collapses);
            AssertHas(s, [default, .. ring[2..]]);
        }
    }

    /// <summary>u and v would meet at (0.7, 0), where a face of v's ring with the side x₁x₂ lies upside down, or has no area any more.</summary>
    [Theory]
    [InlineData(0.95, 1.1)]
    [InlineData(0.7, 0.7)]
    public void CollapseShort_FaceThatWouldTurnOver_KeepsTheEdge(double x1, double x2)
    {
        Vector3D[] positions =
        [
            new(0.4, 0, 0), new(1, 0, 0), new(0.7, 1, 0), new(-0.4, 0.7, 0), new(-0.6, -0.5, 0), new(0.2, -0.9, 0), new(x1, -0.8, 0), new(x2, -3, 0), new(2.8, 0, 0),
        ];
        foreach (Mesh mesh in BothWays(positions, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 1, 0, 5, 1, 5, 6, 1, 6, 7, 1, 7, 8, 1, 8, 2]))
        {
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh);
            // Far vertices want long edges, so that length is no reason.
            s.Size[7] = s.Size[8] = 4;
            Assert.Equal(0, Collapse(s, lines).Collapses);
            // Without the far corner between them the same edge goes.
            s.Positions[6] = s.Positions[6] with { X = 0.3 };
            s.Positions[7] = s.Positions[7] with { X = 0.3 };
            Collapse(s, lines);
            AssertHas(s, new Vector3D(0.7, 0, 0));
        }
    }

    /// <summary>No collapse makes an edge longer than 1.4, on either side.</summary>
    [Theory]
    [InlineData(1.66, 1)]
    [InlineData(1.76, 0)]
    public void CollapseShort_EdgeThatWouldGetLong_KeepsTheEdge(double far, int expected)
    {
        // The middle of the edge is at x = 0.3, the vertex on the right at x = far.
        Vector3D[] positions = [default, new(0.6, 0, 0), new(0.3, 0.9, 0), new(-0.8, 0.8, 0), new(-0.8, -0.8, 0), new(0.3, -0.9, 0), new(far, 0, 0)];
        foreach (Mesh mesh in BothWays(positions, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 1, 0, 5, 1, 5, 6, 1, 6, 2]))
        {
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh);
            Assert.Equal(expected, Collapse(s, lines).Collapses);
        }
    }

    /// <summary>A pyramid whose sides lean by an angle: its tip may go if that turns no face by more than 18°.</summary>
    [Theory]
    [InlineData(17.5, true)]
    [InlineData(18.5, false)]
    public void CollapseShort_Tip_GoesIfFacesTurnBy18DegreesAtMost(double degrees, bool expected)
    {
        double height = Math.Sqrt(3) / 2 * Math.Tan(degrees * Math.PI / 180);
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Fan(new(0, 0, height), RemeshSurfaces.Polygon(6)), 10);
        Assert.Equal(expected, Collapse(s, lines).Collapses > 0);
        AssertHas(s, RemeshSurfaces.Polygon(6));
    }

    /// <summary>A vertex on a line stays where it is, and the free one comes.</summary>
    [Fact]
    public void CollapseShort_FreeVertexBesideALine_GoesToTheLine()
    {
        // The rim bends by 45° everywhere, which keeps its vertices; no side is straight.
        Vector3D[] rim = RemeshSurfaces.Polygon(8);
        foreach (Vector3D center in new Vector3D[] { default, new(0.1, 0.2, 0) })
        {
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Fan(center, rim), 10);
            Assert.Equal(0, lines.Corners);
            Assert.Equal(1, Collapse(s, lines).Collapses);
            Vector3D[] left = RemeshSurfaces.Places(s);
            Assert.Equal(rim.OrderBy(p => (p.X, p.Y)), left.OrderBy(p => (p.X, p.Y)));
        }
    }

    /// <summary>Along a straight side all goes but its ends, from whichever side an edge is seen.</summary>
    [Fact]
    public void CollapseShort_StraightSides_KeepTheirCornersOnly()
    {
        Vector3D[] rim = [new(0, 0, 0), new(0.5, 0, 0), new(1, 0, 0), new(1.5, 0, 0), new(2, 0, 0), new(2, 1, 0), new(2, 2, 0), new(1, 2, 0), new(0, 2, 0), new(0, 0.25, 0)];
        for (int turn = 0; turn < rim.Length; turn++)
        {
            Vector3D[] turned = [.. rim[turn..], .. rim[..turn]];
            int[] corners = [.. Enumerable.Range(0, rim.Length).SelectMany(i => new[] { 0, 1 + i, 1 + (i + 1) % rim.Length })];
            foreach (Mesh mesh in BothWays([new(1, 1, 0), .. turned], corners))
            {
                (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh, 10);
                Assert.Equal(4, lines.Corners);
                for (int pass = 0; pass < 4; pass++)
                    Collapse(s, lines);
                Assert.Equal([new(0, 0, 0), new(0, 2, 0), new(2, 0, 0), new Vector3D(2, 2, 0)], RemeshSurfaces.Places(s).OrderBy(p => (p.X, p.Y)));
            }
        }
    }

    /// <summary>The vertex near the end of a side goes to that end, whichever it is: the rest of the side is long enough.</summary>
    [Theory]
    [InlineData(0.2)]
    [InlineData(0.8)]
    public void CollapseShort_EdgeToACorner_GoesToTheCorner(double x)
    {
        // Nothing else is short: the vertex inside wants little.
        foreach (int[] corners in new int[][] { [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1], [1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 0], [2, 0, 1, 3, 0, 2, 4, 0, 3, 1, 0, 4] })
        {
            Vector3D[] positions = [new(0.5, 0.4, 0), default, new(x, 0, 0), new(1, 0, 0), new(0.5, 0.9, 0)];
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(MeshBuilder.FromTriangles(positions, corners), 1.1);
            s.Size[0] = 0.3;
            Assert.Equal(1, Collapse(s, lines).Collapses);
            Assert.Equal([positions[0], .. positions[3..], default], RemeshSurfaces.Places(s).OrderBy(p => (p == default, p == positions[4], p == positions[3])));
        }
    }

    /// <summary>Where lines cross there may be corners on straight lines, next to each other.</summary>
    [Fact]
    public void CollapseShort_EdgeBetweenCorners_IsKept()
    {
        Vector3D[] rim = [default, new(0.8, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0)];
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Fan(new(1, 0.5, 0), rim));
        s.IsCorner[2] = s.IsCorner[3] = true;
        Collapse(s, lines);
        AssertHas(s, rim[..4]);
    }

    /// <summary>Two lines close to each other do not become one, although short edges join them: a step so flat that no face would turn much.</summary>
    [Fact]
    public void CollapseShort_EdgeFromLineToLine_IsKept()
    {
        Mesh mesh = RemeshSurfaces.Sheet(8, 1, 0.3, x => 0.2 * Math.Clamp(x - 3, 0, 1));
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh, 2, 0.15);
        Assert.Equal(16, lines.FeatureEdges);
        Assert.True(Collapse(s, lines).Collapses > 10);
        double[] lengths = new double[9];
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            Vector3D a = s.Positions[s.Target[h]], b = s.Positions[s.Target[h + 1]];
            if (s.IsFreeEdge(h) || !s.OnLine[h >> 1] || s.Face[h] < 0 || s.Face[h + 1] < 0)
                continue;
            Assert.Equal(a.X, b.X);
            lengths[(int)a.X] += Math.Abs(a.Y - b.Y);
        }
        Assert.Equal([0, 0, 0, 8, 8, 0, 0, 0, 0], lengths.Select(x => Math.Round(x, 12)));
    }

    /// <summary>A narrow facet between two lines that meet at both its ends: either line stays. Seen from either side.</summary>
    [Fact]
    public void CollapseShort_TriangleOfLines_DoesNotClose()
    {
        const double Thin = 5e-4;
        Vector3D[] positions = [new(-1, 0, 0), new(1, 0, 0), new(0, Thin, 0), new(-0.5, 0.5, -1), new(0.5, 0.5, -1), new(-0.5, -0.5, -1), new(0.5, -0.5, -1)];
        foreach (Mesh mesh in BothWays(positions, [0, 1, 2, 0, 2, 3, 2, 4, 3, 2, 1, 4, 1, 0, 5, 1, 5, 6]))
        {
            (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh, 2, 0.7);
            Assert.Equal((3, false), (lines.FeatureEdges, s.IsCorner[2]));
            Assert.True(lines.AllowsChord(positions[0], positions[1], positions[2]));
            s.Size.AsSpan(3).Fill(0.7);
            Collapse(s, lines);
            AssertHas(s, positions[..3]);
        }
    }

    /// <summary>Edges between 0.7 and 1.2 go if that lowers Σ (valence − 6)², all four vertices around being inside; no longer ones.</summary>
    [Fact]
    public void CollapseShort_EdgeOfMediumLength_GoesWhereValencesGetBetter()
    {
        int done = 0, atBorder = 0;
        for (int seed = 0; seed < 3; seed++)
        {
            Mesh sheet = RemeshSurfaces.Sheet(7, seed, 0.6);
            foreach (Edge edge in sheet.Edges)
            {
                if (edge.IsBoundary)
                    continue;
                Mesh mesh = WithFirstEdge(edge);
                Edge first = mesh.Edges[0];
                double length = Vector3D.Distance(first.Vertex0.Position, first.Vertex1.Position);
                Assert.Equal(length, Vector3D.Distance(edge.Vertex0.Position, edge.Vertex1.Position));
                bool inside = !new[] { first.Vertex0, first.Vertex1, first.HalfEdge0.Next.Target, first.HalfEdge1.Next.Target }.Any(v => v.IsBoundary);
                bool goes = FirstCollapses(mesh, length / 1.15);
                Assert.False(FirstCollapses(mesh, length / 1.25), $"{edge}");

                int before = Energy(mesh);
                bool better = first.HalfEdge0.TryCollapse(out _) && Energy(mesh) < before;
                Assert.True(!goes || (better && inside), $"{edge}");
                done += goes ? 1 : 0;
                atBorder += better && !inside ? 1 : 0;
            }
        }
        Assert.True(done > 20 && atBorder > 20, $"{done} {atBorder}");
    }

    private static bool FirstCollapses(Mesh mesh, double length)
    {
        using var trace = new StringWriter();
        // The others want long edges: only this one's own length is a reason.
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(mesh, 10, Math.PI, trace);
        s.Size[s.Target[0]] = s.Size[s.Target[1]] = length;
        new LengthSteps(s, lines, null).CollapseShort();
        string line = trace.ToString().Split('\n')[0];
        return line.Length > 0 && JsonDocument.Parse(line).RootElement.GetProperty("edge").GetInt32() == 0;
    }

    // The same mesh with an edge as the first of all: its faces come first.
    private static Mesh WithFirstEdge(Edge edge)
    {
        Mesh mesh = edge.Mesh;
        Face[] faces = [edge.Face0, edge.Face1];
        return MeshBuilder.FromTriangles(mesh.Positions.ToArray(), [.. faces.Concat(mesh.Faces.Where(f => !faces.Contains(f))).SelectMany(f => FromEdge(f, edge))]);
    }

    // The corners of a face, the edge first if it is one of its own.
    private static IEnumerable<int> FromEdge(Face f, Edge edge)
    {
        HalfEdge h = f.HalfEdges.ToArray().FirstOrDefault(k => k.Edge == edge, f.HalfEdge);
        return [h.Source.Index, h.Target.Index, h.Next.Target.Index];
    }

    private static int Energy(Mesh mesh) => mesh.Vertices.Where(v => !v.IsBoundary).Sum(v => (v.Valence - 6) * (v.Valence - 6));
}
