using System.Text.Json;
using MeshLab.IO;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class DirichletProblemTests
{
    [Theory]
    [InlineData(LaplacianWeights.Cotangent)]
    [InlineData(LaplacianWeights.IntrinsicDelaunay)]
    [InlineData(LaplacianWeights.MeanValue)]
    public void Solve_LinearBoundaryValuesOnAPlane_GivesTheLinearFunction(LaplacianWeights weights)
    {
        // These weights reproduce linear functions exactly; random interior vertices make it a test.
        Mesh mesh = Models.Create("grid");
        var random = new Random(3);
        foreach (Vertex v in mesh.Vertices.Where(v => !v.IsBoundary))
            v.Position += new Vector3D(0.04 * random.NextDouble(), 0.04 * random.NextDouble(), 0);
        static double Linear(Vector3D p) => 2 * p.X - 3 * p.Y + 1;

        double[] u = mesh.ComputeHarmonicFunction(
            [.. mesh.Vertices.Where(v => v.IsBoundary).Select(v => (v, Linear(v.Position)))], new HarmonicOptions { Weights = weights });

        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(Linear(v.Position), u[v.Index], 1e-12);
    }

    [Theory]
    [InlineData("bumpy-sphere")]
    [InlineData("torus")]
    [InlineData("genus-2")]
    [InlineData("holes")]
    [InlineData("slivers")]
    [InlineData("far-away")]
    [InlineData("tiny")]
    [InlineData("bipyramid-1200")]
    public void Solve_TwoFixedVertices_StaysBetweenThem(string name)
    {
        Mesh mesh = Models.Create(name);
        Vertex a = mesh.Vertices[0], b = mesh.Vertices[mesh.VertexSlots / 2];
        foreach (LaplacianWeights weights in Enum.GetValues<LaplacianWeights>())
        {
            double[] u = mesh.ComputeHarmonicFunction([(a, 10), (b, 100)], new HarmonicOptions { Weights = weights });

            double slack = weights == LaplacianWeights.Cotangent ? 100 : 1e-9;
            Assert.All(u, value => Assert.InRange(value, 10 - slack, 100 + slack));
            SparseMatrix l = mesh.ComputeLaplacian(weights);
            double[] residual = l.Multiply(u);
            for (int v = 0; v < u.Length; v++)
            {
                if (v != a.Index && v != b.Index)
                    Assert.Equal(0, residual[v] / l.Diagonal[v], 1e-10);
            }
        }
    }

    [Fact]
    public void Solve_OtherValues_ScalesTheFunction()
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        var problem = new DirichletProblem(mesh, [mesh.Vertices[3], mesh.Vertices[90]]);

        double[] u = problem.Solve(0, 1), v = problem.Solve(-5, 5);

        Assert.All(u.Zip(v), pair => Assert.Equal(10 * pair.First - 5, pair.Second, 1e-12));
    }

    [Fact]
    public void Solve_IsolatedVertices_AreNotANumber()
    {
        Mesh mesh = Models.Create("isolated-vertices");

        double[] u = mesh.ComputeHarmonicFunction([(mesh.Vertices[0], 1), (mesh.Vertices[5], 7)]);

        Assert.All(u.Take(4), value => Assert.Equal(1, value, 1e-14));
        Assert.Equal(double.NaN, u[4]);
        Assert.Equal(7, u[5]);
    }

    [Fact]
    public void Solve_VertexWithoutAreaAround_IsNotANumber()
    {
        // Vertex 3 lies on the edge 0–1; its only face has no area.
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 1, 0), new(1, 0, 0)], [0, 1, 2, 1, 0, 3]);

        double[] u = mesh.ComputeHarmonicFunction([(mesh.Vertices[0], 4)]);

        Assert.Equal(4, u[1], 1e-14);
        Assert.Equal(double.NaN, u[3]);
        Assert.Equal(5, mesh.ComputeHarmonicFunction([(mesh.Vertices[0], 4), (mesh.Vertices[3], 5)])[3]);
    }

    [Fact]
    public void Solve_AllVerticesFixed_ReturnsTheirValues()
    {
        Mesh mesh = Models.Tetrahedron();
        Assert.Equal([1, 2, 3, 4], mesh.ComputeHarmonicFunction([.. mesh.Vertices.Select(v => (v, v.Index + 1.0))]));
    }

    [Fact]
    public void Constructor_ComponentWithoutFixedVertex_IsAnErrorUnlessAllowed()
    {
        Mesh mesh = Models.Create("components");
        Vertex fixedVertex = mesh.Vertices[0];

        string message = Assert.Throws<ArgumentException>(() => mesh.ComputeHarmonicFunction([(fixedVertex, 1)])).Message;
        Assert.Contains("v30", message, StringComparison.Ordinal);

        double[] u = mesh.ComputeHarmonicFunction([(fixedVertex, 1)], new HarmonicOptions { AllowUndetermined = true });
        Assert.All(u.Take(30), value => Assert.Equal(1, value, 1e-13));
        Assert.All(u.Skip(30), value => Assert.Equal(double.NaN, value));
    }

    [Fact]
    public void Constructor_BadFixedVertices_Throws()
    {
        Mesh mesh = Models.Tetrahedron(), other = Models.Tetrahedron();

        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, []));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, [other.Vertices[0]]));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, [default]));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, [mesh.Vertices[1], mesh.Vertices[1]]));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, [mesh.Vertices[1]]).Solve(1, 2));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(mesh, [mesh.Vertices[1]]).Solve(double.NaN));
        Assert.Throws<ArgumentException>(() => new DirichletProblem(Models.Create("cube-quads"), [Models.Create("cube-quads").Vertices[0]]));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Solve_ReferenceModel_GivesTheReferenceFunction(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        JsonElement expected = ReferenceData.Json(name, "core").RootElement.GetProperty("harmonic");
        Vertex zero = mesh.Vertices[expected.GetProperty("fixed_zero").GetInt32()], one = mesh.Vertices[expected.GetProperty("fixed_one").GetInt32()];

        double[] u = mesh.ComputeHarmonicFunction([(zero, 0), (one, 1)], new HarmonicOptions { AllowUndetermined = true });

        double[] index = ReferenceData.Numbers(expected.GetProperty("sample_index")), sample = ReferenceData.Numbers(expected.GetProperty("sample"));
        for (int k = 0; k < sample.Length; k++)
            Assert.Equal(sample[k], u[(int)index[k]], 1e-9);
        Assert.Equal(expected.GetProperty("mean_over_vertices").GetDouble(), u.Where(double.IsFinite).Average(), 1e-9);

        double[] residual = mesh.ComputeLaplacian().Multiply([.. u.Select(x => double.IsNaN(x) ? 0 : x)]);
        residual[zero.Index] = residual[one.Index] = 0;
        Assert.InRange(residual.Max(Math.Abs), 0, 1e-10);
    }
}
