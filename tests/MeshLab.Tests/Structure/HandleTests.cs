using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "1.4")]
public class HandleTests
{
    [Fact]
    public void Handles_OfDeletedElements_AreFoundOutWithTheirNames()
    {
        Mesh mesh = Models.Create("sphere");
        Vertex v = mesh.Vertices[12];
        HalfEdge h = v.Outgoing;
        Face f = h.Face;
        v.Delete();

        Assert.True(v.IsDeleted && h.IsDeleted && h.Edge.IsDeleted && f.IsDeleted);
        Assert.Contains("v12", Assert.Throws<ArgumentException>(() => v.Neighbors).Message, StringComparison.Ordinal);
        Assert.Contains(f.ToString(), Assert.Throws<ArgumentException>(() => f.Vertices).Message, StringComparison.Ordinal);
        Assert.Contains(h.ToString(), Assert.Throws<ArgumentException>(() => h.Loop).Message, StringComparison.Ordinal);
        Assert.Contains(h.Edge.ToString(), Assert.Throws<ArgumentException>(() => h.Edge.Vertices).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => v.ThrowIfDead());
        Assert.Throws<ArgumentException>(() => mesh.MoveVertex(v, default));
        Assert.Throws<ArgumentException>(() => mesh.FindHalfEdge(v, mesh.Vertices[0]));
    }

    [Fact]
    public void Handles_ThatAreNone_SaySo()
    {
        Assert.True(default(Vertex).IsNone && default(HalfEdge).IsNone && default(Edge).IsNone && default(Face).IsNone);
        Assert.Equal("none", default(Vertex).ToString());
        Assert.Equal(-1, default(Face).Index);
        Assert.False(default(Vertex).IsDeleted);
        Assert.Throws<ArgumentException>(() => default(Vertex).ThrowIfDead());
        Assert.Throws<ArgumentException>(() => default(Face).Vertices);
        Assert.Throws<ArgumentException>(() => Models.Tetrahedron().FindEdge(default, default));
    }

    [Fact]
    public void Handles_OfAnotherMesh_AreRefusedAndUnequal()
    {
        Mesh mesh = Models.Tetrahedron(), other = Models.Tetrahedron();
        Assert.NotEqual(mesh.Vertices[0], other.Vertices[0]);
        Assert.Throws<ArgumentException>(() => mesh.FindEdge(mesh.Vertices[0], other.Vertices[1]));
        Assert.Throws<ArgumentException>(() => mesh.MoveVertex(other.Vertices[0], default));
    }

    [Fact]
    public void Handles_CompareByIndexAndPrintTheirNames()
    {
        Mesh mesh = Models.Tetrahedron();
        Assert.True(mesh.Vertices[1] < mesh.Vertices[2]);
        Assert.True(mesh.Faces[3] >= mesh.Faces[3]);
        Assert.Equal("v1 h3 e4 f2", $"{mesh.Vertices[1]} {mesh.HalfEdges[3]} {mesh.Edges[4]} {mesh.Faces[2]}");
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Vertices[4]);
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Faces[-1]);
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.HalfEdges[12]);
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Edges[6]);
    }

    [Fact]
    public void Enumeration_SkipsDeletedAndCountsTheLiving()
    {
        Mesh mesh = Models.Create("grid");
        mesh.Vertices[9].Delete();
        Assert.Equal(mesh.Vertices.Count, mesh.Vertices.Select(x => x.Index).Distinct().Count());
        Assert.Equal(mesh.Edges.Count, mesh.Edges.Select(x => x.Index).Distinct().Count());
        Assert.Equal(mesh.Faces.Count, mesh.Faces.Select(x => x.Index).Distinct().Count());
        Assert.Equal(mesh.HalfEdges.Count, mesh.HalfEdges.Select(x => x.Index).Distinct().Count());
        Assert.DoesNotContain(mesh.Vertices, v => v.IsDeleted);
        Assert.False(mesh.IsCompact);
    }

    [Fact]
    public void Reads_FromManyThreads_AgreeWithOne()
    {
        Mesh mesh = Models.Sphere(30, 40);
        long Sum()
        {
            long sum = 0;
            foreach (Vertex v in mesh.Vertices)
            {
                foreach (Vertex w in v.Neighbors)
                    sum += w.Index;
                sum += v.Valence;
            }
            foreach (Edge e in mesh.Edges)
                sum += (e.CanFlip(out _) ? 1 : 0) + (e.HalfEdge0.CanCollapse(out _) ? 1 : 0);
            return sum + mesh.Validate().Count;
        }
        long expected = Sum();
        long[] sums = new long[8];
        Parallel.For(0, sums.Length, i => sums[i] = Sum());
        Assert.All(sums, s => Assert.Equal(expected, s));
    }
}
