using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Representations;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Representations;

[Trait("Section", "1.3")]
public class RepresentationTests
{
    //   V1(0) ── V3(2)        F1 = (V1, V2, V3) with corners C1, C2, C3
    //     │ F1 / │            F2 = (V3, V2, V4) with corners C4, C5, C6
    //     │  / F2│
    //   V2(1) ── V4(3)
    private static Mesh Figure() => MeshBuilder.FromTriangles(
        [new(0, 1, 0), new(0, 0, 0), new(1, 1, 0), new(1, 0, 0)], [0, 1, 2, 2, 1, 3]);

    [Fact]
    public void CornerTable_OfTheBooksFigure_HasItsValues()
    {
        CornerTable table = CornerTable.FromMesh(Figure());
        Corner C(int number) => table[number - 1];

        Assert.Equal(C(6), C(1).O);
        Assert.Equal(C(1), C(6).O);
        Assert.Equal(C(6), C(3).R);
        Assert.Equal(C(6), C(2).L);
        Assert.Equal(C(1), C(4).L);
        Assert.Equal(C(1), C(5).R);
        Assert.Equal(C(2), C(1).N);
        Assert.Equal(C(3), C(1).P);
        Assert.Equal((0, 0), (C(1).T, C(1).V));
        Assert.Equal((1, 3), (C(6).T, C(6).V));
        Assert.True(C(2).O.IsNone);
        Assert.Equal("none", C(2).O.ToString());
    }

    [Fact]
    public void FaceBased_OfTheBooksFigure_HasItsValues()
    {
        FaceBasedMesh faces = FaceBasedMesh.FromMesh(Figure());

        Assert.Equal([0, 1, 2, 2, 1, 3], faces.Vertices);
        Assert.Equal([-1, 1, -1, 0, -1, -1], faces.Neighbors);
        Assert.Equal(0, faces.FaceOf[0]);
        Assert.Equal(1, faces.FaceOf[3]);
    }

    [Fact]
    public void AdjacencyMatrix_OfTheBooksFigure_HasItsValues()
    {
        AdjacencyMatrix matrix = AdjacencyMatrix.FromMesh(Figure());

        Assert.Equal("0 1 1 0\n1 0 1 1\n1 1 0 1\n0 1 1 0\n", matrix.ToString());
        bool[,] dense = matrix.ToDense();
        for (int i = 0; i < 4; i++)
        {
            for (int j = 0; j < 4; j++)
                Assert.Equal(dense[i, j], dense[j, i]);
        }
    }

    [Fact]
    public void WingedEdge_OfTheBooksFigure_HasItsWings()
    {
        WingedEdgeMesh winged = WingedEdgeMesh.FromMesh(Figure());
        int diagonal = Enumerable.Range(0, 5).Single(e => winged.Edges[e] is { Left: >= 0, Right: >= 0 });
        WingedEdge edge = winged.Edges[diagonal];

        Assert.Equal((1, 2, 0, 1), (edge.V0, edge.V1, edge.Left, edge.Right));
        Assert.Equal((2, 0), (winged.Edges[edge.LeftNext].V0, winged.Edges[edge.LeftNext].V1));
        Assert.Equal((0, 1), (winged.Edges[edge.LeftPrevious].V0, winged.Edges[edge.LeftPrevious].V1));
        Assert.Equal((1, 3), (winged.Edges[edge.RightNext].V0, winged.Edges[edge.RightNext].V1));
        Assert.Equal((3, 2), (winged.Edges[edge.RightPrevious].V0, winged.Edges[edge.RightPrevious].V1));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void EveryPolygonRepresentation_AnswersLikeTheHalfEdges(string name)
    {
        Mesh mesh = Models.Create(name);

        AssertSameAnswers(mesh, WingedEdgeMesh.FromMesh(mesh), all: true);
        // These search everything for each answer, so some elements must do on larger models.
        AssertSameAnswers(mesh, SharedVertexMesh.FromMesh(mesh), all: false);
        AssertSameAnswers(mesh, EdgeBasedMesh.FromMesh(mesh), all: false);
        AssertSameEdges(mesh, EdgeBasedMesh.FromMesh(mesh), WingedEdgeMesh.FromMesh(mesh), AdjacencyMatrix.FromMesh(mesh));
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void EveryTriangleRepresentation_AnswersLikeTheHalfEdges(string name)
    {
        Mesh mesh = Models.Create(name);
        FaceSet set = FaceSet.FromMesh(mesh);

        AssertSameAnswers(mesh, FaceBasedMesh.FromMesh(mesh), all: true);
        AssertSameAnswers(mesh, CornerTable.FromMesh(mesh), all: true);
        foreach (Face f in mesh.Faces.Take(20))
            Assert.Equal(f.Neighbors.ToArray().Select(g => g.Index).Distinct().Order(), set.FacesBeside(f.Index));
        foreach (Vertex v in mesh.Vertices.Take(20))
            Assert.Equal(v.Faces.ToArray().Select(g => g.Index).Order(), set.FacesAround(v.Position));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void ToMesh_OfEveryRepresentation_IsTheMeshAgain(string name)
    {
        Mesh mesh = Models.Create(name);
        int[] corners = PolygonSoup.From(mesh).Corners;

        AssertSame(SharedVertexMesh.FromMesh(mesh).ToMesh());
        AssertSame(EdgeBasedMesh.FromMesh(mesh).ToMesh());
        AssertSame(WingedEdgeMesh.FromMesh(mesh).ToMesh());
        if (mesh.IsTriangleMesh)
        {
            AssertSame(FaceBasedMesh.FromMesh(mesh).ToMesh());
            AssertSame(CornerTable.FromMesh(mesh).ToMesh());
            Mesh again = FaceSet.FromMesh(mesh).ToMesh();
            Assert.Equal(FaceSet.FromMesh(mesh).Corners, FaceSet.FromMesh(again).Corners);
            Assert.Empty(again.Validate());
        }

        void AssertSame(Mesh result)
        {
            Assert.Equal(mesh.Positions.ToArray(), result.Positions.ToArray());
            Assert.Equal(corners, PolygonSoup.From(result).Corners);
            Assert.Empty(result.Validate());
        }
    }

    [Fact]
    public void FromMesh_WithDeletedElements_NumbersTheLiveOnes()
    {
        Mesh mesh = Prisms.Cylinder(6);
        int vertices = mesh.Vertices.Count;
        mesh.DeleteVertexSlot(mesh.AddVertex(new(5, 5, 5)).Index);
        Vertex last = mesh.AddVertex(new(6, 6, 6));
        Assert.False(mesh.IsCompact);

        WingedEdgeMesh winged = WingedEdgeMesh.FromMesh(mesh);

        Assert.Equal(vertices + 1, winged.VertexCount);
        Assert.Equal(last.Position, winged.Positions[^1]);
        Assert.Empty(winged.NeighborsOf(vertices));
        Assert.Equal(vertices + 1, CornerTable.FromMesh(mesh).VertexCount);
    }

    [Fact]
    public void AdjacencyMatrix_ToMesh_FindsTheFacesWhereItCan()
    {
        foreach (Mesh mesh in new[] { Spheres.Icosphere(2), Cones.Tetrahedron(), Polyhedra.Octahedron(), Tori.Torus(m: 12, n: 8), Grids.Grid(5, 4) })
        {
            Assert.True(AdjacencyMatrix.FromMesh(mesh).TryToMesh(mesh.Positions, out Mesh found));
            Assert.Equal(Faces(mesh), Faces(found));
            Assert.Empty(found.Validate());
        }
        // Around a tube of three sides runs a cycle that is no face; a matrix of squares has no cycles of three at all.
        Mesh tube = Tori.Torus(m: 12, n: 3);
        Assert.False(AdjacencyMatrix.FromMesh(tube).TryToMesh(tube.Positions, out _));
        Mesh cube = Polyhedra.Cube();
        Assert.False(AdjacencyMatrix.FromMesh(cube).TryToMesh(cube.Positions, out _));
        Assert.Throws<ArgumentException>(() => AdjacencyMatrix.FromMesh(cube).TryToMesh(new Vector3D[3], out _));

        // Faces as cycles from their smallest vertex; a surface with boundary may come out turned over.
        static IEnumerable<(int, int, int)> Faces(Mesh mesh) => mesh.Faces
            .Select(f => f.Vertices.ToArray().Select(v => v.Index).ToArray())
            .Select(f => (f.Min(), mesh.IsClosed ? f[(Array.IndexOf(f, f.Min()) + 1) % 3] : 0, f.Sum()))
            .Order();
    }

    [Fact]
    public void BadArguments_Throw()
    {
        Mesh quads = Polyhedra.Cube();
        Assert.Throws<ArgumentException>(() => CornerTable.FromMesh(quads));
        Assert.Throws<ArgumentException>(() => FaceBasedMesh.FromMesh(quads));
        Assert.Throws<ArgumentException>(() => FaceSet.FromMesh(quads));
        Assert.Throws<ArgumentException>(() => new FaceSet(new Vector3D[4]));
        Assert.Throws<ArgumentNullException>(() => WingedEdgeMesh.FromMesh(null!));
        Assert.Throws<ArgumentNullException>(() => new SharedVertexMesh(null!));
        WingedEdgeMesh winged = WingedEdgeMesh.FromMesh(quads);
        Assert.Throws<ArgumentOutOfRangeException>(() => winged.FaceVertices(6));
        Assert.Throws<ArgumentOutOfRangeException>(() => winged.NeighborsOf(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => CornerTable.FromMesh(Figure())[6]);
        Assert.Throws<ArgumentOutOfRangeException>(() => AdjacencyMatrix.FromMesh(quads)[0, 8]);
        Assert.Throws<InvalidOperationException>(() => AdjacencyMatrix.FromMesh(Grids.Grid(65, 64)).ToDense());
    }

    [Fact]
    public void Comparison_OfALargeClosedMesh_CountsBytesPerFace()
    {
        Mesh mesh = Spheres.Icosphere(4);
        Dictionary<string, double> perFace = RepresentationComparison.Of(mesh).ToDictionary(row => row.Name, row => (double)row.Bytes / mesh.Faces.Count, StringComparer.Ordinal);

        Assert.Equal(72, perFace["face set"]);
        Assert.Equal(28, perFace["shared vertex"], 0.1);
        Assert.Equal(38, perFace["face-based"], 0.1);
        Assert.Equal(42, perFace["edge-based"], 0.1);
        Assert.Equal(66, perFace["winged edge"], 0.1);
        Assert.Equal(38, perFace["corner table"], 0.1);
        Assert.Equal(66, perFace["half-edge"], 0.1);
        Assert.Equal(-1, RepresentationComparison.Of(Polyhedra.Cube())[0].Bytes);
    }

    private static void AssertSameAnswers(Mesh mesh, IAdjacencyQueries other, bool all)
    {
        Assert.Equal((mesh.Vertices.Count, mesh.Faces.Count), (other.VertexCount, other.FaceCount));
        int step = all ? 1 : Math.Max(1, mesh.Faces.Count / 25);
        for (int f = 0; f < mesh.Faces.Count; f += step)
        {
            Face face = mesh.Faces[f];
            Assert.Equal(face.Vertices.ToArray().Select(v => v.Index), other.FaceVertices(f));
            Assert.Equal(face.Neighbors.ToArray().Select(g => g.Index).Distinct().Order(), other.FacesBeside(f).Distinct().Order());
        }
        for (int v = 0; v < mesh.Vertices.Count; v += step)
        {
            Vertex vertex = mesh.Vertices[v];
            Assert.Equal(vertex.Faces.ToArray().Select(g => g.Index).Order(), other.FacesAround(v).Order());
            Assert.Equal(vertex.Neighbors.ToArray().Select(w => w.Index).Order(), other.NeighborsOf(v).Order());
        }
    }

    private static void AssertSameEdges(Mesh mesh, EdgeBasedMesh edges, WingedEdgeMesh winged, AdjacencyMatrix matrix)
    {
        foreach (Edge e in mesh.Edges)
        {
            Assert.Equal((e.HalfEdge0.Source.Index, e.HalfEdge0.Target.Index), edges.VerticesOf(e.Index));
            Assert.Equal((e.HalfEdge0.Face.Index, e.HalfEdge1.Face.Index), edges.FacesOf(e.Index));
            Assert.True(matrix[e.Vertex0.Index, e.Vertex1.Index] && matrix[e.Vertex1.Index, e.Vertex0.Index]);
        }
        foreach (Vertex v in mesh.Vertices.Take(60))
        {
            int[] expected = [.. v.Edges.ToArray().Select(e => e.Index)];
            Assert.Equal(expected, winged.EdgesAround(v.Index));
            Assert.Equal(expected.Order(), edges.EdgesAround(v.Index));
            Assert.Equal(v.Neighbors.ToArray().Select(w => w.Index).Order(), matrix.Row(v.Index).ToArray());
        }
        foreach (Face f in mesh.Faces.Take(60))
            Assert.Equal(f.Edges.ToArray().Select(e => e.Index), winged.EdgesOfFace(f.Index));
    }

    [Fact]
    public void Queries_OfAnElementThatIsNotThere_SayWhichRange()
    {
        Mesh mesh = Models.Create("octahedron");
        foreach (IAdjacencyQueries queries in (IAdjacencyQueries[])
            [FaceBasedMesh.FromMesh(mesh), EdgeBasedMesh.FromMesh(mesh), WingedEdgeMesh.FromMesh(mesh), CornerTable.FromMesh(mesh), SharedVertexMesh.FromMesh(mesh)])
        {
            foreach (int index in (int[])[-1, 8, int.MaxValue])
            {
                Assert.Throws<ArgumentOutOfRangeException>(() => queries.FaceVertices(index));
                Assert.Throws<ArgumentOutOfRangeException>(() => queries.FacesBeside(index));
                Assert.Throws<ArgumentOutOfRangeException>(() => queries.NeighborsOf(index));
            }
        }
    }
}
