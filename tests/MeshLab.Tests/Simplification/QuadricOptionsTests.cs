using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>Every option of quadric simplification does what it says: each test fails if the option is not heard.</summary>
[Trait("Section", "7.2")]
public class QuadricOptionsTests
{
    public static TheoryData<QuadricMode> Modes => new(Enum.GetValues<QuadricMode>());

    private static Mesh Wave(int n) => Shapes.Sheet(n, (x, y) => 0.1 * Math.Sin(9 * x + 1) * Math.Cos(7 * y) + 0.3 * x * x * y);

    private static double Area(Mesh mesh)
    {
        double sum = 0;
        foreach (Face f in mesh.Faces)
        {
            Vector3D a = f.HalfEdge.Source.Position;
            sum += 0.5 * Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a).Length;
        }
        return sum;
    }

    private static Mesh Simplified(Mesh mesh, QuadricOptions options)
    {
        Mesh copy = mesh.Clone();
        copy.Simplify(options);
        Assert.Empty(copy.Validate());
        return copy;
    }

    private static ulong Hash(Mesh mesh, QuadricOptions options) => Simplified(mesh, options).StateHash();

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_AreaWeights_ChangeTheResult(QuadricMode mode)
    {
        var options = new QuadricOptions { Mode = mode, TargetRatio = 0.3 };
        // Columns of different widths: areas differ.
        Mesh mesh = Shapes.Moved(Wave(14), p => new(p.X * p.X + 0.2 * p.X, p.Y, p.Z));

        Assert.NotEqual(Hash(mesh, options), Hash(mesh, options with { AreaWeights = false }));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_FlatSheet_ShrinksOnlyIfItsBoundaryIsFree(QuadricMode mode)
    {
        Mesh mesh = Shapes.Sheet(10);
        var options = new QuadricOptions { Mode = mode, TargetFaces = 40 };

        Assert.True(Area(Simplified(mesh, options with { Boundary = BoundaryTreatment.Free })) < 0.99);
        Assert.Equal(1, Area(Simplified(mesh, options with { Boundary = BoundaryTreatment.Weighted })), 1e-9);
        Assert.Equal(40, Simplified(mesh, options with { Boundary = BoundaryTreatment.Locked }).Vertices.Count(v => v.IsBoundary));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_BoundaryWeight_IsBetweenFreeAndFirm(QuadricMode mode)
    {
        Mesh mesh = Wave(12);
        var options = new QuadricOptions { Mode = mode, TargetFaces = 40 };

        Assert.Equal(Hash(mesh, options with { Boundary = BoundaryTreatment.Free }), Hash(mesh, options with { BoundaryWeight = 0 }));
        Assert.NotEqual(Hash(mesh, options with { BoundaryWeight = 0.01 }), Hash(mesh, options with { BoundaryWeight = 1000 }));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_Placement_LiesWhereItSays(QuadricMode mode)
    {
        Mesh mesh = Wave(12);
        var before = mesh.Positions.ToArray().ToHashSet();
        var options = new QuadricOptions { Mode = mode, TargetRatio = 0.25 };

        Mesh optimal = Simplified(mesh, options), segment = Simplified(mesh, options with { Placement = VertexPlacement.Segment });
        Mesh endpoint = Simplified(mesh, options with { Placement = VertexPlacement.Endpoint });

        Assert.All(endpoint.Vertices, v => Assert.Contains(v.Position, before));
        Assert.Contains(segment.Vertices, v => !before.Contains(v.Position));
        Assert.NotEqual(optimal.StateHash(), segment.StateHash());
        // What is made of convex combinations stays in the box.
        Assert.All(segment.Vertices, v => Assert.True(v.Position.X is >= -1e-12 and <= 1 + 1e-12 && v.Position.Y is >= -1e-12 and <= 1 + 1e-12));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_AllowFlips_ChangesACrumpledMesh(QuadricMode mode)
    {
        var random = new Random(5);
        Mesh crumpled = Shapes.Sheet(12, (_, _) => 0.3 * random.NextDouble());
        var options = new QuadricOptions { Mode = mode, TargetFaces = 20 };

        Assert.NotEqual(Hash(crumpled, options), Hash(crumpled, options with { AllowFlips = true }));
    }

    /// <summary>On flat ground nothing but the option keeps a line; it is kept by hand, as a crease, as a texture seam and as a border of labels.</summary>
    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_LineInAFlatSheet_StaysIfItIsAsked(QuadricMode mode)
    {
        var options = new QuadricOptions { Mode = mode, TargetFaces = 30 };
        Mesh plain = Shapes.Sheet(12), seam = plain.Clone(), labelled = plain.Clone();
        int[] line = [.. plain.Edges.Where(e => OnLine(e.Vertex0) && OnLine(e.Vertex1)).Select(e => e.Index)];
        HalfEdgeTrait<Vector2D> texture = seam.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear);
        foreach (HalfEdge h in seam.HalfEdges)
        {
            if (!h.IsBoundary)
                texture[h] = new(h.Target.Position.X + (IsRight(h.Face) ? 5 : 0), h.Target.Position.Y);
        }
        FaceLabels labels = labelled.GetOrAddFaceLabels("material");
        foreach (Face f in labelled.Faces)
            labels.Labels[f] = labels.Number(IsRight(f) ? "right" : "left");

        Assert.True(LengthOfLine(Simplified(plain, options)) < 0.99);
        Assert.Equal(1, LengthOfLine(Simplified(plain, options with { FeatureEdges = line })), 1e-12);
        Assert.Equal(1, LengthOfLine(Simplified(seam, options)), 1e-12);
        Assert.True(LengthOfLine(Simplified(seam, options with { KeepTextureSeams = false })) < 0.99);
        Assert.Equal(1, LengthOfLine(Simplified(labelled, options)), 1e-12);
        Assert.True(LengthOfLine(Simplified(labelled, options with { KeepLabelBorders = false })) < 0.99);

        static bool OnLine(Vertex v) => v.Position.X == 0.5;
        static bool IsRight(Face f) => f.Vertices.Average(v => v.Position.X) > 0.5;
        static double LengthOfLine(Mesh mesh) =>
            mesh.Edges.Where(e => OnLine(e.Vertex0) && OnLine(e.Vertex1)).Sum(e => Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position));
    }

    /// <summary>The coordinates of one end differ only: a seam that ends inside.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void Simplify_SeamAtOneEndOfAnEdge_IsASeam(int end)
    {
        Mesh mesh = Shapes.Sheet(8);
        HalfEdgeTrait<Vector2D> texture = mesh.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear);
        Edge edge = mesh.FindEdge(mesh.Vertices[40], mesh.Vertices[41]);
        texture[end == 0 ? edge.HalfEdge0 : edge.HalfEdge1] = new(1, 1);

        bool[]? special = SpecialEdges.Find(mesh, new QuadricOptions());

        Assert.NotNull(special);
        Assert.True(special[edge.Index]);
        Assert.Null(SpecialEdges.Find(mesh, new QuadricOptions { KeepTextureSeams = false }));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public void Simplify_FeatureAngle_IsTheSharperEdgesByHand(QuadricMode mode)
    {
        Mesh mesh = Wave(14);
        var options = new QuadricOptions { Mode = mode, TargetRatio = 0.3 };
        const double Angle = 0.25;
        int[] sharp = [.. mesh.Edges.Where(e => !e.IsBoundary && Vector3D.Angle(Normal(e.Face0), Normal(e.Face1)) > Angle).Select(e => e.Index)];
        Assert.InRange(sharp.Length, 1, mesh.Edges.Count / 2);

        ulong byAngle = Hash(mesh, options with { FeatureAngle = Angle });

        Assert.Equal(byAngle, Hash(mesh, options with { FeatureEdges = sharp }));
        Assert.NotEqual(byAngle, Hash(mesh, options));

        static Vector3D Normal(Face f)
        {
            Vector3D a = f.HalfEdge.Source.Position;
            return Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a);
        }
    }

    [Fact]
    public void Simplify_Modes_AreThree()
    {
        Mesh mesh = Wave(16);
        Assert.Equal(3, Enum.GetValues<QuadricMode>().Select(mode => Hash(mesh, new() { Mode = mode, TargetRatio = 0.2 })).Distinct().Count());
    }
}
