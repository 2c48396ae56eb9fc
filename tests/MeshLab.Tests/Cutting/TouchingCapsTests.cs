using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cutting;

/// <summary>Sections whose outlines touch each other or themselves in a point.</summary>
[Trait("Section", "6.2")]
public class TouchingCapsTests
{
    /// <summary>Names, and the section's area, loops, and points in which loops touch.</summary>
    public static TheoryData<string, double, int, int> Cases => new()
    {
        { "boxes with a common edge", 2, 2, 0 },
        { "void at a corner", 14.5, 2, 1 },
        { "void at a wall", 14, 2, 1 },
        { "void at two corners", 8, 2, 2 },
        { "two voids", 14, 3, 1 },
        { "island in a void at a corner", 8.68, 3, 1 },
    };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Split_LoopsThatTouch_CapsDoNotOverlap(string name, double area, int loops, int touches)
    {
        Mesh mesh = Make(name);
        double volume = mesh.Volume;
        // Also turned, so that no coordinate is exact.
        foreach (double turn in (double[])[0, 0.3, 1.1])
        {
            Mesh turned = mesh.Clone();
            (double s, double c) = Math.SinCos(turn);
            foreach (Vertex v in turned.Vertices)
                v.Position = new((c * v.Position.X) - (s * v.Position.Y), (s * v.Position.X) + (c * v.Position.Y), v.Position.Z);
            var plane = new CuttingPlane(Vector3D.UnitZ, 0.5);
            PlaneSectionResult section = turned.ComputeSection(plane);
            Assert.Equal(loops, section.ClosedLoops);
            Assert.Equal(area, section.Area!.Value, 1e-12);
            (PlaneCutResult above, PlaneCutResult below) = turned.Split(plane, new PlaneCutOptions { Cap = true });
            foreach (PlaneCutResult half in (PlaneCutResult[])[above, below])
            {
                Mesh part = half.Part.Mesh;
                Assert.Empty(part.Validate());
                Assert.True(part.IsClosed);
                Assert.Equal(0, half.FannedLoops);
                double[] caps = [.. part.Faces.Where(f => half.Part.SourceFace[f.Index] < 0).Select(f => f.Area)];
                Assert.Equal(area, caps.Sum(), 1e-9);
                // Two triangles without area join the two vertices of a point in which loops touch.
                if (turn == 0)
                    Assert.Equal(2 * touches, caps.Count(a => a < 1e-12));
            }
            Assert.Equal(volume, above.Part.Mesh.Volume + below.Part.Mesh.Volume, 1e-9);
        }
    }

    [Theory]
    [InlineData(5)]
    [InlineData(9)]
    public void Split_ThroughASaddle_TheCapIsABowTie(int n)
    {
        // The solid below z = x² − y²: the plane z = 0 leaves two triangles that meet in the middle.
        Mesh mesh = Saddle(n);
        double area = Math.Pow(n - 1, 2) / 2, volume = mesh.Volume;
        (PlaneCutResult above, PlaneCutResult below) = mesh.Split(new(Vector3D.UnitZ, 0), new PlaneCutOptions { Cap = true });
        foreach (PlaneCutResult half in (PlaneCutResult[])[above, below])
        {
            Assert.Empty(half.Part.Mesh.Validate());
            Assert.True(half.Part.Mesh.IsClosed);
            Assert.Equal(area, half.Part.Mesh.Faces.Where(f => half.Part.SourceFace[f.Index] < 0).Sum(f => f.Area), 1e-12);
        }
        Assert.Equal(2, above.CapLoops);
        Assert.Equal(1, below.CapLoops);
        Assert.Equal(volume, above.Part.Mesh.Volume + below.Part.Mesh.Volume, 1e-9);
        // Seen as a section the line passes the middle twice.
        Assert.Equal(area, mesh.ComputeSection(new(Vector3D.UnitZ, 0)).Area!.Value, 1e-12);
    }

    [Fact]
    public void ComputeSection_HoleThatBeginsOnTheOutline_IsNestedInIt()
    {
        PlaneSectionResult section = Make("void along a wall").ComputeSection(new(Vector3D.UnitZ, 0.5));
        Assert.Equal([0, 1], section.Polylines.Select(line => line.Depth).Order());
        Assert.Equal(12, section.Area!.Value, 1e-12);
    }

    private static Mesh Make(string name) => name switch
    {
        "boxes with a common edge" => Sum(Prism(0, 1, false, Square(0, 0, 1)), Prism(0, 1, false, Square(1, 1, 1))),
        "void at a corner" => Sum(Block(), Prism(0.2, 0.8, true, [new(0, 0), new(2, 1), new(1, 2)])),
        "void at a wall" => Sum(Block(), Prism(0.2, 0.8, true, [new(2, 0), new(3, 2), new(1, 2)])),
        "void at two corners" => Sum(Block(), Prism(0.2, 0.8, true, [new(0, 0), new(3, 1), new(4, 4), new(1, 3)])),
        "two voids" => Sum(Block(), Prism(0.2, 0.8, true, Square(1, 1, 1)), Prism(0.2, 0.8, true, Square(2, 2, 1))),
        "void along a wall" => Sum(Block(), Prism(0.2, 0.8, true, Square(0, 0, 2))),
        _ => Sum(
            Block(),
            Prism(0.2, 0.8, true, [new(0, 0), new(3, 0.5), new(3, 3), new(0.5, 3)]),
            Prism(0.3, 0.7, false, [new(0, 0), new(1, 0.8), new(0.8, 1)])),
    };

    private static Mesh Block() => Prism(0, 1, false, Square(0, 0, 4));

    private static Vector2D[] Square(double x, double y, double side) => [new(x, y), new(x + side, y), new(x + side, y + side), new(x, y + side)];

    /// <summary>A prism over a convex polygon; inside out as a void.</summary>
    private static Mesh Prism(double bottom, double top, bool isVoid, Vector2D[] polygon)
    {
        int n = polygon.Length;
        Vector3D[] positions = [.. polygon.Select(p => new Vector3D(p.X, p.Y, bottom)), .. polygon.Select(p => new Vector3D(p.X, p.Y, top))];
        var faces = new List<int[]>();
        for (int i = 0; i < n; i++)
        {
            int j = (i + 1) % n;
            faces.Add([i, j, n + j]);
            faces.Add([i, n + j, n + i]);
        }
        for (int i = 1; i + 1 < n; i++)
        {
            faces.Add([0, i + 1, i]);
            faces.Add([n, n + i, n + i + 1]);
        }
        return MeshBuilder.FromPolygons(positions, isVoid ? [.. faces.Select(f => f.Reverse().ToArray())] : [.. faces]);
    }

    private static Mesh Sum(params Mesh[] parts)
    {
        var sum = new Mesh();
        foreach (Mesh part in parts)
            sum.Append(part);
        return sum;
    }

    /// <summary>The height field x² − y² on n × n points, closed by walls and a floor.</summary>
    private static Mesh Saddle(int n)
    {
        double half = (n - 1) / 2.0;
        var positions = new Vector3D[2 * n * n];
        for (int k = 0; k < n * n; k++)
        {
            double x = (k % n) - half, y = (k / n) - half;
            positions[k] = new(x, y, (x * x) - (y * y));
            positions[(n * n) + k] = new(x, y, -2 * half * half);
        }
        var faces = new List<int[]>();
        for (int j = 0; j + 1 < n; j++)
        {
            for (int i = 0; i + 1 < n; i++)
            {
                int a = (j * n) + i, b = a + 1, c = a + n + 1, d = a + n, under = n * n;
                faces.AddRange([[a, b, c], [a, c, d], [under + a, under + c, under + b], [under + a, under + d, under + c]]);
            }
        }
        for (int i = 0; i + 1 < n; i++)
        {
            Wall(i + 1, i);
            Wall(((n - 1) * n) + i, ((n - 1) * n) + i + 1);
            Wall(i * n, (i + 1) * n);
            Wall(((i + 1) * n) + n - 1, (i * n) + n - 1);
        }
        return MeshBuilder.FromPolygons(positions, [.. faces]);

        void Wall(int from, int to) => faces.AddRange([[from, to, (n * n) + to], [from, (n * n) + to, (n * n) + from]]);
    }
}
