using MeshLab.Geodesics;
using MeshLab.IO;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geodesics;

[Trait("Section", "12.1")]
public class HeatGeodesicsTests
{
    [Fact]
    public void ComputeDistances_Spheres_ConvergeToTheAngle()
    {
        double coarse = Error(12), fine = Error(48);

        Assert.InRange(fine, 0, 0.03);
        // A quarter of the edge length: a sixteenth of the error.
        Assert.InRange(coarse / fine, 8, 24);

        // From the north pole of the unit sphere, the distance is the angle.
        static double Error(int rings)
        {
            Mesh mesh = Models.Sphere(rings - 1, 2 * rings);
            Vertex pole = mesh.Vertices.First(v => v.Position == Vector3D.UnitZ);
            double[] d = new HeatGeodesics(mesh).ComputeDistances(pole);
            return mesh.Vertices.Max(v => Math.Abs(d[v.Index] - Vector3D.Angle(v.Position, Vector3D.UnitZ))) / Math.PI;
        }
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void ComputeDistances_AnyMesh_IsFiniteInTheSourcesComponent(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count == 0)
            return;
        double[] edge = mesh.ComputeEdgeDistances(mesh.Vertices[0]), heat = new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0]);

        double[] area = mesh.ComputeLumpedMasses(MassKind.Barycentric);
        Assert.Equal(0, heat[0], 1e-12);
        foreach (Vertex v in mesh.Vertices)
        {
            if (area[v.Index] == 0 && v.Index != 0)
                Assert.Equal(double.NaN, heat[v.Index]);
            else
                Assert.Equal(double.IsInfinity(edge[v.Index]), double.IsInfinity(heat[v.Index]));
        }
    }

    [Fact]
    public void ComputeDistances_VertexWithoutAreaAround_IsNotANumber()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 1, 0), new(1, 0, 0)], [0, 1, 2, 1, 0, 3]);
        double[] d = new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0]);
        Assert.Equal(double.NaN, d[3]);
        Assert.All(d.Take(3), value => Assert.True(double.IsFinite(value)));
    }

    [Fact]
    public void ComputeDistances_TinyMesh_ScalesWithIt()
    {
        Mesh sphere = Models.Create("sphere"), tiny = Models.Create("tiny");
        double[] unit = new HeatGeodesics(sphere).ComputeDistances(sphere.Vertices[5]), scaled = new HeatGeodesics(tiny).ComputeDistances(tiny.Vertices[5]);
        Assert.All(unit.Zip(scaled), pair => Assert.Equal(pair.First, pair.Second * 1e6, 1e-9));
    }

    [Fact]
    public void ComputeDistances_LongStrip_DoesNotUnderflow()
    {
        // Heat falls by about e per edge; 1200 edges would take it below the smallest number from 1.
        Mesh mesh = Models.Triangulated(Models.QuadGrid(1200, 3));
        foreach (ref Vector3D p in mesh.Positions)
            p = new(p.X * 400, p.Y, 0);
        double[] d = new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0], mesh.Vertices[1201], mesh.Vertices[2402], mesh.Vertices[3603]);
        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(v.Position.X, d[v.Index], 0.4);
    }

    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("bunny_closed")]
    [InlineData("three_holes")]
    [InlineData("reference_annulus")]
    public void ComputeDistances_ReferenceModel_IsNearTheExactDistance(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        double[] exact = ReferenceData.Numbers(ReferenceData.Arrays(name, "extras").RootElement.GetProperty("exact_geodesic_from_0"));

        double[] d = new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0]);

        // Independent programs' heat methods are 2 to 17 % of the largest distance away; so are we.
        Assert.InRange(d.Zip(exact, (a, b) => Math.Abs(a - b)).Max() / exact.Max(), 0, 0.1);
        double[] edge = mesh.ComputeEdgeDistances(mesh.Vertices[0]);
        Assert.All(edge.Zip(exact), pair => Assert.True(pair.First >= pair.Second * (1 - 1e-9)));
    }
}
