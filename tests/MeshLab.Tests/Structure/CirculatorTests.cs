using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "1.4")]
public class CirculatorTests
{
    //    3   2
    //     \ /
    //  4 ──0── 1      triangles 0 i i+1: counter-clockwise is 1, 2, 3, 4, 5
    //      |
    //      5
    [Fact]
    public void Neighbors_OfAHub_TurnBothWays()
    {
        Vertex hub = Models.Fan(5).Vertices[0];
        int[] turn = [.. hub.Neighbors.Select(v => v.Index)], back = [.. hub.NeighborsClockwise.Select(v => v.Index)];

        int one = Array.IndexOf(turn, 1);
        Assert.Equal([1, 2, 3, 4, 5], turn.Skip(one).Concat(turn.Take(one)));
        one = Array.IndexOf(back, 1);
        Assert.Equal([1, 5, 4, 3, 2], back.Skip(one).Concat(back.Take(one)));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Around_EveryVertex_StepsAsDocumented(string name)
    {
        foreach (Vertex v in Models.Create(name).Vertices)
        {
            HalfEdge[] turn = [.. v.OutgoingHalfEdges];
            Assert.All(turn, h => Assert.Equal(v, h.Source));
            Assert.Equal(v.Valence, turn.Length);
            for (int i = 1; i < turn.Length; i++)
                Assert.Equal(turn[i - 1].Previous.Twin, turn[i]);
            HalfEdge[] back = [.. v.OutgoingHalfEdgesClockwise];
            for (int i = 1; i < back.Length; i++)
                Assert.Equal(back[i - 1].Twin.Next, back[i]);
            Assert.Equal(turn.Order(), back.Order());
            Assert.Equal(turn.Select(h => h.Twin), v.IncomingHalfEdges);
            Assert.Equal(back.Select(h => h.Twin), v.IncomingHalfEdgesClockwise);
            Assert.Equal(turn.Select(h => h.Edge), v.Edges);
            Assert.Equal(back.Select(h => h.Edge), v.EdgesClockwise);
            Assert.Equal(turn.Where(h => !h.IsBoundary).Select(h => h.Face), v.Faces);
            Assert.Equal(back.Where(h => !h.IsBoundary).Select(h => h.Face), v.FacesClockwise);
        }
    }

    [Theory]
    [MemberData(nameof(Models.BoundaryMeshes), MemberType = typeof(Models))]
    public void Around_EveryBoundaryVertex_GoesFromOneEndOfTheFanToTheOther(string name)
    {
        foreach (Vertex v in Models.Create(name).Vertices.Where(v => v.IsBoundary))
        {
            HalfEdge[] turn = [.. v.OutgoingHalfEdges];
            Assert.True(turn[0].Twin.IsBoundary);
            Assert.True(turn[^1].IsBoundary);
            Assert.Equal(v.Outgoing, v.OutgoingHalfEdgesClockwise.First());
            Assert.Equal(v.Valence - 1, v.Faces.Count());
        }
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Around_EveryFace_GoesFromItsFirstVertexBothWays(string name)
    {
        foreach (Face f in Models.Create(name).Faces)
        {
            Vertex[] turn = [.. f.Vertices];
            Assert.Equal(f.Degree, turn.Length);
            Assert.Equal(f.IsTriangle, turn.Length == 3);
            Assert.Equal(f.HalfEdge.Source, turn[0]);
            Vertex[] reversed = [turn[0], .. turn.Skip(1).Reverse()];
            Assert.Equal(reversed, f.VerticesClockwise);
            Assert.Equal(f.HalfEdges.Reverse(), f.HalfEdgesClockwise);
            Assert.Equal(f.HalfEdges, f.HalfEdge.Loop);
        }
    }

    [Fact]
    public void Circulations_OfEverySort_AllocateNothing()
    {
        Mesh mesh = Models.Create("grid");
        Assert.True(WalkEverything(mesh) > 0);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 20; i++)
            WalkEverything(mesh);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static int WalkEverything(Mesh mesh)
    {
        int sum = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            foreach (Vertex w in v.Neighbors)
                sum += w.Index;
            foreach (HalfEdge h in v.OutgoingHalfEdgesClockwise)
                sum += h.Index;
            foreach (Edge e in v.Edges)
                sum += e.Index;
            foreach (Face f in v.Faces)
                sum += f.Index;
        }
        foreach (Edge e in mesh.Edges)
        {
            foreach (Vertex v in e.Vertices)
                sum += v.Index;
            foreach (Face f in e.Faces)
                sum += f.Index;
            foreach (Edge d in e.Neighbors)
                sum += d.Index;
        }
        foreach (Face f in mesh.Faces)
        {
            foreach (Vertex v in f.Vertices)
                sum += v.Index;
            foreach (Edge e in f.Edges)
                sum += e.Index;
            foreach (Face g in f.Neighbors)
                sum += g.Index;
        }
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            foreach (HalfEdge k in h.Loop)
                sum += k.Index;
        }
        return sum;
    }

    [Fact]
    public void Circulation_AroundAnIsolatedVertex_IsEmpty()
    {
        var mesh = new Mesh();
        Vertex v = mesh.AddVertex(default);
        Assert.Empty(v.Neighbors);
        Assert.Empty(v.Faces);
        Assert.Equal(0, v.Valence);
        Assert.True(v.IsIsolated);
        Assert.False(v.IsBoundary);
        Assert.True(v.Outgoing.IsNone);
    }
}
