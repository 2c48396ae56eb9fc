using MeshLab.Editing;
using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

/// <summary>Walks, the number of faces, and the shape: the parts of the default engine on their own.</summary>
[Trait("Section", "9.6")]
public class RepairTests
{
    private static readonly GuardLevel Loose = new(-0.5, 0, double.PositiveInfinity);

    private static FiveSixSevenMeshing.Tools ToolsFor(Mesh mesh, int target)
    {
        WorkMesh work = WorkMesh.From(mesh);
        InputSurface surface = FiveSixSevenMeshing.SurfaceOf(work, new());
        return FiveSixSevenMeshing.ToolsFor(work, surface, target, default);
    }

    /// <summary>A torus of valence 6 with one vertex of valence 4 in it: two flips that meet.</summary>
    private static Mesh TorusWithABadVertex()
    {
        Mesh mesh = Models.Torus(20, 16);
        Vertex v = mesh.Vertices[50];
        Edge[] edges = [.. v.Edges];
        Assert.True(edges[0].TryFlip(out _) && edges[3].TryFlip(out _));
        Assert.Equal(4, v.Valence);
        return mesh;
    }

    [Fact]
    public void TryRepair_BadVertex_LowersThePenaltyInOneWalk()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(TorusWithABadVertex(), 640);
        WorkMesh work = tools.Guard.Mesh;
        Assert.Equal((1, 1), (work.Penalty, work.CountBad()));
        Assert.True(tools.Walk.TryRepair(50, Loose, 4, 4));
        Assert.Equal((0, 0), (work.Penalty, work.CountBad()));
        // The cheapest way: a flip, so the number of faces is the same.
        Assert.Equal((640, 1), (work.LiveFaces, tools.Walk.Walks));
        Assert.False(work.IsRecording);
    }

    [Fact]
    public void TryRepair_NothingAllowed_LeavesTheMeshAsItWas()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(TorusWithABadVertex(), 640);
        WorkMesh work = tools.Guard.Mesh;
        int[] target = [.. work.Target];
        // No new face may be better than a regular triangle.
        Assert.False(tools.Walk.TryRepair(50, new(1.5, 0, double.PositiveInfinity), 4, 4));
        Assert.Equal(target, work.Target);
        Assert.Equal(1, work.Penalty);
    }

    [Fact]
    public void TryRepair_WalksThatFail_AreTakenBack()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(TorusWithABadVertex(), 640);
        WorkMesh work = tools.Guard.Mesh;
        // Lines and corners everywhere: only splits are left, and one split makes another vertex of valence 4.
        Array.Fill(work.Crease, 1);
        Array.Fill(work.Kind, VertexKind.Corner);
        int[] target = [.. work.Target];
        Assert.False(tools.Walk.TryRepair(50, GuardLevel.TopologyOnly, 1, 10));
        Assert.True(tools.Walk.Walks > 1);
        Assert.Equal((1, 640, target.Length / 2), (work.Penalty, work.LiveFaces, work.EdgeSlots));
        Assert.Equal(target, work.Target[..target.Length]);
    }

    [Fact]
    public void Pass_BelowAndAboveTheTarget_RatherSplitsOrCollapses()
    {
        int FacesAfter(int target)
        {
            FiveSixSevenMeshing.Tools tools = ToolsFor(PathologicalMeshes.Wrecked(Models.Torus(16, 10), 2), target);
            tools.Walk.Pass(GuardLevel.TopologyOnly, 24, 60, default);
            return tools.Guard.Mesh.LiveFaces;
        }

        Assert.True(FacesAfter(10_000) > FacesAfter(10));
    }

    [Fact]
    public void Pass_Wrecked_EndsWithoutBadVertices()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(PathologicalMeshes.Wrecked(Models.Torus(16, 10), 2), 320);
        Assert.True(tools.Guard.Mesh.CountBad() > 10);
        for (int pass = 0; pass < 3; pass++)
            tools.Walk.Pass(GuardLevel.TopologyOnly, 24, 60, default);
        Assert.Equal((0, 0), (tools.Guard.Mesh.Penalty, tools.Guard.Mesh.CountBad()));
    }

    [Theory]
    [InlineData(480)]
    [InlineData(600)]
    [InlineData(638)]
    [InlineData(640)]
    [InlineData(642)]
    [InlineData(700)]
    [InlineData(900)]
    public void Approach_RegularTorus_ReachesTheCountWithoutBadVertices(int target)
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(Models.Torus(20, 16), target);
        tools.Count.Approach(target, Loose, 30);
        Assert.InRange(tools.Guard.Mesh.LiveFaces, target - 1, target + 1);
        Assert.Equal(0, tools.Guard.Mesh.Penalty);
    }

    [Fact]
    public void Sorted_CostsWithTies_GoByIndexAndStopAtTheLimit()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(Models.Torus(6, 5), 60);
        int n = tools.Guard.Mesh.EdgeSlots;
        Assert.Equal(Enumerable.Range(0, n), tools.Count.Sorted(_ => 1));
        Assert.Equal(Enumerable.Range(0, n).Reverse(), tools.Count.Sorted(e => -e));
        Assert.Equal([0, 3, 6, 9, 1, 4, 7], tools.Count.Sorted(e => e > 10 ? 5 : e % 3, 2).Where(e => e is not 10).Take(7));
        Assert.DoesNotContain(2, tools.Count.Sorted(e => e % 3, 2));
    }

    [Fact]
    public void TryCollapse_KeepingThePenalty_RefusesWhatMakesBadVertices()
    {
        // On a regular mesh every collapse takes an edge from two vertices, 6 → 5, and makes one of valence 8.
        FiveSixSevenMeshing.Tools tools = ToolsFor(Models.Torus(20, 16), 640);
        WorkMesh work = tools.Guard.Mesh;
        Assert.False(tools.Count.TryCollapse(0, Loose, keepsPenalty: true));
        Assert.Equal(640, work.LiveFaces);
        Assert.False(tools.Count.TryCollapse(0, Loose, keepsPenalty: false, maxLength: 1e-3));
        Assert.True(tools.Count.TryCollapse(0, Loose, keepsPenalty: false));
        Assert.Equal((638, 1), (work.LiveFaces, work.Penalty));
    }

    [Theory]
    [InlineData(-0.5, 640)]
    [InlineData(0.97, 640)] // the torus bends more than that: most repairs are refused
    [InlineData(-0.5, 10_000)] // walks would rather split, but must not
    public void TryCollapseAndRepair_RegularMesh_IsUndoneOrEndsWithoutBadVertices(double cosine, int target)
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(Models.Torus(20, 16), target);
        var level = new GuardLevel(cosine, 0, double.PositiveInfinity);
        WorkMesh work = tools.Guard.Mesh;
        int[] before = [.. work.Target];
        int done = 0, undone = 0;
        for (int e = 0; e < 200; e++)
        {
            if (!work.IsLiveEdge(e))
                continue;
            int faces = work.LiveFaces;
            bool ok = tools.Count.TryCollapseAndRepair(e, level);
            Assert.Equal(0, work.Penalty);
            // What repairs a collapse adds no faces.
            Assert.True(ok ? work.LiveFaces <= faces - 2 : work.LiveFaces == faces);
            if (!ok && done == 0)
                Assert.Equal(before, work.Target[..before.Length]);
            done += ok ? 1 : 0;
            undone += ok ? 0 : 1;
        }
        Assert.True(cosine < 0 ? done > 10 : undone > 10, $"{done}, {undone}");
    }

    [Fact]
    public void Smooth_GridWithDisturbedVertices_MakesRounderTrianglesInPlace()
    {
        Mesh mesh = Models.Triangulated(Models.QuadGrid(12, 12));
        var random = new Random(3);
        foreach (Vertex v in mesh.Vertices.Where(v => !v.IsBoundary))
            v.Position += new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, 0) * 0.05;
        FiveSixSevenMeshing.Tools tools = ToolsFor(mesh, mesh.Faces.Count);
        WorkMesh work = tools.Guard.Mesh;
        double mean = work.MeanQuality(), least = Least(work);
        tools.Shape.Smooth(3, 0.8, 1, new(0, 0, 0.003));
        Assert.True(work.MeanQuality() > mean + 0.02 && Least(work) >= least);
        Assert.All(work.Positions, p => Assert.Equal(0, p.Z, 12));
        // Corners stay; the others on the boundary move along it.
        Assert.Equal(4, Enumerable.Range(0, work.VertexSlots).Count(v => work.Kind[v] == VertexKind.Corner));
        foreach (Vertex v in mesh.Vertices.Where(v => v.IsBoundary))
        {
            Vector3D p = work.Positions[v.Index];
            Assert.True(work.Kind[v.Index] == VertexKind.Corner ? p == v.Position : p.X is 0 or 1 || p.Y is 0 or 1, $"{v}: {p}");
        }
    }

    [Fact]
    public void Smooth_CurvedSurface_StaysNearTheInput()
    {
        // A coarse sphere over itself: moving a vertex along it moves its faces off it by more than the tolerance, for most.
        Mesh mesh = Models.Sphere(10, 14);
        FiveSixSevenMeshing.Tools tools = ToolsFor(mesh, mesh.Faces.Count);
        WorkMesh work = tools.Guard.Mesh;
        Vector3D[] before = [.. work.Positions];
        const double Tolerance = 0.004;
        tools.Shape.Smooth(2, 0.5, 0, new(0, 0, Tolerance));
        Assert.Contains(Enumerable.Range(0, work.VertexSlots), v => work.Positions[v] != before[v]);
        for (int f = 0; f < work.FaceSlots; f++)
        {
            int h = work.HalfEdgeOf[f];
            Vector3D a = work.Positions[work.Source(h)], b = work.Positions[work.Target[h]], c = work.Positions[work.Apex(h)];
            foreach (Vector3D p in new[] { (a + b + c) / 3, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5 })
                Assert.InRange(Vector3D.Distance(p, tools.Guard.Surface.Project(p)), 0, Tolerance);
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Approach_FewerFaces_TakesThemWhereItIsFlatAndFine(bool wavy)
    {
        // Two halves: one with waves and slightly shorter edges, one flat; or both flat, one with columns twice as wide.
        Mesh grid = Models.Triangulated(Models.QuadGrid(24, 24));
        foreach (Vertex v in grid.Vertices)
        {
            double x = v.Position.X;
            v.Position = wavy
                ? new Vector3D(x > 0.5 ? 0.5 + 0.9 * (x - 0.5) : x, v.Position.Y, x > 0.5 ? 0.015 * Math.Sin(50 * x) * Math.Sin(50 * v.Position.Y) : 0)
                : v.Position with { X = x > 0.5 ? 0.5 + 2 * (x - 0.5) : x };
        }
        FiveSixSevenMeshing.Tools tools = ToolsFor(grid, 900);
        WorkMesh work = tools.Guard.Mesh;
        tools.Count.Approach(900, Loose, 12);
        Assert.InRange(work.LiveFaces, 899, 901);
        int[] gone = [.. Enumerable.Range(0, grid.VertexSlots).Where(v => !work.IsLiveVertex(v))];
        int left = gone.Count(v => grid.Positions[v].X < 0.5), right = gone.Count(v => grid.Positions[v].X > 0.5);
        Assert.True(left > 3 * right, $"{left}, {right}");
    }

    private static double Least(WorkMesh work) => Enumerable.Range(0, work.FaceSlots).Where(work.IsLiveFace).Min(work.QualityOf);

    [Fact]
    public void Smooth_OneVertexOutOfPlace_GoesToTheMeanOfItsCentroids()
    {
        // A fan of six with its centre moved: the centroids' mean by area is the centre of the disk again.
        Mesh mesh = Models.Fan(6);
        Vertex hub = mesh.Vertices.Single(v => !v.IsBoundary);
        hub.Position = new(0.3, 0.1, 0);
        FiveSixSevenMeshing.Tools tools = ToolsFor(mesh, 6);
        Vector3D sum = default;
        double areas = 0;
        foreach (Face f in mesh.Faces)
        {
            Vector3D[] p = [.. f.Vertices.Select(v => v.Position)];
            double area = Vector3D.Cross(p[1] - p[0], p[2] - p[0]).Length;
            sum += (p[0] + p[1] + p[2]) * (area / 3);
            areas += area;
        }
        tools.Shape.Smooth(1, 0.8, 0, new(0, 0, 1));
        Assert.Equal(0, Vector3D.Distance(sum / areas, tools.Guard.Mesh.Positions[hub.Index]), 12);
    }

    [Fact]
    public void Flip_EachRule_DoesWhatItSays()
    {
        foreach (ShapeImprovement.FlipRule rule in Enum.GetValues<ShapeImprovement.FlipRule>())
        {
            FiveSixSevenMeshing.Tools tools = ToolsFor(PathologicalMeshes.Wrecked(Models.Triangulated(Models.QuadGrid(10, 10)), 5), 200);
            WorkMesh work = tools.Guard.Mesh;
            (double least, long penalty, int irregular) = (Least(work), work.Penalty, Irregularity(work));
            tools.Shape.Flip(new(-0.5, 0, double.PositiveInfinity), 5, rule);
            Assert.NotEqual(irregular, Irregularity(work));
            if (rule == ShapeImprovement.FlipRule.Regularity)
                Assert.True(Irregularity(work) < irregular);
            else
                Assert.True(Least(work) >= least);
            if (rule == ShapeImprovement.FlipRule.QualityKeepingPenalty)
                Assert.True(work.Penalty <= penalty);
        }
    }

    private static int Irregularity(WorkMesh work) =>
        Enumerable.Range(0, work.VertexSlots).Where(work.IsLiveVertex).Sum(v => WorkMesh.IrregularityOf(work.Valence[v], work.OnRim[v]));

    [Fact]
    public void CollapseSlivers_Needle_IsGone()
    {
        // A vertex close to its neighbour makes two needles beside the edge between them.
        Mesh mesh = Models.Torus(20, 16);
        HalfEdge h = mesh.Vertices[70].Outgoing;
        h.Edge.Split(Vector3D.Lerp(h.Source.Position, h.Target.Position, 0.02));
        FiveSixSevenMeshing.Tools tools = ToolsFor(mesh, 640);
        WorkMesh work = tools.Guard.Mesh;
        Assert.InRange(Least(work), 0, 0.1);
        tools.Shape.CollapseSlivers(0.35, Loose);
        Assert.InRange(Least(work), 0.35, 1);
    }

    [Fact]
    public void Remesh_CubeOfTwelveFaces_BecomesEvenAtTheAskedCount()
    {
        FiveSixSevenMeshing.Tools tools = ToolsFor(Models.Create("cube"), 1200);
        WorkMesh work = tools.Guard.Mesh;
        tools.Shape.Remesh(1200, 6, new(0.8, 0.1, 0.003));
        Assert.InRange(work.LiveFaces, 900, 1500);
        Assert.InRange(work.MeanQuality(), 0.85, 1);
        double length = Math.Sqrt(4 * 6 / (Math.Sqrt(3) * work.LiveFaces));
        for (int e = 0; e < work.EdgeSlots; e++)
            Assert.True(!work.IsLiveEdge(e) || Math.Sqrt(work.LengthSquared(e)) < 2 * length);
        // Twelve creases and eight corners, as before, and everything on the cube.
        Assert.Equal(8, Enumerable.Range(0, work.VertexSlots).Count(v => work.IsLiveVertex(v) && work.Kind[v] == VertexKind.Corner));
        Assert.All(
            Enumerable.Range(0, work.VertexSlots).Where(work.IsLiveVertex),
            v => Assert.Equal(0, Vector3D.Distance(tools.Guard.Surface.Project(work.Positions[v]), work.Positions[v]), 12));
    }

    [Theory]
    [InlineData(2, 20)]
    [InlineData(0, 14)]
    [InlineData(-2, 28)]
    [InlineData(-10, 140)]
    public void SmallestCounts_Characteristic_GivesTheFewestFaces(int characteristic, int faces) =>
        Assert.Equal(faces, SmallestCounts.Of(characteristic));

    [Fact]
    public void SmallestCounts_Components_AddUp()
    {
        Mesh mesh = Models.Tetrahedron();
        Assert.Equal(20, SmallestCounts.Of(mesh, out bool isOneSphere));
        Assert.True(isOneSphere);
        mesh.Append(Models.Torus(5, 4));
        mesh.Append(Models.Fan(5));
        Assert.Equal(20 + 14 + 1, SmallestCounts.Of(mesh, out isOneSphere));
        Assert.False(isOneSphere);
        SmallestCounts.Of(Models.Torus(5, 4), out isOneSphere);
        Assert.False(isOneSphere);
        SmallestCounts.Of(Models.Fan(5), out isOneSphere);
        Assert.False(isOneSphere);
    }

    [Theory]
    [MemberData(nameof(Models.ClosedTriangleMeshes), MemberType = typeof(Models))]
    public void VertexColors_EveryModel_GivesEveryMovableVertexOnceAndNoNeighboursTogether(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Any(v => v.IsIsolated))
            return;
        WorkMesh work = WorkMesh.From(mesh);
        work.Kind[1] = VertexKind.Corner;
        int[][] colors = VertexColors.Of(work);
        Assert.Equal(Enumerable.Range(0, mesh.VertexSlots).Where(v => v != 1), colors.SelectMany(c => c).Order());
        foreach (int[] color in colors)
            Assert.DoesNotContain(color, v => mesh.Vertices[v].Neighbors.Any(w => color.Contains(w.Index)));
        Assert.All(colors, color => Assert.Equal(color.Order(), color));
    }
}
