using MeshLab.Dual;
using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Dual;

[Trait("Section", "3")]
public class DualMeshTests
{
    [Fact]
    public void ComputeDual_Cube_IsTheOctahedronOfItsFaceCentres()
    {
        Mesh cube = Models.Create("cube-quads");
        DualResult dual = cube.ComputeDual();
        Assert.Equal((6, 12, 8), (dual.Mesh.Vertices.Count, dual.Mesh.Edges.Count, dual.Mesh.Faces.Count));
        Assert.True(dual.Mesh.IsTriangleMesh);
        // The centres of a unit cube's faces: an octahedron of volume 1/6, outside out.
        Assert.Equal(1.0 / 6, dual.Mesh.Volume, 1e-15);
        Assert.Empty(dual.Mesh.Validate());
    }

    [Theory]
    [MemberData(nameof(Models.ClosedMeshes), MemberType = typeof(Models))]
    public void ComputeDual_ClosedModels_HasTheCountsAndIsItsOwnInverse(string name)
    {
        Mesh mesh = Models.Create(name);
        ulong before = mesh.StateHash();
        DualResult dual = mesh.ComputeDual();
        int used = mesh.Vertices.Count(v => !v.IsIsolated);
        Assert.Equal((mesh.Faces.Count, mesh.Edges.Count, used), (dual.Mesh.Vertices.Count, dual.Mesh.Edges.Count, dual.Mesh.Faces.Count));
        Assert.Equal(used - mesh.Edges.Count + mesh.Faces.Count, dual.Mesh.EulerCharacteristic);
        for (int f = 0; f < mesh.Faces.Count; f++)
            Assert.Equal(mesh.Faces[f].Barycenter, dual.Mesh.Positions[f]);
        Assert.All(dual.Mesh.Faces, cell => Assert.Equal(mesh.Vertices[dual.SourceVertex[cell.Index]].Valence, cell.Degree));
        Assert.Empty(dual.Mesh.Validate());
        Assert.Equal(before, mesh.StateHash());

        if (used == mesh.Vertices.Count)
            AssertSameConnectivity(mesh, dual.Mesh.ComputeDual().Mesh);
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void ComputeDual_EveryFormAndBoundary_IsValid(string name)
    {
        foreach (DualForm form in Enum.GetValues<DualForm>())
        {
            foreach (DualBoundary boundary in Enum.GetValues<DualBoundary>())
            {
                Mesh mesh = Models.Create(name);
                DualResult dual = mesh.ComputeDual(new DualOptions { Form = form, Boundary = boundary });
                Assert.Empty(dual.Mesh.Validate());
                Assert.Equal(dual.Mesh.VertexSlots, dual.SourceFace.Length);
                Assert.Equal(dual.Mesh.FaceSlots, dual.SourceVertex.Length);
                int cells = mesh.Vertices.Count(v => !v.IsIsolated && (boundary == DualBoundary.Closed || !v.IsBoundary));
                Assert.Equal(cells, dual.Mesh.Faces.Count);
                // The closed cells cover the surface: same topology, boundary and all.
                if (boundary == DualBoundary.Closed && cells > 0)
                    Assert.Equal(mesh.ComputeTopology().EulerCharacteristic, dual.Mesh.ComputeTopology().EulerCharacteristic);
            }
        }
    }

    [Fact]
    public void ComputeDual_CellsOfATetrahedron_HaveTwiceTheValenceInCorners()
    {
        Mesh mesh = Models.Tetrahedron();
        DualResult dual = mesh.ComputeDual(new DualOptions { Form = DualForm.Cells });
        Assert.Equal((4 + 6, 24 / 2, 4), (dual.Mesh.Vertices.Count, dual.Mesh.Edges.Count, dual.Mesh.Faces.Count));
        Assert.All(dual.Mesh.Faces, f => Assert.Equal(6, f.Degree));
        Edge first = mesh.Edges[0];
        Assert.Equal((first.Vertex0.Position + first.Vertex1.Position) * 0.5, dual.Mesh.Positions[4]);
        Assert.Equal([0, 1, 2, 3, -1, -1, -1, -1, -1, -1], dual.SourceFace);
    }

    [Fact]
    public void ComputeDual_FlatGridClosed_CoversTheSameArea()
    {
        Mesh grid = Models.QuadGrid(4, 3);
        DualResult dual = grid.ComputeDual();
        Assert.Equal(20, dual.Mesh.Faces.Count);
        Assert.Equal(1, dual.Mesh.Area, 1e-14);
        // 12 centres, 14 boundary midpoints, 14 boundary vertices.
        Assert.Equal(40, dual.Mesh.Vertices.Count);
        DualResult inner = grid.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted });
        Assert.Equal(6, inner.Mesh.Faces.Count);
        Assert.Equal(6.0 / 12, inner.Mesh.Area, 1e-14);
    }

    [Fact]
    public void ComputeDual_RightTriangle_CircumcentreOnTheHypotenuseOrBarycentre()
    {
        Mesh mesh = Models.Create("one-triangle");
        Vector3D At(DualCenter center) => mesh.ComputeDual(new DualOptions { Center = center }).Mesh.Positions[0];
        Assert.Equal(new(0.5, 0.5, 0), At(DualCenter.Circumcenter));
        Assert.Equal(At(DualCenter.Barycenter), At(DualCenter.CircumcenterIfAcute));
        mesh.Positions[2] = new(0.4, 1, 0);
        Vector3D c = At(DualCenter.CircumcenterIfAcute);
        Assert.Equal(At(DualCenter.Circumcenter), c);
        Assert.All(mesh.Vertices, v => Assert.Equal(c.Length, Vector3D.Distance(c, v.Position), 1e-14));
    }

    [Fact]
    public void ComputeDual_DeletedElements_NamesSourcesOfTheMeshGiven()
    {
        Mesh two = Models.Tetrahedron();
        AppendMaps second = two.Append(Models.Tetrahedron());
        for (int f = 0; f < 4; f++)
            two.Faces[f].Delete();
        DualResult dual = two.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted });
        Assert.Equal(4, dual.Mesh.Faces.Count);
        Assert.Equal([4, 5, 6, 7], dual.SourceVertex);
        Assert.Equal(second.FirstFace, dual.SourceFace[0]);
    }

    [Fact]
    public void ComputeDual_BadInput_IsNamed()
    {
        Mesh quads = Models.QuadGrid(2, 2);
        Assert.Contains("f0", Assert.Throws<ArgumentException>(() => quads.ComputeDual(new DualOptions { Center = DualCenter.Circumcenter })).Message, StringComparison.Ordinal);
        // A pillow: two triangles share all edges.
        Mesh pillow = MeshBuilder.FromFaces(3, [0, 1, 2], [0, 2, 1]);
        Assert.Equal(["f0", "f1"], Assert.Throws<TopologyException>(() => pillow.ComputeDual()).Elements);
        Assert.Empty(pillow.ComputeDual(new DualOptions { Form = DualForm.Cells }).Mesh.Validate());
        Assert.Throws<ArgumentOutOfRangeException>(() => new DualOptions { Form = (DualForm)7 });
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void ComputeDual_RightAngleAtAnyCorner_IsNotAcute(int corner)
    {
        Mesh mesh = Models.Create("one-triangle");
        (mesh.Positions[corner], mesh.Positions[(corner + 1) % 3], mesh.Positions[(corner + 2) % 3]) = (new(0, 0, 0), new(3, 0, 0), new(0, 6, 0));
        Assert.Equal(new(1, 2, 0), mesh.ComputeDual(new DualOptions { Center = DualCenter.CircumcenterIfAcute }).Mesh.Positions[0]);
        Assert.Equal(new(1.5, 3, 0), mesh.ComputeDual(new DualOptions { Center = DualCenter.Circumcenter }).Mesh.Positions[0]);
    }

    [Fact]
    public void ComputeDual_TriangleWithoutArea_HasItsBarycentre()
    {
        Mesh mesh = Models.Create("one-triangle");
        (mesh.Positions[0], mesh.Positions[1], mesh.Positions[2]) = (new(0, 0, 0), new(1, 0, 0), new(5, 0, 0));
        foreach (DualCenter center in Enum.GetValues<DualCenter>())
            Assert.Equal(new(2, 0, 0), mesh.ComputeDual(new DualOptions { Center = center }).Mesh.Positions[0]);
    }

    [Fact]
    public void ComputeDual_CircumcentreIfAcuteOfAPolygon_IsItsBarycentre()
    {
        // Any three corners in a row that begin with an end of the long side are an acute triangle.
        Mesh quad = MeshBuilder.FromPolygons([new(0, 0, 0), new(4, 0, 0), new(2, 3, 0), new(0, 3, 0)], [0, 1, 2, 3]);
        Assert.Equal(new(1.5, 1.5, 0), quad.ComputeDual(new DualOptions { Center = DualCenter.CircumcenterIfAcute }).Mesh.Positions[0]);
    }

    [Fact]
    public void ComputeDual_CellsThatTouchInACentreAlone_HaveACopyEachNamedByItsFace()
    {
        // Without two opposite corner squares only v5 and v10 lie inside; their cells meet in the middle of f4.
        Mesh grid = Models.QuadGrid(3, 3);
        grid.Faces[2].Delete();
        grid.Faces[6].Delete();
        DualResult pure = grid.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted });
        Assert.Equal([0, 1, 3, 4, 5, 7, 8, 4], pure.SourceFace);
        Assert.Equal([5, 10], pure.SourceVertex);
        Assert.Equal(pure.Mesh.Positions[3], pure.Mesh.Positions[7]);
        Assert.Empty(pure.Mesh.Validate());

        DualResult cells = grid.ComputeDual(new DualOptions { Form = DualForm.Cells, Boundary = DualBoundary.Omitted });
        int edges = grid.Edges.Count;
        Assert.Equal([0, 1, 3, 4, 5, 7, 8, .. Enumerable.Repeat(-1, edges), 4], cells.SourceFace);
        Assert.Equal([5, 10], cells.SourceVertex);
        Assert.Empty(cells.Mesh.Validate());
        Mesh compact = grid.Clone();
        compact.Compact();
        Assert.Equal([0, 1, 2, 3, 4, 5, 6, 3], compact.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted }).SourceFace);
        Assert.Equal([.. Enumerable.Range(0, 7), .. Enumerable.Repeat(-1, edges), 3], compact.ComputeDual(new DualOptions { Form = DualForm.Cells, Boundary = DualBoundary.Omitted }).SourceFace);
    }

    [Fact]
    public void ComputeDual_FacesThatShareTwoEdges_AreRefusedIfBothHaveADual()
    {
        // A square cut in two along a path over v4.
        Mesh square = MeshBuilder.FromFaces(5, [0, 1, 2, 4], [0, 4, 2, 3]);
        Assert.Equal(["f0", "f1"], Assert.Throws<TopologyException>(() => square.ComputeDual()).Elements);
        Assert.Equal(["f0", "f1"], Assert.Throws<TopologyException>(() => square.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted })).Elements);
        Assert.Equal(5, square.ComputeDual(new DualOptions { Form = DualForm.Cells }).Mesh.Faces.Count);
        // A ring of two halves: no vertex inside, so that no edge has a dual unless boundary cells are closed.
        Mesh ring = MeshBuilder.FromFaces(8, [0, 1, 2, 6, 5, 4], [2, 3, 0, 4, 7, 6]);
        Assert.Equal(["f0", "f1"], Assert.Throws<TopologyException>(() => ring.ComputeDual()).Elements);
        Mesh none = ring.ComputeDual(new DualOptions { Boundary = DualBoundary.Omitted }).Mesh;
        Assert.Equal((2, 0, 0), (none.Vertices.Count, none.Edges.Count, none.Faces.Count));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void ComputeDual_PublicModels_HasCountsPositionsAndInverse(string name)
    {
        Mesh mesh = ReferenceData.Load(name);
        Skip.IfNot(mesh.IsClosed);
        Mesh dual = mesh.ComputeDual(new DualOptions { Center = DualCenter.CircumcenterIfAcute }).Mesh;
        Assert.Equal((mesh.Faces.Count, mesh.Edges.Count, mesh.Vertices.Count), (dual.Vertices.Count, dual.Edges.Count, dual.Faces.Count));
        Assert.Equal(mesh.EulerCharacteristic, dual.EulerCharacteristic);
        foreach (Face f in mesh.Faces)
        {
            Triangle t = f.Triangle;
            Vector3D expected = t.MaxAngle < Math.PI / 2 - 1e-9 ? t.Circumcenter : t.MaxAngle > Math.PI / 2 + 1e-9 ? t.Barycenter : dual.Positions[f.Index];
            Assert.True(Vector3D.Distance(expected, dual.Positions[f.Index]) <= 1e-12 * (1 + expected.Length), f.ToString());
        }
        AssertSameConnectivity(mesh, mesh.ComputeDual().Mesh.ComputeDual().Mesh);
    }

    private static void AssertSameConnectivity(Mesh expected, Mesh actual)
    {
        Assert.Equal(expected.Faces.Count, actual.Faces.Count);
        foreach (Face f in expected.Faces)
        {
            // Cyclic order; the first corner is free.
            int[] a = [.. f.Vertices.Select(v => v.Index)], b = [.. actual.Faces[f.Index].Vertices.Select(v => v.Index)];
            int at = Array.IndexOf(b, a[0]);
            Assert.True(at >= 0 && a.SequenceEqual(b[at..].Concat(b[..at])), $"{f}: {string.Join(' ', a)} became {string.Join(' ', b)}.");
        }
    }
}
