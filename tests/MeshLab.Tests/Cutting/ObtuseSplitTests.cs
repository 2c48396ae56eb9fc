using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.6")]
public class ObtuseSplitTests
{
    [Fact]
    public void SplitObtuse_FlatTriangle_BecomesTwoRightAngledOnes()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(1, 0.1, 0)], [0, 1, 2]);
        ObtuseSplitResult result = mesh.SplitObtuse();
        Assert.Equal((1, 1), (result.Splits, result.Passes));
        Assert.Empty(result.Remaining);
        Assert.Equal(new Vector3D(1, 0, 0), mesh.Positions[3]);
        Assert.Equal(2, mesh.Faces.Count);
        Assert.Equal(0.2, mesh.Area, 1e-15);
        Assert.Equal([0, 0], result.SourceFace);
        Assert.Equal([0, 1], result.Pieces.Single());
        ObtuseFoot foot = result.Feet.Single();
        Assert.Equal((3, mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[3]).Index), (foot.Vertex, foot.SourceEdge));
        Assert.Equal((0, 1, 0.25), foot.From == 0 ? (foot.From, foot.To, foot.Parameter) : (foot.To, foot.From, 1 - foot.Parameter));
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void SplitObtuse_Models_AreaStaysAndWhatRemainsIsReported(string name)
    {
        Mesh mesh = Models.Create(name);
        double area = mesh.Faces.Count == 0 ? 0 : mesh.Area;
        Mesh old = mesh.Clone();
        ObtuseSplitResult result = mesh.SplitObtuse(Math.PI * 110 / 180, 3);
        Assert.True(result.Passes <= 3);
        Assert.Equal(mesh.Faces.Where(f => f.Triangle.MaxAngle > Math.PI * 110 / 180 + 1e-12).Select(f => f.Index).Order(), result.Remaining.Select(f => f.Index).Where(f => mesh.Faces[f].Triangle.MaxAngle > Math.PI * 110 / 180 + 1e-12).Order());
        Assert.Equal(area, mesh.Faces.Count == 0 ? 0 : mesh.Area, 1e-9 * (1 + area));
        Assert.Empty(mesh.Validate());
        // Every new vertex lies where it was made: on an edge of that moment, and that on an old edge or inside an old face.
        Assert.Equal(Enumerable.Range(old.VertexSlots, result.Splits), result.Feet.Select(foot => foot.Vertex));
        foreach (ObtuseFoot foot in result.Feet)
        {
            Assert.True(foot.From < foot.Vertex && foot.To < foot.Vertex);
            Vector3D p = mesh.Positions[foot.Vertex];
            Assert.Equal(Vector3D.Lerp(mesh.Positions[foot.From], mesh.Positions[foot.To], foot.Parameter), p);
            bool onOldEdge = old.Edges.Any(e => IsOn(e, p, 1e-12 * (1 + area)));
            Assert.True(foot.SourceEdge < 0 ? !onOldEdge || area < 1e-9 : IsOn(old.Edges[foot.SourceEdge], p, 1e-12 * (1 + area)), $"{foot}");
        }
        // The pieces of a face make it up.
        Assert.Equal(mesh.FaceSlots, result.SourceFace.Length);
        Assert.Equal(mesh.Faces.Count, result.Pieces.Sum(pieces => pieces.Count));
        foreach (Face f in old.Faces)
        {
            Assert.Equal(f.Index, result.Pieces[f.Index][0]);
            Assert.Equal(f.Area, result.Pieces[f.Index].Sum(piece => mesh.Faces[piece].Area), 1e-12 * (1 + area));
        }
    }

    [Fact]
    public void SplitObtuse_AltitudeSplitAgain_NamesNoOldEdge()
    {
        // Splitting at more than 95° goes on inside the first halves.
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0.5, 0.05, 0), new(0.5, -3, 0)], [0, 1, 2, 1, 0, 3]);
        Mesh old = mesh.Clone();
        ObtuseSplitResult result = mesh.SplitObtuse(Math.PI * 91 / 180);
        Assert.Contains(result.Feet, foot => foot.SourceEdge >= 0);
        Assert.All(result.Feet, foot => Assert.Equal(foot.SourceEdge >= 0, old.Edges.Any(e => IsOn(e, mesh.Positions[foot.Vertex], 1e-12))));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void SplitObtuse_NeighbourAcrossTheSameEdge_IsSplitWithItOnce()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(2, 0.25, 0), new(2, -0.25, 0)], [0, 1, 2, 1, 0, 3]);
        ObtuseSplitResult result = mesh.SplitObtuse();
        Assert.Equal((1, 1), (result.Splits, result.Passes));
        Assert.Equal(new(2, 0, 0), mesh.Positions[4]);
        Assert.Equal([2, 2], result.Pieces.Select(pieces => pieces.Count));
        Assert.Equal(4, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void SplitObtuse_NoPass_ListsTheLargestAngleFirst()
    {
        // Apexes 0.5, 0.125 and again 0.5 above the middle of an edge of length 4, and one that is not obtuse enough.
        double[] heights = [0.5, 0.125, 0.5, 2];
        Vector3D[] positions = [.. heights.SelectMany((h, i) => (Vector3D[])[new(0, 10 * i, 0), new(4, 10 * i, 0), new(2, (10 * i) + h, 0)])];
        Mesh mesh = MeshBuilder.FromTriangles(positions, [.. Enumerable.Range(0, 12)]);
        ObtuseSplitResult result = mesh.SplitObtuse(maxPasses: 0);
        Assert.Equal((0, 0), (result.Splits, result.Passes));
        Assert.Equal([1, 0, 2], result.Remaining.Select(f => f.Index));
        Assert.Equal([1, 0, 2], mesh.SplitObtuse().Feet.Select(foot => mesh.Positions[foot.Vertex].Y / 10));
    }

    [Theory]
    [InlineData(2, 6)]
    [InlineData(6, 2)]
    public void SplitObtuse_EdgeSplitTwice_NamesTheOldEdgeBothTimes(double apex, double across)
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(8, 0, 0), new(apex, 0.25, 0), new(across, -0.25, 0)], [0, 1, 2, 1, 0, 3]);
        int edge = mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]).Index;
        ObtuseSplitResult result = mesh.SplitObtuse();
        ObtuseFoot[] onEdge = [.. result.Feet.Where(foot => mesh.Positions[foot.Vertex].Y == 0)];
        Assert.Equal([apex, across], onEdge.Select(foot => Math.Round(mesh.Positions[foot.Vertex].X, 12)));
        Assert.All(onEdge, foot => Assert.Equal(edge, foot.SourceEdge));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void SplitObtuse_FootOnAnEnd_IsMovedToTheMiddle()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(1e-13, 1e-14, 0)], [0, 1, 2]);
        ObtuseSplitResult result = mesh.SplitObtuse(maxPasses: 1);
        Assert.Equal(0.5, result.Feet.Single().Parameter);
        Assert.Equal(new(0.5, 0, 0), mesh.Positions[3]);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void SplitObtuse_EdgeThatCannotBeSplit_StopsAndRemains()
    {
        // Two triangles back to back have the same third vertex.
        Mesh pillow = MeshBuilder.FromTriangles([new(0, 0, 0), new(4, 0, 0), new(1, 0.1, 0)], [0, 1, 2, 0, 2, 1]);
        ulong before = pillow.StateHash();
        ObtuseSplitResult result = pillow.SplitObtuse();
        Assert.Equal((0, 1), (result.Splits, result.Passes));
        Assert.Equal([0, 1], result.Remaining.Select(f => f.Index));
        Assert.Equal(before, pillow.StateHash());
    }

    private static bool IsOn(Edge edge, Vector3D p, double limit)
    {
        Vector3D a = edge.Vertex0.Position, b = edge.Vertex1.Position;
        return Vector3D.Distance(a, p) + Vector3D.Distance(p, b) - Vector3D.Distance(a, b) <= limit;
    }

    [Fact]
    public void SplitObtuse_BadInput_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => Models.Create("cube-quads").SplitObtuse());
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitObtuse(1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Create("cube").SplitObtuse(2, -1));
    }
}
