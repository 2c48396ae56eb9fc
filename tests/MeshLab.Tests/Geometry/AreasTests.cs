using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.1")]
public class AreasTests
{
    /// <summary>An L of area 3 as one hexagon with a reflex corner at (1, 1).</summary>
    internal static Mesh LShape() => MeshBuilder.FromPolygons(
        [new(0, 0, 0), new(2, 0, 0), new(2, 1, 0), new(1, 1, 0), new(1, 2, 0), new(0, 2, 0)], [0, 1, 2, 3, 4, 5]);

    internal static Mesh RightTriangle() => MeshBuilder.FromTriangles([new(0, 0, 0), new(3, 0, 0), new(0, 4, 0)], [0, 1, 2]);

    [Fact]
    public void Area_PolygonThatIsNotConvex_IsExact()
    {
        Mesh mesh = LShape();
        Assert.Equal(3, mesh.Faces[0].Area);
        Assert.Equal(3, mesh.Area);
        Assert.Equal(Vector3D.UnitZ, mesh.Faces[0].Normal);
    }

    [Fact]
    public void MixedAreas_RightTriangle_AddUpToTheArea()
    {
        // The right angle is not obtuse: half of the area lies at it, a quarter at the others.
        Assert.Equal([3, 1.5, 1.5], RightTriangle().ComputeMixedAreas());
        Assert.Equal([3, 1.5, 1.5], RightTriangle().ComputeVoronoiAreas());
        Assert.Equal([2, 2, 2], RightTriangle().ComputeBarycentricAreas());
    }

    [Fact]
    public void MixedAreas_ObtuseTriangle_GiveHalfToTheObtuseCorner()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(-1, 1, 0)], [0, 1, 2]);
        Assert.Equal([1, 0.5, 0.5], mesh.ComputeMixedAreas());
        double[] voronoi = mesh.ComputeVoronoiAreas();
        Assert.Equal(2, voronoi.Sum(), 1e-14);
        Assert.Contains(voronoi, area => area < 0);
    }

    [Fact]
    public void VoronoiAreas_EquilateralTriangles_AreThirds()
    {
        double[] areas = Tetrahedron().ComputeVoronoiAreas();
        Assert.All(areas, area => Assert.Equal(Tetrahedron().Area / 4, area, 1e-14));
    }

    [Fact]
    public void VertexAreas_PolygonMesh_ThrowsNamingTheFaceAndTheTriangulation()
    {
        var error = Assert.Throws<ArgumentException>(() => LShape().ComputeMixedAreas());
        Assert.Contains("f0 has 6 corners", error.Message, StringComparison.Ordinal);
        Assert.Contains("Triangulation.Triangulate", error.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => LShape().Faces[0].HeronArea);
    }

    [Fact]
    public void Areas_IsolatedVertexZeroAreaFaceAndDeletedFace_AreZero()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0), new(9, 9, 9)], [0, 1, 2, 0, 2, 3]);
        Assert.Equal([0, 1], mesh.ComputeFaceAreas());
        double[] mixed = mesh.ComputeMixedAreas();
        Assert.Equal(0, mixed[4]);
        Assert.Equal(1, mixed.Sum(), 1e-15);
        mesh.ComputeFaceNormals(out int degenerate);
        Assert.Equal(1, degenerate);
    }

    [Theory]
    [InlineData(1e-6, 0)]
    [InlineData(1, 0)]
    [InlineData(1e6, 0)]
    [InlineData(1, 1e6)]
    public void MixedAreas_AnySizeAndPlace_AddUpToTheArea(double size, double offset)
    {
        Mesh mesh = AnalyticSurface.Ellipsoid.Mesh(24);
        Vector3D shift = new(offset, offset, -offset);
        for (int v = 0; v < mesh.VertexSlots; v++)
            mesh.Positions[v] = (mesh.Positions[v] * size) + shift;
        double area = mesh.Area;
        Assert.Equal(1, mesh.ComputeMixedAreas().Sum() / area, 1e-12);
        Assert.Equal(1, mesh.ComputeVoronoiAreas().Sum() / area, 1e-12);
        Assert.Equal(1, mesh.ComputeBarycentricAreas().Sum() / area, 1e-12);
        Assert.Equal(14.45301343849834 * size * size, area, 0.02 * area);
    }

    [Fact]
    public void MixedAreas_Slivers_AddUpToTheAreaAndAreNotNegative()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(24);
        for (int v = 0; v < mesh.VertexSlots; v++)
            mesh.Positions[v] = mesh.Positions[v] with { Z = mesh.Positions[v].Z * 1e-7 };
        double[] mixed = mesh.ComputeMixedAreas();
        Assert.All(mixed, area => Assert.True(area >= 0));
        Assert.Equal(1, mixed.Sum() / mesh.Area, 1e-12);
    }

    internal static Mesh Tetrahedron() => MeshBuilder.FromTriangles(
        [new(1, 1, 1), new(1, -1, -1), new(-1, 1, -1), new(-1, -1, 1)], [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2]);

    /// <summary>The fourth vertex lies on the side, or at one of its ends.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(0)]
    [InlineData(2)]
    public void VertexAreas_ZeroAreaFace_GivesNothingToItsCorners(double x)
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), new(x, 0, 0)], [0, 1, 2, 1, 0, 3]);
        Mesh alone = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 2, 0)], [0, 1, 2]);
        foreach (Func<Mesh, double[]> areas in (Func<Mesh, double[]>[])[m => m.ComputeVoronoiAreas(), m => m.ComputeMixedAreas(), m => m.ComputeBarycentricAreas()])
            Assert.Equal([.. areas(alone), 0], areas(mesh));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Barycenter_AnyFace_IsTheMeanOfItsCorners(string name)
    {
        Mesh mesh = Models.Create(name);
        Vector3D[] all = mesh.ComputeFaceBarycenters();
        foreach (Face f in mesh.Faces)
        {
            Vector3D mean = f.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / f.Degree;
            Assert.True(Vector3D.Distance(mean, f.Barycenter) <= 1e-15 * (1 + mean.Length), $"{f}");
            Assert.True(Vector3D.Distance(mean, all[f.Index]) <= 1e-15 * (1 + mean.Length), $"{f}");
        }
    }
}
