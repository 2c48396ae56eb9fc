using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Curvature;

[Trait("Section", "10.8")]
public class PrincipalCurvatureTests
{
    public static TheoryData<string> Surfaces => new(AnalyticSurface.All.Select(s => s.Name));

    /// <summary>The least order of the root mean square error that every quantity shows.</summary>
    [Theory]
    [InlineData("sphere")]
    [InlineData("torus")]
    [InlineData("ellipsoid")]
    [InlineData("catenoid")]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("hyperbolic paraboloid")]
    public void ConvergenceStudy_AnalyticSurface_AllCurvaturesConverge(string name)
    {
        AnalyticSurface surface = AnalyticSurface.All.Single(s => s.Name == name);
        IReadOnlyList<ConvergenceStep> steps = ConvergenceStudy.Measure(surface, 16, 32, 64);
        Assert.Equal(30, steps.Count);
        foreach (ConvergenceStep step in steps.Where(s => s.Size == 64))
        {
            // Tensors of faces and Laplacians of normals lose order where valences are irregular; the others show second order.
            double least = step.Quantity.Contains("Tensor", StringComparison.Ordinal) ? 1.2
                : step.Quantity is "K" or "k1 JetFitting" or "k2 JetFitting" ? 1.6
                : 1.5;
            Assert.True(step.RmsError < 0.05, $"{name} {step}");
            // A ring of vertices of a cylinder is turned into the next one by a symmetry, so that their defects are zero.
            if (name == "cylinder" && step.Quantity is ("K" or "k2 MeanAndGaussian"))
                Assert.True(step.RmsError < 1e-12 && double.IsNaN(step.Order), $"{name} {step}");
            else
                Assert.True(step.Order > least, $"{name} {step}");
        }
    }

    [Fact]
    public void Directions_Torus_PointAlongTubeAndAxisCircles()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(32);
        foreach (PrincipalCurvatureMethod method in (PrincipalCurvatureMethod[])[PrincipalCurvatureMethod.TensorAveraging, PrincipalCurvatureMethod.JetFitting])
        {
            PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(method);
            foreach (Vertex v in mesh.Vertices)
            {
                Vector3D around = new Vector3D(-v.Position.Y, v.Position.X, 0).Normalized();
                Assert.True(Math.Abs(Vector3D.Dot(principal.MinDirection[v.Index], around)) > 0.99, $"{method} {v}");
                Assert.Equal(0, Vector3D.Dot(principal.MaxDirection[v.Index], principal.MinDirection[v.Index]), 1e-12);
                Assert.Equal(1, principal.MaxDirection[v.Index].Length, 1e-12);
                Assert.True(Math.Abs(Vector3D.Dot(principal.MaxDirection[v.Index], AnalyticSurface.Torus.Normal(v.Position).Normalized())) < 0.05);
            }
        }
    }

    [Fact]
    public void JetFitting_QuadricItself_IsExactAtTheVertex()
    {
        // z = −½(3x² + y²) − xy/4 over a grid: the fit finds the coefficients, so at the middle (flat there) the curvatures are those of the matrix.
        var builder = new MeshBuilder();
        const int N = 9;
        for (int j = 0; j < N; j++)
        {
            for (int i = 0; i < N; i++)
            {
                double x = 0.1 * (i - 4), y = 0.1 * (j - 4);
                builder.AddVertex(new(x, y, (-0.5 * ((3 * x * x) + (y * y))) - (x * y / 4)));
            }
        }
        for (int j = 0; j + 1 < N; j++)
        {
            for (int i = 0; i + 1 < N; i++)
            {
                int a = (j * N) + i;
                builder.AddFace(a, a + 1, a + N + 1);
                builder.AddFace(a, a + N + 1, a + N);
            }
        }
        PrincipalCurvatures principal = builder.Build().ComputePrincipalCurvatures();
        double root = Math.Sqrt(1 + (0.25 * 0.25));
        int middle = (4 * N) + 4;
        Assert.Equal(2 + root, principal.Max[middle], 1e-9);
        Assert.Equal(2 - root, principal.Min[middle], 1e-9);
    }

    [Fact]
    public void JetFitting_TooFewPoints_IsNaN()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]);
        Assert.All(mesh.ComputePrincipalCurvatures().Max, k => Assert.True(double.IsNaN(k)));
        // The six vertices of an octahedron lie on a conic of revolution seen from each of them: fewer unknowns can be told apart.
        Assert.Throws<ArgumentOutOfRangeException>(() => new JetFittingOptions { Rings = 0 });
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void AllMethods_AnyTriangleMesh_AreOrderedAndNeverInfinite(string name)
    {
        Mesh mesh = Models.Create(name);
        foreach (PrincipalCurvatureMethod method in Enum.GetValues<PrincipalCurvatureMethod>())
        {
            PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(method);
            for (int v = 0; v < mesh.VertexSlots; v++)
            {
                Assert.False(double.IsInfinity(principal.Max[v]) || double.IsInfinity(principal.Min[v]), $"{method} v{v}");
                Assert.False(principal.Max[v] < principal.Min[v], $"{method} v{v}");
            }
        }
    }

    [Fact]
    public void WriteCurvatureTraits_Sphere_FillsTheTextbooksTraits()
    {
        Mesh mesh = AnalyticSurface.Sphere.Mesh(12);
        mesh.WriteCurvatureTraits();
        VertexCurvatures curvatures = mesh.ComputeCurvatures();
        PrincipalCurvatures principal = mesh.ComputePrincipalCurvatures(PrincipalCurvatureMethod.TensorAveraging);
        foreach (Vertex v in mesh.Vertices)
        {
            Assert.Equal(curvatures.Gaussian[v.Index], v.Traits.GaussianCurvature);
            Assert.Equal(curvatures.Mean[v.Index], v.Traits.MeanCurvature);
            Assert.Equal(principal.Max[v.Index], v.Traits.MaxCurvature);
            Assert.Equal(principal.MinDirection[v.Index], v.Traits.MinCurvatureDirection);
        }
        Assert.Empty(mesh.Validate());
    }
}
