using MeshLab.Editing;
using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

[Trait("Section", "9.6")]
public class WorkMeshTests
{
    public static TheoryData<string> Solid => new(Models.Names.Where(name => IsSolid(Models.Create(name))));

    // The largest hubs take long to check again and again.
    private static bool IsSolid(Mesh mesh) => mesh.IsTriangleMesh && mesh.Faces.Count is > 0 and < 1000 && mesh.Vertices.All(v => !v.IsIsolated);

    [Theory]
    [MemberData(nameof(Solid))]
    public void Operations_Random_KeepColumnsTrueAndUndoTakesThemBack(string name)
    {
        Mesh mesh = Models.Create(name);
        WorkMesh work = WorkMesh.From(mesh);
        Creases.Mark(work, 40 * Math.PI / 180, 0);
        var random = new Random(7);
        int undone = 0;
        for (int round = 0; round < 30; round++)
        {
            State before = State.Of(work);
            WorkMesh.Mark mark = work.StartRecording();
            int done = Enumerable.Range(0, 12).Count(_ => TryAny(work, random));
            CheckColumns(work, mesh);
            if (round % 3 != 0)
            {
                work.UndoTo(mark);
                undone += done;
                State.AssertEqual(before, State.Of(work));
            }
            work.StopRecording();
        }
        Assert.True(undone > 0);
    }

    private static bool TryAny(WorkMesh work, Random random)
    {
        int h = random.Next(2 * work.EdgeSlots), kind = random.Next(3);
        if (!work.IsLiveEdge(h >> 1) || (kind == 0 && !work.CanFlip(h)) || (kind == 1 && !work.CanCollapse(h)))
            return false;
        if (kind == 0)
            work.Flip(h);
        else if (kind == 1)
            work.Collapse(h, work.Positions[work.Target[h]]);
        else
            work.Split(h, (work.Positions[work.Source(h)] + work.Positions[work.Target[h]]) * 0.5);
        return true;
    }

    /// <summary>Everything that is kept up, counted anew; and a mesh of the same topology as at first.</summary>
    private static void CheckColumns(WorkMesh work, Mesh original)
    {
        var valence = new int[work.VertexSlots];
        var rim = new int[work.VertexSlots];
        for (int h = 0; h < 2 * work.EdgeSlots; h++)
        {
            if (!work.IsLiveEdge(h >> 1))
                continue;
            valence[work.Target[h]]++;
            if (work.Face[h] < 0)
                rim[work.Target[h]] = 1;
            Assert.Equal(h, work.Previous[work.Next[h]]);
            Assert.Equal(work.Target[h], work.Source(work.Next[h]));
            Assert.Equal(work.Face[h], work.Face[work.Next[h]]);
            if (work.Face[h] >= 0)
                Assert.Equal(h, work.Next[work.Next[work.Next[h]]]);
        }
        long penalty = 0;
        for (int v = 0; v < work.VertexSlots; v++)
        {
            if (!work.IsLiveVertex(v))
                continue;
            Assert.Equal((valence[v], rim[v], v), (work.Valence[v], work.OnRim[v], work.Source(work.Outgoing[v])));
            penalty += WorkMesh.PenaltyOf(valence[v], rim[v]);
        }
        Assert.Equal(penalty, work.Penalty);
        for (int f = 0; f < work.FaceSlots; f++)
            Assert.True(!work.IsLiveFace(f) || work.Face[work.HalfEdgeOf[f]] == f);
        Assert.Equal(Enumerable.Range(0, work.FaceSlots).Count(work.IsLiveFace), work.LiveFaces);

        (Vector3D[] positions, int[] corners, int[] slots) = work.Export();
        Mesh mesh = MeshBuilder.FromTriangles(positions, corners);
        Assert.Empty(mesh.Validate());
        Assert.Equal(original.Vertices.Count - original.Edges.Count + original.Faces.Count, mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count);
        Assert.Equal(mesh.Vertices.Select(v => v.Valence), slots.Select(v => work.Valence[v]));
    }

    [Fact]
    public void Collapse_CreaseBesideIt_StaysACreaseAndQuadricsAddUp()
    {
        //    c           c
        //   /|\          |
        //  a─┼→b   ⟶     b     the crease c–a becomes c–b
        WorkMesh work = WorkMesh.From(Models.Torus(12, 8));
        int h = 0, left = work.Previous[h];
        work.Crease[left >> 1] = 1;
        int a = work.Source(h), b = work.Target[h], c = work.Apex(h);
        double weight = work.Quadrics[a].Weight + work.Quadrics[b].Weight;
        Assert.True(work.CanCollapse(h));
        work.Collapse(h, work.Positions[b]);
        Assert.Equal(1, work.Crease[work.Find(b, c) >> 1]);
        Assert.Equal(1, work.Crease.Take(work.EdgeSlots).Where((crease, e) => work.IsLiveEdge(e)).Sum());
        Assert.Equal(weight, work.Quadrics[b].Weight, 12);
    }

    [Fact]
    public void Split_OnACrease_MakesTwoCreasesAndAVertexOnThem()
    {
        WorkMesh work = WorkMesh.From(Models.Torus(12, 8));
        work.Crease[0] = 1;
        int b = work.Target[0], m = work.Split(0, default);
        Assert.Equal((VertexKind.OnCrease, 4, 0), (work.Kind[m], work.Valence[m], work.OnRim[m]));
        Assert.Equal(1, work.Crease[work.Find(m, b) >> 1]);
        Assert.Equal(2, work.Crease.Take(work.EdgeSlots).Sum());
        Assert.Equal(VertexKind.Smooth, work.Kind[work.Split(2 * 7, default)]);
    }

    [Theory]
    [MemberData(nameof(Solid))]
    public void CanFlip_EveryEdge_SaysWhatTheMeshSays(string name)
    {
        Mesh mesh = Models.Create(name);
        WorkMesh work = WorkMesh.From(mesh);
        foreach (Edge e in mesh.Edges)
        {
            // An end that would be left with too few edges is refused too.
            bool spares = e.Vertices.All(v => v.Valence > (v.IsBoundary ? 2 : 3));
            Assert.Equal(e.CanFlip(out _) && spares, work.CanFlip(2 * e.Index));
            work.Crease[e.Index] = 1;
            Assert.False(work.CanFlip(2 * e.Index));
        }
    }

    [Theory]
    [MemberData(nameof(Solid))]
    public void CanCollapse_EveryHalfEdge_AllowsNothingThatTheMeshForbids(string name)
    {
        Mesh mesh = Models.Create(name);
        WorkMesh work = WorkMesh.From(mesh);
        int allowed = 0, possible = 0;
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            bool legal = h.CanCollapse(out _);
            Assert.True(legal || !work.CanCollapse(h.Index), $"{h}");
            allowed += work.CanCollapse(h.Index) ? 1 : 0;
            // Around vertices with many edges nothing but the link condition forbids it.
            possible += legal && h.Source.Valence > 4 && h.Target.Valence > 4 && h.Next.Target.Valence > 4 && h.Twin.Next.Target.Valence > 4 ? 1 : 0;
        }
        Assert.True(allowed >= possible, $"{allowed} of {possible}");
    }

    [Fact]
    public void PenaltyOf_EveryValence_IsTheSquaredDistanceToFiveToSeven()
    {
        Assert.Equal([25, 16, 9, 4, 1, 0, 0, 0, 1, 4, 9], Enumerable.Range(0, 11).Select(valence => WorkMesh.PenaltyOf(valence, 0)));
        Assert.Equal([100, 100, 0, 0, 0, 0, 0, 0, 0, 0, 0], Enumerable.Range(0, 11).Select(valence => WorkMesh.PenaltyOf(valence, 1)));
        Assert.Equal((4, 0, 0, 9), (WorkMesh.IrregularityOf(4, 0), WorkMesh.IrregularityOf(4, 1), WorkMesh.IrregularityOf(6, 0), WorkMesh.IrregularityOf(7, 1)));
    }

    [Fact]
    public void Quality_KnownTriangles_IsExact()
    {
        double root = Math.Sqrt(3);
        Assert.Equal(1, Shape.Quality(default, new(1, 0, 0), new(0.5, root / 2, 0)), 15);
        Assert.Equal(root / 2, Shape.Quality(default, new(1, 0, 0), new(0, 1, 0)), 15);
        Assert.Equal(0, Shape.Quality(default, new(1, 0, 0), new(2, 0, 0)));
        Assert.Equal(0, Shape.Quality(default, default, default));
        Assert.Equal(default, Shape.Normal(default, new(1, 0, 0), new(2, 0, 0)));
        Assert.Equal(1, WorkMesh.From(Models.Tetrahedron()).MeanQuality(), 15);
    }

    private sealed record State(int[][] Columns, Vector3D[] Positions, Quadric[] Quadrics, long Penalty, int Faces)
    {
        public static State Of(WorkMesh w)
        {
            int halfEdges = 2 * w.EdgeSlots, vertices = w.VertexSlots;
            return new(
                [
                    w.Next[..halfEdges], w.Previous[..halfEdges], w.Target[..halfEdges], w.Face[..halfEdges], w.Crease[..w.EdgeSlots],
                    w.Outgoing[..vertices], w.Valence[..vertices], w.OnRim[..vertices], w.Kind[..vertices], w.HalfEdgeOf[..w.FaceSlots],
                ],
                w.Positions[..vertices],
                w.Quadrics[..vertices],
                w.Penalty,
                w.LiveFaces);
        }

        public static void AssertEqual(State expected, State actual)
        {
            Assert.Equal(expected.Columns, actual.Columns);
            Assert.Equal(expected.Positions, actual.Positions);
            Assert.Equal(expected.Quadrics, actual.Quadrics);
            Assert.Equal((expected.Penalty, expected.Faces), (actual.Penalty, actual.Faces));
        }
    }
}
