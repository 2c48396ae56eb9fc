using System.Globalization;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>How an axis is divided.</summary>
public enum AxisScale
{
    /// <summary>Equal steps are equal differences.</summary>
    Linear,

    /// <summary>Equal steps are equal ratios; only positive values can be shown.</summary>
    Logarithmic,
}

/// <summary>How a series is drawn.</summary>
public enum SeriesStyle
{
    /// <summary>A line through the points.</summary>
    Line,

    /// <summary>A line with a dot at each point.</summary>
    LineWithPoints,

    /// <summary>Dots only.</summary>
    Points,

    /// <summary>A dashed line, for references such as a slope.</summary>
    Dashed,
}

/// <summary>One row of points of a chart.</summary>
/// <param name="Name">Its name in the legend; empty for no entry.</param>
/// <param name="X">First coordinates.</param>
/// <param name="Y">Second coordinates, as many.</param>
/// <param name="Style">How it is drawn.</param>
public sealed record ChartSeries(string Name, IReadOnlyList<double> X, IReadOnlyList<double> Y, SeriesStyle Style = SeriesStyle.LineWithPoints)
{
    /// <summary>Its colour; the next of <see cref="Palette"/> if none is given.</summary>
    public Color? Color { get; init; }
}

/// <summary>
/// A chart as SVG: lines and points over linear or logarithmic axes, or bars. Texts and axes take the colour of the page's text,
/// so a chart fits light and dark pages.
/// </summary>
public sealed record SvgChart
{
    private const double Left = 72, Right = 18, Bottom = 50;

    private const string Faint = "stroke=\"currentColor\" stroke-opacity=\"0.13\"";
    private const string Axis = "stroke=\"currentColor\" stroke-opacity=\"0.55\"";
    private const string Small = "font-size=\"12\" fill=\"currentColor\"";

    /// <summary>The title over the chart.</summary>
    public string Title { get; init; } = "";

    /// <summary>The title of the horizontal axis, with the unit.</summary>
    public string XLabel { get; init; } = "";

    /// <summary>The title of the vertical axis, with the unit.</summary>
    public string YLabel { get; init; } = "";

    /// <summary>How the horizontal axis is divided.</summary>
    public AxisScale XScale { get; init; }

    /// <summary>How the vertical axis is divided.</summary>
    public AxisScale YScale { get; init; }

    /// <summary>Width in units of SVG, at least 200.</summary>
    public int Width { get; init => field = AtLeast(value, 200); } = 640;

    /// <summary>Height in units of SVG, at least 150.</summary>
    public int Height { get; init => field = AtLeast(value, 150); } = 400;

    /// <summary>The rows of points.</summary>
    public IReadOnlyList<ChartSeries> Series { get; init; } = [];

    /// <summary>Bars; a chart has either bars or series.</summary>
    public IReadOnlyList<ChartBar> Bars { get; init; } = [];

    /// <summary>A chart of bars with names (柱状图).</summary>
    public static SvgChart BarChart(string title, IReadOnlyList<string> names, IReadOnlyList<double> values, string yLabel = "")
    {
        ArgumentNullException.ThrowIfNull(names);
        ArgumentNullException.ThrowIfNull(values);
        if (names.Count != values.Count)
            throw new ArgumentException($"There are {names.Count} names but {values.Count} values.", nameof(values));
        return new() { Title = title, YLabel = yLabel, Bars = [.. names.Select((name, i) => new ChartBar(name, values[i]))] };
    }

    /// <summary>A histogram (直方图): how many of the finite values fall into each of equal parts of their range.</summary>
    /// <param name="title">The title.</param>
    /// <param name="values">The values; those that are not finite are counted in the note below.</param>
    /// <param name="bins">How many parts.</param>
    /// <param name="xLabel">What the values are.</param>
    public static SvgChart Histogram(string title, IReadOnlyList<double> values, int bins = 30, string xLabel = "")
    {
        ArgumentNullException.ThrowIfNull(values);
        ArgumentOutOfRangeException.ThrowIfLessThan(bins, 1);
        double[] finite = [.. values.Where(double.IsFinite)];
        var (low, high) = finite.Length == 0 ? (0, 1) : NiceTicks.Widen(finite.Min(), finite.Max());
        var counts = new int[bins];
        foreach (double value in finite)
            counts[Math.Clamp((int)((value - low) / (high - low) * bins), 0, bins - 1)]++;
        var bars = counts.Select((count, i) => new ChartBar("", count) { From = low + (high - low) * i / bins, To = low + (high - low) * (i + 1) / bins });
        return new() { Title = title, XLabel = xLabel, YLabel = "count", Bars = [.. bars], LeftOut = values.Count - finite.Length };
    }

    /// <summary>How many values were left out because they are not finite.</summary>
    public int LeftOut { get; private init; }

    /// <summary>The chart as one <c>svg</c> element.</summary>
    /// <exception cref="ArgumentException">A series has different numbers of X and Y.</exception>
    public string ToSvg()
    {
        foreach (ChartSeries series in Series)
        {
            if (series.X.Count != series.Y.Count)
                throw new ArgumentException($"Series '{series.Name}' has {series.X.Count} X but {series.Y.Count} Y.");
        }
        var svg = new SvgWriter();
        svg.Raw($"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {Width} {Height}" width="{Width}" height="{Height}" role="img" font-family="system-ui,'Segoe UI','Noto Sans CJK SC','PingFang SC','Microsoft YaHei',sans-serif">""");
        if (Title.Length > 0)
            svg.Raw($"<title>{SvgWriter.Escape(Title)}</title>");
        svg.Text(Left, 24, Title, "font-size=\"15\" font-weight=\"600\" fill=\"currentColor\"");
        if (Bars.Count > 0)
            DrawBars(svg);
        else
            DrawSeries(svg);
        svg.Raw("</svg>");
        return svg.ToString();
    }

    /// <summary>Writes the chart as a file; folders on the way are made.</summary>
    public void Save(string path) => TextFile.Save(path, ToSvg());

    private void DrawSeries(SvgWriter svg)
    {
        var named = Series.Select((series, i) => (series.Name, Color: series.Color ?? Palette.Categorical(i), Dashed: series.Style == SeriesStyle.Dashed)).Where(s => s.Name.Length > 0).ToList();
        double top = DrawLegend(svg, named);
        ChartAxis x = ChartAxis.Fit(Series.SelectMany(s => s.X), XScale, Left, Width - Right);
        ChartAxis y = ChartAxis.Fit(Series.SelectMany(s => s.Y), YScale, Height - Bottom, top);
        DrawFrame(svg, y, top);
        DrawTicks(svg, x, top);
        int leftOut = 0;
        for (int i = 0; i < Series.Count; i++)
            leftOut += DrawOne(svg, Series[i], SvgWriter.Css(Series[i].Color ?? Palette.Categorical(i)), x, y);
        Note(svg, leftOut);
    }

    private static int DrawOne(SvgWriter svg, ChartSeries series, string color, ChartAxis x, ChartAxis y)
    {
        int leftOut = 0;
        var path = new StringBuilder();
        var dots = new StringBuilder();
        bool pen = false;
        for (int i = 0; i < series.X.Count; i++)
        {
            if (!x.CanShow(series.X[i]) || !y.CanShow(series.Y[i]))
            {
                leftOut++;
                pen = false;
                continue;
            }
            string px = SvgWriter.Number(x.Place(series.X[i])), py = SvgWriter.Number(y.Place(series.Y[i]));
            path.Append(pen ? 'L' : 'M').Append(px).Append(' ').Append(py);
            dots.Append(CultureInfo.InvariantCulture, $"""<circle cx="{px}" cy="{py}" r="3"/>""");
            pen = true;
        }
        if (series.Style != SeriesStyle.Points)
        {
            string dash = series.Style == SeriesStyle.Dashed ? " stroke-dasharray=\"6 5\"" : "";
            svg.Raw($"""<path d="{path}" fill="none" stroke="{color}" stroke-width="2" stroke-linejoin="round" stroke-linecap="round"{dash}/>""");
        }
        if (series.Style is SeriesStyle.Points or SeriesStyle.LineWithPoints)
            svg.Raw($"""<g fill="{color}">{dots}</g>""");
        return leftOut;
    }

    private void DrawBars(SvgWriter svg)
    {
        const double top = 40;
        bool ranges = Bars[0].From is not null;
        double[] finite = [.. Bars.Select(bar => bar.Value).Where(double.IsFinite), 0];
        ChartAxis y = ChartAxis.Fit(finite, AxisScale.Linear, Height - Bottom, top);
        DrawFrame(svg, y, top);
        double zero = y.Place(0), width = (Width - Right - Left) / Bars.Count;
        ChartAxis? x = ranges ? ChartAxis.Exact(Bars[0].From!.Value, Bars[^1].To!.Value, Left, Width - Right) : null;
        int every = Math.Max(1, (int)Math.Ceiling(Bars.Max(bar => TextWidth(bar.Name)) / Math.Max(width - 4, 1)));
        for (int i = 0; i < Bars.Count; i++)
        {
            double value = double.IsFinite(Bars[i].Value) ? Bars[i].Value : 0, end = y.Place(value);
            double gap = ranges ? Math.Min(1, width * 0.1) : width * 0.2;
            string color = SvgWriter.Css(Bars[i].Color ?? Palette.Categorical(0));
            svg.Raw($"""<rect x="{SvgWriter.Number(Left + i * width + gap / 2)}" y="{SvgWriter.Number(Math.Min(zero, end))}" width="{SvgWriter.Number(width - gap)}" height="{SvgWriter.Number(Math.Abs(end - zero))}" fill="{color}"><title>{SvgWriter.Escape(Bars[i].ToolTip)}</title></rect>""");
            if (!ranges && i % every == 0)
                svg.Text(Left + (i + 0.5) * width, Height - Bottom + 18, Bars[i].Name, Small + " text-anchor=\"middle\"");
        }
        svg.Line(Left, zero, Width - Right, zero, Axis);
        if (x is { } axis)
            DrawTicks(svg, axis, top, grid: false);
        Note(svg, LeftOut + Bars.Count(bar => !double.IsFinite(bar.Value)));
    }

    private double DrawLegend(SvgWriter svg, List<(string Name, Color Color, bool Dashed)> named)
    {
        double at = Left, row = 44;
        if (named.Count == 0)
            return 40;
        foreach (var (name, color, dashed) in named)
        {
            double width = 34 + TextWidth(name);
            if (at > Left && at + width > Width - Right)
            {
                at = Left;
                row += 18;
            }
            svg.Line(at, row - 4, at + 18, row - 4, $"stroke=\"{SvgWriter.Css(color)}\" stroke-width=\"3\"{(dashed ? " stroke-dasharray=\"5 3\"" : " stroke-linecap=\"round\"")}");
            svg.Text(at + 24, row, name, Small);
            at += width + 8;
        }
        return row + 14;
    }

    private void DrawFrame(SvgWriter svg, ChartAxis y, double top)
    {
        string[] texts = y.TickTexts;
        for (int i = 0; i < y.Ticks.Length; i++)
        {
            double at = y.Place(y.Ticks[i]);
            svg.Line(Left, at, Width - Right, at, Faint);
            svg.Text(Left - 8, at + 4, texts[i], Small + " text-anchor=\"end\"");
        }
        svg.Line(Left, top, Left, Height - Bottom, Axis);
        svg.Line(Left, Height - Bottom, Width - Right, Height - Bottom, Axis);
        if (YLabel.Length > 0)
            svg.Text(0, 0, YLabel, Small + $" text-anchor=\"middle\" transform=\"translate(16 {SvgWriter.Number((top + Height - Bottom) / 2)}) rotate(-90)\"");
        if (XLabel.Length > 0)
            svg.Text((Left + Width - Right) / 2, Height - 12, XLabel, Small + " text-anchor=\"middle\"");
    }

    private void DrawTicks(SvgWriter svg, ChartAxis x, double top, bool grid = true)
    {
        string[] texts = x.TickTexts;
        for (int i = 0; i < x.Ticks.Length; i++)
        {
            double at = x.Place(x.Ticks[i]);
            if (grid)
                svg.Line(at, top, at, Height - Bottom, Faint);
            else
                svg.Line(at, Height - Bottom, at, Height - Bottom + 4, Axis);
            svg.Text(at, Height - Bottom + 18, texts[i], Small + " text-anchor=\"middle\"");
        }
    }

    private void Note(SvgWriter svg, int leftOut)
    {
        if (leftOut > 0)
            svg.Text(Width - Right, Height - 12, $"{leftOut} without a place on the axes", "font-size=\"11\" fill=\"currentColor\" fill-opacity=\"0.7\" text-anchor=\"end\"");
    }

    // An estimate: Chinese signs are about as wide as high, Latin letters half as wide.
    private static double TextWidth(string text) => text.Sum(c => c > 0x2E7F ? 12.5 : 6.7);

    private static int AtLeast(int value, int least) =>
        value >= least ? value : throw new ArgumentOutOfRangeException(nameof(value), value, $"The size must be at least {least}.");
}

/// <summary>One bar of a chart.</summary>
/// <param name="Name">What stands below it.</param>
/// <param name="Value">Its height.</param>
public sealed record ChartBar(string Name, double Value)
{
    /// <summary>Its colour; the first of <see cref="Palette"/> if none is given.</summary>
    public Color? Color { get; init; }

    /// <summary>The lower end of a histogram's part.</summary>
    public double? From { get; init; }

    /// <summary>The upper end of a histogram's part.</summary>
    public double? To { get; init; }

    internal string ToolTip => From is { } from && To is { } to
        ? $"{NiceTicks.Format(from)} – {NiceTicks.Format(to)}: {NiceTicks.Format(Value)}"
        : $"{Name}: {NiceTicks.Format(Value)}";
}
