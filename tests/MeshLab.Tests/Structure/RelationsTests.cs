using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

/// <summary>The nine relations V/E/F × V/E/F against brute force over the faces' vertex lists.</summary>
[Trait("Section", "1.5")]
public class RelationsTests
{
    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void NineRelations_OfEveryModel_AreThoseOfItsVertexLists(string name)
    {
        Mesh mesh = Models.Create(name);
        var faces = mesh.Faces.ToDictionary(f => f, f => f.Vertices.ToArray());
        var edges = mesh.Edges.ToDictionary(e => e, e => (A: e.Vertex0, B: e.Vertex1));
        Assert.Equal(Sides(faces.Values).ToHashSet(), edges.Values.Select(e => Key(e.A, e.B)).ToHashSet());

        var facesOfVertex = faces.SelectMany(f => f.Value.Select(v => (v, f.Key))).ToLookup(p => p.v, p => p.Key);
        var edgesOfVertex = edges.SelectMany(e => new[] { (e.Value.A, e.Key), (e.Value.B, e.Key) }).ToLookup(p => p.Item1, p => p.Key);
        var edgeBetween = edges.ToDictionary(e => Key(e.Value.A, e.Value.B), e => e.Key);
        var facesOfEdge = faces.SelectMany(f => Sides([f.Value]).Select(s => (edgeBetween[s], f.Key))).ToLookup(p => p.Item1, p => p.Key);

        foreach (Vertex v in mesh.Vertices)
        {
            Same(edgesOfVertex[v].Select(e => e.Vertex0 == v ? e.Vertex1 : e.Vertex0), v.Neighbors);
            Same(edgesOfVertex[v], v.Edges);
            Same(facesOfVertex[v], v.Faces);
        }
        foreach (Edge e in mesh.Edges)
        {
            Same([edges[e].A, edges[e].B], e.Vertices);
            Same(edgesOfVertex[e.Vertex0].Concat(edgesOfVertex[e.Vertex1]).Where(d => d != e), e.Neighbors);
            Same(facesOfEdge[e], e.Faces);
            Assert.Equal(facesOfEdge[e].Count() == 1, e.IsBoundary);
        }
        foreach (Face f in mesh.Faces)
        {
            Same(faces[f], f.Vertices);
            Edge[] sides = [.. Sides([faces[f]]).Select(s => edgeBetween[s])];
            Same(sides, f.Edges);
            Same(sides.SelectMany(e => facesOfEdge[e]).Where(g => g != f), f.Neighbors);
            Assert.Equal(sides.Any(e => facesOfEdge[e].Count() == 1), f.IsBoundary);
        }
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void FindHalfEdge_EveryPair_FindsExactlyTheEdges(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count > 100)
            return;
        foreach (Vertex a in mesh.Vertices)
        {
            foreach (Vertex b in mesh.Vertices)
            {
                HalfEdge h = mesh.FindHalfEdge(a, b);
                Assert.Equal(a.Neighbors.Contains(b), !h.IsNone);
                Assert.Equal(a.IsNeighborOf(b), !h.IsNone);
                if (!h.IsNone)
                    Assert.Equal((a, b, h.Edge), (h.Source, h.Target, mesh.FindEdge(b, a)));
            }
        }
    }

    private static IEnumerable<(int, int)> Sides(IEnumerable<Vertex[]> faces) =>
        faces.SelectMany(f => f.Select((v, i) => Key(v, f[(i + 1) % f.Length])));

    private static (int, int) Key(Vertex a, Vertex b) => (Math.Min(a.Index, b.Index), Math.Max(a.Index, b.Index));

    private static void Same<T>(IEnumerable<T> expected, IEnumerable<T> actual) => Assert.Equal(expected.Order(), actual.Order());
}
