using MeshLab.FiveSixSeven;
using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Spatial;

public class TraitTransferTests
{
    // On the square [0, 6]², with a seam in the corner values and a border in the labels at x = 3, and marked edges along it.
    private static Mesh Square()
    {
        Mesh mesh = Grid(6);
        VertexTrait<double> slope = mesh.AddVertexTrait<double>("slope", 0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            slope[v] = 2 * v.Position.X - v.Position.Y;
        HalfEdgeTrait<double> jump = mesh.AddHalfEdgeTrait<double>("jump", -1, Blend.Linear);
        FaceLabels material = mesh.GetOrAddFaceLabels("material");
        foreach (Face f in mesh.Faces)
        {
            bool left = Center(f).X < 3;
            material.Labels[f] = material.Number(left ? "left" : "right");
            foreach (HalfEdge h in f.HalfEdges)
                jump[h] = h.Target.Position.X + (left ? 0 : 100);
        }
        EdgeTrait<int> mark = mesh.AddEdgeTrait("mark", -1);
        foreach (Edge e in mesh.Edges)
            mark[e] = e.Vertex0.Position.X == 3 && e.Vertex1.Position.X == 3 ? e.Index : -2;
        return mesh;
    }

    private static Mesh Grid(int n)
    {
        Mesh mesh = Models.Triangulated(Models.QuadGrid(n, n));
        foreach (ref Vector3D p in mesh.Positions)
            p *= 6;
        return mesh;
    }

    private static Vector3D Center(Face f) => f.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / 3;

    private static void AssertCarried(Mesh source, Mesh mesh, bool keepsBorder)
    {
        Assert.True(mesh.TryGetVertexTrait("slope", out VertexTrait<double>? slope));
        Assert.True(mesh.TryGetHalfEdgeTrait("jump", out HalfEdgeTrait<double>? jump));
        Assert.True(mesh.TryGetEdgeTrait("mark", out EdgeTrait<int>? mark));
        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(2 * v.Position.X - v.Position.Y, slope[v], 1e-9);
        FaceLabels material = Assert.Single(mesh.FaceLabels);
        Assert.Equal(["left", "right"], material.Names.Order(StringComparer.Ordinal), StringComparer.Ordinal);
        foreach (Face f in mesh.Faces)
        {
            Vector3D center = Center(f);
            if (Math.Abs(center.X - 3) > 1e-9)
                Assert.Equal(center.X < 3 ? "left" : "right", material.NameOf(f));
            foreach (HalfEdge h in f.HalfEdges)
            {
                double x = h.Target.Position.X, side = center.X < 3 ? 0 : 100;
                // Where a face lies across the seam its corners may be of either side.
                if (keepsBorder || f.Vertices.All(v => v.Position.X <= 3) || f.Vertices.All(v => v.Position.X >= 3))
                    Assert.Equal(x + side, jump[h], 1e-4);
            }
        }
        foreach (HalfEdge h in mesh.HalfEdges.Where(h => h.IsBoundary))
            Assert.Equal(-1, jump[h]);
        if (!keepsBorder)
            return;
        foreach (Edge e in mesh.Edges.Where(e => e.Vertex0.Position.X == 3 && e.Vertex1.Position.X == 3))
            Assert.Equal(3, source.Edges[mark[e]].Vertex0.Position.X);
        // Parallel to the old edges, but between them: the default.
        foreach (Edge e in mesh.Edges.Where(e => e.Vertex0.Position.X == e.Vertex1.Position.X && Math.Abs(e.Vertex0.Position.X % 1 - 0.5) < 0.3))
            Assert.Equal(-1, mark[e]);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void TakeTraitsFrom_FinerGridOfTheSameSquare_BlendsInheritsAndKeepsTheSeam()
    {
        Mesh source = Square(), fine = Grid(24);

        fine.TakeTraitsFrom(source);

        AssertCarried(source, fine, keepsBorder: true);
    }

    [Fact]
    public void TakeTraitsFrom_ItsOwnClone_HasTheSameValuesEverywhere()
    {
        Mesh source = Square(), copy = MeshBuilder.FromFaces(source.Vertices.Count, [.. source.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())]);
        source.Positions.CopyTo(copy.Positions);
        copy.TakeTraitsFrom(source);
        Assert.Equal(source.StateHash(), copy.StateHash());
        Assert.Throws<ArgumentException>("source", () => copy.TakeTraitsFrom(source));
    }

    [Theory]
    [InlineData(0.2, 0.3, 0)]
    [InlineData(0.3, 0.2, 0)]
    [InlineData(0.5, 0.2, 1)]
    [InlineData(0.5, 0.4, 1)]
    [InlineData(0.2, 0.5, 2)]
    [InlineData(0.4, 0.5, 2)]
    public void TakeTraitsFrom_PointWithinAFace_NameComesFromTheCornerOfLargestWeight(double x, double y, int largest)
    {
        Mesh source = MeshBuilder.FromTriangles([default, new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]);
        VertexTrait<string> name = source.AddVertexTrait("name", "none");
        VertexTrait<int> first = source.AddVertexTrait("first", -1, (one, _, _) => one);
        foreach (Vertex v in source.Vertices)
            (name[v], first[v]) = (v.ToString(), v.Index);
        Mesh mesh = MeshBuilder.FromTriangles([new(x, y, 0.5), new(x + 5, y, 0.5), new(x, y + 5, 0.5)], [0, 1, 2]);

        mesh.TakeTraitsFrom(source);

        Assert.True(mesh.TryGetVertexTrait("name", out VertexTrait<string>? taken));
        Assert.Equal($"v{largest}", taken[mesh.Vertices[0]]);
        Assert.True(mesh.TryGetVertexTrait("first", out VertexTrait<int>? index));
        Assert.Equal(largest, index[mesh.Vertices[0]]);
    }

    [Fact]
    public void TakeTraitsFrom_BadInput_NamesIt()
    {
        Mesh quads = Models.QuadGrid(2, 2), mesh = Models.Triangulated(quads);
        mesh.TakeTraitsFrom(quads);
        quads.AddFaceTrait<int>("label");
        Assert.Throws<ArgumentException>("source", () => mesh.TakeTraitsFrom(quads));
        Assert.Throws<ArgumentNullException>(() => mesh.TakeTraitsFrom(null!));
        Mesh empty = new(), source = Square();
        empty.TakeTraitsFrom(source);
        Assert.Equal(source.VertexTraits.Count, empty.VertexTraits.Count);
        Assert.Throws<OperationCanceledException>(() => Models.Create("grid").TakeTraitsFrom(source, new CancellationToken(true)));
    }

    [Fact]
    [Trait("Section", "L4")]
    public void RemeshIsotropically_WithTraits_CarriesThem()
    {
        Mesh source = Square();
        AssertCarried(source, source.RemeshIsotropically(new() { RelativeLength = 0.6 }).Mesh, keepsBorder: false);
    }

    [Theory]
    [Trait("Section", "9.6")]
    [InlineData(FiveSixSevenEngine.Repair)]
    [InlineData(FiveSixSevenEngine.Textbook)]
    public void ToFiveSixSeven_WithTraits_CarriesThem(FiveSixSevenEngine engine)
    {
        Mesh source = Square();
        AssertCarried(source, source.ToFiveSixSeven(new() { Engine = engine }).Mesh, keepsBorder: false);
    }

    [Fact]
    [Trait("Section", "9.6")]
    public void ToFiveSixSeven_VerticesThatStay_KeepTheirValues()
    {
        Mesh source = Spheres.Icosphere(3);
        VertexTrait<int> number = source.AddVertexTrait("number", -1);
        foreach (Vertex v in source.Vertices)
            number[v] = v.Index;
        Mesh mesh = source.ToFiveSixSeven(new() { ImproveShape = false }).Mesh;
        Assert.True(mesh.TryGetVertexTrait("number", out VertexTrait<int>? carried));
        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(source.Positions[carried[v]], v.Position);
    }
}
