using System.Globalization;
using System.Xml.Linq;
using MeshLab.Numerics;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

[Trait("Section", "pictures")]
public class SvgChartTests
{
    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    [Fact]
    public void ToSvg_TwoSeriesOnLogarithmicAxes_HasPathsDotsAndLegend()
    {
        var chart = new SvgChart
        {
            Title = "a < b & c",
            XScale = AxisScale.Logarithmic,
            YScale = AxisScale.Logarithmic,
            Series = [new("first", [0.001, 0.01, 0.1], [1e-6, 1e-4, 1e-2]), new("slope 2", [0.001, 0.1], [1e-6, 1e-2], SeriesStyle.Dashed)],
        };

        XElement svg = XElement.Parse(chart.ToSvg());

        Assert.Equal(2, svg.Elements(Svg + "path").Count());
        Assert.Equal(3, svg.Descendants(Svg + "circle").Count());
        string[] texts = [.. svg.Elements(Svg + "text").Select(text => text.Value)];
        Assert.Contains("a < b & c", texts, StringComparer.Ordinal);
        Assert.Contains("first", texts, StringComparer.Ordinal);
        Assert.Contains("slope 2", texts, StringComparer.Ordinal);
        Assert.Contains("10⁻⁴", texts, StringComparer.Ordinal);
    }

    [Fact]
    public void ToSvg_StraightLineOnLogarithmicAxes_IsStraight()
    {
        var chart = new SvgChart { XScale = AxisScale.Logarithmic, YScale = AxisScale.Logarithmic, Series = [new("", [1, 10, 100], [1, 100, 10000])] };
        double[][] dots = [.. XElement.Parse(chart.ToSvg()).Descendants(Svg + "circle").Select(c => new[] { Number(c, "cx"), Number(c, "cy") })];
        Assert.Equal(dots[1][0] - dots[0][0], dots[2][0] - dots[1][0], 1);
        Assert.Equal(dots[1][1] - dots[0][1], dots[2][1] - dots[1][1], 1);
        Assert.True(dots[2][1] < dots[0][1]);
    }

    [Fact]
    public void ToSvg_ValuesWithoutPlace_AreCountedInANote()
    {
        var chart = new SvgChart { YScale = AxisScale.Logarithmic, Series = [new("", [1, 2, 3, 4], [1, double.NaN, -5, 10])] };
        Assert.Contains("2 without a place", chart.ToSvg(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("de-DE")]
    [InlineData("tr-TR")]
    public void ToSvg_OtherCulture_GivesTheSameText(string culture)
    {
        var chart = new SvgChart { Title = "i", Series = [new("s", [0.5, 1.25], [1.5, 2.75])] };
        string expected = chart.ToSvg(), html = Page();
        CultureInfo before = CultureInfo.CurrentCulture;
        CultureInfo.CurrentCulture = CultureInfo.GetCultureInfo(culture);
        try
        {
            Assert.Equal(expected, chart.ToSvg());
            Assert.Equal(html, Page());
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }

        static string Page() => HtmlViewer.ToHtml(Models.Create("cube"), new() { Coloring = Coloring.VertexScalars([.. Enumerable.Range(0, 8).Select(i => i / 8.0)], title: "t") });
    }

    [Fact]
    public void Histogram_Values_AreAllCounted()
    {
        SvgChart chart = SvgChart.Histogram("h", [0, 0.1, 0.5, 1, double.NaN], bins: 4);
        Assert.Equal(4, chart.Bars.Sum(bar => bar.Value));
        Assert.Equal(1, chart.LeftOut);
        Assert.Equal(4, XElement.Parse(chart.ToSvg()).Elements(Svg + "rect").Count());
    }

    [Fact]
    public void BarChart_Heights_AreProportional()
    {
        XElement svg = XElement.Parse(SvgChart.BarChart("b", ["x", "y"], [10, 20]).ToSvg());
        double[] heights = [.. svg.Elements(Svg + "rect").Select(rect => Number(rect, "height"))];
        Assert.Equal(2 * heights[0], heights[1], 1);
    }

    [Fact]
    public void Chart_BadInput_Throws()
    {
        Assert.Throws<ArgumentException>(() => new SvgChart { Series = [new("s", [1], [1, 2])] }.ToSvg());
        Assert.Throws<ArgumentException>(() => SvgChart.BarChart("b", ["x"], [1, 2]));
        Assert.Throws<ArgumentOutOfRangeException>(() => SvgChart.Histogram("h", [1], bins: 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SvgChart { Width = 0 });
        XElement.Parse(new SvgChart().ToSvg());
        XElement.Parse(SvgChart.Histogram("nothing", []).ToSvg());
    }

    [Fact]
    public void Polylines_SquareInSquare_FitTheViewAndFillEvenOdd()
    {
        Vector2D[] outer = [new(-10, -10), new(10, -10), new(10, 10), new(-10, 10)], inner = [new(-5, -5), new(5, -5), new(5, 5), new(-5, 5)];
        XElement svg = XElement.Parse(new SvgPolylines { Size = 232, Unit = "mm" }.ToSvg([outer, inner]));
        XElement path = svg.Element(Svg + "path")!;
        Assert.Equal("evenodd", path.Attribute("fill-rule")!.Value);
        Assert.Equal("M16 216L216 216L216 16L16 16ZM66 166L166 166L166 66L66 66Z", path.Attribute("d")!.Value);
        Assert.Equal("5 mm", svg.Element(Svg + "text")!.Value);
        XElement.Parse(new SvgPolylines().ToSvg([]));
        Assert.Throws<ArgumentException>(() => new SvgPolylines().ToSvg([[new(double.NaN, 0)]]));
    }

    [Fact]
    public void ToPlane_HorizontalPlane_KeepsDistancesAndOrientation()
    {
        Vector2D[] flat = SvgPolylines.ToPlane([new(0, 0, 5), new(1, 0, 5), new(0, 2, 5)], new(0, 0, 5), new(0, 0, 3));
        Assert.Equal([new(0, 0), new(1, 0), new(0, 2)], flat);
        Assert.Throws<ArgumentException>(() => SvgPolylines.ToPlane([], default, default));
    }

    [Theory]
    [InlineData(0, 1, new[] { "0.0", "0.2", "0.4", "0.6", "0.8", "1.0" })]
    [InlineData(-0.3, 0.3, new[] { "-0.3", "-0.2", "-0.1", "0.0", "0.1", "0.2", "0.3" })]
    [InlineData(0, 2500, new[] { "0", "500", "1000", "1500", "2000", "2500" })]
    [InlineData(0, 5e6, new[] { "0", "1e6", "2e6", "3e6", "4e6", "5e6" })]
    public void Ticks_Range_AreRoundNumbers(double low, double high, string[] expected) =>
        Assert.Equal(expected, NiceTicks.Format(NiceTicks.Linear(low, high)));

    private static double Number(XElement element, string attribute) => double.Parse(element.Attribute(attribute)!.Value, CultureInfo.InvariantCulture);
}
