using System.Text.Json;
using MeshLab.Curvature;
using MeshLab.Generation;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

/// <summary>Every shape whose area, volume and curvature are known exactly: beside the reference values, and beside what can be said without them.</summary>
[Trait("Section", "10.1")]
[Trait("Section", "10.2")]
[Trait("Section", "10.7")]
public class AnalyticReferenceTests
{
    private const double Tau = 2 * Math.PI;

    /// <summary>The surfaces, and how the reference values name them.</summary>
    private static readonly Dictionary<string, AnalyticSurface> Surfaces = new(StringComparer.Ordinal)
    {
        ["unit_sphere"] = AnalyticSurface.Sphere,
        ["torus_R2_r0.5"] = AnalyticSurface.Torus,
        ["cylinder_R1_h2_lateral"] = AnalyticSurface.Cylinder,
        ["cone_R1_h2_lateral"] = AnalyticSurface.Cone,
        ["ellipsoid_1.5_1_0.75"] = AnalyticSurface.Ellipsoid,
        ["catenoid_c1"] = AnalyticSurface.Catenoid,
        ["hyperbolic_paraboloid"] = AnalyticSurface.HyperbolicParaboloid,
    };

    private static readonly Dictionary<string, Func<Mesh>> Solids = new(StringComparer.Ordinal)
    {
        ["tetrahedron"] = () => Polyhedra.Tetrahedron(),
        ["cube"] = () => Polyhedra.Cube(),
        ["octahedron"] = () => Polyhedra.Octahedron(),
        ["dodecahedron"] = () => Polyhedra.Dodecahedron(),
        ["icosahedron"] = () => Polyhedra.Icosahedron(),
    };

    public static TheoryData<string> SurfaceNames => new(Surfaces.Keys);

    public static TheoryData<string> SolidNames => new(Solids.Keys);

    [SkippableFact]
    public void AnalyticShapes_AllOfTheReference_AreComparedHere()
    {
        JsonElement reference = ReferenceData.Json("analytic").RootElement;
        Assert.Equal(reference.GetProperty("surfaces").EnumerateObject().Select(p => p.Name).Order(StringComparer.Ordinal), Surfaces.Keys.Order(StringComparer.Ordinal), StringComparer.Ordinal);
        Assert.Equal(reference.GetProperty("platonic_edge_length_1").EnumerateObject().Select(p => p.Name).Order(StringComparer.Ordinal), Solids.Keys.Order(StringComparer.Ordinal), StringComparer.Ordinal);
    }

    [SkippableTheory]
    [MemberData(nameof(SurfaceNames))]
    public void ExactCurvatures_Samples_EqualTheReferenceValues(string name)
    {
        AnalyticSurface surface = Surfaces[name];
        JsonElement[] samples = [.. Reference(name).GetProperty("samples").EnumerateArray()];
        Assert.Equal(25, samples.Length);
        foreach (JsonElement sample in samples)
        {
            double[] p = ReferenceData.Numbers(sample.GetProperty("point"));
            Vector3D point = new(p[0], p[1], p[2]);
            Assert.Equal(sample.GetProperty("H").GetDouble(), surface.Mean(point), 1e-13);
            Assert.Equal(sample.GetProperty("K").GetDouble(), surface.Gaussian(point), 1e-12);
        }
    }

    /// <summary>The exact H is half the divergence of the unit normal, so that formula, sign and normal fit together.</summary>
    [Theory]
    [MemberData(nameof(SurfaceNames))]
    public void ExactMeanCurvature_AnySurface_IsHalfTheDivergenceOfItsNormal(string name)
    {
        AnalyticSurface surface = Surfaces[name];
        foreach (Vertex v in surface.Mesh(6).Vertices)
        {
            Vector3D p = v.Position, n = surface.Normal(p).Normalized(), a = Vector3D.Cross(n, Math.Abs(n.X) < 0.6 ? Vector3D.UnitX : Vector3D.UnitY).Normalized(), b = Vector3D.Cross(n, a);
            Assert.Equal(surface.Mean(p), 0.5 * (Change(a) + Change(b)), 1e-7);

            double Change(Vector3D t) => Vector3D.Dot(t, surface.Normal(p + (1e-5 * t)).Normalized() - surface.Normal(p - (1e-5 * t)).Normalized()) / 2e-5;
        }
    }

    /// <summary>Both over the mesh of the surface: half of the cone's height has three quarters of its side.</summary>
    [SkippableTheory]
    [MemberData(nameof(SurfaceNames))]
    public void AreaAndVolume_SmoothSurface_ConvergeWithOrderTwo(string name)
    {
        JsonElement reference = Reference(name);
        MassProperties coarse = Surfaces[name].Mesh(16).ComputeMassProperties(), fine = Surfaces[name].Mesh(32).ComputeMassProperties();
        IsOrderTwo(reference.GetProperty("area_value").GetDouble() * (name.StartsWith("cone", StringComparison.Ordinal) ? 0.75 : 1), coarse.Area, fine.Area);
        if (Surfaces[name].Mesh(4).IsClosed)
            IsOrderTwo(reference.GetProperty("volume_value").GetDouble(), coarse.Volume, fine.Volume);
    }

    [SkippableTheory]
    [InlineData("cylinder_R1_h2_lateral", Tau)]
    [InlineData("cone_R1_h2_lateral", Math.PI)]
    public void AreaAndVolume_CylinderAndConeWithTheirLids_ConvergeWithOrderTwo(string name, double lids)
    {
        JsonElement reference = Reference(name);
        Func<int, Mesh> make = name.StartsWith("cone", StringComparison.Ordinal) ? n => Cones.Cone(n, 2, 1) : n => Prisms.Cylinder(n, 2, 1);
        MassProperties coarse = make(32).ComputeMassProperties(), fine = make(64).ComputeMassProperties();
        IsOrderTwo(reference.GetProperty("area_value").GetDouble() + lids, coarse.Area, fine.Area);
        IsOrderTwo(reference.GetProperty("volume_value").GetDouble(), coarse.Volume, fine.Volume);
    }

    [Theory]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(200)]
    public void Measures_PrismAndPyramid_AreThoseOfTheirPolygons(int n)
    {
        double side = 2 * Math.Sin(Math.PI / n), inner = Math.Cos(Math.PI / n), polygon = 0.5 * n * Math.Sin(Tau / n), slant = Math.Sqrt(4 + (inner * inner));
        MassProperties prism = Prisms.Cylinder(n, 2, 1).ComputeMassProperties();
        Assert.Equal((2 * polygon) + (2 * n * side), prism.Area, 1e-12);
        Assert.Equal(2 * polygon, prism.Volume, 1e-12);

        Mesh pyramid = Cones.Cone(n, 2, 1);
        MassProperties cone = pyramid.ComputeMassProperties();
        Assert.Equal(polygon + (0.5 * n * side * slant), cone.Area, 1e-12);
        Assert.Equal(2 * polygon / 3, cone.Volume, 1e-12);
        Assert.Equal(Tau - (2 * n * Math.Atan2(side / 2, slant)), pyramid.ComputeAngleDefects()[Apex(pyramid)], 1e-12);
    }

    [Fact]
    public void AngleDefect_ApexOfACone_ConvergesToThatOfTheSmoothOne()
    {
        // 2π(1 − sin α) with sin α = R/√(R² + h²).
        double[] defects = [.. new[] { 32, 64 }.Select(n => Cones.Cone(n, 2, 1)).Select(cone => cone.ComputeAngleDefects()[Apex(cone)])];
        IsOrderTwo(Tau * (1 - (1 / Math.Sqrt(5))), defects[0], defects[1]);
    }

    [Fact]
    public void IntegralsOfCurvature_CatenoidTorusCylinder_AreTheExactOnes()
    {
        // ∫K over the catenoid is −4π tanh 1; the vertices of the boundary hold its turning instead, which the interior sum leaves out.
        double[] total = [.. new[] { 32, 64, 128 }.Select(n => InteriorDefects(AnalyticSurface.Catenoid.Mesh(n)))];
        Assert.Equal(-4 * Math.PI * Math.Tanh(1), (2 * total[2]) - total[1], 2e-2);
        Assert.Equal(0, InteriorDefects(AnalyticSurface.Torus.Mesh(16)), 1e-11);
        Assert.Equal(0, InteriorDefects(AnalyticSurface.Cylinder.Mesh(16)), 1e-11);

        // ∫H over the torus is 2π²R.
        double[] mean = [.. new[] { 16, 32 }.Select(n => AnalyticSurface.Torus.Mesh(n)).Select(m => m.ComputeMeanCurvature().Zip(m.ComputeMixedAreas(), (h, a) => h * a).Sum())];
        IsOrderTwo(4 * Math.PI * Math.PI, mean[0], mean[1]);
    }

    [SkippableTheory]
    [MemberData(nameof(SolidNames))]
    public void PlatonicSolid_EdgeLengthOne_EqualsTheReferenceValues(string name)
    {
        JsonElement expected = ReferenceData.Json("analytic").RootElement.GetProperty("platonic_edge_length_1").GetProperty(name);
        Mesh mesh = WithEdgesOfOne(Solids[name]());
        Assert.Equal(Count("V"), mesh.Vertices.Count);
        Assert.Equal(Count("E"), mesh.Edges.Count);
        Assert.Equal(Count("F"), mesh.Faces.Count);
        MassProperties mass = mesh.ComputeMassProperties();
        Assert.Equal(Value("area"), mass.Area, 2e-14 * mass.Area);
        Assert.Equal(Value("volume"), mass.Volume, 2e-14 * mass.Volume);
        Assert.All(mesh.ComputeDihedralAngles(), angle => Assert.Equal(Value("exterior_dihedral"), angle, 1e-14));
        Assert.All(mesh.ComputeAngleDefects(), defect => Assert.Equal(Value("defect"), defect, 2e-14));

        int Count(string element) => expected.GetProperty(element).GetInt32();
        double Value(string quantity) => expected.GetProperty(quantity).GetDouble();
    }

    /// <summary>Faces of p corners, q of them at a vertex: everything else follows (Schläfli).</summary>
    [Theory]
    [InlineData("tetrahedron", 3, 3)]
    [InlineData("cube", 4, 3)]
    [InlineData("octahedron", 3, 4)]
    [InlineData("dodecahedron", 5, 3)]
    [InlineData("icosahedron", 3, 5)]
    public void PlatonicSolid_EdgeLengthOne_FollowsFromItsSymbol(string name, int p, int q)
    {
        Mesh mesh = WithEdgesOfOne(Solids[name]());
        int edges = 2 * p * q / (4 - ((p - 2) * (q - 2)));
        Assert.Equal(edges, mesh.Edges.Count);
        Assert.All(mesh.Faces, f => Assert.Equal(p, f.Degree));
        Assert.All(mesh.Vertices, v => Assert.Equal(q, v.Valence));
        double interior = 2 * Math.Asin(Math.Cos(Math.PI / q) / Math.Sin(Math.PI / p)), perFace = p / (4 * Math.Tan(Math.PI / p)), area = 2 * edges / p * perFace;
        double inradius = Math.Tan(interior / 2) / (2 * Math.Tan(Math.PI / p));
        MassProperties mass = mesh.ComputeMassProperties();
        Assert.All(mesh.ComputeFaceAreas(), a => Assert.Equal(perFace, a, 1e-14));
        Assert.Equal(area, mass.Area, 1e-13);
        Assert.Equal(area * inradius / 3, mass.Volume, 1e-13);
        Assert.All(mesh.ComputeDihedralAngles(), angle => Assert.Equal(Math.PI - interior, angle, 1e-14));
        Assert.All(mesh.ComputeCornerAngles(), angle => Assert.Equal(Math.PI * (p - 2) / p, angle, 1e-14));
        Assert.All(mesh.ComputeAngleDefects(), defect => Assert.Equal(2 * Tau / mesh.Vertices.Count, defect, 2e-14));
    }

    private static JsonElement Reference(string name) => ReferenceData.Json("analytic").RootElement.GetProperty("surfaces").GetProperty(name);

    private static void IsOrderTwo(double exact, double coarse, double fine) => Assert.InRange(Math.Log2(Math.Abs((coarse - exact) / (fine - exact))), 1.8, 2.2);

    private static double InteriorDefects(Mesh mesh)
    {
        double[] defects = mesh.ComputeAngleDefects();
        return mesh.Vertices.Where(v => !v.IsBoundary).Sum(v => defects[v.Index]);
    }

    private static int Apex(Mesh cone) => cone.Vertices.Single(v => Math.Abs(v.Position.X) + Math.Abs(v.Position.Y) < 1e-12 && v.Position.Z > cone.Vertices.Average(w => w.Position.Z)).Index;

    private static Mesh WithEdgesOfOne(Mesh solid)
    {
        double length = solid.Edges[0].Length;
        foreach (ref Vector3D p in solid.Positions)
            p /= length;
        return solid;
    }
}
