using System.Text.Json;
using MeshLab.Editing;
using MeshLab.IO;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.LinearAlgebra;

[Trait("Section", "12.5")]
public class LaplacianTests
{
    //   3 ───── 2        the unit square with the diagonal 0–2: the angles opposite the diagonal are right,
    //   │     / │        those opposite the sides 45°
    //   │   /   │
    //   │ /     │
    //   0 ───── 1
    private static Mesh Square() => MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)], [0, 1, 2, 0, 2, 3]);

    [Fact]
    public void ComputeLaplacian_Square_HasHalvesAtTheSides()
    {
        SparseMatrix l = Square().ComputeLaplacian();

        Assert.Equal(-0.5, l[0, 1], 1e-15);
        Assert.Equal(-0.5, l[2, 3], 1e-15);
        Assert.Equal(0, l[0, 2], 1e-15);
        Assert.All(l.Diagonal.ToArray(), d => Assert.Equal(1, d, 1e-15));
    }

    [Fact]
    public void ComputeLaplacian_RegularTetrahedron_HasTheCotangentOf60Degrees()
    {
        SparseMatrix l = Models.Tetrahedron().ComputeLaplacian();

        for (int i = 0; i < 4; i++)
        {
            for (int j = 0; j < 4; j++)
                Assert.Equal(i == j ? Math.Sqrt(3) : -1 / Math.Sqrt(3), l[i, j], 1e-14);
        }
    }

    [Fact]
    public void ComputeMeanValueWeights_RegularTetrahedron_AreEqual()
    {
        double expected = 2 * Math.Tan(Math.PI / 6) / Math.Sqrt(8);
        Assert.All(Models.Tetrahedron().ComputeMeanValueWeights(), w => Assert.Equal(expected, w, 1e-15));
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void QuadraticForm_OfTheCoordinates_IsTwiceTheArea(string name)
    {
        Mesh mesh = Models.Create(name);
        SparseMatrix l = mesh.ComputeLaplacian();
        Vector3D center = mesh.VertexSlots == 0 ? default : mesh.Positions[0];

        double sum = 0, terms = 0;
        for (int axis = 0; axis < 3; axis++)
        {
            double[] x = [.. mesh.Positions.ToArray().Select(p => (p - center)[axis])];
            sum += l.QuadraticForm(x);
            terms += x.Zip(l.Diagonal.ToArray(), (a, d) => a * a * d).Sum();
        }

        double area = mesh.Faces.Sum(f => Area(f));
        // On slivers huge terms cancel.
        Assert.Equal(2 * area, sum, 1e-9 * area + 1e-15 * terms);
        Assert.Equal(area, Ones(mesh.ComputeMassMatrix(MassKind.Mixed)), 1e-12 * area);
        Assert.Equal(area, Ones(mesh.ComputeMassMatrix(MassKind.Barycentric)), 1e-12 * area);
        Assert.Equal(area, Ones(mesh.ComputeMassMatrix(MassKind.Voronoi)), 1e-6 * area);
        Assert.Equal(area, Ones(mesh.ComputeMassMatrix(MassKind.Full)), 1e-12 * area);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void ComputeLaplacian_AllWeights_AnnihilateConstants(string name)
    {
        Mesh mesh = Models.Create(name);
        foreach (LaplacianWeights weights in Enum.GetValues<LaplacianWeights>())
        {
            SparseMatrix l = mesh.ComputeLaplacian(weights);
            double[] ones = new double[l.Size];
            Array.Fill(ones, 1);
            double scale = l.Diagonal.ToArray().DefaultIfEmpty().Max() + 1;
            Assert.All(l.Multiply(ones), y => Assert.Equal(0, y, 1e-12 * scale));
        }
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void IntrinsicDelaunay_AnyMesh_HasNoNegativeWeight(string name)
    {
        Mesh mesh = Models.Create(name);
        IntrinsicDelaunay delaunay = IntrinsicDelaunay.Of(mesh);

        for (int e = 0; e < mesh.EdgeSlots; e++)
            Assert.True(mesh.IsDeletedEdge(e) || delaunay.CotangentWeight(e) >= -1e-11, $"e{e}: {delaunay.CotangentWeight(e)}");
    }

    [Fact]
    public void IntrinsicDelaunay_FlatSliverGrid_StaysExactForLinearFunctions()
    {
        // On a plane L x = 0 at interior vertices whatever the triangulation, as long as it tiles the plane.
        Mesh mesh = Models.Create("grid");
        foreach (ref Vector3D p in mesh.Positions)
            p = new(p.X, 0.05 * p.Y + 0.3 * p.X, 0);
        SparseMatrix l = mesh.ComputeLaplacian(LaplacianWeights.IntrinsicDelaunay);

        Assert.True(IntrinsicDelaunay.Of(mesh).FlipCount > 0);
        double[] y = l.Multiply([.. mesh.Positions.ToArray().Select(p => 3 * p.X - 2 * p.Y)]);
        foreach (Vertex v in mesh.Vertices.Where(v => !v.IsBoundary))
            Assert.Equal(0, y[v.Index], 1e-9);
    }

    [Fact]
    public void ComputeLaplacian_Clamped_HasNoNegativeWeight()
    {
        Mesh mesh = Models.Create("slivers");
        SparseMatrix l = mesh.ComputeLaplacian(LaplacianWeights.ClampedCotangent);
        Assert.True(l.Values.ToArray().Max() <= -1e-6);
    }

    [Fact]
    public void ComputeLaplacian_FaceWithoutArea_IsFinite()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(0, 1, 0)], [0, 1, 2, 0, 2, 3]);
        foreach (LaplacianWeights weights in Enum.GetValues<LaplacianWeights>())
            Assert.All(mesh.ComputeLaplacian(weights).Diagonal.ToArray(), d => Assert.True(double.IsFinite(d), weights.ToString()));
    }

    [Fact]
    public void ComputeLaplacian_Polygons_OnlyUniformWeights()
    {
        Mesh mesh = Models.Create("mixed-polygons");

        Assert.Equal(mesh.Edges.Count * 2 + mesh.Vertices.Count, mesh.ComputeLaplacian(LaplacianWeights.Uniform).NonZeros);
        foreach (LaplacianWeights weights in Enum.GetValues<LaplacianWeights>().Where(w => w != LaplacianWeights.Uniform))
        {
            string message = Assert.Throws<ArgumentException>(() => mesh.ComputeLaplacian(weights)).Message;
            Assert.Contains("f0", message, StringComparison.Ordinal);
            Assert.Contains("Triangulate", message, StringComparison.Ordinal);
        }
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void ComputeLaplacian_ReferenceModel_HasTheReferenceNorms(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        JsonElement expected = ReferenceData.Json(name, "core").RootElement.GetProperty("cotan_laplacian");
        SparseMatrix l = mesh.ComputeLaplacian();
        double[] values = l.Values.ToArray(), diagonal = l.Diagonal.ToArray();

        AssertClose(expected.GetProperty("trace").GetDouble(), diagonal.Sum());
        AssertClose(expected.GetProperty("frobenius").GetDouble(), Math.Sqrt(values.Sum(a => a * a) + diagonal.Sum(a => a * a)));
        AssertClose(expected.GetProperty("abs_sum").GetDouble(), values.Sum(Math.Abs) + diagonal.Sum(Math.Abs));
        AssertClose(expected.GetProperty("min_offdiagonal_weight").GetDouble(), -values.Max());
        double[] energies = ReferenceData.Numbers(expected.GetProperty("xTLx"));
        for (int axis = 0; axis < 3; axis++)
            AssertClose(energies[axis], l.QuadraticForm([.. mesh.Positions.ToArray().Select(p => p[axis])]));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.ModelsWithArraysCases), MemberType = typeof(ReferenceData))]
    public void ComputeLaplacian_ReferenceModel_HasTheReferenceEntries(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        JsonElement arrays = ReferenceData.Arrays(name).RootElement;
        double[] pairs = ReferenceData.Numbers(arrays.GetProperty("cotan_weight_ij")), weights = ReferenceData.Numbers(arrays.GetProperty("cotan_weight"));
        double[] masses = ReferenceData.Numbers(arrays.GetProperty("mixed_area"));
        SparseMatrix l = mesh.ComputeLaplacian();

        double scale = weights.Max(Math.Abs);
        for (int k = 0; k < weights.Length; k++)
        {
            double own = -l[(int)pairs[2 * k], (int)pairs[2 * k + 1]];
            // An entry near zero is the difference of two cotangents; the digits that these have cannot come back.
            Assert.True(Math.Abs(own - weights[k]) <= 1e-9 * Math.Abs(weights[k]) + 1e-13 * scale, $"{pairs[2 * k]}-{pairs[2 * k + 1]}: {own} {weights[k]}");
        }
        Assert.All(masses.Zip(mesh.ComputeLumpedMasses()), pair => AssertClose(pair.First, pair.Second));
    }

    private static void AssertClose(double expected, double actual) => Assert.Equal(expected, actual, 1e-9 * Math.Abs(expected));

    private static double Area(Face f) => 0.5 * Vector3D.Cross(
        f.HalfEdge.Target.Position - f.HalfEdge.Source.Position, f.HalfEdge.Next.Target.Position - f.HalfEdge.Source.Position).Length;

    private static double Ones(SparseMatrix matrix)
    {
        var ones = new double[matrix.Size];
        Array.Fill(ones, 1);
        return matrix.QuadraticForm(ones);
    }

    [Fact]
    public void MeanValueWeights_OneTriangle_SeeItFromBothSidesOfItsEdges()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(0, 2, 0)], [0, 1, 2]);
        double[] weights = mesh.ComputeMeanValueWeights();
        double half = Math.Tan(Math.PI / 8);
        foreach (HalfEdge h in mesh.HalfEdges)
            Assert.Equal((h.Source.Index == 0 ? 1 : half) / h.Edge.Length, weights[h.Index], 1e-14);
    }

    [Fact]
    public void MeanValueWeights_CoincidentVertices_AreFinite()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2, 0, 2, 3]);
        Assert.All(mesh.ComputeMeanValueWeights(), w => Assert.True(double.IsFinite(w)));
    }

    [Fact]
    public void MeanValueWeights_AfterDeletions_AreThoseOfTheCompactMesh()
    {
        Mesh mesh = Models.Create("grid");
        mesh.Vertices[0].Delete();
        Assert.False(mesh.IsCompact);
        Mesh compact = mesh.Clone();
        compact.Compact();
        double[] weights = mesh.ComputeMeanValueWeights();
        Assert.Equal(compact.ComputeMeanValueWeights(), mesh.HalfEdges.Select(h => weights[h.Index]));
        Assert.Empty(mesh.Validate());
    }
}
