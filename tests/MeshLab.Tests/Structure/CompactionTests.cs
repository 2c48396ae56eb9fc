using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "4.8")]
public class CompactionTests
{
    private static Mesh Labelled(string name)
    {
        Mesh mesh = Models.Create(name);
        IndexTraits.AddTo(mesh);
        FaceLabels materials = mesh.GetOrAddFaceLabels("material");
        foreach (Face f in mesh.Faces)
            materials.Labels[f] = materials.Number(f.Index % 2 == 0 ? "even" : "odd");
        return mesh;
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Compact_AfterRemovals_KeepsOrderTraitsAndLabels(string name)
    {
        Mesh mesh = Labelled(name);
        for (int v = 0; v < mesh.VertexSlots; v += 5)
        {
            if (!mesh.Vertices[v].IsDeleted)
                mesh.Vertices[v].TryDelete(out _);
        }
        Mesh old = mesh.Clone();

        CompactionMaps maps = mesh.Compact();

        Assert.True(mesh.IsCompact);
        Assert.Empty(mesh.Validate());
        Assert.Equal((old.Vertices.Count, old.Edges.Count, old.Faces.Count), (mesh.VertexSlots, mesh.EdgeSlots, mesh.FaceSlots));
        Assert.Equal(Enumerable.Range(0, mesh.VertexSlots), maps.Vertices.Where(v => v >= 0));
        Assert.Equal(Enumerable.Range(0, mesh.EdgeSlots), maps.Edges.Where(e => e >= 0));
        Assert.Equal(Enumerable.Range(0, mesh.FaceSlots), maps.Faces.Where(f => f >= 0));
        (VertexTrait<int> vertex, HalfEdgeTrait<int> halfEdge, EdgeTrait<int> edge, FaceTrait<int> face) = IndexTraits.Of(mesh);
        foreach (Vertex v in old.Vertices)
            Assert.Equal((v.Index, v.Position), (vertex[maps.Vertices[v.Index]], mesh.Positions[maps.Vertices[v.Index]]));
        foreach (HalfEdge h in old.HalfEdges)
        {
            HalfEdge now = mesh.HalfEdges[maps.HalfEdges[h.Index]];
            Assert.Equal((h.Index, h.Edge.Index), (halfEdge[now], edge[now.Edge]));
            Assert.Equal(maps.Vertices[h.Target.Index], now.Target.Index);
        }
        foreach (Face f in mesh.Faces)
            Assert.Equal(face[f] % 2 == 0 ? "even" : "odd", mesh.FaceLabels[0].NameOf(f));
    }

    [Fact]
    public void Compact_WhileRecording_Throws()
    {
        Mesh mesh = Models.Create("grid");
        using OperationHistory history = mesh.StartRecording();
        Assert.Throws<InvalidOperationException>(() => mesh.Compact());
        Assert.Throws<InvalidOperationException>(() => mesh.Append(Models.Tetrahedron()));
    }

    [Fact]
    public void Compact_ThenEdit_GrowsAgain()
    {
        Mesh mesh = Labelled("sphere");
        mesh.Vertices[3].Delete();
        mesh.Compact();
        foreach (Face f in mesh.Faces)
            f.Split();
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Clone_EveryModel_IsEqualAndIndependent(string name)
    {
        Mesh mesh = Labelled(name);
        if (mesh.FaceSlots > 2)
            mesh.Faces[1].TryDelete(out _);
        ulong hash = mesh.StateHash();

        Mesh copy = mesh.Clone();

        Assert.Equal(hash, copy.StateHash());
        Assert.Empty(copy.Validate());
        foreach (Vertex v in copy.Vertices)
            v.Position += Vector3D.UnitX;
        if (copy.FaceLabels.Count > 0)
            copy.FaceLabels[0].Number("new");
        copy.AddVertex(default);
        Assert.Equal(hash, mesh.StateHash());
        Assert.NotEqual(hash, copy.StateHash());
    }

    [Fact]
    public void Append_WithTraitsAndLabels_BringsThemAlong()
    {
        Mesh mesh = Labelled("tetrahedron"), other = Labelled("octahedron");
        FaceLabels theirs = other.FaceLabels[0];
        theirs.Labels[other.Faces[0]] = theirs.Number("third");
        other.AddVertexTrait("only theirs", 2.5);
        other.Faces[7].Delete();

        AppendMaps maps = mesh.Append(other);

        Assert.Empty(mesh.Validate());
        Assert.Equal(new AppendMaps(4, 12, 6, 4), maps);
        Assert.Equal(4 + 7, mesh.Faces.Count);
        Assert.Equal("even", mesh.FaceLabels[0].NameOf(mesh.Faces[0]));
        Assert.Equal("third", mesh.FaceLabels[0].NameOf(mesh.Faces[4]));
        Assert.Equal("odd", mesh.FaceLabels[0].NameOf(mesh.Faces[5]));
        Assert.True(mesh.TryGetVertexTrait("old", out VertexTrait<int>? vertex));
        Assert.Equal([0, 1, 2, 3, 0, 1, 2, 3, 4, 5], vertex.Values.ToArray());
        Assert.True(mesh.TryGetVertexTrait("only theirs", out VertexTrait<double>? only));
        Assert.Equal(2.5, only[9]);
        Assert.True(mesh.Faces[11].IsDeleted);
    }

    [Fact]
    public void Append_Itself_Doubles()
    {
        Mesh mesh = Models.Create("torus");
        int faces = mesh.Faces.Count;
        mesh.Append(mesh);
        Assert.Equal(2 * faces, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
        Assert.Throws<ArgumentNullException>(() => mesh.Append(null!));
    }
}
