using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.4")]
public class VertexNormalsTests
{
    public static TheoryData<VertexNormalWeight> Weights => new(Enum.GetValues<VertexNormalWeight>());

    [Fact]
    public void InscribedSphere_AnyTrianglesOnASphere_IsExact()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(9);
        Vector3D[] normals = mesh.ComputeVertexNormals(VertexNormalWeight.InscribedSphere);
        foreach (Vertex v in mesh.Vertices)
            Assert.True(Vector3D.Distance(normals[v.Index], v.Position) < 1e-14, $"{v}: {normals[v.Index]}");
    }

    [Fact]
    public void Angle_CubeCutIntoTriangles_PointsAlongTheDiagonals()
    {
        // The other kinds feel which corners the diagonals meet.
        Mesh cube = Triangulation.Triangulate(VolumesTests.Cube(new(-0.5, -0.5, -0.5))).Mesh;
        Vector3D[] angle = cube.ComputeVertexNormals(), uniform = cube.ComputeVertexNormals(VertexNormalWeight.Uniform);
        foreach (Vertex v in cube.Vertices)
            Assert.True(Vector3D.Distance(angle[v.Index], v.Position.Normalized()) < 1e-14);
        Assert.Contains(cube.Vertices, v => Vector3D.Distance(uniform[v.Index], v.Position.Normalized()) > 0.1);
    }

    [Theory]
    [MemberData(nameof(Weights))]
    public void AllKinds_QuadCube_PointAlongTheDiagonals(VertexNormalWeight weight)
    {
        Mesh cube = VolumesTests.Cube(new(-0.5, -0.5, -0.5));
        Vector3D[] normals = cube.ComputeVertexNormals(weight);
        foreach (Vertex v in cube.Vertices)
            Assert.True(Vector3D.Distance(normals[v.Index], v.Position.Normalized()) < 1e-14);
    }

    [Theory]
    [MemberData(nameof(Weights))]
    public void NormalBy_HandleAndColumn_AgreeOnTriangles(VertexNormalWeight weight)
    {
        Mesh mesh = AnalyticSurface.Catenoid.Mesh(8);
        Vector3D[] normals = mesh.ComputeVertexNormals(weight);
        foreach (Vertex v in mesh.Vertices)
            Assert.True(Vector3D.Distance(normals[v.Index], v.NormalBy(weight)) < 1e-14);
    }

    [Theory]
    [MemberData(nameof(Weights))]
    public void AllKinds_ZeroAreaFacesAndIsolatedVertex_AreFiniteOrNull(VertexNormalWeight weight)
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0), new(9, 9, 9)], [0, 1, 2, 0, 2, 3]);
        Vector3D[] normals = mesh.ComputeVertexNormals(weight);
        Assert.Equal(Vector3D.UnitZ, normals[0]);
        Assert.Equal(default, normals[1]);
        Assert.Equal(default, normals[4]);
        Assert.Equal(default, mesh.Vertices[4].NormalBy(weight));
    }

    [Theory]
    [InlineData(1e-6, 0, 1e-12)]
    [InlineData(1e6, 0, 1e-12)]
    [InlineData(1, 1e6, 1e-7)]
    public void AllKinds_AnySizeAndPlace_ChangeByRoundingOnly(double size, double offset, double tolerance)
    {
        foreach (VertexNormalWeight weight in Enum.GetValues<VertexNormalWeight>())
        {
            Mesh mesh = AnalyticSurface.Ellipsoid.Mesh(8);
            Vector3D[] before = mesh.ComputeVertexNormals(weight);
            for (int v = 0; v < mesh.VertexSlots; v++)
                mesh.Positions[v] = (mesh.Positions[v] * size) + new Vector3D(offset, -offset, offset);
            Vector3D[] after = mesh.ComputeVertexNormals(weight);
            Assert.All(before.Zip(after), pair => Assert.True(Vector3D.Distance(pair.First, pair.Second) < tolerance));
        }
    }

    [Fact]
    public void Compare_AnalyticSurfaces_ErrorsFallAndMaxIsExactOnTheSphere()
    {
        foreach (AnalyticSurface surface in AnalyticSurface.All)
        {
            IReadOnlyList<NormalError> coarse = VertexNormalComparison.Compare(surface.Mesh(12), surface.Normal);
            IReadOnlyList<NormalError> fine = VertexNormalComparison.Compare(surface.Mesh(24), surface.Normal);
            for (int k = 0; k < coarse.Count; k++)
            {
                Assert.Equal((VertexNormalWeight)k, fine[k].Weight);
                Assert.True(fine[k].MaxError < 0.25);
                Assert.True(fine[k].MeanError < Math.Max(0.6 * coarse[k].MeanError, 1e-14), $"{surface} {fine[k]}");
                Assert.True(fine[k].MeanError <= fine[k].RmsError && fine[k].RmsError <= fine[k].MaxError);
            }
        }
        NormalError max = VertexNormalComparison.Compare(AnalyticSurface.Sphere.Mesh(12), p => p)[(int)VertexNormalWeight.InscribedSphere];
        Assert.True(max.MaxError < 1e-14);
    }

    [Fact]
    public void ComputeVertexNormals_OneAndManyThreads_GiveTheSameBits()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(80);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            Vector3D[] one = mesh.ComputeVertexNormals();
            MassProperties mass = mesh.ComputeMassProperties();
            Parallelism.MaxThreads = 4;
            Assert.Equal(one, mesh.ComputeVertexNormals());
            Assert.Equal(mass, mesh.ComputeMassProperties());
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }

    [Fact]
    public void ComputeVertexNormals_UnknownWeight_Throws() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => AreasTests.Tetrahedron().ComputeVertexNormals((VertexNormalWeight)9));
}
