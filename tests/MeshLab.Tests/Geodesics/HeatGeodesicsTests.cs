using System.Text.Json;
using MeshLab.Geodesics;
using MeshLab.Geometry;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geodesics;

[Trait("Section", "12.1")]
public class HeatGeodesicsTests
{
    private static readonly HeatOptions AsGiven = new() { IntrinsicDelaunay = false };

    /// <summary>
    /// Exact distances on surfaces that are flat, round, and rolled up. The limits are a tenth above what the method gives: with the time h² its error is about half an edge
    /// length, and the order falls slowly below 1, since ever shorter times feel the lattice (Crane, Weischedel, Wardetzky 2013, §3.3).
    /// </summary>
    [Theory]
    [InlineData("plane, from the middle", 32, 0.0385, 0.0137, 0.55)]
    [InlineData("plane, from a corner", 32, 0.0252, 0.0084, 0.55)]
    [InlineData("sphere, from a pole", 16, 0.0105, 0.0049, 0.68)]
    [InlineData("sphere, from anywhere", 16, 0.0110, 0.0051, 0.45)]
    [InlineData("cylinder", 32, 0.0199, 0.0068, 0.55)]
    public void ComputeDistances_AnalyticSurface_IsNearTheExactDistance(string name, int size, double most, double rms, double order)
    {
        bool isPlane = name.StartsWith("plane", StringComparison.Ordinal);
        (double maxCoarse, _) = Errors(name, isPlane ? size / 2 : size);
        (double max, double mean) = Errors(name, isPlane ? size : 2 * size);

        Assert.InRange(max, 0, most);
        Assert.InRange(mean, 0, rms);
        // The edge length is halved.
        Assert.InRange(Math.Log2(maxCoarse / max), 0.7 * order, 2);
    }

    [Theory]
    [InlineData("plane, from the middle")]
    [InlineData("sphere, from anywhere")]
    [InlineData("cylinder")]
    public void ComputeDistances_IntrinsicDelaunayOfADelaunayMesh_IsTheSame(string name)
    {
        (Mesh mesh, Vertex source, _) = Surface(name, 16);
        double[] plain = new HeatGeodesics(mesh, AsGiven).ComputeDistances(source), intrinsic = new HeatGeodesics(mesh).ComputeDistances(source);
        Assert.All(plain.Zip(intrinsic), pair => Assert.Equal(pair.First, pair.Second, 1e-9));
    }

    [Fact]
    public void ComputeDistances_PlaneOfSlivers_NeedsTheIntrinsicTriangulation()
    {
        // A regular grid, sheared by three cells per row: no triangle is Delaunay, and most weights are negative.
        Mesh mesh = Models.Triangulated(Models.QuadGrid(24, 24));
        foreach (ref Vector3D p in mesh.Positions)
            p = new(p.X + (3 * p.Y), p.Y, 0);
        Vertex middle = mesh.Vertices[(12 * 25) + 12];
        double[] plain = new HeatGeodesics(mesh, AsGiven).ComputeDistances(middle), intrinsic = new HeatGeodesics(mesh).ComputeDistances(middle);
        Assert.InRange(Worst(intrinsic), 0, 0.06);
        Assert.True(Worst(plain) > 2 * Worst(intrinsic), $"{Worst(plain)} {Worst(intrinsic)}");

        // The straight way stays inside the parallelogram.
        double Worst(double[] d) => mesh.Vertices.Max(v => Math.Abs(d[v.Index] - Vector3D.Distance(v.Position, middle.Position))) / 1.6;
    }

    private static (double Max, double Rms) Errors(string name, int size)
    {
        (Mesh mesh, Vertex source, Func<Vector3D, Vector3D, double> exact) = Surface(name, size);
        double[] d = new HeatGeodesics(mesh).ComputeDistances(source);
        double[] distances = [.. mesh.Vertices.Select(v => exact(source.Position, v.Position))];
        double far = distances.Max();
        return (d.Zip(distances, (x, y) => Math.Abs(x - y)).Max() / far, Math.Sqrt(d.Zip(distances, (x, y) => (x - y) * (x - y)).Average()) / far);
    }

    private static (Mesh Mesh, Vertex Source, Func<Vector3D, Vector3D, double> Exact) Surface(string name, int size)
    {
        switch (name)
        {
            case "plane, from the middle":
            case "plane, from a corner":
                Mesh plane = Patch(size, size, isRolled: false);
                return (plane, Nearest(plane, name.EndsWith("middle", StringComparison.Ordinal) ? new(0.5, 0.5, 0) : default), Vector3D.Distance);
            case "sphere, from a pole":
            case "sphere, from anywhere":
                Mesh sphere = AnalyticSurface.Sphere.Mesh(size);
                return (sphere, Nearest(sphere, name.EndsWith("pole", StringComparison.Ordinal) ? Vector3D.UnitZ : new Vector3D(1, 0.7, 0.4).Normalized()), Vector3D.Angle);
            default:
                // Unrolled, the distance is that of the plane.
                Mesh cylinder = Patch(size, size / 2, isRolled: true);
                return (cylinder, Nearest(cylinder, new(1, 0, 1.36)), (a, b) =>
                {
                    double around = Vector3D.Angle(new(a.X, a.Y, 0), new(b.X, b.Y, 0));
                    return Math.Sqrt((around * around) + ((a.Z - b.Z) * (a.Z - b.Z)));
                });
        }
    }

    private static Vertex Nearest(Mesh mesh, Vector3D point) => mesh.Vertices.MinBy(v => Vector3D.DistanceSquared(v.Position, point));

    /// <summary>The unit square with diagonals both ways by turns, or a cylinder of radius 1 and height 2.72 with rows shifted by half a cell.</summary>
    private static Mesh Patch(int n, int m, bool isRolled)
    {
        var builder = new MeshBuilder();
        int columns = isRolled ? n : n + 1;
        for (int j = 0; j <= m; j++)
        {
            for (int i = 0; i < columns; i++)
            {
                double angle = 2 * Math.PI * (i + (0.5 * (j % 2))) / n;
                builder.AddVertex(isRolled ? new(Math.Cos(angle), Math.Sin(angle), 2.72 * j / m) : new((double)i / n, (double)j / m, 0));
            }
        }
        for (int j = 0; j < m; j++)
        {
            for (int i = 0; i < n; i++)
            {
                int a = At(i, j), b = At(i + 1, j), c = At(i + 1, j + 1), d = At(i, j + 1);
                bool rising = isRolled ? j % 2 == 1 : (i + j) % 2 == 0;
                builder.AddFace(a, b, rising ? c : d);
                if (rising)
                    builder.AddFace(a, c, d);
                else
                    builder.AddFace(b, c, d);
            }
        }
        return builder.Build();

        int At(int i, int j) => (j * columns) + (isRolled ? i % n : i);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void ComputeDistances_AnyMesh_IsFiniteInTheSourcesComponent(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count == 0)
            return;
        double[] edge = mesh.ComputeEdgeDistances(mesh.Vertices[0]), heat = new HeatGeodesics(mesh, AsGiven).ComputeDistances(mesh.Vertices[0]);

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
        double[] d = new HeatGeodesics(mesh, AsGiven).ComputeDistances(mesh.Vertices[0]);
        Assert.Equal(double.NaN, d[3]);
        Assert.All(d.Take(3), value => Assert.True(double.IsFinite(value)));
        // The flat face loses its long side to the face beside it: then there is area around every vertex.
        Assert.All(new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0]), value => Assert.True(double.IsFinite(value)));
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

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void ComputeDistances_IntrinsicOfAnyMesh_IsFiniteInTheSourcesComponent(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count == 0)
            return;
        double[] edge = mesh.ComputeEdgeDistances(mesh.Vertices[0]);
        double[] heat = new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0]);
        Assert.All(edge.Zip(heat), pair => Assert.Equal(double.IsFinite(pair.First), double.IsFinite(pair.Second)));
    }

    /// <summary>
    /// Beside the exact polyhedral distance (window propagation). The limit is the error that an independent program's heat method, on a tufted intrinsic triangulation, has
    /// at the same vertices, and a tenth more for another choice of diagonals.
    /// </summary>
    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("bunny_closed")]
    [InlineData("three_holes")]
    [InlineData("reference_annulus")]
    [InlineData("fandisk")]
    [InlineData("rocker_arm")]
    [InlineData("camelhead")]
    [InlineData("featuretype")]
    public void ComputeDistances_ReferenceModel_IsAsNearTheExactDistanceAsOthers(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        JsonElement geodesics = ReferenceData.Json(name, "extras").RootElement.GetProperty("geodesic_from_vertex_0"), exact = geodesics.GetProperty("exact_libigl_MMP");
        double[] index = ReferenceData.Numbers(exact.GetProperty("sample_index")), sample = ReferenceData.Numbers(exact.GetProperty("sample"));
        double far = exact.GetProperty("max").GetDouble(), limit = 1.1 * geodesics.GetProperty("heat_vs_exact_max_rel").GetDouble();

        double usual = Worst(new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[0])), asGiven = Worst(new HeatGeodesics(mesh, AsGiven).ComputeDistances(mesh.Vertices[0]));
        Assert.InRange(usual, 0, limit);
        // Slivers make the weights of the given triangles negative on these two: the reason why the triangulation is intrinsic unless asked otherwise.
        if (name is "camelhead" or "featuretype")
            Assert.True(asGiven > 2 * usual, $"{asGiven} {usual}");
        else
            Assert.InRange(asGiven, 0, limit);
        double[] edge = mesh.ComputeEdgeDistances(mesh.Vertices[0]);
        Assert.All(index.Zip(sample), pair => Assert.True(edge[(int)pair.First] >= pair.Second * (1 - 1e-9)));

        double Worst(double[] d) => index.Zip(sample, (i, e) => Math.Abs(d[(int)i] - e)).Max() / far;
    }
}
