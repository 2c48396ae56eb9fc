using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.1")]
public class TriangulationTests
{
    [Fact]
    public void Triangulate_LShape_KeepsTheAreaWithoutFolds()
    {
        TriangulationResult result = Triangulation.Triangulate(AreasTests.LShape());
        Assert.Equal(4, result.Mesh.Faces.Count);
        Assert.Equal(3, result.Mesh.Area, 1e-15);
        Assert.All(result.Mesh.ComputeFaceNormals(), normal => Assert.Equal(Vector3D.UnitZ, normal));
        Assert.Equal([0, 0, 0, 0], result.FaceOf);
        Assert.Empty(result.Mesh.Validate());
    }

    [Fact]
    public void Triangulate_TriangleMesh_IsTheSameMesh()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(6);
        TriangulationResult result = Triangulation.Triangulate(mesh);
        Assert.Equal(mesh.StateHash(), result.Mesh.StateHash());
        Assert.Equal(Enumerable.Range(0, mesh.Faces.Count), result.FaceOf);
    }

    [Fact]
    public void Triangulate_QuadCube_HasTwelveTrianglesAndTheSameSolid()
    {
        Mesh mesh = Triangulation.Triangulate(VolumesTests.Cube()).Mesh;
        Assert.Equal(12, mesh.Faces.Count);
        Assert.True(mesh.IsClosed);
        Assert.Equal(1, mesh.Volume, 1e-15);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(40)]
    public void Triangulate_Star_HasNoFoldedTriangle(int points)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < 2 * points; i++)
        {
            double a = Math.PI * i / points, r = i % 2 == 0 ? 1 : 0.2;
            builder.AddVertex(new(0.3, r * Math.Cos(a), r * Math.Sin(a)));
        }
        builder.AddFace([.. Enumerable.Range(0, 2 * points)]);
        Mesh star = builder.Build(), triangles = Triangulation.Triangulate(star).Mesh;
        Assert.Equal((2 * points) - 2, triangles.Faces.Count);
        Assert.Equal(star.Area, triangles.Area, 1e-14);
        Assert.All(triangles.ComputeFaceNormals(), normal => Assert.True(normal.X > 0.999));
    }

    [Fact]
    public void Triangulate_PolygonOfZeroArea_IsAFan()
    {
        Mesh mesh = MeshBuilder.FromPolygons([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(3, 0, 0)], [0, 1, 2, 3]);
        Assert.Equal(2, Triangulation.Triangulate(mesh).Mesh.Faces.Count);
    }

    [Fact]
    public void Triangulate_Traits_AreCarriedOver()
    {
        Mesh mesh = Models.QuadGrid(3, 2);
        IndexTraits.AddTo(mesh);
        TriangulationResult result = Triangulation.Triangulate(mesh);
        IndexTraits traits = IndexTraits.Of(result.Mesh);
        Assert.All(result.Mesh.Vertices, v => Assert.Equal(v.Index, traits.Vertex[v]));
        Assert.All(result.Mesh.Faces, f => Assert.Equal(result.FaceOf[f.Index], traits.Face[f]));
        Assert.All(result.Mesh.HalfEdges.Where(h => !h.IsBoundary), h => Assert.Equal(
            (result.FaceOf[h.Face.Index], h.Target.Index),
            (mesh.HalfEdges[traits.HalfEdge[h]].Face.Index, mesh.HalfEdges[traits.HalfEdge[h]].Target.Index)));
        foreach (Edge e in result.Mesh.Edges)
        {
            Edge old = mesh.FindEdge(mesh.Vertices[e.Vertex0.Index], mesh.Vertices[e.Vertex1.Index]);
            Assert.Equal(old.IsNone ? -1 : old.Index, traits.Edge[e]);
        }
    }
}
