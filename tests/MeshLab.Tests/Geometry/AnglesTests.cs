using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.5")]
[Trait("Section", "10.6")]
public class AnglesTests
{
    //   2 ─── 3      folded along 1–2 by the angle given: up is concave, down is convex
    //   │ \   │
    //   0 ─── 1
    private static Mesh Hinge(double angle) => MeshBuilder.FromTriangles(
        [new(-1, 0, 0), new(0, -1, 0), new(0, 1, 0), new(Math.Cos(angle), 0, -Math.Sin(angle))], [0, 1, 2, 1, 3, 2]);

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(-0.3)]
    [InlineData(3)]
    [InlineData(-3)]
    [InlineData(1e-9)]
    public void DihedralAngle_Hinge_IsTheAngleWithItsSign(double angle)
    {
        Mesh mesh = Hinge(angle);
        Edge edge = mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[2]);
        Assert.Equal(angle, edge.DihedralAngle, 1e-15);
        Assert.Equal(Math.Abs(angle), edge.UnsignedDihedralAngle, 1e-15);
        Assert.Equal(angle, mesh.ComputeDihedralAngles()[edge.Index], 1e-15);
        Assert.Equal(4, mesh.ComputeUnsignedDihedralAngles().Count(double.IsNaN));
    }

    [Fact]
    public void DihedralAngle_BoundaryEdgeOrFlatFace_IsNaN()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0)], [0, 1, 2, 0, 2, 3]);
        Assert.All(mesh.ComputeDihedralAngles(), angle => Assert.True(double.IsNaN(angle)));
    }

    [Fact]
    public void CornerAngles_PolygonWithReflexCorner_AddUpAndDefectIsThatOfADisk()
    {
        Mesh mesh = AreasTests.LShape();
        double[] angles = mesh.ComputeCornerAngles();
        Assert.Equal(4 * Math.PI, angles.Where(a => !double.IsNaN(a)).Sum(), 1e-14);
        Assert.Equal(1.5 * Math.PI, mesh.Vertices[3].AngleSum, 1e-15);
        Assert.Equal(-0.5 * Math.PI, mesh.Vertices[3].AngleDefect, 1e-15);
        Assert.Equal(2 * Math.PI, mesh.ComputeAngleDefects().Sum(), 1e-14);
    }

    [Fact]
    public void CornerAngle_IsThatAtTheTarget()
    {
        Mesh mesh = AreasTests.RightTriangle();
        HalfEdge h = mesh.Faces[0].HalfEdge;
        Assert.Equal(Math.Atan2(4, 3), h.CornerAngle, 1e-15);
        Assert.Equal(Math.PI / 2, h.Previous.CornerAngle, 1e-15);
        Assert.True(double.IsNaN(h.Twin.CornerAngle));
    }

    [Fact]
    public void AngleDefects_SumOfAngles_AgreesWithTheTurningSum()
    {
        foreach (AnalyticSurface surface in AnalyticSurface.All)
        {
            Mesh mesh = surface.Mesh(12);
            double[] defects = mesh.ComputeAngleDefects();
            foreach (Vertex v in mesh.Vertices)
                Assert.Equal(v.AngleDefect, defects[v.Index], 1e-14);
        }
    }

    [Theory]
    [InlineData(3)]
    [InlineData(1200)]
    [InlineData(20000)]
    public void AngleDefects_FanOfManyTriangles_IsFlatAtTheCenter(int n)
    {
        var builder = new MeshBuilder();
        builder.AddVertex(default);
        for (int i = 0; i < n; i++)
            builder.AddVertex(new(1e-7 * Math.Cos(2 * Math.PI * i / n), 1e-7 * Math.Sin(2 * Math.PI * i / n), 0));
        for (int i = 0; i < n; i++)
            builder.AddFace(0, 1 + i, 1 + ((i + 1) % n));
        Assert.Equal(0, builder.Build().ComputeAngleDefects()[0], 1e-15 * Math.Sqrt(n) * 10);
    }

    [Fact]
    public void AngleDefects_FoldedCone_CountsMoreThanOneTurn()
    {
        // Twelve corners of 80° each around one vertex: 960°, more than two full turns.
        const int N = 12;
        var builder = new MeshBuilder();
        builder.AddVertex(default);
        for (int i = 0; i < N; i++)
        {
            double a = 2 * Math.PI * i / N, up = i % 2 == 0 ? 1 : -1;
            builder.AddVertex(new(0.5 * Math.Cos(a), 0.5 * Math.Sin(a), up));
        }
        for (int i = 0; i < N; i++)
            builder.AddFace(0, 1 + i, 1 + ((i + 1) % N));
        Mesh mesh = builder.Build();
        Assert.True(mesh.Vertices[0].AngleSum > 4 * Math.PI);
        Assert.Equal(mesh.Vertices[0].AngleDefect, mesh.ComputeAngleDefects()[0], 1e-14);
    }

    [Fact]
    public void AngleDefects_IsolatedVertexAndZeroAreaFace_AreNaNAndFinite()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0), new(9, 9, 9)], [0, 1, 2, 0, 2, 3]);
        double[] defects = mesh.ComputeAngleDefects();
        Assert.True(double.IsNaN(defects[4]));
        Assert.True(double.IsNaN(mesh.Vertices[4].AngleDefect));
        // The angle of the flat triangle at its middle corner is π.
        Assert.Equal(0, defects[1], 1e-15);
        Assert.Equal(2 * Math.PI, defects.Take(4).Sum(), 1e-14);
    }

    [Fact]
    public void FaceQualities_EveryMeasure_MatchesTheTriangle()
    {
        Mesh mesh = AnalyticSurface.Ellipsoid.Mesh(6);
        foreach (QualityMeasure measure in Enum.GetValues<QualityMeasure>())
        {
            double[] qualities = mesh.ComputeFaceQualities(measure);
            Triangle triangle = mesh.Faces[11].Triangle;
            double expected = measure switch
            {
                QualityMeasure.MeanRatio => triangle.Quality,
                QualityMeasure.RadiusRatio => triangle.RadiusRatio,
                QualityMeasure.MinAngle => triangle.MinAngle,
                QualityMeasure.MaxAngle => triangle.MaxAngle,
                _ => triangle.AspectRatio,
            };
            Assert.Equal(expected, qualities[11], 1e-12);
        }
    }

    [Fact]
    public void AngleDefects_SideOfLengthZero_MakesNoAngle()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), new(2, 0, 0)], [0, 1, 2, 1, 0, 3]);
        double[] defects = mesh.ComputeAngleDefects();
        Assert.Equal(Math.PI / 2, defects[0], 1e-15);
        Assert.Equal(Math.PI * 3 / 4, defects[1], 1e-15);
        Assert.Equal(Math.PI, defects[3], 1e-15);
    }

    /// <summary>The product of ten corners would be too small or too large for a double; it is scaled on the way.</summary>
    [Theory]
    [InlineData(1e-70)]
    [InlineData(1e-20)]
    [InlineData(1e20)]
    [InlineData(1e70)]
    public void AngleDefects_AnySize_AreThoseOfTheUnitMesh(double size)
    {
        // A vertex with ten spokes that go up and down: its angles add to more than a full turn.
        List<Vector3D> positions = [default];
        List<int> corners = [];
        for (int i = 0; i < 10; i++)
        {
            positions.Add(new(Math.Cos(0.2 * Math.PI * i), Math.Sin(0.2 * Math.PI * i), i % 2 == 0 ? 1.5 : -1.5));
            corners.AddRange([0, i + 1, 1 + ((i + 1) % 10)]);
        }
        double[] unit = MeshBuilder.FromTriangles([.. positions], [.. corners]).ComputeAngleDefects();
        double[] scaled = MeshBuilder.FromTriangles([.. positions.Select(p => p * size)], [.. corners]).ComputeAngleDefects();
        Assert.InRange(unit[0], -20, -4 * Math.PI);
        Assert.All(unit.Zip(scaled), pair => Assert.Equal(pair.First, pair.Second, 1e-13));
    }
}
