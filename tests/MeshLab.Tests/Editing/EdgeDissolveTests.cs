using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.3")]
public class EdgeDissolveTests
{
    [Fact]
    public void TryDissolve_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone()
    {
        Mesh mesh = MeshBuilder.FromFaces(3, [0, 1, 2], [0, 2, 1]);
        ulong before = mesh.StateHash();
        Assert.False(mesh.Edges[0].TryDissolve(out JoinRefusal why));
        Assert.Equal(JoinRefusal.SharesMoreThanTheEdge, why);
        Assert.Throws<TopologyException>(() => mesh.Edges[0].Dissolve());
        Assert.Equal(before, mesh.StateHash());

        Mesh square = Models.QuadGrid(1, 1);
        Assert.False(square.Edges[0].TryDissolve(out why));
        Assert.Equal(JoinRefusal.Boundary, why);

        Mesh row = Models.QuadGrid(3, 1);
        Assert.False(row.Faces[0].TryJoin(row.Faces[2], out why));
        Assert.Equal(JoinRefusal.NoCommonEdge, why);
        Assert.Throws<TopologyException>(() => row.Faces[0].Join(row.Faces[0]));
    }

    //    3 ── 4 ── 5            3 ── 4 ── 5
    //    │  0 │  1 │     ⟶      │    0    │
    //    0 ── 1 ── 2            0 ── 1 ── 2
    [Fact]
    public void Dissolve_BetweenTwoQuads_MakesAHexagon()
    {
        Mesh mesh = Models.QuadGrid(2, 1);
        Face joined = mesh.FindEdge(mesh.Vertices[1], mesh.Vertices[4]).Dissolve();
        Assert.Equal(6, joined.Degree);
        Assert.Equal((6, 6, 1), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Join_KeepsTheFaceItIsCalledOn()
    {
        Mesh mesh = Models.QuadGrid(2, 1);
        mesh.Faces[1].Join(mesh.Faces[0]);
        Assert.True(mesh.Faces[0].IsDeleted);
        Assert.Equal(6, mesh.Faces[1].Degree);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void DissolveAndCut_EveryEdgeInTurn_AreInverse(string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        for (int e = 0; e < mesh.EdgeSlots; e += 3)
        {
            Edge edge = mesh.Edges[e];
            if (edge.IsDeleted || !edge.CanDissolve(out _))
                continue;
            (Vertex a, Vertex b) = (edge.Vertex0, edge.Vertex1);
            int left = edge.Face0.Degree, right = edge.Face1.Degree;
            Face joined = edge.Dissolve();
            Assert.Equal(left + right - 2, joined.Degree);
            HalfEdge cut = joined.Cut(a, b);
            Assert.Equal((left, right), (cut.Face.Degree, cut.Twin.Face.Degree));
        }
        Assert.Empty(mesh.Validate());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void Dissolve_EverythingLegal_LeavesASoundMesh()
    {
        foreach (string name in Models.Names)
        {
            Mesh mesh = Models.Create(name);
            foreach (Edge e in mesh.Edges)
                e.TryDissolve(out _);
            Assert.Empty(mesh.Validate());
        }
    }
}
