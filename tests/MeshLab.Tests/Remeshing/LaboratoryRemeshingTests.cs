using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using MeshLab.Tests.Spatial;
using Xunit;

namespace MeshLab.Tests.Remeshing;

[Trait("Section", "L4")]
public class LaboratoryRemeshingTests
{
    private static Mesh MeshOf(TriangleSoups.Soup soup) => MeshBuilder.FromTriangles(soup.Positions, soup.Corners);

    private static int Euler(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.6)]
    public void RemeshInLaboratory_Sphere_HasTheEdgeLengthsOfTheScript(double relative)
    {
        Mesh mesh = MeshOf(TriangleSoups.Sphere(24));
        double length = relative * mesh.Edges.Average(e => (e.Vertex0.Position - e.Vertex1.Position).Length);

        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { EdgeLength = length });

        Assert.Empty(mesh.Validate());
        Assert.Equal(2, Euler(mesh));
        Assert.Equal(length, result.EdgeLength);
        // Flips and smoothing come after the lengths, so a few edges leave the range again.
        double[] lengths = [.. mesh.Edges.Select(e => (e.Vertex0.Position - e.Vertex1.Position).Length / length)];
        Assert.InRange(lengths.Count(l => l is > 0.8 * 0.8 and < 4.0 / 3 * 1.25), 0.97 * lengths.Length, lengths.Length);
        RemeshingQuality quality = RemeshingQuality.Of(mesh);
        Assert.InRange(quality.MeanSmallestAngle * 180 / Math.PI, 44, 60);
        Assert.InRange(quality.Valence567, 0.95, 1);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void RemeshInLaboratory_AnyModel_KeepsTopology(string name)
    {
        if (name == "slivers")
            return; // thousands of pieces; the other tests have slivers enough
        Mesh mesh = Models.Create(name);
        int euler = Euler(mesh);
        bool closed = mesh.IsClosed;
        mesh.RemeshInLaboratory();
        Assert.Empty(mesh.Validate());
        Assert.Equal(euler, Euler(mesh));
        Assert.Equal(closed, mesh.IsClosed);
    }

    // Two hexagons of flat triangles: vertices 0 and 1 inside, 2 and 5 see both, the edges are between 0.78 and 1.2 long.
    private static Mesh TwoHexagons(bool flipped)
    {
        Vector3D[] positions =
        [
            new(-0.5, 0, 0), new(0.5, 0, 0), new(0, 0.6, 0), new(-1, 0.6, 0), new(-1.5, 0, 0), new(0, -0.6, 0), new(1.5, 0, 0), new(1, 0.6, 0), new(-1, -0.6, 0), new(1, -0.6, 0),
        ];
        int[] middle = flipped ? [0, 5, 2, 1, 2, 5] : [0, 1, 2, 1, 0, 5];
        return MeshBuilder.FromTriangles(positions, [.. middle, 0, 2, 3, 0, 3, 4, 0, 4, 8, 0, 8, 5, 1, 5, 9, 1, 9, 6, 1, 6, 7, 1, 7, 2]);
    }

    private static readonly LaboratoryRemeshingOptions OnePass = new() { Passes = 1, EdgeLength = 0.95 };

    /// <summary>6 inside and 4 on the boundary: that is what flips lead to and what they leave.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void RemeshInLaboratory_OnePass_LeadsTo6InsideAnd4OnTheBoundary(bool flipped)
    {
        Mesh mesh = TwoHexagons(flipped), expected = TwoHexagons(false);
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(OnePass);
        Assert.Equal((0, 0, flipped ? 1 : 0, 0), (result.Splits, result.Collapses, result.Flips, result.RefusedCollapses));
        Assert.Empty(mesh.Validate());
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            Assert.Equal(expected.Vertices[v].Valence, mesh.Vertices[v].Valence);
            // Each is in the middle of its neighbours already.
            Assert.True(Vector3D.Distance(expected.Positions[v], mesh.Positions[v]) < 1e-15);
        }
    }

    /// <summary>The quadrilateral is not convex: the flip for the valences' sake would fold the sheet.</summary>
    [Fact]
    public void RemeshInLaboratory_FlipThatFolds_IsNotDone()
    {
        // From vertex 0 to vertex 1 the way leads past vertex 2, above it.
        Mesh mesh = TwoHexagons(flipped: true);
        Vector3D[] positions =
        [
            new(-0.8, 0.1, 0), new(0.8, 0.1, 0), new(0, 0, 0), new(-0.5, 0.85, 0), new(-1.5, 0.4, 0), new(0, -0.78, 0), new(1.5, 0.4, 0), new(0.5, 0.85, 0), new(-1, -0.65, 0), new(1, -0.65, 0),
        ];
        positions.CopyTo(mesh.Positions);
        Assert.All(mesh.Faces, f => Assert.True(NormalOf(f).Z > 0, $"{f}"));
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = 0.95, SmoothingWeight = 1e-9 });
        Assert.Equal((0, 0, 0), (result.Splits, result.Collapses, result.Flips));
        Assert.All(mesh.Faces, f => Assert.True(NormalOf(f).Z > 0, $"{f}"));
    }

    /// <summary>A tip over a hexagon: the area vector of its faces is upright, so it moves sideways only, by the weight of the way to the middle.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(0.25)]
    public void RemeshInLaboratory_Smoothing_MovesInsideVerticesAlongTheSurface(double weight)
    {
        var tip = new Vector3D(0.15, 0.1, 0.3);
        Vector3D[] rim = RemeshSurfaces.Polygon(6);
        Mesh mesh = RemeshSurfaces.Fan(tip, rim);
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = 1, SmoothingWeight = weight });
        Assert.Equal((0, 0, 0), (result.Splits, result.Collapses, result.Flips));
        Assert.True(Vector3D.Distance(new(0.15 * (1 - weight), 0.1 * (1 - weight), 0.3), mesh.Positions[0]) < 1e-15);
        Assert.Equal(rim, mesh.Positions[1..].ToArray());
    }

    /// <summary>Edges between ⅘ and 4⁄3 of the length, both included, stay: the sides 3 and 5 of a triangle are just that for 3.75.</summary>
    [Theory]
    [InlineData(3.75, false, false)]
    [InlineData(3.74, true, false)]
    [InlineData(3.76, false, true)]
    public void RemeshInLaboratory_Lengths_FromFourFifthsToFourThirds(double length, bool splits, bool collapses)
    {
        Mesh mesh = MeshBuilder.FromTriangles([default, new(3, 0, 0), new(0, 4, 0)], [0, 1, 2]);
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = length });
        Assert.Equal(splits, result.Splits > 0);
        // The halves of what was split are short, and are collapsed again.
        Assert.Equal(splits || collapses, result.Collapses + result.RefusedCollapses > 0);
    }

    [Fact]
    public void RemeshInLaboratory_LongEdges_AreSplitUntilNoneIsLong()
    {
        // After one halving of 8 pieces of 4 are left, then of 2, then of 1.
        Mesh mesh = MeshBuilder.FromTriangles([default, new(8, 0, 0), new(4, 1, 0)], [0, 1, 2]);
        double longest = 0;
        using OperationHistory history = mesh.StartRecording();
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = 0.9 }, new Simplification.ProgressTeller(share =>
        {
            if (share == 0.25)
                longest = mesh.Edges.Max(e => Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position));
        }));
        Assert.InRange(longest, 0.6, 1.2);
        Assert.True(result.Splits > 20);
    }

    /// <summary>A short edge from inside to the border: the border keeps its vertex, whichever end comes first.</summary>
    [Fact]
    public void RemeshInLaboratory_CollapseAtTheBorder_KeepsTheBordersVertex()
    {
        // A pentagon with sides of 1, which is not short any more, and diagonals of 1.62, which are not long yet.
        Vector3D[] rim = RemeshSurfaces.Polygon(5, 0.851);
        int[] corners = [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1];
        foreach (int[] order in new int[][] { corners, [.. corners.Chunk(3).SelectMany(f => new[] { f[1], f[2], f[0] })] })
        {
            Mesh mesh = MeshBuilder.FromTriangles([default, .. rim], order);
            LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = 1.24 });
            Assert.Equal((0, 1), (result.Splits, result.Collapses));
            Assert.Empty(mesh.Validate());
            Assert.Equal(rim.OrderBy(p => (p.X, p.Y)), mesh.Vertices.Select(v => v.Position).OrderBy(p => (p.X, p.Y)));
        }
    }

    /// <summary>No collapse makes an edge longer than 4⁄3 of the length, at either end.</summary>
    [Theory]
    [InlineData(1.55, 1)]
    [InlineData(1.65, 0)]
    public void RemeshInLaboratory_CollapseThatMakesALongEdge_IsRefused(double far, int collapses)
    {
        // The short edge is 0.6 long and its middle at 0.3: from there to the far vertex it is more than 4/3 or less.
        Vector3D[] positions =
        [
            default, new(0.6, 0, 0), new(0.3, 0.9, 0), new(-0.75, 0.6, 0), new(-0.75, -0.6, 0), new(0.3, -0.9, 0), new(1.2, -0.8, 0), new(far, 0, 0), new(1.2, 0.8, 0),
        ];
        int[] corners = [0, 1, 2, 1, 0, 5, 0, 2, 3, 0, 3, 4, 0, 4, 5, 1, 5, 6, 1, 6, 7, 1, 7, 8, 1, 8, 2];
        // The first half-edge leads from 0 to 1, then from 1 to 0.
        foreach (int[] order in new int[][] { corners, [1, 0, 5, 0, 1, 2, .. corners[6..]] })
        {
            Mesh mesh = MeshBuilder.FromTriangles(positions, order);
            LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 1, EdgeLength = 0.97 });
            Assert.Equal((0, collapses, 1 - collapses), (result.Splits, result.Collapses, result.RefusedCollapses));
        }
    }

    private static Vector3D NormalOf(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
    }

    [Fact]
    public void RemeshInLaboratory_Recorded_CanBeUndone()
    {
        Mesh mesh = MeshOf(TriangleSoups.Sphere(8));
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Passes = 2 });
        Assert.True(result.Splits + result.Collapses + result.Flips > 0);
        Assert.NotEqual(before, mesh.StateHash());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void RemeshInLaboratory_BadInputAndCancelled_LeaveAValidMesh()
    {
        Assert.Throws<ArgumentException>("mesh", () => Models.Create("cube-quads").RemeshInLaboratory());
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { SmoothingWeight = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { EdgeLength = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new LaboratoryRemeshingOptions { Passes = 0 });
        Mesh mesh = MeshOf(TriangleSoups.Sphere(8));
        Assert.Throws<OperationCanceledException>(() => mesh.RemeshInLaboratory(null, null, new CancellationToken(true)));
        Assert.Empty(mesh.Validate());
    }
}
