using MeshLab.Cutting;
using MeshLab.IO;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Topology;

[Trait("Section", "11.5")]
[Trait("Section", "11.6")]
public class HomologyGeneratorsTests
{
    public static TheoryData<string> GenusModels => new("three_holes", "rocker_arm", "featuretype", "isosurface_large", "box_assembly");

    [SkippableTheory]
    [MemberData(nameof(GenusModels))]
    public void Compute_PublicModels_AreIndependentLoops(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        Check(mesh, HomologyGenerators.Compute(mesh));
    }

    [SkippableTheory]
    [InlineData("three_holes")]
    [InlineData("rocker_arm")]
    [InlineData("featuretype")]
    public void Compute_Shortened_AreIndependentAndShorter(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        IReadOnlyList<MeshLoop> plain = HomologyGenerators.Compute(mesh), shortened = HomologyGenerators.Compute(mesh, new() { Shorten = true });
        Check(mesh, shortened, fromOneTree: false);
        Assert.True(shortened.Sum(l => l.Length) < plain.Sum(l => l.Length));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Compute_AnyMesh_GivesTwoPerHandle(string name)
    {
        Mesh mesh = Models.Create(name);
        Check(mesh, HomologyGenerators.Compute(mesh));
        Check(mesh, HomologyGenerators.Compute(mesh, new() { Shorten = true }), fromOneTree: false);
    }

    [Theory]
    [InlineData("creature.obj")]
    [InlineData("genus-3.ply")]
    [InlineData("bracket.off")]
    [InlineData("flange.stl")]
    [InlineData("perforated-sheet.off")]
    public void Compute_Shortened_NoLoopIsLongerThanBefore(string name)
    {
        Mesh mesh = MeshFile.Read(RepositoryFiles.PathOf("models/" + name));
        IReadOnlyList<MeshLoop> plain = HomologyGenerators.Compute(mesh), shortened = HomologyGenerators.Compute(mesh, new() { Shorten = true });
        Check(mesh, shortened, fromOneTree: false);
        Assert.All(shortened.Select(l => l.Length).Order().Zip(plain.Select(l => l.Length).Order()), pair => Assert.True(pair.First <= pair.Second, $"{pair}"));
    }

    [Fact]
    public void LoopExchange_SumsOfABasis_KeepsABasisOfWholeNumbers()
    {
        // Three loops with sums over a basis of two: the first is twice a loop and can stand for none, the others may come in.
        var basis = new[] { new MeshLoop([], 10), new MeshLoop([], 20) };
        MeshLoop[] others = [new([], 3), new([], 1), new([], 2)];
        Dictionary<double, long[]> sums = new() { [1] = [2, 0], [2] = [3, 1], [3] = [1, 0] };

        LoopExchange.Shorten(basis, others, loop => [.. sums[loop.Length]], default);

        Assert.Equal([3.0, 2.0], basis.Select(l => l.Length));
    }

    [Fact]
    public void LoopExchange_DependentLoops_ReplaceOnlyOne()
    {
        // Both stand for b₀ + b₁: once one is in, the other is a multiple of it.
        var basis = new[] { new MeshLoop([], 10), new MeshLoop([], 20) };
        LoopExchange.Shorten(basis, [new([], 2), new([], 1)], _ => [1, -1], default);
        Assert.Equal([10.0, 1.0], basis.Select(l => l.Length));
    }

    [Fact]
    public void Shorten_Torus_FindsTheTubeAndAShortWayAroundTheHole()
    {
        // Radii 1 and 0.4 in 24 and 16 steps: the shortest loops go around the tube and around the hole. Greedy steps move one vertex at a time,
        // so a loop on a longer parallel circle stays there: only the tube is found for certain.
        Mesh mesh = Models.Torus(24, 16);
        IReadOnlyList<MeshLoop> loops = HomologyGenerators.Compute(mesh, new() { Shorten = true });
        Assert.Equal(2, loops.Count);
        double tube = 16 * 2 * 0.4 * Math.Sin(Math.PI / 16), hole = 24 * 2 * 0.6 * Math.Sin(Math.PI / 24);
        Assert.Equal(tube, loops.Min(l => l.Length), 1e-9);
        Assert.InRange(loops.Max(l => l.Length), hole - 1e-9, 1.6 * hole);
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void FindCutGraph_PublicModels_LeavesOneDiskPerComponent(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        CheckDisks(mesh);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void FindCutGraph_AnyMesh_LeavesOneDiskPerComponent(string name) => CheckDisks(Models.Create(name));

    [Fact]
    public void FindCutGraph_DiskAlready_IsEmpty() => Assert.Empty(Models.Create("grid").FindCutGraph());

    private static void CheckDisks(Mesh mesh)
    {
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, mesh.FindCutGraph());
        Assert.Empty(cut.Uncut);
        TopologyReport before = mesh.ComputeTopology(), report = cut.Mesh.ComputeTopology();
        Assert.Equal(before.Components.Count, report.Components.Count);
        Assert.All(report.Components, c => Assert.Equal((1, 1, 0), (c.EulerCharacteristic, c.BoundaryLoops, c.Genus)));
        Assert.Empty(cut.Mesh.Validate());
    }

    private static void Check(Mesh mesh, IReadOnlyList<MeshLoop> loops, bool fromOneTree = true)
    {
        TopologyReport report = mesh.ComputeTopology();
        Assert.Equal(2 * report.Genus, loops.Count);
        foreach (MeshLoop loop in loops)
        {
            for (int i = 0; i < loop.HalfEdges.Count; i++)
                Assert.Equal(loop.HalfEdges[i].Target, loop.HalfEdges[(i + 1) % loop.HalfEdges.Count].Source);
            Assert.Equal(loop.Vertices.Count, loop.Vertices.Distinct().Count());
        }
        // The matrix of crossings has full rank, so no sum of loops bounds: they are independent.
        Assert.Equal(loops.Count, IntersectionRank(loops));
        if (!report.IsClosed)
            return;
        Mesh cut = EdgeCutting.CutAlong(mesh, loops.SelectMany(l => l.HalfEdges.Select(h => h.Edge))).Mesh;
        // Along all generators of a closed surface no handle is left.
        Assert.Equal(0, cut.Genus);
        Assert.Empty(cut.Validate());
        // Loops of one tree leave each component in one piece; shortened ones may cross twice and cut off disks.
        if (fromOneTree)
            Assert.Equal(report.Components.Count, cut.ComponentCount);
        else
            Assert.All(loops, l => Assert.Equal(report.Components.Count, EdgeCutting.CutAlong(mesh, l.HalfEdges.Select(h => h.Edge)).Mesh.ComponentCount));
    }

    /// <summary>The rank over the integers mod 2 of the crossing matrix: full if and only if the loops are a basis.</summary>
    private static int IntersectionRank(IReadOnlyList<MeshLoop> loops)
    {
        int n = loops.Count;
        var rows = new System.Numerics.BigInteger[n];
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                if (i != j && Crossings(loops[i], loops[j]) % 2 != 0)
                    rows[i] |= System.Numerics.BigInteger.One << j;
            }
        }
        int rank = 0;
        for (int column = 0; column < n; column++)
        {
            int pivot = Array.FindIndex(rows, rank, r => !(r >> column).IsEven);
            if (pivot < 0)
                continue;
            (rows[rank], rows[pivot]) = (rows[pivot], rows[rank]);
            for (int i = 0; i < n; i++)
            {
                if (i != rank && !(rows[i] >> column).IsEven)
                    rows[i] ^= rows[rank];
            }
            rank++;
        }
        return rank;
    }

    /// <summary>How often the second loop, pushed a little to its left, crosses the edges of the first, mod 2.</summary>
    private static int Crossings(MeshLoop first, MeshLoop second)
    {
        var edges = first.HalfEdges.Select(h => h.Edge).ToHashSet();
        int crossings = 0;
        for (int i = 0; i < second.HalfEdges.Count; i++)
        {
            // From the half-edge we arrive by to the one we leave by, on the left: the spokes in between are crossed.
            HalfEdge arrive = second.HalfEdges[i], leave = second.HalfEdges[(i + 1) % second.HalfEdges.Count];
            for (HalfEdge spoke = leave.Previous.Twin; spoke != arrive.Twin; spoke = spoke.Previous.Twin)
            {
                if (edges.Contains(spoke.Edge))
                    crossings++;
            }
        }
        return crossings;
    }
}
