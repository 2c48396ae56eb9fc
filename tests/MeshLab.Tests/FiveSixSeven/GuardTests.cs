using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

[Trait("Section", "9.6")]
public class GuardTests
{
    private static readonly GuardLevel Strict = new(0.9, 0.2, 0.002);

    private static Guard Of(Mesh mesh) => Of(mesh, mesh);

    private static Guard Of(Mesh mesh, Mesh input)
    {
        WorkMesh work = WorkMesh.From(mesh);
        (Vector3D[] positions, int[] corners, _) = WorkMesh.From(input).Export();
        return new(work, new InputSurface(positions, corners, []));
    }

    /// <summary>Two triangles over the square (±1, 0, 0), (0, ±w, −z), joined along the x axis; half-edge 0 runs along it.</summary>
    private static Mesh Roof(double width, double drop) => MeshBuilder.FromTriangles(
        [new(-1, 0, 0), new(1, 0, 0), new(0, width, -drop), new(0, -width, -drop)], [0, 1, 2, 1, 0, 3]);

    [Fact]
    public void AllowsFlip_FlatSquare_Allows() => Assert.True(Of(Roof(1, 0)).AllowsFlip(0, Strict));

    [Theory]
    [InlineData(0.2, true)] // 22.6° between the faces: both new ones turn by less than acos 0.9
    [InlineData(0.277, false)] // old and new faces differ by 22°, but the new ones by 31°
    [InlineData(0.6, false)]
    public void AllowsFlip_Roof_DependsOnTheTurn(double drop, bool allowed)
    {
        Guard guard = Of(Roof(1, drop));
        Assert.Equal(allowed, guard.AllowsFlip(0, new(0.9, 0, double.PositiveInfinity)));
        // The other diagonal lies below the ridge by its drop.
        Assert.Equal(allowed, guard.AllowsFlip(0, new(0.9, 0, drop + 0.01)));
        Assert.False(guard.AllowsFlip(0, new(0.9, 0, 0.01)));
        Assert.True(guard.AllowsFlip(0, GuardLevel.TopologyOnly));
    }

    [Fact]
    public void AllowsFlip_FarFromTheInput_LooksAtTheNewEdgeAndBothFaces()
    {
        // The middle of the new edge sinks by 0.196, the centroids by two thirds of it.
        Assert.False(Of(Roof(1, 0.2)).AllowsFlip(0, new(0.9, 0, 0.15)));
        // An input that lacks one half of what the mesh has: first the left one, then the right one; the diagonals do not cross at right angles, so nothing is flat.
        foreach (int side in new[] { -1, 1 })
        {
            Mesh half = MeshBuilder.FromTriangles([new(0, -2, 0), new(side, 0, 0), new(0, 2, 0)], side > 0 ? [0, 1, 2] : [0, 2, 1]);
            Mesh saddle = Roof(1, 0.01);
            Assert.False(Of(saddle, half).AllowsFlip(0, new(0.9, 0, 0.1)));
            Assert.True(Of(saddle, half).AllowsFlip(0, new(0.9, 0, 0.4)));
        }
    }

    [Fact]
    public void AllowsFlip_NoAreaBeforeAndAfter_Refuses()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(-1, 0, 0), new(1, 0, 0), new(0.1, 0, 0), new(-0.1, 0, 0)], [0, 1, 2, 1, 0, 3]);
        Assert.False(Of(mesh).AllowsFlip(0, new(-1, 0, double.PositiveInfinity)));
    }

    [Theory]
    [InlineData(1, false, true)] // as good as before
    [InlineData(1, true, false)]
    [InlineData(0.3, false, true)] // quality 0.34 becomes 0.82
    [InlineData(0.3, true, true)]
    [InlineData(0.97, true, true)] // three hundredths better
    [InlineData(0.99, true, false)] // one hundredth
    [InlineData(4, false, false)] // 0.73 becomes 0.28
    public void AllowsFlip_Rhombus_DependsOnQuality(double width, bool mustImprove, bool allowed) =>
        Assert.Equal(allowed, Of(Roof(width, 0)).AllowsFlip(0, new(0.9, 0.6, 0.002), mustImprove));

    [Theory]
    [InlineData(0.1, true)] // quality 0.12 becomes 0.34: still below the least, but better than it was
    [InlineData(10, false)]
    public void AllowsFlip_NeedlesBefore_MustNotGetWorse(double width, bool allowed) =>
        Assert.Equal(allowed, Of(Roof(width, 0)).AllowsFlip(0, new(0.9, 0.5, 0.002)));

    [Fact]
    public void AllowsSplit_MidpointAndNearAnEnd_DependsOnQuality()
    {
        Guard guard = Of(Roof(1.7, 0));
        Assert.True(guard.AllowsSplit(0, default, new(0.9, 0.2, 0.002)));
        Assert.False(guard.AllowsSplit(0, new(0.99, 0, 0), new(0.9, 0.2, 0.002)));
        Assert.False(guard.AllowsSplit(0, new(0, 0, 2), new(0.9, 0, double.PositiveInfinity)));
        Assert.True(guard.AllowsSplit(0, new(0, 0, 2), GuardLevel.TopologyOnly));
        // Halves of a regular triangle have quality ¾: a split may take half of what there was, whatever the least.
        Assert.True(Of(Roof(Math.Sqrt(3), 0)).AllowsSplit(0, default, new(0.9, 0.9, 0.002)));
    }

    [Fact]
    public void SplitPosition_SmoothAndCrease_IsOnTheInput()
    {
        Mesh mesh = Roof(1, 0.5), input = Roof(1, 0.5);
        foreach (Vertex v in input.Vertices)
            v.Position += new Vector3D(0, 0, 0.25);
        WorkMesh work = WorkMesh.From(mesh);
        (Vector3D[] positions, int[] corners, _) = WorkMesh.From(input).Export();
        var guard = new Guard(work, new InputSurface(positions, corners, [(0, 2)]));
        // The ridge above is nearest to no face but by its own line; the middle of 0–2 is 0.25 below the middle of the line that was given.
        Assert.Equal(0, Distance(guard.SplitPosition(0), input), 12);
        int h = work.Find(0, 2);
        work.Crease[h >> 1] = 1;
        Vector3D p = guard.SplitPosition(h), a = positions[0], along = (positions[2] - a).Normalized();
        Assert.Equal(0, Vector3D.Cross(p - a, along).Length, 12);
    }

    private static double Distance(Vector3D p, Mesh input) => FaceTree.Build(input).FindClosest(p).DistanceSquared;

    [Fact]
    public void TryCollapsePosition_KindsOfVertices_KeepsLinesAndCorners()
    {
        Mesh mesh = Models.Triangulated(Models.QuadGrid(6, 6));
        Guard guard = Of(mesh);
        WorkMesh work = guard.Mesh;
        HalfEdge inner = mesh.HalfEdges.First(h => !h.Source.IsBoundary && !h.Target.IsBoundary);
        (int a, int b) = (inner.Source.Index, inner.Target.Index);
        Vector3D middle = (work.Positions[a] + work.Positions[b]) * 0.5;

        Assert.True(guard.TryCollapsePosition(inner.Index, out Vector3D p));
        Assert.Equal(0, Vector3D.Distance(middle, p), 12);
        work.Kind[b] = VertexKind.OnCrease;
        Assert.True(guard.TryCollapsePosition(inner.Index, out p));
        Assert.Equal(work.Positions[b], p);
        work.Kind[a] = VertexKind.OnCrease;
        Assert.False(guard.TryCollapsePosition(inner.Index, out _));
        work.Crease[inner.Index >> 1] = 1;
        Assert.True(guard.TryCollapsePosition(inner.Index, out _));
        work.Kind[a] = VertexKind.Corner;
        Assert.False(guard.TryCollapsePosition(inner.Index, out _));
    }

    [Fact]
    public void AllowsCollapse_FlatAndPyramid_DependsOnShape()
    {
        Mesh grid = Models.Triangulated(Models.QuadGrid(6, 6));
        HalfEdge inner = grid.HalfEdges.First(h => !h.Source.IsBoundary && !h.Target.IsBoundary);
        Guard flat = Of(grid);
        Assert.True(flat.AllowsCollapse(inner.Index, inner.Target.Position, Strict));
        // Far to the side the faces turn over.
        Assert.False(flat.AllowsCollapse(inner.Index, new(3, 0, 0), Strict));
        Assert.True(flat.AllowsCollapse(inner.Index, new(3, 0, 0), GuardLevel.TopologyOnly));
        // Above the plane by a tenth: too far from the input, whatever the angles.
        Vector3D above = inner.Target.Position + new Vector3D(0, 0, 0.01);
        Assert.False(flat.AllowsCollapse(inner.Index, above, new(0.5, 0.001, 0.005)));
        Assert.True(flat.AllowsCollapse(inner.Index, above, new(0.5, 0.001, 0.02)));
    }

    [Fact]
    public void AllowsCollapse_Bump_SeesFacesAndEdgesOfBothStars()
    {
        // One vertex of a flat grid raised. Merging a neighbour into it at its height lifts the neighbour's other faces off the input, and merging it into
        // the neighbour cuts the bump off.
        Mesh grid = Models.Triangulated(Models.QuadGrid(6, 6));
        HalfEdge h = grid.HalfEdges.First(g => !g.Source.IsBoundary && !g.Target.IsBoundary);
        h.Target.Position += new Vector3D(0, 0, 0.05);
        Guard guard = Of(grid);
        // No planes, so that only distances count.
        Array.Clear(guard.Mesh.Quadrics);
        GuardLevel near = new(-1, 0, 0.012), far = new(-1, 0, 0.06);
        Assert.False(guard.AllowsCollapse(h.Index, h.Target.Position, near));
        Assert.True(guard.AllowsCollapse(h.Index, h.Target.Position, far));
        Assert.False(guard.AllowsCollapse(h.Index, h.Source.Position, near));
        Assert.False(guard.AllowsCollapse(h.Twin.Index, h.Source.Position, near));
        Assert.True(guard.AllowsCollapse(h.Twin.Index, h.Source.Position, far));
    }

    [Fact]
    public void IsStarNear_VertexMoved_SeesEdgesAndFaces()
    {
        Mesh grid = Models.Triangulated(Models.QuadGrid(6, 6));
        Guard guard = Of(grid);
        int v = grid.Vertices.First(u => !u.IsBoundary).Index;
        Vector3D p = grid.Positions[v];
        // Centroids rise by a third, midpoints of edges by half of it.
        Assert.True(guard.IsStarNear(v, p + new Vector3D(0, 0, 0.018), new(0, 0, 0.01)));
        Assert.False(guard.IsStarNear(v, p + new Vector3D(0, 0, 0.022), new(0, 0, 0.01)));
    }

    [Fact]
    public void InputSurface_PointsAroundAPlane_AreProjectedAndMeasured()
    {
        (Vector3D[] positions, int[] corners, _) = WorkMesh.From(Models.Triangulated(Models.QuadGrid(4, 4))).Export();
        var surface = new InputSurface(positions, corners, [(0, 4)]);
        Assert.Equal(1, surface.Area, 12);
        foreach (bool hinted in new[] { false, true })
        {
            surface.Hint = hinted ? 3 : -1;
            Assert.Equal(new Vector3D(0.6, 0.7, 0), surface.Project(new(0.6, 0.7, 0.3)));
            surface.Hint = hinted ? 3 : -1;
            Assert.True(surface.IsNear(new(0.6, 0.7, 0.3), 0.301));
            surface.Hint = hinted ? 3 : -1;
            Assert.False(surface.IsNear(new(0.6, 0.7, 0.3), 0.299));
        }
        Assert.True(surface.IsNear(new(100, 0, 0), double.PositiveInfinity));
        Assert.Equal(new Vector3D(0.6, 0, 0), surface.ProjectToLines(new(0.6, 0.7, 0.3)));
        Assert.Equal(new Vector3D(1, 2, 3), new InputSurface(positions, corners, []).ProjectToLines(new(1, 2, 3)));
    }
}
