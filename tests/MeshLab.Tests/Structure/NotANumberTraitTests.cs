using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Simplification;
using Xunit;

namespace MeshLab.Tests.Structure;

/// <summary>NaN in a trait: catching where it has a share in a blend, and nowhere else; positions and connectivity do not depend on it.</summary>
[Trait("Section", "1.4")]
public class NotANumberTraitTests
{
    private const int Marked = 77;

    private static Mesh Torus(bool withTraits)
    {
        Mesh mesh = Shapes.Torus(16, 12);
        if (!withTraits)
            return mesh;
        VertexTrait<double> number = mesh.AddVertexTrait("number", 0.0, Blend.Linear);
        HalfEdgeTrait<Vector3D> vector = mesh.AddHalfEdgeTrait<Vector3D>("vector", default, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            number[v] = v.Index == Marked ? double.NaN : v.Position.X;
        foreach (HalfEdge h in mesh.HalfEdges)
            vector[h] = h.Target.Index == Marked ? new(double.NaN, 0, 0) : h.Target.Position;
        return mesh;
    }

    public static TheoryData<string> Algorithms =>
    [
        .. Enum.GetNames<QuadricMode>().Select(mode => "Simplify " + mode), .. Enum.GetNames<DeletionMeasure>().Select(measure => "Delete " + measure),
        .. Enum.GetNames<SubdivisionScheme>().Select(scheme => "Subdivide " + scheme), .. Enum.GetNames<FiveSixSevenEngine>().Select(engine => "FiveSixSeven " + engine),
        "Remesh", "Laboratory", "Cells",
    ];

    private static Mesh Run(string algorithm, Mesh mesh)
    {
        string name = algorithm.Split(' ')[^1];
        switch (algorithm.Split(' ')[0])
        {
            case "Simplify":
                mesh.Simplify(new() { TargetRatio = 0.4, Mode = Enum.Parse<QuadricMode>(name) });
                return mesh;
            case "Delete":
                mesh.DeleteElements(new() { TargetFaces = 200, Measure = Enum.Parse<DeletionMeasure>(name) });
                return mesh;
            case "Subdivide":
                return mesh.Subdivide(Enum.Parse<SubdivisionScheme>(name));
            case "FiveSixSeven":
                return mesh.ToFiveSixSeven(new() { Engine = Enum.Parse<FiveSixSevenEngine>(name), TargetFaces = 300 }).Mesh;
            case "Remesh":
                return mesh.RemeshIsotropically(new() { RelativeLength = 0.8 }).Mesh;
            case "Laboratory":
                mesh.RemeshInLaboratory();
                return mesh;
            default:
                mesh.CollapseCells(new() { CellSize = 0.2 });
                return mesh;
        }
    }

    [Theory]
    [MemberData(nameof(Algorithms))]
    public void Run_TraitsWithNaN_ChangeNothingElse(string algorithm)
    {
        Mesh plain = Run(algorithm, Torus(withTraits: false)), marked = Run(algorithm, Torus(withTraits: true));

        Assert.Equal(plain.Positions.ToArray(), marked.Positions.ToArray());
        Assert.Equal(plain.Target.ToArray(), marked.Target.ToArray());
        Assert.Equal(plain.Next.ToArray(), marked.Next.ToArray());
        Assert.Empty(marked.Validate());
        VertexTrait<double> number = marked.GetOrAddVertexTrait("number", 0.0);
        // A few around the marked vertex have no number; the others keep theirs, which blends do not leave.
        Assert.InRange(marked.Vertices.Count(v => double.IsNaN(number[v])), 0, 20);
        Assert.All(marked.Vertices, v => Assert.True(double.IsNaN(number[v]) || Math.Abs(number[v]) <= 1.4 + 1e-12));
        HalfEdgeTrait<Vector3D> vector = marked.GetOrAddHalfEdgeTrait<Vector3D>("vector", default);
        Assert.InRange(marked.HalfEdges.Count(h => !h.IsBoundary && double.IsNaN(vector[h].X)), 0, 120);
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    [InlineData(QuadricMode.Textbook)]
    public void Simplify_VerticesThatStay_KeepTheirValuesBitForBit(QuadricMode mode)
    {
        Mesh mesh = Torus(withTraits: true), original = mesh.Clone();

        mesh.Simplify(new() { TargetRatio = 0.3, Mode = mode, Placement = VertexPlacement.Endpoint });

        VertexTrait<double> number = mesh.GetOrAddVertexTrait("number", 0.0);
        Vector3D place = original.Vertices[Marked].Position;
        foreach (Vertex v in mesh.Vertices)
            Assert.Equal(v.Position == place ? double.NaN : v.Position.X, number[v]);
    }

    [Fact]
    public void Subdivide_NewVertices_AreNaNWhereTheMarkedOneHasAShare()
    {
        Mesh mesh = Torus(withTraits: true), fine = mesh.Subdivide(SubdivisionScheme.Loop);

        VertexTrait<double> number = fine.GetOrAddVertexTrait("number", 0.0);
        int[] expected = [Marked, .. mesh.Vertices[Marked].Edges.Select(e => mesh.VertexSlots + e.Index).Order()];
        Assert.Equal(expected, fine.Vertices.Where(v => double.IsNaN(number[v])).Select(v => v.Index));
    }

    [Fact]
    public void Linear_AtItsEnds_IsTheEndBitForBit()
    {
        Assert.Equal(0.1, Blend.Linear(0.1, double.NaN, 0));
        Assert.Equal(0.3, Blend.Linear(double.NaN, 0.3, 1));
        Assert.Equal(0.3, Blend.Linear(1e17, 0.3, 1));
        Assert.Equal(double.NaN, Blend.Linear(double.NaN, 0.3, 0.5));
        Vector3D p = new(1, 2, 3), nan = new(double.NaN, 0, 0);
        Assert.Equal(p, Blend.Linear(p, nan, 0));
        Assert.Equal(p, Blend.Linear(nan, p, 1));
        Assert.Equal(p.Normalized(), Blend.Direction(nan, p, 1));
        Vector2D q = new(1, 2), none = new(double.NaN, double.NaN);
        Assert.Equal(q, Blend.Linear(q, none, 0));
        Assert.Equal(q, Blend.Linear(none, q, 1));
        Color red = new(1, 0, 0), broken = new(float.NaN, 0, 0);
        Assert.Equal(red, Blend.Linear(red, broken, 0));
        Assert.Equal(red, Blend.Linear(broken, red, 1));
    }

    /// <summary>A sharpness is no value to be blended but a rule: NaN is refused, with the edge's name.</summary>
    [Fact]
    public void Subdivide_SharpnessNaN_IsRefused()
    {
        Mesh mesh = Shapes.Torus(6, 5);
        EdgeTrait<double> sharpness = mesh.AddEdgeTrait<double>(MeshLab.Subdivision.Creases.TraitName, 0);
        sharpness[mesh.Edges[7]] = double.NaN;

        foreach (SubdivisionScheme scheme in new[] { SubdivisionScheme.Loop, SubdivisionScheme.CatmullClark })
        {
            Assert.Contains("e7", Assert.Throws<ArgumentException>("mesh", () => mesh.Subdivide(scheme)).Message, StringComparison.Ordinal);
            Assert.Empty(mesh.Subdivide(scheme, new() { UseCreases = false }).Validate());
        }
        Assert.Throws<ArgumentException>("mesh", () => LimitSurface.OfLoop(mesh));
        Assert.Throws<ArgumentException>("mesh", () => LimitSurface.OfCatmullClark(mesh));
    }
}
