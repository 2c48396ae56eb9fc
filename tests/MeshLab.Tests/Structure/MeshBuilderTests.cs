using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "1.4")]
public class MeshBuilderTests
{
    /// <summary>Inputs that are no oriented 2-manifold, with a word that the message must hold.</summary>
    public static TheoryData<string, int[][], string> Unsound => new()
    {
        // Two triangles that touch in vertex 0.
        { "bow-tie", [[0, 1, 2], [0, 3, 4]], "v0" },
        { "three faces on an edge", [[0, 1, 2], [1, 0, 3], [0, 1, 4]], "f2" },
        { "neighbours against each other", [[0, 1, 2], [0, 1, 3]], "f1" },
        { "the same face twice", [[0, 1, 2], [0, 1, 2]], "f1" },
        { "Möbius strip", [[0, 2, 3, 1], [2, 4, 5, 3], [4, 1, 0, 5]], "f" },
        { "repeated vertex", [[0, 1, 2], [2, 1, 1]], "f1" },
        { "vertex twice in a polygon", [[0, 1, 2, 0, 3]], "f0" },
        { "two corners", [[0, 1, 2], [3, 4]], "f1" },
        { "one corner", [[0]], "f0" },
        { "no corner", [[]], "f0" },
    };

    private static PolygonSoup Soup(int[][] faces) => PolygonSoup.From(new Vector3D[6], faces);

    [Theory]
    [MemberData(nameof(Unsound))]
    public void FromPolygons_UnsoundThrow_NamesTheElement(string what, int[][] faces, string element)
    {
        var error = Assert.Throws<TopologyException>(() => MeshBuilder.FromPolygons(Soup(faces)));
        Assert.True(error.Message.Contains(element, StringComparison.Ordinal), $"{what}: {error.Message}");
        Assert.NotEmpty(error.Elements);
    }

    [Theory]
    [MemberData(nameof(Unsound))]
    public void FromPolygons_UnsoundSkip_LeavesFacesOutAndReportsEach(string what, int[][] faces, string element)
    {
        Mesh mesh = MeshBuilder.FromPolygons(Soup(faces), NonManifoldPolicy.Skip, out BuildReport report);

        Assert.Empty(mesh.Validate());
        Assert.True(report.Repairs.Count > 0, what + element);
        Assert.All(report.Repairs, r => Assert.Equal(RepairKind.SkippedFace, r.Kind));
        Assert.Equal(faces.Length, mesh.Faces.Count + report.Repairs.Count);
        Assert.Equal(mesh.Faces.Count, report.SourceFaces!.Length);
        foreach (Face f in mesh.Faces)
            Assert.Equal(faces[report.SourceFaces[f.Index]], f.Vertices.Select(v => v.Index));
    }

    [Theory]
    [MemberData(nameof(Unsound))]
    public void FromPolygons_UnsoundSplit_KeepsEveryPolygon(string what, int[][] faces, string element)
    {
        Mesh mesh = MeshBuilder.FromPolygons(Soup(faces), NonManifoldPolicy.Split, out BuildReport report);

        Assert.Empty(mesh.Validate());
        Assert.True(report.Repairs.Count > 0, what + element);
        int polygons = faces.Count(f => f.Length >= 3 && f.Distinct().Count() == f.Length);
        Assert.Equal(polygons, mesh.Faces.Count);
        foreach (Face f in mesh.Faces)
        {
            int source = report.SourceFaces?[f.Index] ?? f.Index;
            Assert.Equal(faces[source], f.Vertices.Select(v => report.SourceVertices?[v.Index] ?? v.Index));
        }
    }

    [Fact]
    public void FromPolygons_BadNumbers_ThrowArgumentExceptions()
    {
        Vector3D[] three = new Vector3D[3];
        Assert.Throws<ArgumentOutOfRangeException>(() => MeshBuilder.FromTriangles(three, [0, 1, 3]));
        Assert.Throws<ArgumentOutOfRangeException>(() => MeshBuilder.FromTriangles(three, [0, 1, -1]));
        Assert.ThrowsAny<ArgumentException>(() => MeshBuilder.FromTriangles(three, [0, 1]));
        three[1] = new(0, double.NaN, 0);
        Assert.Contains("v1", Assert.Throws<ArgumentException>(() => MeshBuilder.FromTriangles(three, [0, 1, 2])).Message, StringComparison.Ordinal);
        three[1] = new(0, 0, double.NegativeInfinity);
        Assert.Throws<ArgumentException>(() => MeshBuilder.FromTriangles(three, [0, 1, 2]));
        Assert.Throws<ArgumentOutOfRangeException>(() => MeshBuilder.FromFaces(-1));
        Assert.Throws<ArgumentNullException>(() => MeshBuilder.FromPolygons((PolygonSoup)null!));
        Assert.Throws<ArgumentException>(() => new PolygonSoup(three, [0, 4], [0, 1, 2]));
        Assert.Throws<ArgumentException>(() => new PolygonSoup(three, [0, 3, 2, 3], [0, 1, 2]));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void FromPolygons_SoundModel_KeepsOrderOfVerticesFacesAndCorners(string name)
    {
        Mesh model = Models.Create(name);
        int[][] faces = [.. model.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        Mesh mesh = MeshBuilder.FromPolygons(PolygonSoup.From(model.Positions, faces), NonManifoldPolicy.Throw, out BuildReport report);

        Assert.Empty(report.Repairs);
        Assert.Null(report.SourceFaces);
        Assert.Equal(mesh.Vertices.Count(v => v.IsIsolated), report.IsolatedVertices);
        Assert.Equal(faces, mesh.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray()));
        Assert.Equal(model.Positions.ToArray(), mesh.Positions.ToArray());
        Assert.Empty(mesh.Validate());
    }

    // A hub makes the lists long: the walk gives up and the counting sort takes over, with the same result.
    [Fact]
    public void Match_FanOfAHundredThousand_IsTheSameBothWays()
    {
        const int N = 100_000;
        var corners = new int[3 * N];
        for (int i = 0; i < N; i++)
            (corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]) = (0, 1 + i, 1 + ((i + 1) % N));
        PolygonSoup soup = PolygonSoup.FromTriangles(new Vector3D[N + 1], corners);

        int[] byLists = new int[corners.Length], byCounting = new int[corners.Length];
        EdgeMatching.ByLists(soup, byLists, 8L * corners.Length + 1024, out bool spent);
        Assert.True(spent);
        int edges = EdgeMatching.ByCounting(soup, byCounting);
        Assert.Equal(2 * N, edges);
        Assert.Equal(byCounting, EdgeMatching.Match(soup, out _));
        Assert.Equal(N, MeshBuilder.FromPolygons(soup).Vertices[0].Valence);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Match_EveryModel_IsTheSameBothWays(string name)
    {
        Mesh model = Models.Create(name);
        PolygonSoup soup = PolygonSoup.From(model.Positions, [.. model.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())]);
        int[] byLists = new int[soup.Corners.Length], byCounting = new int[soup.Corners.Length];
        int edges = EdgeMatching.ByLists(soup, byLists, long.MaxValue, out bool spent);
        Assert.False(spent);
        Assert.Equal(edges, EdgeMatching.ByCounting(soup, byCounting));
        Assert.Equal(byLists, byCounting);
        Assert.Equal(model.Edges.Count, edges);
    }

    [Fact]
    public void Build_FaceByFace_IsTheSameAsAtOnce()
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < 4; i++)
            Assert.Equal(i, builder.AddVertex(new(i, 0, 0)));
        Assert.Equal(0, builder.AddFace(0, 1, 2));
        Assert.Equal(1, builder.AddFace([1, 0, 3]));
        Assert.Equal((4, 2), (builder.VertexCount, builder.FaceCount));
        Assert.Equal(2, builder.Build().Faces.Count);
    }

    /// <summary>Long faces are searched in another way than short ones.</summary>
    [Theory]
    [InlineData(5)]
    [InlineData(64)]
    [InlineData(65)]
    [InlineData(200)]
    public void FromFaces_RepeatedVertexInALongFace_IsNamed(int corners)
    {
        int[] face = [.. Enumerable.Range(0, corners - 1), corners - 3];
        TopologyException error = Assert.Throws<TopologyException>(() => MeshBuilder.FromFaces(corners, face));
        Assert.Contains("f0", error.Elements, StringComparer.Ordinal);
        Assert.Contains($"v{corners - 3}", error.Elements, StringComparer.Ordinal);
        face[^1] = corners - 1;
        Assert.Equal(corners, MeshBuilder.FromFaces(corners, face).Faces[0].Degree);
    }

    [Fact]
    public void BoundingBox_AfterDeletion_IsThatOfTheLiving()
    {
        Mesh mesh = Models.Create("grid");
        Vertex far = mesh.AddVertex(new(100, 100, 100));
        Assert.Equal(100, mesh.BoundingBox.Max.Z);
        MeshLab.Editing.VertexRemoval.Delete(far);
        Assert.Equal(0, mesh.BoundingBox.Max.Z);
        Assert.Empty(mesh.Validate());
    }
}
