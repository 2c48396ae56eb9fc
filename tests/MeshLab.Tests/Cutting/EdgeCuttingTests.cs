using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.4")]
public class EdgeCuttingTests
{
    [Fact]
    public void CutAlong_AcrossAGrid_MakesTwoParts()
    {
        Mesh mesh = Models.QuadGrid(4, 2);
        // The middle column of vertices: 2, 7, 12.
        Edge[] path = [mesh.FindEdge(mesh.Vertices[2], mesh.Vertices[7]), mesh.FindEdge(mesh.Vertices[7], mesh.Vertices[12])];
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, path);
        Assert.Equal(2, cut.Mesh.ComponentCount);
        Assert.Equal(mesh.Vertices.Count + 3, cut.Mesh.Vertices.Count);
        Assert.Equal(2, cut.Copies[7].Count);
        Assert.Equal(7, cut.Copies[7][0]);
        Assert.All(cut.Copies[7], copy => Assert.Equal(7, cut.SourceVertex[copy]));
        Assert.Equal(Enumerable.Range(0, 8), cut.SourceFace);
        Assert.Equal(Enumerable.Range(0, 8), cut.NewFace);
        Assert.Equal(mesh.Area, cut.Mesh.Area, 1e-14);
        Assert.Empty(cut.Uncut);
        Assert.Empty(cut.Mesh.Validate());
    }

    [Fact]
    public void CutAlong_PathInside_OpensASlitAndItsEndsStay()
    {
        Mesh mesh = Models.QuadGrid(4, 4);
        Edge[] path = [mesh.FindEdge(mesh.Vertices[7], mesh.Vertices[12]), mesh.FindEdge(mesh.Vertices[12], mesh.Vertices[17])];
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, path, opening: 0.01);
        Assert.Equal(2, cut.Mesh.ComputeTopology().BoundaryLoops);
        Assert.Single(cut.Copies[7]);
        Assert.Single(cut.Copies[17]);
        // The two copies of the middle move apart by twice the opening, across the cut.
        Vector3D a = cut.Mesh.Vertices[cut.Copies[12][0]].Position, b = cut.Mesh.Vertices[cut.Copies[12][1]].Position;
        Assert.Equal(0.02, Vector3D.Distance(a, b), 1e-14);
        Assert.Equal(0.02, Math.Abs(a.X - b.X), 1e-14);
        Assert.Equal(mesh.Positions[7], cut.Mesh.Positions[7]);
        Assert.Empty(cut.Mesh.Validate());
    }

    [Fact]
    public void CutAlong_OpeningAcrossAGrid_MovesEverySideIntoItsFaces()
    {
        Mesh mesh = Models.QuadGrid(4, 2);
        Edge[] path = [mesh.FindEdge(mesh.Vertices[2], mesh.Vertices[7]), mesh.FindEdge(mesh.Vertices[7], mesh.Vertices[12])];
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, path, opening: 0.125);
        foreach (Face f in cut.Mesh.Faces)
        {
            bool left = mesh.Faces[f.Index].Barycenter.X < 0.5;
            foreach (Vertex v in f.Vertices)
            {
                int source = cut.SourceVertex[v.Index];
                Vector3D moved = source is 2 or 7 or 12 ? new(left ? -0.125 : 0.125, 0, 0) : default;
                Assert.Equal(mesh.Positions[source] + moved, v.Position);
            }
        }
        // A negative opening lets the sides overlap.
        Assert.Equal(0.625, EdgeCutting.CutAlong(mesh, path, -0.125).Mesh.Faces[1].Vertices.Max(v => v.Position.X));
    }

    [Fact]
    public void CutAlong_OpeningAtACubesCorner_IsTheSumOfNormalTimesEdge()
    {
        // Two edges of the corner 0 part its side z = 0 from the two others, which stay joined.
        Mesh cube = Models.Create("cube-quads");
        Vertex At(double x, double y, double z) => cube.Vertices.Single(v => v.Position == new Vector3D(x, y, z));
        Vertex corner = At(0, 0, 0), onX = At(1, 0, 0), onY = At(0, 1, 0);
        EdgeCutResult cut = EdgeCutting.CutAlong(cube, [cube.FindEdge(corner, onX), cube.FindEdge(corner, onY)], opening: 0.5);
        Assert.Equal(2, cut.Copies[corner.Index].Count);
        Face bottom = cube.Faces.Single(f => f.Vertices.All(v => v.Position.Z == 0));
        foreach (int copy in cut.Copies[corner.Index])
        {
            bool atBottom = cut.Mesh.Vertices[copy].Faces.Any(f => cut.SourceFace[f.Index] == bottom.Index);
            Vector3D expected = atBottom ? new(0.5 / Math.Sqrt(2), 0.5 / Math.Sqrt(2), 0) : new(0, 0, 0.5);
            Assert.Equal(0, Vector3D.Distance(expected, cut.Mesh.Positions[copy]), 1e-15);
        }
        // The ends of the cut are one vertex still, and stay.
        Assert.Equal(onX.Position, cut.Mesh.Positions[cut.Copies[onX.Index].Single()]);
        Assert.Equal(onY.Position, cut.Mesh.Positions[cut.Copies[onY.Index].Single()]);
        Assert.Empty(cut.Mesh.Validate());
    }

    [Fact]
    public void CutAlong_BoundaryEdges_AreCutAlready()
    {
        Mesh mesh = Models.QuadGrid(2, 2);
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, mesh.Edges.Where(e => e.IsBoundary), opening: 0.1);
        Assert.Empty(cut.Uncut);
        Assert.Equal(mesh.StateHash(), cut.Mesh.StateHash());
    }

    [Fact]
    public void CutAlong_OneEdgeInside_CannotOpenAndIsNamed()
    {
        Mesh mesh = Models.QuadGrid(4, 4);
        Edge edge = mesh.FindEdge(mesh.Vertices[12], mesh.Vertices[13]);
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, [edge]);
        Assert.Equal([edge], cut.Uncut);
        Assert.Equal(mesh.StateHash(), cut.Mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void CutAlong_AllEdges_LeavesFacesApart(string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, mesh.Edges);
        Assert.Equal(mesh.Faces.Count, cut.Mesh.ComponentCount);
        Assert.Equal(mesh.Faces.Sum(f => f.Degree), cut.Mesh.Edges.Count);
        Assert.Empty(cut.Mesh.Validate());
        Assert.Equal(before, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void CutAlong_RandomEdges_IsAManifoldOverTheSameFaces(string name)
    {
        Mesh mesh = Models.Create(name);
        var random = new Random(3);
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, mesh.Edges.Where(_ => random.Next(3) == 0), opening: 1e-3);
        Assert.Equal(mesh.Faces.Count, cut.Mesh.Faces.Count);
        Assert.Empty(cut.Mesh.Validate());
        foreach (Face f in cut.Mesh.Faces)
        {
            Assert.Equal(
                mesh.Faces[cut.SourceFace[f.Index]].Vertices.Select(v => v.Index), f.Vertices.Select(v => cut.SourceVertex[v.Index]));
        }
    }

    [Fact]
    public void CutAlong_Traits_GoWithTheCopies()
    {
        Mesh mesh = Models.QuadGrid(4, 4);
        IndexTraits.AddTo(mesh);
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, mesh.Edges.Where(e => e.Index % 2 == 0));
        IndexTraits old = IndexTraits.Of(cut.Mesh);
        Assert.All(cut.Mesh.Vertices, v => Assert.Equal(cut.SourceVertex[v.Index], old.Vertex[v]));
        Assert.All(cut.Mesh.Faces, f => Assert.Equal(cut.SourceFace[f.Index], old.Face[f]));
        Assert.All(cut.Mesh.Edges, e => Assert.Equal(
            mesh.FindEdge(mesh.Vertices[cut.SourceVertex[e.Vertex0.Index]], mesh.Vertices[cut.SourceVertex[e.Vertex1.Index]]).Index, old.Edge[e]));
        Assert.All(cut.Mesh.HalfEdges.Where(h => !h.IsBoundary), h => Assert.Equal(
            (cut.SourceFace[h.Face.Index], cut.SourceVertex[h.Target.Index]),
            (mesh.HalfEdges[old.HalfEdge[h]].Face.Index, mesh.HalfEdges[old.HalfEdge[h]].Target.Index)));
    }

    [Fact]
    public void CutAlong_BadInput_ThrowsNamingIt()
    {
        Mesh mesh = Models.QuadGrid(2, 2), other = Models.QuadGrid(2, 2);
        Assert.Contains("e3", Assert.Throws<ArgumentException>(() => EdgeCutting.CutAlong(mesh, [other.Edges[3]])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => EdgeCutting.CutAlong(mesh, [], double.NaN));
        Assert.Throws<ArgumentException>(() => EdgeCutting.CutAlong(mesh, [default]));
        Edge gone = mesh.Edges[0];
        mesh.Detach(mesh.Faces);
        Assert.Throws<ArgumentException>(() => EdgeCutting.CutAlong(mesh, [gone]));
    }
}
