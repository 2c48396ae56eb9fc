using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests;

/// <summary>Traits that hold every element's index, to see afterwards where the elements went.</summary>
internal sealed record IndexTraits(VertexTrait<int> Vertex, HalfEdgeTrait<int> HalfEdge, EdgeTrait<int> Edge, FaceTrait<int> Face)
{
    private const string Name = "old";

    public static IndexTraits AddTo(Mesh mesh)
    {
        var traits = new IndexTraits(
            mesh.AddVertexTrait(Name, -1), mesh.AddHalfEdgeTrait(Name, -1), mesh.AddEdgeTrait(Name, -1), mesh.AddFaceTrait(Name, -1));
        foreach (Vertex v in mesh.Vertices)
            traits.Vertex[v] = v.Index;
        foreach (HalfEdge h in mesh.HalfEdges)
            traits.HalfEdge[h] = h.Index;
        foreach (Edge e in mesh.Edges)
            traits.Edge[e] = e.Index;
        foreach (Face f in mesh.Faces)
            traits.Face[f] = f.Index;
        return traits;
    }

    /// <summary>Those of a mesh made from one that has them.</summary>
    public static IndexTraits Of(Mesh mesh)
    {
        Assert.True(mesh.TryGetVertexTrait(Name, out VertexTrait<int>? vertex));
        Assert.True(mesh.TryGetHalfEdgeTrait(Name, out HalfEdgeTrait<int>? halfEdge));
        Assert.True(mesh.TryGetEdgeTrait(Name, out EdgeTrait<int>? edge));
        Assert.True(mesh.TryGetFaceTrait(Name, out FaceTrait<int>? face));
        return new(vertex, halfEdge, edge, face);
    }
}
