using System.Text.Json;
using MeshLab.Geodesics;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geodesics;

[Trait("Section", "12.1")]
public class EdgeDistanceTests
{
    [Fact]
    public void ComputeEdgeDistances_Grid_FollowsTheEdges()
    {
        // Sides of 1/6 and 1/5, no diagonals: the Manhattan distance.
        Mesh mesh = Models.Create("grid-quads");

        double[] d = mesh.ComputeEdgeDistances(mesh.Vertices[0]);

        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(v.Position.X + v.Position.Y, d[v.Index], 1e-14);
    }

    [Fact]
    public void ComputeEdgeDistances_SeveralSources_IsTheLeast()
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        double[] a = mesh.ComputeEdgeDistances(mesh.Vertices[0]), b = mesh.ComputeEdgeDistances(mesh.Vertices[77]);

        double[] both = mesh.ComputeEdgeDistances(mesh.Vertices[0], mesh.Vertices[77]);

        Assert.Equal(a.Zip(b, Math.Min), both);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void ComputeEdgeDistances_AnyMesh_NoEdgeIsAShortcut(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count == 0)
            return;
        double[] d = mesh.ComputeEdgeDistances(mesh.Vertices[0]);
        foreach (Edge e in mesh.Edges)
        {
            (double from, double to) = (d[e.Vertex0.Index], d[e.Vertex1.Index]);
            Assert.True(double.IsInfinity(from) == double.IsInfinity(to));
            if (!double.IsInfinity(from))
                Assert.InRange(Math.Abs(from - to), 0, Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position) * (1 + 1e-9) + 1e-15);
        }
    }

    [Fact]
    public void ComputeEdgeDistances_OtherComponents_AreInfinitelyFar()
    {
        Mesh mesh = Models.Create("components");
        double[] d = mesh.ComputeEdgeDistances(mesh.Vertices[0]);
        Assert.All(d.Skip(30), value => Assert.Equal(double.PositiveInfinity, value));
        Assert.All(d.Take(30), value => Assert.True(double.IsFinite(value)));
    }

    [Fact]
    public void ComputeEdgeDistances_BadSources_Throws()
    {
        Mesh mesh = Models.Tetrahedron();
        Assert.Throws<ArgumentException>(() => mesh.ComputeEdgeDistances());
        Assert.Throws<ArgumentException>(() => mesh.ComputeEdgeDistances(Models.Tetrahedron().Vertices[0]));
        Assert.Throws<ArgumentException>(() => new HeatGeodesics(mesh).ComputeDistances());
        Assert.Throws<ArgumentOutOfRangeException>(() => new HeatOptions { TimeFactor = 0 });
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void ComputeEdgeDistances_ReferenceModel_GivesTheReferenceDistances(string name)
    {
        Mesh mesh = MeshFile.Read(ReferenceData.ModelPath(name));
        JsonElement expected = ReferenceData.Json(name, "extras").RootElement.GetProperty("geodesic_from_vertex_0").GetProperty("edge_dijkstra");

        double[] d = mesh.ComputeEdgeDistances(mesh.Vertices[0]);

        double[] index = ReferenceData.Numbers(expected.GetProperty("sample_index")), sample = ReferenceData.Numbers(expected.GetProperty("sample"));
        for (int k = 0; k < sample.Length; k++)
            AssertClose(sample[k], d[(int)index[k]]);
        Assert.Equal(expected.GetProperty("reached").GetInt32(), d.Count(double.IsFinite));
        AssertClose(expected.GetProperty("sum").GetDouble(), d.Where(double.IsFinite).Sum());
    }

    private static void AssertClose(double expected, double actual)
    {
        if (double.IsInfinity(expected))
            Assert.Equal(expected, actual);
        else
            Assert.Equal(expected, actual, 1e-12 * Math.Abs(expected));
    }
}
