using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Generation;

[Trait("Section", "2.1")]
public class PolygonsTests
{
    [Theory]
    [InlineData(3, 3, 1)]
    [InlineData(4, 4, 2)]
    [InlineData(5, 6, 5)]
    [InlineData(50, 51, 50)]
    public void Polygon_OfNCorners_HasTheBooksCounts(int n, int vertices, int faces)
    {
        Mesh mesh = Polygons.Polygon(n);

        Assert.Equal((vertices, faces), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.Equal(1, Measure.EulerCharacteristic(mesh));
        Assert.Equal(n / 8.0 * Math.Sin(2 * Math.PI / n), Measure.Area(mesh), 1e-14);
        Assert.All(mesh.Faces, f => Assert.True(Measure.VectorArea(f).Z > 0));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Polygon_Corners_LieWhereTheBookSays()
    {
        Mesh mesh = Polygons.Polygon(7, 2, 3);

        for (int i = 0; i < 7; i++)
        {
            Vector3D expected = new(2 * Math.Cos(2 * Math.PI * i / 7), 2 * Math.Sin(2 * Math.PI * i / 7), 3);
            Assert.True(Vector3D.Distance(expected, mesh.Vertices[i].Position) < 1e-15 * 8);
        }
        Assert.Equal(new Vector3D(0, 0.5, 0), Polygons.Polygon(4).Vertices[1].Position);
    }

    [Theory]
    [InlineData(2, 1)]
    [InlineData(-1, 1)]
    [InlineData(5, 0)]
    [InlineData(5, -1)]
    [InlineData(5, double.NaN)]
    [InlineData(5, double.PositiveInfinity)]
    public void Polygon_OfBadArguments_Throws(int n, double radius) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Polygons.Polygon(n, radius));

    [Fact]
    public void Annulus_Area_ConvergesWithTheSquareOfTheSegments()
    {
        double exact = Math.PI * (0.25 - 0.0625);
        double coarse = exact - Measure.Area(Polygons.Annulus(segments: 32)), fine = exact - Measure.Area(Polygons.Annulus(segments: 64));

        Assert.InRange(coarse / fine, 3.9, 4.1);
        Mesh mesh = Polygons.Annulus();
        Assert.Equal((0, 2), (Measure.EulerCharacteristic(mesh), Measure.BoundaryLoops(mesh)));
        Assert.All(mesh.Faces, f => Assert.True(Measure.VectorArea(f).Z > 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => Polygons.Annulus(0.5, 0.5));
        Assert.Throws<ArgumentOutOfRangeException>(() => Polygons.Annulus(rings: 0));
    }
}

[Trait("Section", "2.2")]
public class ConesTests
{
    [Theory]
    [InlineData(3, 4, 4)]
    [InlineData(4, 5, 6)]
    [InlineData(50, 52, 100)]
    public void Create_OfNSides_HasTheBooksCountsAndVolume(int n, int vertices, int faces)
    {
        Mesh mesh = Cones.Create(n, Math.Sqrt(0.5));

        Assert.Equal((vertices, faces), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.True(mesh.IsClosed);
        Assert.Equal(n / 8.0 * Math.Sin(2 * Math.PI / n) * Math.Sqrt(0.5) / 3, Measure.Volume(mesh), 1e-14);
        Assert.Equal(new Vector3D(0, 0, Math.Sqrt(0.5) / 2), mesh.Vertices[vertices - 1].Position);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Tetrahedron_Edges_AreEquallyLong()
    {
        foreach (Edge e in Cones.Tetrahedron().Edges)
            Assert.Equal(Math.Sqrt(3) / 2, Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position), 1e-15);
    }

    [Fact]
    public void Cone_Default_IsTheBooks() => Assert.Equal(Cones.Create(50, Math.Sqrt(0.5)).StateHash(), Cones.Cone().StateHash());

    [Theory]
    [InlineData(2, 1, 1)]
    [InlineData(3, 0, 1)]
    [InlineData(3, 1, -1)]
    [InlineData(3, double.NaN, 1)]
    public void Create_OfBadArguments_Throws(int n, double height, double radius) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Cones.Create(n, height, radius));
}

[Trait("Section", "2.3")]
public class PrismsTests
{
    [Theory]
    [InlineData(3, 6, 8)]
    [InlineData(4, 8, 12)]
    [InlineData(50, 102, 200)]
    public void Create_OfNSides_HasTheBooksCountsAndVolume(int n, int vertices, int faces)
    {
        Mesh mesh = Prisms.Create(n, 2);

        Assert.Equal((vertices, faces), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.True(mesh.IsClosed);
        Assert.Equal(n / 4.0 * Math.Sin(2 * Math.PI / n), Measure.Volume(mesh), 1e-14);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Cube_IsACube()
    {
        Mesh cube = Prisms.Cube();
        double edge = Math.Sqrt(0.5);

        Assert.Equal(edge * edge * edge, Measure.Volume(cube), 1e-15);
        Assert.Equal(6 * edge * edge, Measure.Area(cube), 1e-14);
        Assert.All(cube.Vertices, v => Assert.Equal(Math.Sqrt(6) / 4, v.Position.Length, 1e-15));
    }

    [Fact]
    public void OpenCylinder_HasTwoLoopsAndASeamInTheTexture()
    {
        Mesh mesh = Prisms.OpenCylinder(8, 3);

        Assert.Equal((32, 48), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.Equal((0, 2), (Measure.EulerCharacteristic(mesh), Measure.BoundaryLoops(mesh)));
        Assert.Equal(8 * 2 * 0.5 * Math.Sin(Math.PI / 8), Measure.Area(mesh), 1e-14);
        Assert.All(mesh.Faces, f => Assert.True(Vector3D.Dot(Measure.VectorArea(f), f.HalfEdge.Source.Position with { Z = 0 }) > 0));
        // Corner coordinates follow the angle, except that the seam is 1, not 0.
        foreach (HalfEdge h in mesh.Faces.SelectMany(f => f.HalfEdges.ToArray()))
        {
            Vector2D uv = h.Traits.TextureCoordinate;
            Vector3D p = h.Target.Position;
            Assert.Equal(0.5 * Math.Cos(2 * Math.PI * uv.X), p.X, 1e-15);
            Assert.Equal(0.5 * Math.Sin(2 * Math.PI * uv.X), p.Y, 1e-15);
            Assert.Equal(p.Z + 0.5, uv.Y, 1e-15);
        }
        Assert.Contains(mesh.HalfEdges.Where(h => !h.IsBoundary), h => h.Traits.TextureCoordinate.X == 1);
    }

    [Theory]
    [InlineData(2, 1, 1, 1)]
    [InlineData(3, 0, 1, 1)]
    [InlineData(3, 1, -1, 1)]
    [InlineData(3, 1, 1, double.NaN)]
    public void OpenCylinder_OfBadArguments_Throws(int n, int rings, double height, double radius) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Prisms.OpenCylinder(n, rings, height, radius));
}

[Trait("Section", "2.4")]
public class SpheresTests
{
    [Theory]
    [InlineData(3)]
    [InlineData(10)]
    [InlineData(33)]
    public void UVSphere_OfNRings_HasTheBooksCounts(int n)
    {
        Mesh mesh = Spheres.UVSphere(n, 2);

        Assert.Equal((n * (n - 1) + 2, 2 * n * (n - 1)), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.Equal(2, Measure.EulerCharacteristic(mesh));
        Assert.True(mesh.IsClosed && mesh.IsTriangleMesh);
        Assert.Equal(n, mesh.Vertices[0].Valence);
        Assert.Equal(n, mesh.Vertices[mesh.Vertices.Count - 1].Valence);
        Assert.All(mesh.Vertices, v => Assert.Equal(2, v.Position.Length, 1e-14));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Spheres_AreaAndVolume_ConvergeWithTheSquareOfTheEdge()
    {
        AssertOrder(n => Spheres.UVSphere(n), 4 * Math.PI, 4 * Math.PI / 3);
        AssertOrder(n => Spheres.Icosphere(n == 20 ? 3 : 4), 4 * Math.PI, 4 * Math.PI / 3);
        AssertOrder(n => Spheres.Ellipsoid(1, 1, 0.5, n), null, 4 * Math.PI / 6);

        static void AssertOrder(Func<int, Mesh> make, double? area, double volume)
        {
            Mesh coarse = make(20), fine = make(40);
            Assert.InRange((volume - Measure.Volume(coarse)) / (volume - Measure.Volume(fine)), 3.8, 4.2);
            if (area is double a)
                Assert.InRange((a - Measure.Area(coarse)) / (a - Measure.Area(fine)), 3.8, 4.2);
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public void Icosphere_OfALevel_HasItsCounts(int level)
    {
        Mesh mesh = Spheres.Icosphere(level, 3);
        int power = 1 << (2 * level);

        Assert.Equal((10 * power + 2, 20 * power), (mesh.Vertices.Count, mesh.Faces.Count));
        Assert.All(mesh.Vertices, v => Assert.Equal(3, v.Position.Length, 1e-14));
        Assert.All(mesh.Vertices, v => Assert.InRange(v.Valence, 5, 6));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Spheres_OfBadArguments_Throw()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.UVSphere(2));
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.UVSphere(8, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.Icosphere(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.Icosphere(10));
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.Ellipsoid(1, double.NaN));
    }
}

[Trait("Section", "2.5")]
public class GridsTests
{
    [Theory]
    [InlineData(2, 2)]
    [InlineData(7, 4)]
    [InlineData(10, 11)]
    public void Grid_OfMTimesN_IsCentredToTheLastBit(int m, int n)
    {
        Mesh mesh = Grids.Grid(m, n, 3, 0.7);

        Assert.Equal((m * n, 2 * (m - 1) * (n - 1)), (mesh.Vertices.Count, mesh.Faces.Count));
        for (int v = 0; v < m * n; v++)
            Assert.Equal(-mesh.Vertices[v].Position + Vector3D.Zero, mesh.Vertices[m * n - 1 - v].Position);
        Assert.Equal(3 * 0.7, Measure.Area(mesh), 1e-14);
        Assert.All(mesh.Faces, f => Assert.True(Measure.VectorArea(f).Z > 0));
        Assert.Equal(new Vector2D(1, 1), mesh.Vertices[m * n - 1].Traits.UV);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Grid_OfQuads_HasFourCornersPerFace()
    {
        Mesh mesh = Grids.Grid(4, 3, faces: PatchFaces.Quads);

        Assert.Equal(6, mesh.Faces.Count);
        Assert.All(mesh.Faces, f => Assert.Equal(4, f.Degree));
    }

    [Theory]
    [InlineData(1, 5, 1)]
    [InlineData(5, 1, 1)]
    [InlineData(5, 5, 0)]
    [InlineData(100_000, 100_000, 1)]
    public void Grid_OfBadArguments_Throws(int m, int n, double width) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Grids.Grid(m, n, width));
}

[Trait("Section", "2.6")]
public class CloneTests
{
    [Fact]
    public void Clone_WithTraits_IsEqualAndIndependent()
    {
        Mesh source = Prisms.OpenCylinder(6, 2);
        VertexTrait<double> distance = source.AddVertexTrait("distance", 1.5);
        FaceTraits selected = source.Faces[3].Traits;
        selected.SelectedFlag = 7;
        source.GetOrAddFaceLabels("material").Labels[source.Faces[2]] = source.GetOrAddFaceLabels("material").Number("brass");
        ulong before = source.StateHash();

        Mesh copy = source.Clone();

        Assert.Equal(before, copy.StateHash());
        Assert.Equal(7, copy.Faces[3].Traits.SelectedFlag);
        Assert.Equal("brass", copy.GetOrAddFaceLabels("material").NameOf(copy.Faces[2]));
        foreach (HalfEdge h in source.HalfEdges)
            Assert.Equal(h.Traits.TextureCoordinate, copy.HalfEdges[h.Index].Traits.TextureCoordinate);

        copy.Vertices[0].Position = new(9, 9, 9);
        FaceTraits unselected = copy.Faces[3].Traits;
        unselected.SelectedFlag = 1;
        Assert.True(copy.TryGetVertexTrait("distance", out VertexTrait<double>? copied));
        copied[copy.Vertices[0]] = -1;
        Assert.Equal(before, source.StateHash());
        Assert.Equal(1.5, distance[source.Vertices[0]]);
        Assert.Empty(copy.Validate());
    }
}
