using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>Lines in a flat sheet, which nothing but the constraint holds.</summary>
[Trait("Section", "7.2")]
public class ConstraintsTests
{
    private const int N = 12;

    public static TheoryData<QuadricMode> Modes => new(QuadricMode.Fast, QuadricMode.Accurate);

    private static int[] Edges(Mesh mesh, Func<Vector3D, bool> on) =>
        [.. mesh.Edges.Where(e => on(e.Vertex0.Position) && on(e.Vertex1.Position)).Select(e => e.Index)];

    private static double Length(Mesh mesh, Func<Vector3D, bool> on) =>
        mesh.Edges.Where(e => on(e.Vertex0.Position) && on(e.Vertex1.Position)).Sum(e => Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position));

    /// <summary>Two curved lines very near to each other: to contract the edges between them would cost less than along them, but neither vanishes in the other.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_TwoLinesSideBySide_StayTwo(QuadricMode mode)
    {
        Mesh mesh = Shapes.Moved(Shapes.Sheet(N), p => new(p.X == 6.0 / N ? 5.001 / N : p.X, p.Y, 0.3 * Math.Sin(9 * p.Y)));
        static bool Left(Vector3D p) => Math.Abs(p.X - 5.0 / N) < 1e-9;
        static bool Right(Vector3D p) => Math.Abs(p.X - 5.001 / N) < 1e-9;

        mesh.Simplify(new() { TargetFaces = 60, Mode = mode, FeatureEdges = [.. Edges(mesh, Left), .. Edges(mesh, Right)] });

        foreach (Func<Vector3D, bool> on in (Func<Vector3D, bool>[])[Left, Right])
        {
            // One chain from side to side.
            Vertex[] line = [.. mesh.Vertices.Where(v => on(v.Position)).OrderBy(v => v.Position.Y)];
            Assert.Equal((0, 1), (line[0].Position.Y, line[^1].Position.Y));
            Assert.InRange(line.Length, 4, N + 1);
            Assert.All(line.Zip(line[1..]), pair => Assert.True(pair.First.IsNeighborOf(pair.Second)));
        }
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_LineOfOneEdge_StaysWithBothEnds(QuadricMode mode)
    {
        Mesh mesh = Shapes.Sheet(N);
        Edge edge = mesh.FindEdge(mesh.Vertices[6 * (N + 1) + 4], mesh.Vertices[6 * (N + 1) + 5]);
        (Vector3D a, Vector3D b) = (edge.Vertex0.Position, edge.Vertex1.Position);

        mesh.Simplify(new() { TargetFaces = 1, Mode = mode, FeatureEdges = [edge.Index] });

        Vertex first = Assert.Single(mesh.Vertices, v => v.Position == a), second = Assert.Single(mesh.Vertices, v => v.Position == b);
        Assert.True(first.IsNeighborOf(second));
        Assert.Empty(mesh.Validate());
    }

    /// <summary>Where three, four or six lines meet is a corner, as is where one ends or turns; all lines stay as long as they are.</summary>
    [Theory]
    [InlineData(QuadricMode.Fast, 3)]
    [InlineData(QuadricMode.Fast, 4)]
    [InlineData(QuadricMode.Fast, 6)]
    [InlineData(QuadricMode.Accurate, 4)]
    public void Simplify_LinesThatMeet_KeepTheirMeetingPoint(QuadricMode mode, int lines)
    {
        Mesh mesh = Shapes.Sheet(N);
        Func<Vector3D, bool>[] all =
        [
            p => p.Y == 0.5 && p.X >= 0.5, p => p.Y == 0.5 && p.X <= 0.5, p => p.X == 0.5 && p.Y >= 0.5,
            p => p.X == 0.5 && p.Y <= 0.5, p => p.X == p.Y && p.X >= 0.5, p => p.X == p.Y && p.X <= 0.5,
        ];

        mesh.Simplify(new() { TargetFaces = 1, Mode = mode, FeatureEdges = [.. all[..lines].SelectMany(on => Edges(mesh, on))] });

        Vertex middle = Assert.Single(mesh.Vertices, v => v.Position == new Vector3D(0.5, 0.5, 0));
        Assert.True(middle.Valence >= lines);
        for (int i = 0; i < lines; i++)
            Assert.Equal(i < 4 ? 0.5 : Math.Sqrt(0.5), Length(mesh, all[i]), 1e-12);
        Assert.True(mesh.Faces.Count < 40, $"{mesh.Faces.Count}");
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Simplify_FeatureThatIsDeleted_IsNamed()
    {
        Mesh mesh = Shapes.Sheet(4);
        HalfEdge h = mesh.Faces[10].HalfEdge;
        int gone = h.Edge.Index;
        h.Collapse();

        ArgumentException e = Assert.Throws<ArgumentException>(() => mesh.Simplify(new() { TargetFaces = 10, FeatureEdges = [gone] }));

        Assert.Contains($"e{gone} ", e.Message, StringComparison.Ordinal);
    }

    /// <summary>The vertices 5 and 9 are within the line, 1 is its end: a best place beside the line is brought onto the edge, or to the end.</summary>
    [Theory]
    [InlineData(5, 9, 0.25, 0.25)]
    [InlineData(5, 9, -1, 0)]
    [InlineData(5, 9, 3, 1)]
    [InlineData(1, 5, 0.7, 0)]
    [InlineData(5, 6, 0.7, 0)]
    public void Choose_BestPlaceBesideALine_IsOnIt(int u, int v, double along, double expected)
    {
        Mesh mesh = Shapes.Sheet(3);
        var working = new WorkingMesh(mesh);
        static bool On(Vector3D p) => p.X == 1 / 3.0;
        working.Constraints = Constraints.From(mesh, new() { FeatureEdges = Edges(mesh, On) });
        HalfEdge h = mesh.FindEdge(mesh.Vertices[u], mesh.Vertices[v]).HalfEdge0;
        // As the loop does: from the start of half-edge 0 to its end.
        (int first, int second) = (h.Source.Index, h.Target.Index);
        Vector3D a = working.Positions[u], b = working.Positions[v], best = Vector3D.Lerp(a, b, along) + new Vector3D(along == 0.7 ? 0 : 0.2, 0, 0.4);
        Quadric planes = Quadric.OfPlane(new(1, 0, 0), -best.X, 1) + Quadric.OfPlane(new(0, 1, 0), -best.Y, 1) + Quadric.OfPlane(new(0, 0, 1), -best.Z, 1);

        double cost = new MeshLab.Simplification.Placement(working, VertexPlacement.Optimal).Choose(in planes, h.Edge.Index, first, second, out Vector3D position);

        // At an end, the end's own bits.
        if (expected == 0)
            Assert.Equal(a, position);
        else if (expected == 1)
            Assert.Equal(b, position);
        Assert.Equal(0, Vector3D.Distance(Vector3D.Lerp(a, b, expected), position), 1e-15);
        Assert.Equal(Vector3D.DistanceSquared(best, position), cost, 1e-15);
    }
}
