using System.Text.Json;
using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using Xunit;
using static MeshLab.Tests.Neighborhoods.NeighborhoodTests;

namespace MeshLab.Tests.Neighborhoods;

[Trait("Section", "5.6")]
[Trait("Section", "5.7")]
public class BoundaryAndRegionTests
{
    [Fact]
    public void FindBoundaryLoops_Grid_IsOneLoopFromTheLowestVertex()
    {
        Mesh mesh = Grid();
        BoundaryLoop loop = Assert.Single(mesh.FindBoundaryLoops());
        Assert.Equal([0, 3, 6, 7, 8, 5, 2, 1], Indices(loop.Vertices));
        Assert.Equal(8, loop.Length);
        Assert.Equal(8, loop.Count);
        Assert.Equal(8, mesh.BoundaryEdges.Length);
        Assert.All(loop.HalfEdges, h => Assert.True(h.IsBoundary));
    }

    [Fact]
    public void FindBoundaryLoops_IsolatedVertexOrClosedMesh_AreNone()
    {
        Assert.Empty(MeshBuilder.FromFaces(3).FindBoundaryLoops());
        Assert.Empty(Models.Create("sphere").FindBoundaryLoops());
        Assert.Empty(new Mesh().FindBoundaryLoops());
    }

    [Fact]
    public void FindBoundaryLoops_LaterFaceWithLowerVertices_ComesFirst()
    {
        // The half-edges of the first face are lower, but the other triangle has the lowest vertex.
        Mesh mesh = MeshBuilder.FromFaces(6, [3, 4, 5], [0, 1, 2]);
        Assert.Equal([0, 3], mesh.FindBoundaryLoops().Select(loop => loop.Vertices[0].Index));
    }

    [Fact]
    public void FindBoundaryLoops_AndRegions_AfterDeletions_AreThoseOfTheCompactMesh()
    {
        Mesh mesh = Models.Create("grid");
        mesh.Faces[0].Delete();
        mesh.Vertices.First(v => !v.IsBoundary).Delete();
        Assert.False(mesh.IsCompact);
        Mesh compact = mesh.Clone();
        compact.Compact();
        Assert.Equal(compact.FindBoundaryLoops().Select(l => (l.Count, l.Length)), mesh.FindBoundaryLoops().Select(l => (l.Count, l.Length)));
        Assert.Equal(compact.BoundaryLoopCount, mesh.BoundaryLoopCount);
        Assert.Equal(compact.BoundaryEdges.Length, mesh.BoundaryEdges.Length);
        Assert.All(mesh.BoundaryEdges, e => Assert.True(!e.IsDeleted && e.IsBoundary));
        FaceRegions regions = mesh.FindRegions(new bool[mesh.EdgeSlots]);
        Assert.Equal(compact.FindRegions(new bool[compact.EdgeSlots]).Sizes, regions.Sizes);
        Assert.Equal(mesh.FaceSlots - mesh.Faces.Count, regions.Labels.Count(label => label < 0));
        Assert.Empty(mesh.Validate());
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void FindBoundaryLoops_PublicModels_EqualTheReferenceValues(string name)
    {
        JsonElement topology = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        Mesh mesh = ReferenceMesh.Load(name);
        IReadOnlyList<BoundaryLoop> loops = mesh.FindBoundaryLoops();
        Assert.Equal(topology.GetProperty("boundary_loops").GetInt32(), loops.Count);
        Assert.Equal(loops.Count, mesh.BoundaryLoopCount);
        Assert.Equal(topology.GetProperty("boundary_edges").GetInt32(), mesh.BoundaryEdges.Length);
        Assert.Equal(
            ReferenceData.Numbers(topology.GetProperty("boundary_loop_vertex_counts")).Order(), loops.Select(l => (double)l.Count).Order());
        double[] lengths = [.. ReferenceData.Numbers(topology.GetProperty("boundary_loop_lengths")).Order()];
        Assert.All(lengths.Zip(loops.Select(l => l.Length).Order()), pair => Assert.Equal(pair.First, pair.Second, 1e-12 * pair.First));
    }

    [Fact]
    public void FindRegions_ClosedPathOfEdges_CutsOneRegionOff()
    {
        Mesh mesh = Grid();
        FaceRegions regions = mesh.FindRegions([Edge(mesh, 0, 4), Edge(mesh, 1, 4)]);
        Assert.Equal(2, regions.Count);
        Assert.Equal([0, 1, 1, 1, 1, 1, 1, 1], regions.Labels);
        Assert.Equal([1, 7], regions.Sizes);
        Assert.Equal(1, mesh.FindRegions([Edge(mesh, 0, 4)]).Count);
        Assert.Equal(8, mesh.FindRegions(mesh.Edges).Count);
    }

    [Fact]
    public void FindSelectedRegions_SelectedFlags_AreTheSame()
    {
        Mesh mesh = Grid();
        EdgeTraits first = Edge(mesh, 0, 4).Traits, second = Edge(mesh, 1, 4).Traits;
        first.SelectedFlag = 1;
        second.SelectedFlag = 2;
        Assert.Equal([1, 7], mesh.FindSelectedRegions().Sizes);
    }

    [Fact]
    public void FindRegions_BadInput_Throws()
    {
        Mesh mesh = Grid();
        Assert.Throws<ArgumentException>(() => mesh.FindRegions(new bool[3]));
        Assert.Throws<ArgumentException>(() => mesh.FindRegions([Grid().Edges[0]]));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void FindRegions_SharpEdges_EqualTheReferenceValues(string name)
    {
        JsonElement sharp = ReferenceData.Json(name, "extras").RootElement.GetProperty("sharp_edge_regions");
        Mesh mesh = ReferenceMesh.Load(name);
        double[] angles = mesh.ComputeDihedralAngles();
        foreach (int degrees in (int[])[20, 30, 40, 60])
        {
            JsonElement expected = sharp.GetProperty($"{degrees}_deg");
            bool[] isSharp = [.. angles.Select(a => Math.Abs(a) > degrees * Math.PI / 180)];
            FaceRegions regions = mesh.FindRegions(isSharp);
            Assert.Equal(expected.GetProperty("regions").GetInt32(), regions.Count);
            double[] largest = ReferenceData.Numbers(expected.GetProperty("largest_sizes"));
            Assert.Equal(largest, regions.Sizes.OrderDescending().Take(largest.Length).Select(s => (double)s));
        }
    }
}
