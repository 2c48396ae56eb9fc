using MeshLab.Editing;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Neighborhoods;

[Trait("Section", "5.1")]
[Trait("Section", "5.2")]
[Trait("Section", "5.3")]
public class NeighborhoodTests
{
    //   6──7──8      a 2 × 2 grid of squares, each cut from lower left to upper right
    //   │ /│ /│
    //   3──4──5
    //   │ /│ /│
    //   0──1──2
    internal static Mesh Grid()
    {
        var builder = new MeshBuilder();
        for (int v = 0; v < 9; v++)
            builder.AddVertex(new(v % 3, v / 3, 0));
        foreach (int a in (int[])[0, 1, 3, 4])
        {
            builder.AddFace(a, a + 1, a + 4);
            builder.AddFace(a, a + 4, a + 3);
        }
        return builder.Build();
    }

    internal static int[] Indices(IEnumerable<Vertex> vertices) => [.. vertices.Select(v => v.Index)];

    internal static int[] Indices(IEnumerable<Face> faces) => [.. faces.Select(f => f.Index)];

    internal static string[] Pairs(IEnumerable<Edge> edges) =>
        [.. edges.Select(e => $"{Math.Min(e.Vertex0.Index, e.Vertex1.Index)}-{Math.Max(e.Vertex0.Index, e.Vertex1.Index)}").Order(StringComparer.Ordinal)];

    internal static Edge Edge(Mesh mesh, int a, int b) => mesh.FindEdge(mesh.Vertices[a], mesh.Vertices[b]);

    [Fact]
    public void VertexQueries_MiddleOfTheGrid_GiveItsStar()
    {
        Vertex v = Grid().Vertices[4];
        Assert.Equal([0, 1, 3, 5, 7, 8], Indices(v.RingVertices));
        Assert.Equal(["0-4", "1-4", "3-4", "4-5", "4-7", "4-8"], Pairs(v.SpokeEdges));
        Assert.Equal(["0-1", "0-3", "1-5", "3-7", "5-8", "7-8"], Pairs(v.LinkEdges));
        Assert.Equal([0, 1, 3, 4, 6, 7], Indices(v.IncidentFaces));
    }

    [Fact]
    public void VertexQueries_Corner_GiveOneSide()
    {
        Vertex v = Grid().Vertices[0];
        Assert.Equal([1, 3, 4], Indices(v.RingVertices));
        Assert.Equal(["1-4", "3-4"], Pairs(v.LinkEdges));
        Assert.Equal([0, 1], Indices(v.IncidentFaces));
    }

    [Fact]
    public void EdgeQueries_InnerEdge_GiveItsLoop()
    {
        Edge e = Edge(Grid(), 1, 4);
        Assert.Equal([0, 2, 3, 5, 7, 8], Indices(e.LoopVertices));
        Assert.Equal([0, 1, 2, 3, 4, 6, 7], Indices(e.TouchingFaces));
        Assert.Equal(["0-3", "2-5", "3-7", "5-8", "7-8"], Pairs(e.LoopEdges));
    }

    [Theory]
    [MemberData(nameof(Models.ClosedTriangleMeshes), MemberType = typeof(Models))]
    public void LoopEdges_ClosedMesh_AreTheValencesLessFour(string name)
    {
        Mesh mesh = Models.Create(name);
        foreach (Edge e in mesh.Edges.Take(200))
        {
            // In tiny meshes both sides of the loop can be one edge.
            int most = e.Vertex0.Valence + e.Vertex1.Valence - 4;
            Assert.True(e.LoopEdges.Length <= most, $"{name} {e}");
            if (mesh.Vertices.Count > 60 && !name.Contains("1200", StringComparison.Ordinal))
                Assert.Equal(most, e.LoopEdges.Length);
            Assert.Equal(e.Vertex0.Valence + e.Vertex1.Valence - 2, e.TouchingFaces.Length);
        }
    }

    [Fact]
    public void FaceQueries_Corner_GiveItsRing()
    {
        Face f = Grid().Faces[0];
        Assert.Equal([0, 1, 4], Indices(f.Vertices));
        Assert.Equal([1, 3], Indices(f.FacesSharingEdge));
        Assert.Equal([1, 2, 3, 4, 6, 7], Indices(f.FacesSharingVertex));
        Assert.Equal([2, 3, 5, 7, 8], Indices(f.RingVertices));
        Assert.Equal(["2-5", "3-7", "5-8", "7-8"], Pairs(f.RingEdges));
    }

    [Fact]
    public void Ring_OfVertexEdgeAndFace_CountsEdges()
    {
        Mesh mesh = Grid();
        Assert.Equal([0], Indices(mesh.Vertices[0].Ring(0)));
        Assert.Equal([1, 3, 4], Indices(mesh.Vertices[0].Ring(1)));
        Assert.Equal([2, 5, 6, 7, 8], Indices(mesh.Vertices[0].Ring(2)));
        Assert.Empty(mesh.Vertices[0].Ring(3));
        Assert.Equal(9, mesh.Vertices[0].Disk(2).Length);
        Assert.Equal([6], Indices(Edge(mesh, 1, 4).Ring(2)));
        Assert.Equal([6], Indices(mesh.Faces[0].Ring(2)));
    }

    [Fact]
    public void Ring_NegativeK_Throws()
    {
        Mesh mesh = Grid();
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Vertices[0].Ring(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Edges[0].Ring(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Faces[0].Ring(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Vertices[0].Disk(-2));
    }

    [Fact]
    public void Queries_NoneOrIsolated_ThrowOrAreEmpty()
    {
        Assert.Throws<ArgumentException>(() => default(Vertex).RingVertices);
        Assert.Throws<ArgumentException>(() => default(Edge).LoopEdges);
        Assert.Throws<ArgumentException>(() => default(Face).FacesSharingEdge);
        Vertex isolated = MeshBuilder.FromFaces(4, [0, 1, 2]).Vertices[3];
        Assert.Empty(isolated.RingVertices);
        Assert.Empty(isolated.LinkEdges);
        Assert.Empty(isolated.Ring(1));
        Assert.Equal([3], Indices(isolated.Component));
    }

    [Fact]
    public void Queries_DeletedElement_ThrowArgumentException()
    {
        Mesh mesh = Models.Create("grid");
        Vertex corner = mesh.Faces[0].HalfEdge.Target, v = mesh.Faces[0].Vertices.First(w => w.Faces.Count() == 1 || w == corner);
        Face face = v.Faces.First();
        Edge edge = v.Edges.First();
        v.Delete();
        Action[] queries =
        [
            () => _ = v.Component, () => v.Ring(0), () => v.Disk(0), () => v.AsGroup(), () => _ = edge.Component, () => edge.Ring(0),
            () => edge.AsGroup(), () => _ = face.Component, () => face.Ring(0), () => face.AsGroup(), () => _ = default(Vertex).Component,
            () => default(Vertex).Ring(0), () => default(Vertex).Disk(0), () => default(Vertex).AsGroup(), () => _ = default(Edge).Component,
            () => default(Edge).AsGroup(), () => _ = default(Face).Component, () => default(Face).AsGroup(),
        ];
        Assert.All(queries, query => Assert.Throws<ArgumentException>(query));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Component_OpenMesh_HasAllEdgesAndFacesOnce()
    {
        Mesh mesh = Models.Create("grid");
        Assert.All([0, mesh.Faces.Count - 1], f => Assert.Equal(Enumerable.Range(0, mesh.Faces.Count), Indices(mesh.Faces[f].Component)));
        Assert.Equal(Enumerable.Range(0, mesh.Edges.Count), mesh.Edges[3].Component.Select(e => e.Index));
    }

    [Fact]
    public void Disk_GroupThatBeginsWithAnIsolatedVertex_GoesOnWithTheOthers()
    {
        Mesh mesh = MeshBuilder.FromFaces(4, [1, 2, 3]);
        Assert.Equal([0, 1, 2, 3], Indices(mesh.Group([mesh.Vertices[0], mesh.Vertices[1]]).Disk(1)));
        Assert.Equal([2, 3], Indices(mesh.Group([mesh.Vertices[0], mesh.Vertices[1]]).Ring(1)));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void RingVertices_EveryVertex_AreTheCirculatorsNeighbours(string name)
    {
        Mesh mesh = Models.Create(name);
        foreach (Vertex v in mesh.Vertices)
        {
            Assert.Equal(v.Neighbors.Select(w => w.Index).Order(), Indices(v.RingVertices));
            Assert.Equal(Indices(v.RingVertices), Indices(v.Ring(1)));
            Assert.Equal(v.Faces.Select(f => f.Index).Order(), Indices(v.IncidentFaces));
            Assert.Equal(Indices(v.RingVertices), Indices(v.AsGroup().RingVertices));
            Assert.Equal(Indices(v.IncidentFaces), Indices(v.AsGroup().RingFaces));
        }
    }

    [Fact]
    public void Component_OfEveryKind_IsThatPartOnly()
    {
        Mesh mesh = MeshBuilder.FromFaces(7, [0, 1, 2], [3, 5, 4]);
        Assert.Equal([3, 4, 5], Indices(mesh.Vertices[4].Component));
        Assert.Equal([1], Indices(mesh.Faces[1].Component));
        Assert.Equal(["0-1", "0-2", "1-2"], Pairs(Edge(mesh, 1, 2).Component));
        Mesh sphere = Models.Create("sphere");
        Assert.Equal(sphere.Faces.Count, sphere.Faces[3].Component.Length);
        Assert.Equal(sphere.Edges.Count, sphere.Edges[3].Component.Length);
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Rings_PublicModels_EqualTheReferenceValues(string name)
    {
        var rings = ReferenceData.Json(name, "extras").RootElement.GetProperty("rings");
        Mesh mesh = ReferenceMesh.Load(name);
        double[] vertices = ReferenceData.Numbers(rings.GetProperty("vertex"));
        for (int i = 0; i < vertices.Length; i++)
        {
            Vertex v = mesh.Vertices[(int)vertices[i]];
            Assert.Equal(rings.GetProperty("valence")[i].GetInt32(), v.Ring(1).Length);
            Assert.Equal(rings.GetProperty("vertices_at_edge_distance_2")[i].GetInt32(), v.Ring(2).Length);
            Assert.Equal(rings.GetProperty("vertices_at_edge_distance_3")[i].GetInt32(), v.Ring(3).Length);
            Assert.Equal(rings.GetProperty("incident_faces")[i].GetInt32(), v.IncidentFaces.Length);
        }
    }
}
