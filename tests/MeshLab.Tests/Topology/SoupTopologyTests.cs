using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Topology;

[Trait("Section", "11.1")]
public class SoupTopologyTests
{
    private static PolygonSoup Soup(int vertices, params int[][] faces) => PolygonSoup.From(new Vector3D[vertices], faces);

    [Fact]
    public void Examine_Tetrahedron_FindsNothingWrong()
    {
        SoupTopologyReport report = SoupTopology.Examine(Soup(4, [0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]));
        Assert.True(report.IsManifold && report.IsOrientable && report.IsOriented && report.IsClosed);
        Assert.Empty(report.FlippedFaces);
    }

    [Fact]
    public void Examine_OneFaceTurned_NamesItAndMakeOrientedRepairsIt()
    {
        PolygonSoup soup = Soup(4, [0, 1, 2], [0, 3, 1], [0, 3, 2], [1, 3, 2]);
        SoupTopologyReport report = SoupTopology.Examine(soup);
        Assert.True(report.IsManifold);
        Assert.True(report.IsOrientable);
        Assert.False(report.IsOriented);
        Assert.Equal([2], report.FlippedFaces);
        Assert.Equal(3, report.MisorientedEdges.Count);
        Mesh mesh = MeshBuilder.FromPolygons(SoupTopology.MakeOriented(soup));
        Assert.True(mesh.IsClosed);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Examine_MoebiusBand_IsNotOrientableAndAnEdgeIsNamed()
    {
        const int N = 8;
        var faces = new List<int[]>();
        for (int i = 0; i < N; i++)
        {
            int a = 2 * i, b = a + 1, c = 2 * (i + 1) % (2 * N), d = c + 1;
            // The last strip joins upside down.
            faces.Add(i == N - 1 ? [a, d, c, b] : [a, c, d, b]);
        }
        SoupTopologyReport report = SoupTopology.Examine(Soup(2 * N, [.. faces]));
        Assert.True(report.IsManifold);
        Assert.False(report.IsOrientable);
        Assert.NotEmpty(report.UnorientableEdges);
        Assert.Empty(report.FlippedFaces);
        Assert.Equal(2 * N, report.BoundaryEdges);
        var error = Assert.Throws<TopologyException>(() => SoupTopology.MakeOriented(Soup(2 * N, [.. faces])));
        Assert.Contains("f", error.Elements[2], StringComparison.Ordinal);
    }

    [Fact]
    public void Examine_ThreeFacesOnAnEdge_NamesEdgeAndFaces()
    {
        SoupTopologyReport report = SoupTopology.Examine(Soup(5, [0, 1, 2], [1, 0, 3], [0, 1, 4]));
        SoupEdge edge = Assert.Single(report.NonManifoldEdges);
        Assert.Equal((0, 1), (edge.Vertex0, edge.Vertex1));
        Assert.Equal([0, 1, 2], edge.Faces);
        Assert.Equal("v0–v1 (f0, f1, f2)", edge.ToString());
        Assert.False(report.IsManifold);
    }

    [Fact]
    public void Examine_BowTie_NamesTheVertex()
    {
        SoupTopologyReport report = SoupTopology.Examine(Soup(5, [0, 1, 2], [2, 3, 4]));
        Assert.Equal([2], report.NonManifoldVertices);
        Assert.Empty(report.NonManifoldEdges);
        Assert.False(report.IsManifold);
    }

    [Fact]
    public void Examine_DegenerateFaces_AreNamedAndLeftOut()
    {
        SoupTopologyReport report = SoupTopology.Examine(Soup(4, [0, 1, 1], [0, 1, 2], [3, 2]));
        Assert.Equal([0, 2], report.DegenerateFaces);
        Assert.Equal(3, report.BoundaryEdges);
        Assert.Empty(report.NonManifoldVertices);
    }
}
