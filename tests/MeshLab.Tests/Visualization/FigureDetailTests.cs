using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

/// <summary>What makes a figure readable: titles and labels, the right colours, sharp edges, files on the disk.</summary>
[Trait("Section", "pictures")]
public sealed class FigureDetailTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("figures").FullName;

    private static readonly RenderOptions Plain = new()
    {
        Width = 240,
        Height = 170,
        Background = new Color(0, 0, 0, 0),
        GroundShadow = false,
        AmbientOcclusion = false,
        Supersampling = 2,
        View = new(0, 0),
    };

    public void Dispose() => Directory.Delete(folder, true);

    [Fact]
    public void Render_FaceLabels_HaveThePalettesColors()
    {
        // Two squares side by side, facing the viewer.
        Mesh mesh = MeshBuilder.FromPolygons([new(-1, 0, 0), new(0, 0, 0), new(1, 0, 0), new(1, 0, 1), new(0, 0, 1), new(-1, 0, 1)], [[0, 1, 4, 5], [1, 2, 3, 4]]);
        Image image = MeshRenderer.Render(mesh, Plain with { Shading = Shading.None, Legend = false, Coloring = Coloring.FaceLabels([7, 2]) });
        Near(Palette.Categorical(7), image[80, 85]);
        Near(Palette.Categorical(2), image[160, 85]);
    }

    [Fact]
    public void Render_LegendTitleAndLabels_LeaveInk()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 0, 1)], [0, 1, 2]);
        RenderOptions options = Plain with { Shading = Shading.None, Width = 400 };
        Coloring plain = Coloring.VertexScalars([0, 1, 2], title: " "), titled = Coloring.VertexScalars([0, 1, 2], title: "mmm");
        Assert.True(Differences(options with { Coloring = plain }, options with { Coloring = titled }) > 20);
        Assert.True(Differences(options, options with { Labels = [new TextLabel(new(0.3, 0, 0.3), "v12", new Color(0, 0, 0))] }) > 20);
        Assert.True(Differences(options, options with { Title = "Figure" }) > 20);

        int Differences(RenderOptions one, RenderOptions other)
        {
            Image a = MeshRenderer.Render(mesh, one), b = MeshRenderer.Render(mesh, other);
            int count = 0;
            for (int y = 0; y < a.Height; y++)
            {
                for (int x = 0; x < a.Width; x++)
                    count += a[x, y] == b[x, y] ? 0 : 1;
            }
            return count;
        }
    }

    [Fact]
    public void Render_SmoothShading_KeepsSharpEdgesAndRoundsTheRest()
    {
        RenderOptions smooth = Plain with { View = new(30, 20) }, flat = smooth with { Shading = Shading.Flat };
        Mesh ball = Spheres.Icosphere(1);
        double cube = MeanDifference(Polyhedra.Cube(), smooth, flat), round = MeanDifference(ball, smooth with { CreaseAngle = 80 }, flat);
        double sharp = MeanDifference(ball, smooth with { CreaseAngle = 1 }, flat);
        Assert.True(cube < 1e-3 && sharp < 1e-3 && round > 5 * Math.Max(cube, sharp) && round > 1e-3, $"{cube} {sharp} {round}");

        static double MeanDifference(Mesh mesh, RenderOptions one, RenderOptions other)
        {
            Image a = MeshRenderer.Render(mesh, one), b = MeshRenderer.Render(mesh, other);
            double sum = 0;
            for (int y = 0; y < a.Height; y++)
            {
                for (int x = 0; x < a.Width; x++)
                    sum += Math.Abs(a[x, y].G - b[x, y].G);
            }
            return sum / (a.Width * a.Height);
        }
    }

    /// <summary>The drawing is done in bands of rows; the last may be shorter.</summary>
    [Theory]
    [InlineData(160)]
    [InlineData(161)]
    [InlineData(175)]
    public void Render_AnyHeight_DrawsLinesDownToTheLastRow(int height)
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1)], [0, 1, 2]);
        Image image = MeshRenderer.Render(mesh, Plain with { Height = height, Surface = false, Wireframe = true, WireframeWidth = 4 });
        int last = Enumerable.Range(0, height).Last(y => Enumerable.Range(0, image.Width).Any(x => image[x, y].A > 0.2));
        // The margin is six hundredths of the shorter side; the lower edge lies on it.
        Assert.InRange(last, height - 0.06 * height - 4, height - 0.06 * height + 4);
    }

    [Fact]
    public void SideBySide_Pictures_StandInOrderWithMiddlesAligned()
    {
        Image red = new(4, 6, new Color(1, 0, 0)), blue = new(3, 2, new Color(0, 0, 1));
        Image both = Image.SideBySide(red, blue);
        Assert.Equal((7, 6), (both.Width, both.Height));
        Assert.Equal(new Color(1, 0, 0), both[3, 0]);
        Assert.Equal(Color.White, both[4, 0]);
        Assert.Equal(new Color(0, 0, 1), both[4, 2]);
        Assert.Equal(new Color(0, 0, 1), both[6, 3]);
        Assert.Equal(Color.White, both[6, 4]);
    }

    [Fact]
    public void WithoutOutliers_UnsortedValues_LeavesOutBothEnds()
    {
        double[] values = [.. Enumerable.Range(0, 101).Select(i => (double)(i * 37 % 101))];
        (values[3], values[50]) = (1e6, -1e6);
        Coloring coloring = Coloring.VertexScalars(values).WithoutOutliers(0.05);
        Assert.InRange(coloring.Minimum, 0, 10);
        Assert.InRange(coloring.Maximum, 90, 101);
    }

    [Fact]
    public void Save_PageAndViewer_AreWholeFilesInNewFolders()
    {
        string page = Path.Combine(folder, "new", "index.html"), viewer = Path.Combine(folder, "new", "model.html");
        var html = new HtmlPage("title");
        html.AddSection("1.1", "节", "Section").AddText("text");
        html.Save(page);
        Assert.Equal(html.ToHtml(), File.ReadAllText(page));

        Mesh mesh = Polyhedra.Tetrahedron();
        HtmlViewer.Save(viewer, mesh, new RenderOptions { Coloring = Coloring.VertexScalars([1, 2, 3, double.NaN], title: "height") }, "model", embedded: true);
        Assert.Contains("no value (1)", File.ReadAllText(viewer), StringComparison.Ordinal);
    }

    private static void Near(Color expected, Color found)
    {
        Assert.InRange(found.R, expected.R - 0.01, expected.R + 0.01);
        Assert.InRange(found.G, expected.G - 0.01, expected.G + 0.01);
        Assert.InRange(found.B, expected.B - 0.01, expected.B + 0.01);
    }
}
