using System.Globalization;
using FsCheck;
using FsCheck.Fluent;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;
using Xunit.Abstractions;

namespace MeshLab.Tests.Structure;

/// <summary>Random legal and illegal operations: the rules hold after each, refusals change nothing, and undo leads back to the first bit.</summary>
[Trait("Section", "4.8")]
public class LocalOperationProperties(ITestOutputHelper output)
{
    private const int Operations = 10_000;
    private const int StepsPerRun = 250;

    /// <summary>What one random step does, and where.</summary>
    public readonly record struct Step(int Kind, int First, int Second, int Third);

    [Theory]
    [InlineData("octahedron")]
    [InlineData("cube-quads")]
    [InlineData("prism-6")]
    [InlineData("mixed-polygons")]
    [InlineData("annulus")]
    [InlineData("open-fan")]
    [InlineData("isolated-vertices")]
    [InlineData("grid-quads")]
    [InlineData("genus-2")]
    [InlineData("components")]
    public void RandomOperations_OnEachModel_KeepTheRulesAndUndoExactly(string name)
    {
        // The same seed on every run, unless the environment names another to search further.
        string? wanted = Environment.GetEnvironmentVariable("MESHLAB_TEST_SEED");
        ulong seed = wanted is null ? 20_240_607 : ulong.Parse(wanted, CultureInfo.InvariantCulture);
        output.WriteLine($"{name}: seed {seed}");
        Gen<Step> step =
            from kind in Gen.Choose(0, 15)
            from first in Gen.Choose(0, 1 << 20)
            from second in Gen.Choose(0, 1 << 20)
            from third in Gen.Choose(0, 1 << 20)
            select new Step(kind, first, second, third);
        Gen<Step[]> steps = Gen.ArrayOf(step, StepsPerRun);
        Config config = Config.QuickThrowOnFailure.WithMaxTest(Operations / StepsPerRun).WithReplay(seed, 1UL).WithStartSize(1).WithEndSize(1);

        Check.One(config, Prop.ForAll(Arb.From(steps, Shrink), sequence => Run(name, sequence)));
    }

    private static IEnumerable<Step[]> Shrink(Step[] steps)
    {
        for (int part = steps.Length / 2; part >= 1; part /= 2)
        {
            for (int i = 0; i + part <= steps.Length; i += part)
                yield return [.. steps[..i], .. steps[(i + part)..]];
        }
    }

    private static void Run(string name, Step[] steps)
    {
        Mesh mesh = Models.Create(name);
        mesh.AddVertexTrait("v", 0.5, Blend.Linear);
        mesh.AddHalfEdgeTrait("h", 3, Blend.Largest);
        mesh.AddEdgeTrait("e", Vector3D.UnitX, Blend.Direction);
        mesh.AddFaceTrait("f", 1);
        ulong start = mesh.StateHash(), state = start;
        using OperationHistory history = mesh.StartRecording();
        for (int i = 0; i < steps.Length; i++)
        {
            bool done = Do(mesh, steps[i]);
            IReadOnlyList<Violation> violations = mesh.Validate();
            Assert.True(violations.Count == 0, $"step {i} {steps[i]}: {string.Join("; ", violations)}");
            ulong now = mesh.StateHash();
            Assert.True(done || now == state, $"step {i} {steps[i]} was refused but changed the mesh");
            state = now;
        }
        history.UndoAll();
        Assert.Equal(start, mesh.StateHash());
        history.RedoAll();
        Assert.Equal(state, mesh.StateHash());
        history.UndoAll();
        Assert.Equal(start, mesh.StateHash());
    }

    private static bool Do(Mesh mesh, Step step)
    {
        Vertex v = Pick(mesh.VertexSlots, step.First, i => mesh.Vertices[i], x => x.IsDeleted);
        Vertex w = Pick(mesh.VertexSlots, step.Second, i => mesh.Vertices[i], x => x.IsDeleted);
        Vertex u = Pick(mesh.VertexSlots, step.Third, i => mesh.Vertices[i], x => x.IsDeleted);
        HalfEdge h = Pick(mesh.HalfEdgeSlots, step.First, i => mesh.HalfEdges[i], x => x.IsDeleted);
        Face f = Pick(mesh.FaceSlots, step.First, i => mesh.Faces[i], x => x.IsDeleted);
        // Growth and removal in balance: large meshes split no further, small ones are not deleted.
        bool large = mesh.Faces.Count > 150, small = mesh.Faces.Count < 12;
        RemovalOptions options = new() { DeleteOrphans = step.Second % 2 == 0, SplitPinched = step.Third % 2 == 0 };
        switch (step.Kind)
        {
            case 0 or 1 when !h.IsNone:
                return h.Edge.TryFlip(out _);
            case 2 or 3 when !h.IsNone:
                return h.TryCollapse(out _);
            case 4 when !h.IsNone && !large:
                return h.Edge.TrySplit(h.Target.Position, out _, out _);
            case 5 when !f.IsNone && !large:
                return !f.Split().IsNone;
            case 6 or 7 when !v.IsNone && !large:
                Vertex[] ring = [.. v.Neighbors, default];
                return v.TrySplit(ring[step.Second % ring.Length], ring[step.Third % ring.Length], out _, out _);
            case 8 when !f.IsNone && !small:
                return f.TryDelete(out _, options);
            case 9 when !h.IsNone && !small:
                return h.Edge.TryDelete(out _, options);
            case 10 when !v.IsNone && !small:
                return v.TryDelete(out _, options);
            case 11 when !h.IsNone:
                return h.Edge.TryDissolve(out _);
            case 12 when !f.IsNone:
                Vertex[] corners = [.. f.Vertices];
                return f.TryCut(corners[step.Second % corners.Length], corners[step.Third % corners.Length], out _, out _);
            case 13 when !h.IsNone:
                HalfEdge g = NextBoundary(h);
                HalfEdge k = NextBoundary(mesh.HalfEdges[step.Second % mesh.HalfEdgeSlots]);
                return !g.IsNone && !k.IsNone && g.TryStitch(k, out _);
            case 14 when !h.IsNone:
                HalfEdge rim = NextBoundary(h);
                return !rim.IsNone && rim.Source.TryMerge(rim.Next.Target, out _);
            case 15 when !v.IsNone:
                if (v.IsBoundary && step.Third % 2 == 0)
                    return mesh.TryAddFace([v, v.Outgoing.Target, v.Outgoing.Next.Target], out _, out _);
                return mesh.TryAddFace([v, w, u], out _, out _);
            default:
                return false;
        }
    }

    private static HalfEdge NextBoundary(HalfEdge h)
    {
        Mesh mesh = h.Mesh;
        for (int i = 0; i < mesh.HalfEdgeSlots; i++)
        {
            HalfEdge k = mesh.HalfEdges[(h.Index + i) % mesh.HalfEdgeSlots];
            if (!k.IsDeleted && k.IsBoundary)
                return k;
        }
        return default;
    }

    private static T Pick<T>(int slots, int random, Func<int, T> element, Func<T, bool> isDeleted)
        where T : struct
    {
        for (int i = 0; i < slots; i++)
        {
            T candidate = element((random + i) % slots);
            if (!isDeleted(candidate))
                return candidate;
        }
        return default;
    }
}
