using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Generation;

[Trait("Section", "2")]
public class PolyhedraTests
{
    public static TheoryData<string, int, int, int, double> Solids => new()
    {
        { "regular-tetrahedron", 4, 6, 4, 8 * Math.Sqrt(3) / 27 },
        { "regular-cube", 8, 12, 6, 8 * Math.Sqrt(3) / 9 },
        { "octahedron", 6, 12, 8, 4.0 / 3 },
        { "dodecahedron", 20, 30, 12, 2 * (5 * Math.Sqrt(3) + Math.Sqrt(15)) / 9 },
        { "icosahedron", 12, 30, 20, Math.Sqrt(2 * (5 + Math.Sqrt(5))) * 2 / 3 },
    };

    [Theory]
    [MemberData(nameof(Solids))]
    public void Solid_IsRegular(string name, int vertices, int edges, int faces, double volume)
    {
        Mesh mesh = ShapeCatalog.Find(name).Create();

        Assert.Equal((vertices, edges, faces), (mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count));
        Assert.True(mesh.IsClosed);
        Assert.Equal(volume, Measure.Volume(mesh), 1e-14);
        double[] lengths = [.. mesh.Edges.Select(e => Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position))];
        Assert.Equal(lengths.Min(), lengths.Max(), 1e-14);
        Assert.All(mesh.Vertices, v => Assert.Equal(1, v.Position.Length, 1e-15));
        Assert.Empty(mesh.Validate());
    }
}

[Trait("Section", "2")]
public class FurtherShapeTests
{
    [Theory]
    [InlineData(PatchFaces.Triangles)]
    [InlineData(PatchFaces.Quads)]
    public void Torus_AreaAndVolume_ConvergeWithTheSquareOfTheEdge(PatchFaces faces)
    {
        double volume = 2 * Math.PI * Math.PI * 0.16, area = 4 * Math.PI * Math.PI * 0.4;
        Mesh coarse = Tori.Torus(m: 40, n: 20, faces: faces), fine = Tori.Torus(m: 80, n: 40, faces: faces);

        Assert.Equal(0, Measure.EulerCharacteristic(coarse));
        Assert.InRange((volume - Measure.Volume(coarse)) / (volume - Measure.Volume(fine)), 3.8, 4.2);
        Assert.InRange((area - Measure.Area(coarse)) / (area - Measure.Area(fine)), 3.8, 4.2);
        Assert.Empty(coarse.Validate());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void KHoled_OfK_HasGenusK(int genus)
    {
        Mesh mesh = Tori.KHoled(genus, 6);

        Assert.True(mesh.IsClosed);
        Assert.Equal(1, Measure.Components(mesh));
        Assert.Equal(2 - 2 * genus, Measure.EulerCharacteristic(mesh));
        Assert.True(Measure.Volume(mesh) > 0);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Chain_OfLinks_HasAsManyComponentsOfGenusOne()
    {
        Mesh mesh = Tori.Chain(4, 12, 6);

        Assert.Equal((4, 0), (Measure.Components(mesh), Measure.EulerCharacteristic(mesh)));
        Assert.True(Measure.Volume(mesh) > 0);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void MoebiusStrip_IsRefusedAsNotOrientable()
    {
        PolygonSoup strip = MoebiusStrips.Strip(12, 2);

        Assert.Equal((36, 48), (strip.VertexCount, strip.FaceCount));
        Assert.Throws<TopologyException>(() => MeshBuilder.FromPolygons(strip));
        Mesh split = MeshBuilder.FromPolygons(strip, NonManifoldPolicy.Split, out BuildReport report);
        Assert.Equal(48, split.Faces.Count);
        Assert.NotEmpty(report.Repairs);
        // Two half-turns make an ordinary band: every edge but the seam is crossed in opposite directions.
        var directed = new HashSet<(int, int)>();
        int clashes = 0;
        for (int f = 0; f < strip.FaceCount; f++)
        {
            ReadOnlySpan<int> face = strip.Face(f);
            for (int k = 0; k < 3; k++)
            {
                if (!directed.Add((face[k], face[(k + 1) % 3])))
                    clashes++;
            }
        }
        Assert.Equal(2, clashes);
    }

    [Fact]
    public void Catenoid_Area_ConvergesToTheIntegral()
    {
        // 2π c² (z/2c + sinh(z/c)/4 · 2) over z in [−1/2, 1/2], c = 1/2: π c (1 + c sinh(1/c)).
        double exact = Math.PI * 0.5 * (1 + 0.5 * Math.Sinh(2));
        double coarse = exact - Measure.Area(Revolutions.Catenoid(segments: 32, rings: 16)), fine = exact - Measure.Area(Revolutions.Catenoid());

        Assert.InRange(coarse / fine, 3.8, 4.2);
        Assert.Equal(2, Measure.BoundaryLoops(Revolutions.Catenoid(segments: 6, rings: 2)));
        Assert.All(Revolutions.Catenoid(segments: 16, rings: 8).Faces, f => Assert.True(Vector3D.Dot(Measure.VectorArea(f), f.HalfEdge.Source.Position with { Z = 0 }) > 0));
    }

    [Fact]
    public void Revolve_WithPolesAndEnds_IsClosed()
    {
        Mesh cone = Revolutions.Revolve([new(0.5, 0), new(0, 1)], 7, closeEnds: true);

        Assert.Equal((8, 8), (cone.Vertices.Count, cone.Faces.Count));
        Assert.True(cone.IsClosed);
        Assert.Equal(7 / 8.0 * Math.Sin(2 * Math.PI / 7) / 3, Measure.Volume(cone), 1e-14);
        Mesh barrel = Revolutions.Revolve([new(0.5, 0), new(0.6, 0.5), new(0.5, 1)], 8, PatchFaces.Quads, closeEnds: true);
        Assert.Equal(18, barrel.Faces.Count);
        Assert.True(barrel.IsClosed && Measure.Volume(barrel) > 0);
        Assert.Throws<ArgumentException>(() => Revolutions.Revolve([new(0, 0)], 5));
        Assert.Throws<ArgumentException>(() => Revolutions.Revolve([new(1, 0), new(0, 1), new(1, 2)], 5));
        Assert.Throws<ArgumentException>(() => Revolutions.Revolve([new(0, 0), new(0, 1)], 5));
        Assert.Throws<ArgumentException>(() => Revolutions.Revolve([new(-1, 0), new(1, 1)], 5));
        Assert.Throws<ArgumentException>(() => Revolutions.Revolve([new(double.NaN, 0), new(1, 1)], 5));
    }

    [Fact]
    public void Vase_IsClosedAndMostlyOfQuads()
    {
        Mesh mesh = Revolutions.Vase();

        Assert.True(mesh.IsClosed);
        Assert.Equal(2, Measure.EulerCharacteristic(mesh));
        Assert.True(Measure.Volume(mesh) > 0);
        Assert.True(mesh.Faces.Count(f => f.Degree == 4) > 0.95 * mesh.Faces.Count);
        Assert.Contains(mesh.Faces, f => f.Degree == 3);
        Assert.Contains(mesh.Faces, f => f.Degree == 48);
        Assert.Empty(mesh.Validate());
    }

    [Theory]
    [InlineData(2, 3)]
    [InlineData(3, 5)]
    public void TorusKnot_IsATubeOfGenusOne(int p, int q)
    {
        Mesh mesh = Sweeps.TorusKnot(p, q, 400, 12, 0.1);

        Assert.True(mesh.IsClosed);
        Assert.Equal(0, Measure.EulerCharacteristic(mesh));
        // A tube's volume is its cross section times the length of its path (Pappus).
        double length = 0;
        for (int i = 0; i < 20000; i++)
            length += (Knot((i + 1) / 20000.0) - Knot(i / 20000.0)).Length;
        Assert.Equal(1, Measure.Volume(mesh) / (length * 6 * 0.01 * Math.Sin(Math.PI / 6)), 5e-3);
        Assert.Empty(mesh.Validate());

        Vector3D Knot(double t)
        {
            double r = 2 + Math.Cos(2 * Math.PI * q * t);
            return new(r * Math.Cos(2 * Math.PI * p * t), r * Math.Sin(2 * Math.PI * p * t), -Math.Sin(2 * Math.PI * q * t));
        }
    }

    [Fact]
    public void Sweep_AlongALine_IsAPrism()
    {
        Vector2D[] square = [new(1, 0), new(0, 1), new(-1, 0), new(0, -1)];

        Mesh mesh = Sweeps.Sweep(square, [new(0, 0, 0), new(0, 0, 1), new(0, 0, 3)], closed: false);

        Assert.True(mesh.IsClosed);
        Assert.Equal(6, Measure.Volume(mesh), 1e-14);
        Assert.Equal(2, Measure.EulerCharacteristic(Sweeps.Spring(2, 12, 6)));
        Assert.True(Measure.Volume(Sweeps.Spring(2, 12, 6)) > 0);
        Assert.Throws<ArgumentException>(() => Sweeps.Sweep(square, [new(0, 0, 0), new(0, 0, 0)], closed: false));
        Assert.Throws<ArgumentException>(() => Sweeps.Sweep(square, [new(0, 0, 0)], closed: false));
        Assert.Throws<ArgumentException>(() => Sweeps.Sweep(square.AsSpan(0, 2), [new(0, 0, 0), new(1, 0, 0)], closed: false));
        Assert.Throws<ArgumentException>(() => Sweeps.TorusKnot(2, 4));
    }

    [Fact]
    public void HeightFields_HaveTheirShape()
    {
        Mesh saddle = HeightFields.HyperbolicParaboloid(9, 2, 4);
        Assert.All(saddle.Vertices, v => Assert.Equal((v.Position.X * v.Position.X - v.Position.Y * v.Position.Y) / 2, v.Position.Z, 1e-14));
        Mesh terrain = HeightFields.Terrain(32, 0.3, 5);
        Assert.Equal(HeightFields.Terrain(32, 0.3, 5).StateHash(), terrain.StateHash());
        Assert.NotEqual(HeightFields.Terrain(32, 0.3, 6).StateHash(), terrain.StateHash());
        Assert.Empty(terrain.Validate());
        Assert.Throws<ArgumentException>(() => HeightFields.Create(3, 3, (_, _) => double.NaN));
        Assert.Throws<ArgumentNullException>(() => HeightFields.Create(3, 3, null!));
    }

    [Theory]
    [InlineData(1, 2)]
    [InlineData(2, 9)]
    [InlineData(4, 16)]
    public void PerforatedSheet_HasOneLoopPerHoleAndOneAround(int holes, int resolution)
    {
        Mesh mesh = HeightFields.PerforatedSheet(holes, resolution, 0.05);

        Assert.Equal(holes * holes + 1, Measure.BoundaryLoops(mesh));
        Assert.Equal((1, 1 - holes * holes), (Measure.Components(mesh), Measure.EulerCharacteristic(mesh)));
        Assert.DoesNotContain(mesh.Vertices, v => v.IsIsolated);
        Assert.All(mesh.Faces, f => Assert.True(Measure.VectorArea(f).Z > 0));
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Extrude_WithHoles_HasTheirGenusAndVolume()
    {
        Vector2D[] square = [new(0, 0), new(4, 0), new(4, 4), new(0, 4)];
        Vector2D[] first = [new(1, 1), new(1, 2), new(2, 2), new(2, 1)], second = [new(2.5, 1.5), new(3, 3), new(3.5, 1.5)];

        Mesh mesh = Extrusions.Extrude(square, 0.5, first, second);

        Assert.True(mesh.IsClosed);
        Assert.Equal(2 - 2 * 2, Measure.EulerCharacteristic(mesh));
        Assert.Equal((16 - 1 - 0.75) / 2, Measure.Volume(mesh), 1e-14);
        Assert.Empty(mesh.Validate());
        Assert.Throws<ArgumentException>(() => Extrusions.Extrude([.. square.Reverse()]));
        Assert.Throws<ArgumentException>(() => Extrusions.Extrude(square, 1, (Vector2D[])[.. first.Reverse()]));
        Assert.Throws<ArgumentException>(() => Extrusions.Extrude([new(0, 0), new(1, 0)]));
        Assert.Throws<ArgumentException>(() => Extrusions.Extrude([new(0, 0), new(3, 0), new(1, -1), new(2, 2)]));
        Assert.Throws<ArgumentException>(() => Extrusions.Extrude(square, 1, new Vector2D[] { new(5, 5), new(5, 6), new(6, 6) }));
        Assert.Throws<ArgumentOutOfRangeException>(() => Extrusions.Extrude(square, 0));
    }

    [Fact]
    public void Flange_HasGenusFiveSharpEdgesAndSlivers()
    {
        Mesh mesh = CadParts.Flange(16);

        Assert.True(mesh.IsClosed && mesh.IsTriangleMesh);
        Assert.Equal((1, 2 - 2 * 5), (Measure.Components(mesh), Measure.EulerCharacteristic(mesh)));
        double circle = 8 * Math.Sin(2 * Math.PI / 16);
        double plate = 4 - 4 * 0.09 + 0.09 * circle - 4 * 0.12 * 0.12 * circle;
        double expected = 0.3 * plate + 0.5 * 0.25 * circle - 0.8 * 0.32 * 0.32 * circle;
        Assert.Equal(expected, Measure.Volume(mesh), 1e-12);
        Assert.Contains(mesh.Faces, f => Slenderness(f) < 0.1);
        Assert.Empty(mesh.Validate());
        Assert.Throws<ArgumentOutOfRangeException>(() => CadParts.Flange(18));
        Assert.Equal(0.6 * 0.36, Measure.Volume(CadParts.Bracket()), 1e-14);

        static double Slenderness(Face f) =>
            4 * Math.Sqrt(3) * Measure.VectorArea(f).Length
            / f.HalfEdges.ToArray().Sum(h => Vector3D.DistanceSquared(h.Source.Position, h.Target.Position));
    }

    [Fact]
    public void Beast_IsClosedOfGenusOneAndTheSameEveryTime()
    {
        Mesh mesh = Creatures.Beast(16);

        Assert.True(mesh.IsClosed);
        Assert.Equal((1, 0), (Measure.Components(mesh), Measure.EulerCharacteristic(mesh)));
        Assert.True(Measure.Volume(mesh) > 0.5);
        Assert.Equal(Creatures.Beast(16).StateHash(), mesh.StateHash());
        Assert.NotEqual(Creatures.Beast(16, seed: 2).StateHash(), mesh.StateHash());
        Assert.Empty(mesh.Validate());
    }
}

[Trait("Section", "2")]
public class ImplicitSurfacesTests
{
    private static readonly BoundingBox Box = new(new(-1.5, -1.5, -1.5), new(1.5, 1.5, 1.5));

    [Fact]
    public void March_OfASphere_Converges()
    {
        Mesh coarse = ImplicitSurfaces.March(p => p.Length - 1, Box, 0.2), fine = ImplicitSurfaces.March(p => p.Length - 1, Box, 0.1);

        Assert.Equal(2, Measure.EulerCharacteristic(coarse));
        double exact = 4 * Math.PI / 3;
        Assert.InRange((exact - Measure.Volume(coarse)) / (exact - Measure.Volume(fine)), 3.5, 4.5);
        Assert.All(ImplicitSurfaces.March(p => p.Length - 1, Box, 0.2, 3).Vertices, v => Assert.Equal(1, v.Position.Length, 1e-6));
    }

    [Fact]
    public void March_OfNoise_IsAClosedManifold()
    {
        // Every sign pattern of a cube occurs, the ambiguous ones too.
        var random = new Random(3);
        var signs = new Dictionary<Vector3D, double>();

        Mesh mesh = ImplicitSurfaces.March(Field, Box, 0.25);

        Assert.True(mesh.IsClosed);
        Assert.True(mesh.Faces.Count > 5000);
        Assert.Empty(mesh.Validate());

        double Field(Vector3D p)
        {
            if (Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))) > 1.45)
                return 1;
            if (!signs.TryGetValue(p, out double value))
                signs[p] = value = random.NextDouble() - 0.5;
            return value;
        }
    }

    [Fact]
    public void March_OfBadArguments_Throws()
    {
        Assert.Throws<ArgumentException>(() => ImplicitSurfaces.March(p => p.Length - 2, Box, 0.2));
        Assert.Throws<ArgumentException>(() => ImplicitSurfaces.March(_ => double.NaN, Box, 0.2));
        Assert.Throws<ArgumentException>(() => ImplicitSurfaces.March(_ => 1, BoundingBox.Empty, 0.2));
        Assert.Throws<ArgumentOutOfRangeException>(() => ImplicitSurfaces.March(_ => 1, Box, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => ImplicitSurfaces.March(_ => 1, Box, 1e-4));
        Assert.Equal(0, ImplicitSurfaces.March(_ => 1, Box, 0.5).Faces.Count);
    }
}

[Trait("Section", "2")]
public class ShapeCatalogTests
{
    [Fact]
    public void EveryShape_WithDefaults_IsAValidMesh()
    {
        foreach (Shape shape in ShapeCatalog.Shapes)
        {
            Mesh mesh = shape.Create(shape.Complete(), NonManifoldPolicy.Split, out BuildReport report);
            Assert.True(mesh.Faces.Count > 0, shape.Name);
            Assert.Empty(mesh.Validate());
            Assert.Equal(shape.Name == "moebius", report.Repairs.Count > 0);
            if (mesh.IsClosed)
                Assert.True(Measure.Volume(mesh) > 0, shape.Name);
        }
        Assert.Equal(ShapeCatalog.Shapes.Count, ShapeCatalog.Shapes.Select(s => s.Name).Distinct(StringComparer.Ordinal).Count());
    }

    [Fact]
    public void Create_WithValues_PassesThemOn()
    {
        Assert.Equal(100, ShapeCatalog.Find("grid").Create(new Dictionary<string, double>(StringComparer.Ordinal) { ["m"] = 20, ["n"] = 5 }).Vertices.Count);
        Assert.Equal(Tori.Torus(2, 0.5, 9, 7).StateHash(), ShapeCatalog.Find("torus").Create(
            new Dictionary<string, double>(StringComparer.Ordinal) { ["major"] = 2, ["minor"] = 0.5, ["m"] = 9, ["n"] = 7 }).StateHash());
    }

    [Fact]
    public void Create_OfBadNamesOrValues_SaysWhatIsAllowed()
    {
        Assert.Contains("torus", Assert.Throws<ArgumentException>(() => ShapeCatalog.Find("donut")).Message, StringComparison.Ordinal);
        Shape torus = ShapeCatalog.Find("torus");
        Assert.Contains("minor", Assert.Throws<ArgumentException>(() => torus.Create(new Dictionary<string, double>(StringComparer.Ordinal) { ["x"] = 1 })).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => torus.Create(new Dictionary<string, double>(StringComparer.Ordinal) { ["m"] = 2 }));
        Assert.Throws<ArgumentException>(() => torus.Create(new Dictionary<string, double>(StringComparer.Ordinal) { ["m"] = 7.5 }));
        Assert.Throws<ArgumentException>(() => torus.Create(new Dictionary<string, double>(StringComparer.Ordinal) { ["major"] = double.NaN }));
        Assert.Throws<TopologyException>(() => ShapeCatalog.Find("moebius").Create());
    }

    [Fact]
    public void Shapes_OfImpossibleSizes_AreRefusedAtOnce()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.Icosphere(2, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Spheres.Icosphere(2, double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => Sweeps.TorusKnot(around: 2));
        Assert.Throws<ArgumentOutOfRangeException>(() => Tori.Torus(m: 1_000_000, n: 1_000_000));
    }

    [Fact]
    public void Polygon_TextureCoordinates_AreThePlacesInTheSquareAroundIt()
    {
        Mesh mesh = Polygons.Polygon(6);
        foreach (Vertex v in mesh.Vertices)
        {
            Assert.Equal(v.Position.X + 0.5, v.Traits.UV.X, 12);
            Assert.Equal(v.Position.Y + 0.5, v.Traits.UV.Y, 12);
        }
    }
}
