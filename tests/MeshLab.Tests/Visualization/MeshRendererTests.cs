using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

[Trait("Section", "pictures")]
public class MeshRendererTests
{
    private static readonly RenderOptions Plain = new()
    {
        Width = 200,
        Height = 200,
        Background = new Color(0, 0, 0, 0),
        GroundShadow = false,
        AmbientOcclusion = false,
        Supersampling = 2,
    };

    [Theory]
    [InlineData(30, 20, 28)]
    [InlineData(0, 90, 60)]
    [InlineData(-100, -35, 2)]
    public void Render_Sphere_CoversTheDiscOfItsProjection(double azimuth, double elevation, double fieldOfView)
    {
        Image image = MeshRenderer.Render(Sphere(96), Plain with { View = new(azimuth, elevation) { FieldOfView = fieldOfView } });

        // The camera is placed so that the outline just touches the picture without its margin of 6 %.
        double radius = 0.44 * 200, covered = Coverage(image);
        Assert.InRange(covered, 0.985 * Math.PI * radius * radius, 1.002 * Math.PI * radius * radius);
    }

    [Fact]
    public void Render_TwoFaces_TheNearerHidesTheOther()
    {
        // Two squares that face the viewer at y = −1 (front) and y = +1; seen from the front.
        Mesh mesh = MeshBuilder.FromTriangles(
            [new(-1, -1, -1), new(1, -1, -1), new(1, -1, 1), new(-1, -1, 1), new(-1, 1, -1), new(1, 1, -1), new(1, 1, 1), new(-1, 1, 1)],
            [4, 5, 6, 4, 6, 7, 0, 1, 2, 0, 2, 3]);
        Color red = new(1, 0, 0), green = new(0, 1, 0);
        Coloring coloring = Coloring.FaceColors([green, green, red, red]);

        Image image = MeshRenderer.Render(mesh, Plain with { View = new(0, 0), Shading = Shading.None, Coloring = coloring });
        Assert.Equal(red, image[100, 100]);

        // From behind both squares show their inner sides: the tint is mixed in, and green is nearer.
        Color behind = MeshRenderer.Render(mesh, Plain with { View = new(180, 0), Shading = Shading.None, Coloring = coloring })[100, 100];
        Assert.NotEqual(green, behind);
        Assert.True(behind.G > 0.3);
    }

    [Fact]
    public void Render_TwiceAndOnOneThread_GivesTheSameBytes()
    {
        Mesh mesh = Sphere(24);
        double[] heights = [.. Heights(mesh)];
        RenderOptions options = Plain with
        {
            GroundShadow = true,
            AmbientOcclusion = true,
            Wireframe = true,
            Vertices = true,
            Background = null,
            Coloring = Coloring.VertexScalars(heights, title: "height").WithIsolines(10),
            Points = [new([new(0, 0, 1)], new Color(1, 0, 0))],
            Polylines = [new([new(-1.1, -1.1, 0), new(1.1, -1.1, 0)], new Color(0, 0, 1))],
        };

        byte[] first = MeshRenderer.Render(mesh, options).ToPng();

        Assert.Equal(first, MeshRenderer.Render(mesh, options).ToPng());
        Assert.Equal(first, MeshRenderer.Render(mesh, options with { MaxDegreeOfParallelism = 1 }).ToPng());
        Assert.Equal(first, MeshRenderer.Render(mesh, options with { MaxDegreeOfParallelism = 7 }).ToPng());
    }

    [Fact]
    public void Render_EmptyMesh_IsBackground()
    {
        Color background = Color.FromBytes(10, 200, 30);
        Image image = MeshRenderer.Render(new Mesh(), new() { Width = 30, Height = 20, Background = background, Wireframe = true, Vertices = true });
        for (int y = 0; y < 20; y++)
        {
            for (int x = 0; x < 30; x++)
                Assert.Equal(background, image[x, y]);
        }
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Render_EveryModel_ShowsSomething(string name)
    {
        Mesh mesh = Models.Create(name);
        Image image = MeshRenderer.Render(mesh, Plain with { Wireframe = true, Width = 120, Height = 90, GroundShadow = true, AmbientOcclusion = true });
        if (mesh.Faces.Count > 0)
            Assert.True(Coverage(image) > 20);
        else
            Assert.Equal(0, Coverage(image));
    }

    [Fact]
    public void Render_AnyScaleAndPlace_LooksTheSame()
    {
        Image one = MeshRenderer.Render(Sphere(32), Plain), other = MeshRenderer.Render(Sphere(32, 1e-7, new(3, -5, 2)), Plain);
        Assert.InRange(Coverage(other), Coverage(one) * 0.99, Coverage(one) * 1.01);
    }

    [Fact]
    public void Render_NotANumber_IsGreyAndInTheLegend()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 0, 1)], [0, 1, 2]);
        RenderOptions options = Plain with { View = new(0, 0), Shading = Shading.None, Width = 400 };
        Coloring half = Coloring.VertexScalars([double.NaN, 1, 2], title: "x"), none = Coloring.VertexScalars([0, 1, 2], title: "x");

        Image image = MeshRenderer.Render(mesh, options with { Coloring = half, Legend = false });

        Assert.Contains(Pixels(image), color => color == ColorMap.NotANumber);
        Assert.DoesNotContain(Pixels(MeshRenderer.Render(mesh, options with { Coloring = none })), color => color == ColorMap.NotANumber);
        Assert.True(Legend.Width(half) > Legend.Width(none));
        Assert.Equal((1.0, 2.0), (half.Minimum, half.Maximum));
    }

    [Fact]
    public void Render_VertexScalars_AreMappedAfterInterpolation()
    {
        // Between blue (0) and red (1) the middle of this map is green: only mapping per pixel shows it.
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(1, 0, 1), new(0, 0, 1)], [0, 1, 2, 0, 2, 3]);
        var map = new ColorMap("test", [new(0, 0, 1), new(0, 1, 0), new(1, 0, 0)]);
        Image image = MeshRenderer.Render(mesh, Plain with { View = new(0, 0), Shading = Shading.None, Coloring = Coloring.VertexScalars([0, 1, 1, 0], map) });
        Assert.True(image[100, 100].G > 0.95);
        Assert.True(image[15, 100].B > 0.9);
        Assert.True(image[184, 100].R > 0.9);
    }

    [Fact]
    public void Render_Wireframe_DrawsRealEdgesOnly()
    {
        Mesh quad = MeshBuilder.FromFaces(4, [0, 1, 2, 3]);
        Vector3D[] corners = [new(0, 0, 0), new(1, 0, 0), new(1, 0, 1), new(0, 0, 1)];
        corners.CopyTo(quad.Positions);
        RenderOptions options = Plain with
        {
            View = new(0, 0), Shading = Shading.None, Wireframe = true, WireframeColor = Color.Black, WireframeWidth = 4,
            Coloring = Coloring.Uniform(Color.White),
        };
        Image image = MeshRenderer.Render(quad, options);
        Assert.Equal(Color.White, image[100, 100]);
        Assert.True(image[100, 12].R < 0.3, "the upper edge is missing");
    }

    [Fact]
    public void Render_HiddenLine_IsNotDrawn()
    {
        Mesh mesh = Sphere(32);
        Polyline behind = new([new(-0.5, 1.2, 0), new(0.5, 1.2, 0)], new Color(1, 0, 0), 5);
        RenderOptions options = Plain with { View = new(0, 0) };
        Assert.DoesNotContain(Pixels(MeshRenderer.Render(mesh, options with { Polylines = [behind] })), IsRed);
        Assert.Contains(Pixels(MeshRenderer.Render(mesh, options with { Polylines = [behind with { HiddenOpacity = 1 }] })), IsRed);
        Assert.Contains(Pixels(MeshRenderer.Render(mesh, options with { Polylines = [behind], View = new(180, 0) })), IsRed);

        static bool IsRed(Color color) => color is { R: > 0.9f, G: < 0.2f, B: < 0.2f };
    }

    [Theory]
    [InlineData(MarkShape.Sphere)]
    [InlineData(MarkShape.Disc)]
    public void Render_Marks_HaveTheirSizeAndAreHiddenBehind(MarkShape shape)
    {
        Mesh mesh = Sphere(32);
        PointMarks front = new([new(0, -1.0, 0)], new Color(1, 0, 0), 20, shape), behind = front with { Points = [new(0, 1.3, 0)] };
        RenderOptions options = Plain with { View = new(0, 0) };

        // Of a ball on the surface half is seen, in front of it all of its disc.
        int seen = Pixels(MeshRenderer.Render(mesh, options with { Points = [front] })).Count(IsReddish);
        Assert.InRange(seen, 0.9 * Math.PI * 100, 1.1 * Math.PI * 100);
        Assert.DoesNotContain(Pixels(MeshRenderer.Render(mesh, options with { Points = [behind] })), IsReddish);
        Assert.InRange(Pixels(MeshRenderer.Render(new Mesh(), options with { Points = [front] })).Count(IsReddish), seen - 25, seen + 25);

        static bool IsReddish(Color color) => color.A > 0.5f && color.R > 2 * color.G + 0.1f && color.R > 2 * color.B + 0.1f;
    }

    [Fact]
    public void Render_HighlightedEdges_AreDrawn()
    {
        Mesh mesh = Sphere(16);
        EdgeMarks marks = new([.. mesh.Edges.Where(e => e.Vertices.All(v => Math.Abs(v.Position.Z) < 1e-9)).Select(e => e.Index)], new Color(1, 0, 0), 4);
        Assert.Equal(32, marks.Edges.Count);
        Image image = MeshRenderer.Render(mesh, Plain with { View = new(0, 0), HighlightedEdges = [marks] });
        Assert.Equal(new Color(1, 0, 0), image[100, 100]);
        Assert.NotEqual(new Color(1, 0, 0), image[100, 90]);
    }

    [Fact]
    public void Render_WrongArrays_Throw()
    {
        Mesh mesh = Sphere(8);
        Assert.Throws<ArgumentException>(() => MeshRenderer.Render(mesh, new() { Coloring = Coloring.VertexScalars([1, 2]) }));
        Assert.Throws<ArgumentException>(() => MeshRenderer.Render(mesh, new() { Coloring = Coloring.FaceLabels([1, 2]) }));
        Assert.Throws<ArgumentOutOfRangeException>(() => MeshRenderer.Render(mesh, new() { HighlightedEdges = [new([mesh.EdgeSlots], Color.Black)] }));
        Assert.Throws<ArgumentException>(() => MeshRenderer.Render(mesh, new() { Polylines = [new([new(double.NaN, 0, 0)], Color.Black)] }));
        Assert.Throws<ArgumentNullException>(() => MeshRenderer.Render(null!));
    }

    [Fact]
    public void Options_BadValues_Throw()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Width = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Height = -3 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Supersampling = 5 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { WireframeWidth = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { MaxDegreeOfParallelism = 0 });
        Assert.Throws<ArgumentNullException>(() => new RenderOptions { Coloring = null! });
        Assert.Throws<ArgumentOutOfRangeException>(() => new View(double.NaN, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new View(0, 91));
        Assert.Throws<ArgumentOutOfRangeException>(() => new View { Zoom = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new View { FieldOfView = 180 });
    }

    [Fact]
    public void ByValence_Cube_HasThreeAndRegularFour()
    {
        Mesh cube = Models.Create("cube-quads");
        Coloring coloring = Coloring.ByValence(cube);
        Assert.All(coloring.Labels!, valence => Assert.Equal(3, valence));
        Assert.Equal([new LegendEntry("3", Palette.Valence(3, regular: 4))], coloring.Entries);
    }

    [Fact]
    public void Coloring_Ranges_AreChecked()
    {
        Coloring coloring = Coloring.VertexScalars([-1, 0, 3]);
        Assert.Equal((-3.0, 3.0), (coloring.Symmetric().Minimum, coloring.Symmetric().Maximum));
        Assert.Throws<ArgumentOutOfRangeException>(() => coloring.WithRange(1, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => coloring.WithRange(double.NaN, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => coloring.WithoutOutliers(0.5));
        Assert.Throws<ArgumentOutOfRangeException>(() => coloring.WithIsolines(-1));

        Coloring outlier = Coloring.VertexScalars([.. Enumerable.Range(0, 1000).Select(i => i == 500 ? 1e9 : i)]).WithoutOutliers();
        Assert.True(outlier.Maximum < 1000);
        Coloring constant = Coloring.VertexScalars([5, 5, 5]);
        Assert.Equal(0.5, constant.Normalize(5), 12);
    }

    internal static Mesh Sphere(int rows, double radius = 1, Vector3D center = default)
    {
        int columns = 2 * rows;
        var positions = new List<Vector3D> { center + new Vector3D(0, 0, radius), center - new Vector3D(0, 0, radius) };
        var corners = new List<int>();
        for (int i = 1; i < rows; i++)
        {
            for (int j = 0; j < columns; j++)
            {
                double theta = Math.PI * i / rows, phi = 2 * Math.PI * j / columns;
                positions.Add(center + radius * new Vector3D(Math.Sin(theta) * Math.Cos(phi), Math.Sin(theta) * Math.Sin(phi), Math.Cos(theta)));
            }
        }
        for (int j = 0; j < columns; j++)
        {
            int k = (j + 1) % columns;
            corners.AddRange([0, At(1, j), At(1, k), 1, At(rows - 1, k), At(rows - 1, j)]);
            for (int i = 1; i < rows - 1; i++)
                corners.AddRange([At(i, j), At(i + 1, j), At(i + 1, k), At(i, j), At(i + 1, k), At(i, k)]);
        }
        return MeshBuilder.FromTriangles(positions.ToArray(), corners.ToArray());

        int At(int row, int column) => 2 + (row - 1) * columns + column;
    }

    private static IEnumerable<double> Heights(Mesh mesh) => mesh.Vertices.Select(v => v.Position.Z);

    private static double Coverage(Image image) => Pixels(image).Sum(color => (double)color.A);

    private static IEnumerable<Color> Pixels(Image image)
    {
        for (int y = 0; y < image.Height; y++)
        {
            for (int x = 0; x < image.Width; x++)
                yield return image[x, y];
        }
    }
}
