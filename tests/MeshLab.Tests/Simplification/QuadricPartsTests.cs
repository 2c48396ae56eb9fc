using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>The parts of quadric simplification on their own: planes of a vertex, placement, costs from the current faces.</summary>
[Trait("Section", "7.2")]
public class QuadricPartsTests
{
    private static readonly Mesh Bumpy = Shapes.Sheet(6, (x, y) => 0.2 * Math.Sin(5 * x + 1) * Math.Cos(4 * y) + x * x);

    private static double Area(Face f)
    {
        Vector3D a = f.HalfEdge.Source.Position;
        return 0.5 * Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a).Length;
    }

    [Fact]
    public void Gather_InteriorVertex_WeighsItsFacesByAreaOrAlike()
    {
        var working = new WorkingMesh(Bumpy);
        Vertex v = Bumpy.Vertices[16];
        Assert.False(v.IsBoundary);

        new VertexQuadrics(working, areaWeights: true, 10, holdBoundary: true).Gather(v.Index, out Quadric byArea);
        new VertexQuadrics(working, areaWeights: false, 10, holdBoundary: true).Gather(v.Index, out Quadric alike);

        Assert.Equal(v.Faces.Sum(Area) / (working.Scale * working.Scale), byArea.Weight, 1e-12);
        Assert.Equal(6, alike.Weight, 1e-12);
        Assert.Equal(0, alike.At(working.Positions[v.Index]), 1e-12);
    }

    [Theory]
    [InlineData(true, 10)]
    [InlineData(true, 0.5)]
    [InlineData(false, 10)]
    [InlineData(true, 0)]
    public void Gather_BoundaryVertex_IsHeldByPlanesThroughItsEdges(bool hold, double borderWeight)
    {
        Mesh mesh = Shapes.Sheet(4);
        var working = new WorkingMesh(mesh);
        // The middle of the lower side: two edges of a quarter along x, and three faces.
        Vertex v = mesh.Vertices[2];
        Assert.True(v.IsBoundary);
        double edge = 0.25 / working.Scale, face = edge * edge / 2;

        new VertexQuadrics(working, areaWeights: true, borderWeight, hold).Gather(v.Index, out Quadric quadric);

        double held = hold ? 2 * borderWeight * edge * edge : 0;
        Assert.Equal(3 * face + held, quadric.Weight, 1e-10);
        Vector3D p = working.Positions[v.Index];
        Assert.Equal(held * edge * edge, quadric.At(p + new Vector3D(0, edge, 0)), 1e-10);
        Assert.Equal(0, quadric.At(p + new Vector3D(edge, 0, 0)), 1e-10);
        Assert.Equal(3 * face * edge * edge, quadric.At(p + new Vector3D(0, 0, edge)), 1e-10);
    }

    /// <summary>Each face around either end counts once, those between both ends too; the sums so far by a tenth.</summary>
    [Fact]
    public void Evaluate_Memoryless_CountsEveryFaceOnce()
    {
        var working = new WorkingMesh(Bumpy);
        var planes = new VertexQuadrics(working, areaWeights: true, 0, holdBoundary: false);
        UncheckedArray<Quadric> history = new Quadric[Bumpy.VertexSlots];
        Edge edge = Bumpy.FindEdge(Bumpy.Vertices[16], Bumpy.Vertices[17]);
        history[16] = Quadric.OfPlane(new(0, 0, 1), 0, 3);
        history[17] = Quadric.OfPlane(new(0, 1, 0), 0, 5);
        var costs = new MemorylessQuadrics(working, planes, new Placement(working, VertexPlacement.Optimal), history);

        double cost = costs.Evaluate(edge.Index, out Vector3D position, out double weight);

        Quadric expected = default;
        foreach (Face f in Bumpy.Vertices[16].Faces.Union(Bumpy.Vertices[17].Faces))
        {
            int[] v = [.. f.Vertices.Select(w => w.Index)];
            planes.AddFace(ref expected, v[0], v[1], v[2], 1);
        }
        expected.Add(in history[16], 0.1);
        expected.Add(in history[17], 0.1);
        Assert.Equal(expected.Weight, weight, 1e-12);
        Assert.Equal(expected.At(position), cost, 1e-12);
        Assert.True(expected.TryMinimize(out Vector3D best, out _));
        Assert.True(Vector3D.Distance(best, position) < 1e-9);
        // The error is that of the original's planes alone: 3 z² + 5 y² over 8.
        var at = new Vector3D(9, 2, 3);
        Assert.Equal((3 * 9 + 5 * 4) / 8.0, costs.MeanSquare(edge.Index, at, 0, weight), 1e-12);
    }

    private static (WorkingMesh Mesh, int Edge, int U, int V) OneEdge()
    {
        var working = new WorkingMesh(Shapes.Sheet(1));
        return (working, 0, working.Rows[1].Target, working.Rows[0].Target);
    }

    [Theory]
    [InlineData(VertexPlacement.Endpoint, 0.3, 0)]
    [InlineData(VertexPlacement.Endpoint, 0.7, 1)]
    [InlineData(VertexPlacement.Segment, 0.3, 0.3)]
    [InlineData(VertexPlacement.Segment, -2, 0)]
    [InlineData(VertexPlacement.Segment, 7, 1)]
    [InlineData(VertexPlacement.Optimal, 0.3, 0.3)]
    [InlineData(VertexPlacement.Optimal, 0.5, 0.5)]
    [InlineData(VertexPlacement.Optimal, 0, 0)]
    [InlineData(VertexPlacement.Optimal, 1, 1)]
    public void Choose_OnePlaneAcrossTheEdge_IsTheNearestPlaceThatIsAllowed(VertexPlacement placement, double planeAt, double expected)
    {
        var (working, edge, u, v) = OneEdge();
        Vector3D a = working.Positions[u], along = working.Positions[v] - a, normal = along.Normalized();
        Quadric plane = Quadric.OfPlane(normal, -Vector3D.Dot(normal, a + planeAt * along), 2);

        double cost = new Placement(working, placement).Choose(in plane, edge, u, v, out Vector3D position);

        Assert.True(Vector3D.Distance(a + expected * along, position) < 1e-12, $"{position}");
        Assert.Equal(2 * Math.Pow((expected - planeAt) * along.Length, 2), cost, 1e-12);
    }

    /// <summary>A quadric that has no unique minimum and is as good everywhere on the edge: the midpoint.</summary>
    [Fact]
    public void Choose_FlatGround_IsTheMidpoint()
    {
        var (working, edge, u, v) = OneEdge();
        Quadric plane = Quadric.OfPlane(new(0, 0, 1), -working.Positions[u].Z, 1);

        Assert.Equal(0, new Placement(working, VertexPlacement.Optimal).Choose(in plane, edge, u, v, out Vector3D position));

        Assert.Equal((working.Positions[u] + working.Positions[v]) * 0.5, position);
    }

    [Fact]
    public void Choose_ThreePlanes_IsTheirPointUnlessItMustBeOnTheEdge()
    {
        var (working, edge, u, v) = OneEdge();
        var point = new Vector3D(0.1, 0.2, 0.7);
        Quadric planes = Quadric.OfPlane(new(1, 0, 0), -point.X, 1) + Quadric.OfPlane(new(0, 1, 0), -point.Y, 1) + Quadric.OfPlane(new(0, 0, 1), -point.Z, 1);
        Vector3D a = working.Positions[u], b = working.Positions[v];
        double t = Math.Clamp(Vector3D.Dot(point - a, b - a) / (b - a).LengthSquared, 0, 1);

        new Placement(working, VertexPlacement.Optimal).Choose(in planes, edge, u, v, out Vector3D optimal);
        new Placement(working, VertexPlacement.Segment).Choose(in planes, edge, u, v, out Vector3D onEdge);
        new Placement(working, VertexPlacement.Endpoint).Choose(in planes, edge, u, v, out Vector3D end);

        Assert.True(Vector3D.Distance(point, optimal) < 1e-12);
        Assert.True(Vector3D.Distance(Vector3D.Lerp(a, b, t), onEdge) < 1e-12);
        Assert.Equal(t < 0.5 ? a : b, end);
    }
}
