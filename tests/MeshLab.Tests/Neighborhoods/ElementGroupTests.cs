using MeshLab.Neighborhoods;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.Neighborhoods.NeighborhoodTests;

namespace MeshLab.Tests.Neighborhoods;

[Trait("Section", "5.4")]
[Trait("Section", "5.5")]
public class ElementGroupTests
{
    /// <summary>Like the drawing of <see cref="Grid"/>, n × n squares.</summary>
    private static Mesh Grid(int n)
    {
        var builder = new MeshBuilder();
        int w = n + 1;
        for (int v = 0; v < w * w; v++)
            builder.AddVertex(new(v % w, v / w, 0));
        for (int j = 0; j < n; j++)
        {
            for (int i = 0; i < n; i++)
            {
                int a = (j * w) + i;
                builder.AddFace(a, a + 1, a + w + 1);
                builder.AddFace(a, a + w + 1, a + w);
            }
        }
        return builder.Build();
    }

    [Fact]
    public void VertexGroup_OneVertex_HasItsRing()
    {
        Mesh mesh = Grid(4);
        ElementGroup group = mesh.Group([mesh.Vertices[12]]);
        Assert.Equal([6, 7, 11, 13, 17, 18], Indices(group.RingVertices));
        Assert.Equal(6, group.RingFaces.Length);
        Assert.Equal(6, group.RingEdges.Length);
        Assert.Equal(6, group.RingHalfEdges.Length);
        Assert.Empty(group.Faces);
        Assert.Empty(group.RimHalfEdges);
        Assert.Empty(group.RimLoops);
    }

    [Fact]
    public void VertexGroup_TwoPatches_BothAreAnsweredFor()
    {
        Mesh mesh = Grid(6);
        // The corners of face 0 and of the last face.
        Face first = mesh.Faces[0], last = mesh.Faces[mesh.Faces.Count - 1];
        ElementGroup group = mesh.Group(first.Vertices.Concat(last.Vertices));
        Assert.Equal([first.Index, last.Index], Indices(group.Faces));
        Assert.Equal(2, group.RimLoops.Length);
        Assert.All(group.RimLoops, loop => Assert.Equal(3, loop.Length));
        Assert.Equal([first.Index, last.Index], Indices(group.RimFaces));
        Assert.All(group.RimHalfEdges, h => Assert.True(h.IsBoundary || (h.Face != first && h.Face != last)));
    }

    [Fact]
    public void EdgeGroup_OneEdge_IsWalkedOnBothSides()
    {
        Mesh mesh = Grid(4);
        Edge e = mesh.FindEdge(mesh.Vertices[11], mesh.Vertices[12]);
        ElementGroup group = mesh.Group([e]);
        HalfEdge[] loop = Assert.Single(group.RimLoops);
        Assert.Equal([e.HalfEdge0, e.HalfEdge1], loop);
        Assert.Equal(e.LoopEdges, group.RingEdges);
        Assert.Equal(e.TouchingFaces, group.RingFaces);
        Assert.Empty(group.RimFaces);
        Assert.Equal(2, group.OuterRimFaces.Length);
    }

    [Fact]
    public void FaceGroup_Block_HasInsideToTheLeft()
    {
        Mesh mesh = Grid(4);
        // The four squares around vertex 12, less one triangle: a rim of nine edges.
        Face[] faces = [.. mesh.Vertices[12].Faces];
        ElementGroup group = mesh.Group(faces);
        HalfEdge[] loop = Assert.Single(group.RimLoops);
        Assert.Equal(6, loop.Length);
        for (int i = 0; i < loop.Length; i++)
        {
            Assert.Contains(loop[i].Face, faces);
            Assert.Equal(loop[i].Target, loop[(i + 1) % loop.Length].Source);
        }
        Assert.Equal(Indices(faces.OrderBy(f => f.Index)), Indices(group.RimFaces));
        Assert.Equal(6, group.OuterRimFaces.Length);
        Assert.Equal([6, 7, 11, 12, 13, 17, 18], Indices(group.Vertices));
    }

    [Fact]
    public void FaceGroup_AtTheBoundary_HasNoFaceBeyondIt()
    {
        Mesh mesh = Models.Create("grid");
        ElementGroup all = mesh.Group(mesh.Faces), one = mesh.Group([mesh.Faces[0]]);
        Assert.Empty(all.OuterRimFaces);
        Assert.Equal(mesh.Faces.Where(f => f.Edges.Any(e => e.IsBoundary)), all.RimFaces);
        Assert.Equal(mesh.Faces[0].Neighbors.OrderBy(f => f.Index), one.OuterRimFaces);
        Assert.Equal(mesh.Faces[0].Neighbors.OrderBy(f => f.Index), mesh.Faces[0].FacesSharingEdge);
    }

    [Fact]
    public void FaceGroup_Annulus_HasTwoLoops()
    {
        Mesh mesh = Grid(5);
        Face[] around = [.. mesh.Vertices[14].Faces];
        ElementGroup ring = mesh.Group(mesh.Group(around).RingFaces);
        Assert.Equal(2, ring.RimLoops.Length);
        Assert.Equal(ring.RimHalfEdges.Length, ring.RimLoops.Sum(loop => loop.Length));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void RimLoops_RandomGroups_AreClosedAndHoldEveryRimHalfEdgeOnce(string name)
    {
        Mesh mesh = Models.Create(name);
        var random = new Random(5);
        ElementGroup[] groups =
        [
            mesh.Group(mesh.Vertices.Where(_ => random.Next(2) == 0)),
            mesh.Group(mesh.Edges.Where(_ => random.Next(4) == 0)),
            mesh.Group(mesh.Faces.Where(_ => random.Next(2) == 0)),
            mesh.Group(mesh.Faces),
        ];
        foreach (ElementGroup group in groups)
        {
            Assert.Equal(group.RimHalfEdges, group.RimLoops.SelectMany(loop => loop).OrderBy(h => h.Index));
            foreach (HalfEdge[] loop in group.RimLoops)
            {
                for (int i = 0; i < loop.Length; i++)
                    Assert.Equal(loop[i].Target, loop[(i + 1) % loop.Length].Source);
            }
            Assert.Empty(group.RingFaces.Intersect(group.Faces));
            Assert.Empty(group.RingVertices.Intersect(group.Vertices));
        }
        Assert.Equal(mesh.BoundaryLoopCount, groups[^1].RimLoops.Length);
    }

    /// <summary>Time follows memory here: every step of a walk adds an element to a list or a set. A hundred times the mesh must not cost a byte more.</summary>
    [Fact]
    public void Queries_MeshesOfDifferentSize_CostTheSame()
    {
        Mesh small = Grid(20), large = Grid(200);
        foreach (Func<Vertex, object> query in (Func<Vertex, object>[])
        [
            v => v.RingVertices, v => v.SpokeEdges, v => v.LinkEdges, v => v.IncidentFaces, v => v.Ring(3), v => v.Disk(3),
            v => v.SpokeEdges[0].LoopVertices, v => v.SpokeEdges[0].LoopEdges, v => v.SpokeEdges[0].TouchingFaces, v => v.SpokeEdges[0].Ring(2),
            v => v.IncidentFaces[0].FacesSharingVertex, v => v.IncidentFaces[0].FacesSharingEdge, v => v.IncidentFaces[0].RingVertices, v => v.IncidentFaces[0].RingEdges,
            v => v.Mesh.Group(v.Disk(2)).RingVertices, v => v.Mesh.Group(v.SpokeEdges).RingFaces, v => v.Mesh.Group(v.IncidentFaces).RingEdges,
            v => v.Mesh.Group(v.Disk(2)).RimLoops, v => v.Mesh.Group(v.IncidentFaces).RimFaces, v => v.Mesh.Group(v.IncidentFaces).OuterRimFaces,
        ])
        {
            Vertex inSmall = small.Vertices[(10 * 21) + 10], inLarge = large.Vertices[(100 * 201) + 100];
            query(inSmall);
            Assert.Equal(Allocated(() => query(inSmall)), Allocated(() => query(inLarge)));
        }

        static long Allocated(Func<object> query)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            query();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
    }

    [Fact]
    public void Group_ForeignDeletedOrNoElement_ThrowsWithItsName()
    {
        Mesh mesh = Grid(2), other = Grid(2);
        Assert.Contains("v3", Assert.Throws<ArgumentException>(() => mesh.Group([other.Vertices[3]])).Message, StringComparison.Ordinal);
        Assert.Contains("e2", Assert.Throws<ArgumentException>(() => mesh.Group([other.Edges[2]])).Message, StringComparison.Ordinal);
        Assert.Contains("f1", Assert.Throws<ArgumentException>(() => mesh.Group([other.Faces[1]])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => mesh.Group([default(Vertex)]));
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.Group([mesh.Vertices[0]]).Ring(-1));
        Assert.Empty(mesh.Group(Array.Empty<Vertex>()).RingVertices);
    }
}
