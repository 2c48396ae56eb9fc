using MeshLab.FiveSixSeven;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

public class TextbookStepTests
{
    //        2                    2
    //      / | \                / | \
    //     /  3  \      ⟶       /  3  \
    //    / /   \ \            / / | \ \
    //   0 ─────── 1          0 ── 4 ── 1
    [Fact]
    [Trait("Section", "9.2")]
    public void RaiseValenceThree_FanOfThree_SplitsTheLongestOppositeEdge()
    {
        Mesh mesh = Models.Fan(3);
        Assert.Equal(1, mesh.RaiseValenceThree());
        Assert.Equal(4, mesh.Vertices[0].Valence);
        Assert.Equal(5, mesh.Vertices.Count);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "9.3")]
    public void RaiseValenceFour_OneTriangleOfALargeMesh_IsReplacedBySixteen()
    {
        // An octahedron cut into nine: six vertices of valence 4 far apart, all others 6.
        Mesh mesh = Models.Bipyramid(4).SplitFacesIntoNine();
        (int vertices, int faces) = (mesh.Vertices.Count, mesh.Faces.Count);
        IReadOnlyDictionary<int, int> before = mesh.CountInnerValences();
        Assert.Equal(6, before[4]);

        int replaced = mesh.RaiseValenceFour();

        Assert.Equal(6, replaced);
        Assert.Equal((vertices + 36, faces + 72), (mesh.Vertices.Count, mesh.Faces.Count));
        IReadOnlyDictionary<int, int> after = mesh.CountInnerValences();
        Assert.DoesNotContain(4, after.Keys);
        Assert.True(after[5] >= 6 * 7);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [Trait("Section", "9.4")]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void SplitFacesIntoNine_EveryModel_KeepsValencesAndAddsSixes(string name)
    {
        Mesh mesh = Models.Create(name), fine = mesh.SplitFacesIntoNine();
        Assert.Equal(9 * mesh.Faces.Count, fine.Faces.Count);
        Assert.Equal(mesh.Vertices.Count + 2 * mesh.Edges.Count + mesh.Faces.Count, fine.Vertices.Count);
        foreach (Vertex v in mesh.Vertices)
            Assert.Equal((v.Valence, v.Position), (fine.Vertices[v.Index].Valence, fine.Vertices[v.Index].Position));
        foreach (Vertex v in fine.Vertices)
            Assert.True(v.Index < mesh.Vertices.Count || v.Valence == (v.IsBoundary ? 4 : 6));
        Assert.Empty(fine.Validate());
    }

    [Theory]
    [Trait("Section", "9.5")]
    [InlineData(8)]
    [InlineData(9)]
    [InlineData(13)]
    [InlineData(50)]
    [InlineData(601)]
    public void LowerHighValences_HubOfAnyValence_LeavesFiveToSeven(int valence)
    {
        Mesh mesh = Models.Fan(valence).SplitFacesIntoNine();
        int splits = mesh.LowerHighValences();
        Assert.Equal((valence - 7 + 2) / 3, splits);
        Assert.All(mesh.CountInnerValences().Keys, v => Assert.InRange(v, 5, 7));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    [Trait("Section", "9.6")]
    public void SimplifyKeepingValences_FineSphere_CollapsesManyAndKeepsFiveToSeven()
    {
        Mesh mesh = Models.Bipyramid(5);
        mesh.RaiseValenceFour();
        mesh = mesh.SplitFacesIntoNine();
        mesh.LowerHighValences();
        int faces = mesh.Faces.Count;

        (FiveSixSevenStop stop, int collapses, int flips) = mesh.SimplifyKeepingValences(faces / 4);

        Assert.True(collapses > 0 && flips >= 0);
        Assert.Equal(mesh.Faces.Count <= faces / 4 ? FiveSixSevenStop.Reached : FiveSixSevenStop.CountOutOfReach, stop);
        Assert.Equal(new(FiveSixSevenStop.NothingToDo, 0, 0), mesh.SimplifyKeepingValences(faces));
        Assert.InRange(mesh.Faces.Count, faces / 4 - 1, faces / 2);
        Assert.All(mesh.CountInnerValences().Keys, v => Assert.InRange(v, 5, 7));
        Assert.Empty(mesh.Validate());
        Assert.Equal(FiveSixSevenStop.CountOutOfReach, mesh.SimplifyKeepingValences(0).StopReason);
        Assert.Throws<ArgumentOutOfRangeException>(() => mesh.SimplifyKeepingValences(-1));
    }

    [Fact]
    public void Steps_Cancelled_LeaveAValidMesh()
    {
        foreach (Action<Mesh, IProgress<double>, CancellationToken> step in new Action<Mesh, IProgress<double>, CancellationToken>[]
        {
            (m, p, c) => m.RaiseValenceThree(p, c),
            (m, p, c) => m.RaiseValenceFour(p, c),
            (m, p, c) => m.SplitFacesIntoNine(p, c),
            (m, p, c) => m.LowerHighValences(p, c),
            (m, p, c) => m.SimplifyKeepingValences(20, p, c),
        })
        {
            Mesh mesh = PathologicalMeshes.Wrecked(Models.Sphere(12, 16), 1).SplitFacesIntoNine();
            var shares = new List<double>();
            using var source = new CancellationTokenSource();
            step(mesh.Clone(), new Reporter(shares.Add), source.Token);
            Assert.Equal(1, shares[^1]);
            Assert.Equal(shares.Order(), shares);
            source.Cancel();
            Assert.Throws<OperationCanceledException>(() => step(mesh, new Reporter(shares.Add), source.Token));
            Assert.Empty(mesh.Validate());
        }
    }

    private sealed class Reporter(Action<double> report) : IProgress<double>
    {
        public void Report(double value) => report(value);
    }

    [Fact]
    public void Steps_OnPolygons_Throw()
    {
        Mesh mesh = Models.Create("cube-quads");
        Assert.Throws<ArgumentException>(() => mesh.RaiseValenceThree());
        Assert.Throws<ArgumentException>(() => mesh.RaiseValenceFour());
        Assert.Throws<ArgumentException>(() => mesh.SplitFacesIntoNine());
        Assert.Throws<ArgumentException>(() => mesh.LowerHighValences());
    }
}
