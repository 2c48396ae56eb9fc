using MeshLab.Editing;
using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Subdivision;

[Trait("Section", "L2")]
public class LaboratorySubdivisionTests
{
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void SubdivideInLaboratory_AnyModel_IsLoopsSubdivision(string name)
    {
        foreach (LoopWeights weights in Enum.GetValues<LoopWeights>())
        {
            Mesh mesh = Models.Create(name), expected = LoopSubdivision.Subdivide(mesh, new() { Weights = weights });
            int edges = mesh.Edges.Count, faces = mesh.Faces.Count;

            LaboratorySubdivisionResult result = mesh.SubdivideInLaboratory(weights);

            Assert.Equal(new(faces > 0 ? SubdivisionStop.StepsDone : SubdivisionStop.NothingToDo, edges, faces), result);
            Assert.Empty(mesh.Validate());
            Assert.Equal(Faces(expected), Faces(mesh));
            double tolerance = 1e-14 * Math.Max(1, mesh.Vertices.Select(v => v.Position.Length).DefaultIfEmpty().Max());
            for (int v = 0; v < expected.VertexSlots; v++)
                Assert.True(Vector3D.Distance(expected.Positions[v], mesh.Positions[v]) <= tolerance, $"v{v}");
        }
    }

    [Fact]
    public void SubdivideInLaboratory_TwiceAndRecorded_CanBeUndone()
    {
        Mesh mesh = Polyhedra.Icosahedron();
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        mesh.SubdivideInLaboratory();
        mesh.SubdivideInLaboratory();
        Assert.Equal(320, mesh.Faces.Count);
        Assert.Empty(mesh.Validate());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void SubdivideInLaboratory_WithDeletedSlots_PassesThemOver()
    {
        Mesh mesh = Models.Create("torus");
        foreach (int f in new[] { 3, 40, 41 })
            mesh.Faces[f].Delete();
        Assert.True(mesh.Edges.Last().HalfEdge0.TryCollapse(out _));
        Assert.False(mesh.IsCompact);
        Mesh expected = mesh.Clone();
        expected.Compact();
        expected = LoopSubdivision.Subdivide(expected);

        int edges = mesh.Edges.Count, faces = mesh.Faces.Count;
        Assert.Equal(new(SubdivisionStop.StepsDone, edges, faces), mesh.SubdivideInLaboratory());

        Assert.Empty(mesh.Validate());
        Assert.Equal((expected.Vertices.Count, expected.Edges.Count, expected.Faces.Count), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Vector3D[] places = [.. mesh.Vertices.Select(v => v.Position)];
        Assert.All(expected.Vertices, v => Assert.Contains(places, p => Vector3D.Distance(p, v.Position) < 1e-12));
    }

    [Fact]
    public void SubdivideInLaboratory_BadInputAndCancelled_LeaveAValidMesh()
    {
        Assert.Throws<ArgumentException>("mesh", () => Models.Create("cube-quads").SubdivideInLaboratory());
        Mesh mesh = Models.Create("torus");
        using var source = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => mesh.SubdivideInLaboratory(LoopWeights.Warren, null, new CancelAt(0.6, source), source.Token));
        Assert.Empty(mesh.Validate());
    }

    // Each face from its lowest corner, in order.
    private static List<(int, int, int)> Faces(Mesh mesh) => [.. mesh.Faces.Select(f =>
    {
        int[] v = [.. f.Vertices.Select(w => w.Index)];
        int first = Array.IndexOf(v, v.Min());
        return (v[first], v[(first + 1) % 3], v[(first + 2) % 3]);
    }).Order()];

    private sealed class CancelAt(double share, CancellationTokenSource source) : IProgress<double>
    {
        public void Report(double value)
        {
            if (value >= share)
                source.Cancel();
        }
    }
}
