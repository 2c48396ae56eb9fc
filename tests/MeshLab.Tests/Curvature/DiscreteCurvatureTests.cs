using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Tests.Geometry;
using Xunit;

namespace MeshLab.Tests.Curvature;

[Trait("Section", "10.7")]
public class DiscreteCurvatureTests
{
    [Fact]
    public void Curvatures_Octahedron_AreExact()
    {
        // Edge √2; at each vertex four right-angled-free equilateral triangles: defect 2π/3, mixed area a third of four times √3/2.
        Mesh mesh = AnalyticSurface.Sphere.Mesh(1);
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        double area = 4 * (Math.Sqrt(3) / 2) / 3;
        Assert.All(curvatures.Gaussian, k => Assert.Equal(2 * Math.PI / 3 / area, k, 1e-14));
        // 𝐊 = 1/(2A) · 8 cot 60° (v − p) summed over four neighbours = 8/√3 · v / (2A).
        Assert.All(curvatures.Mean, h => Assert.Equal(2 / Math.Sqrt(3) / area, h, 1e-14));
    }

    [Fact]
    public void Mean_SphereInsideOut_IsNegative()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(8);
        Mesh inside = InsideOut(mesh);
        Assert.All(mesh.ComputeMeanCurvature(), h => Assert.InRange(h, 0.9, 1.1));
        Assert.All(inside.ComputeMeanCurvature(), h => Assert.InRange(h, -1.1, -0.9));
    }

    private static Mesh InsideOut(Mesh mesh) =>
        MeshBuilder.FromTriangles(mesh.Positions, [.. mesh.Faces.SelectMany(f => f.Vertices.Select(v => v.Index).Reverse())]);

    [Fact]
    public void MeanCurvatureNormal_Sphere_IsTwiceTheNormal()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(16);
        Vector3D[] normals = mesh.ComputeMeanCurvatureNormals();
        foreach (Vertex v in mesh.Vertices)
        {
            Assert.True(Vector3D.Distance(normals[v.Index], 2 * v.Position) < 0.05);
            Assert.Equal(normals[v.Index], v.MeanCurvatureNormal);
            Assert.Equal(v.MeanCurvature, mesh.ComputeCurvatures().Mean[v.Index]);
            Assert.Equal(v.GaussianCurvature, mesh.ComputeCurvatures().Gaussian[v.Index]);
            if (v.Index > 3)
                break;
        }
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Gaussian_TimesMixedArea_AddsUpToTheDefects(string name)
    {
        Mesh mesh = Models.Create(name);
        double[] gaussian = mesh.ComputeGaussianCurvature(), areas = mesh.ComputeMixedAreas(), defects = mesh.ComputeAngleDefects();
        for (int v = 0; v < gaussian.Length; v++)
        {
            if (areas[v] > 0)
                Assert.Equal(defects[v], gaussian[v] * areas[v], 1e-12);
            else
                Assert.True(double.IsNaN(gaussian[v]));
        }
    }

    [Fact]
    public void BendingCurvature_Sphere_AddsUpToTheIntegralAndFollowsTheSign()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(12);
        double[] areas = mesh.ComputeBarycentricAreas(), bending = mesh.ComputeBendingCurvature();
        // The integral is ½ Σ |e| θ over all edges, whatever the vertices are given.
        double sum = mesh.Edges.Sum(e => 0.5 * e.Length * e.DihedralAngle);
        Assert.Equal(sum, Enumerable.Range(0, mesh.VertexSlots).Sum(v => bending[v] * areas[v]), 1e-12);
        Assert.InRange(sum / (4 * Math.PI), 0.98, 1.02);
        Assert.All(InsideOut(mesh).ComputeBendingCurvature().Zip(bending), pair => Assert.Equal(-pair.Second, pair.First, 1e-12));
        Assert.All(Models.Create("isolated-vertices").ComputeBendingCurvature().Skip(4), h => Assert.True(double.IsNaN(h)));
        Assert.Throws<ArgumentException>(() => VolumesTests.Cube().ComputeBendingCurvature());
    }

    [Theory]
    [InlineData(1e-6, 0, 1e-9)]
    [InlineData(1e6, 0, 1e-9)]
    [InlineData(1, 1e6, 1e-5)]
    public void Curvatures_AnySizeAndPlace_ScaleByRoundingOnly(double size, double offset, double tolerance)
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(16);
        VertexCurvatures before = mesh.ComputeCurvatures();
        for (int v = 0; v < mesh.VertexSlots; v++)
            mesh.Positions[v] = (mesh.Positions[v] * size) + new Vector3D(offset, -offset, offset);
        VertexCurvatures after = mesh.ComputeCurvatures();
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            Assert.Equal(before.Gaussian[v], after.Gaussian[v] * size * size, tolerance);
            Assert.Equal(before.Mean[v], after.Mean[v] * size, tolerance);
        }
    }

    [Fact]
    public void Mean_SpikyMesh_HasTheSignOfTheAngleWeightedNormal()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(12);
        var random = new Random(5);
        foreach (Vertex v in mesh.Vertices)
            v.Position *= 0.2 + 2 * random.NextDouble();
        Vector3D[] normals = mesh.ComputeVertexNormals(), curvature = mesh.ComputeMeanCurvatureNormals();
        double[] mean = mesh.ComputeMeanCurvature();
        foreach (Vertex v in mesh.Vertices)
        {
            Assert.Equal(Math.Sign(Vector3D.Dot(curvature[v.Index], normals[v.Index])), Math.Sign(mean[v.Index]));
            Assert.Equal(curvature[v.Index].Length / 2, Math.Abs(mean[v.Index]), 1e-12 * (1 + Math.Abs(mean[v.Index])));
        }
    }

    [Fact]
    public void Curvatures_ZeroAreaFaceAndIsolatedVertex_NoInfinity()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(1, 1, 0), new(9, 9, 9)], [0, 1, 2, 0, 2, 3]);
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        Assert.True(double.IsNaN(curvatures.Gaussian[4]));
        Assert.True(double.IsNaN(curvatures.Mean[1]));
        Assert.All(new[] { 0, 2, 3 }, v => Assert.True(double.IsFinite(curvatures.Gaussian[v]) && double.IsFinite(curvatures.Mean[v])));
    }

    [Fact]
    public void Curvatures_Polygons_ThrowNamingTheFace()
    {
        Assert.Contains("f0", Assert.Throws<ArgumentException>(() => VolumesTests.Cube().ComputeCurvatures()).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => VolumesTests.Cube().Vertices[0].MeanCurvature);
        Assert.All(Enum.GetValues<PrincipalCurvatureMethod>(), m => Assert.Throws<ArgumentException>(() => VolumesTests.Cube().ComputePrincipalCurvatures(m)));
    }

    [Fact]
    public void Curvatures_OneAndManyThreads_GiveTheSameBits()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(64);
        int threads = Parallelism.MaxThreads;
        try
        {
            Parallelism.MaxThreads = 1;
            VertexCurvatures one = mesh.ComputeCurvatures();
            PrincipalCurvatures jets = mesh.ComputePrincipalCurvatures();
            Parallelism.MaxThreads = 3;
            Assert.Equal(one.Gaussian, mesh.ComputeCurvatures().Gaussian);
            Assert.Equal(one.Mean, mesh.ComputeCurvatures().Mean);
            Assert.Equal(jets.Max, mesh.ComputePrincipalCurvatures().Max);
            Assert.Equal(jets.MinDirection, mesh.ComputePrincipalCurvatures().MinDirection);
        }
        finally
        {
            Parallelism.MaxThreads = threads;
        }
    }
}
