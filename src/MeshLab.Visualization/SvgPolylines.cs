using System.Text;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// Chains of points of a plane as SVG, such as the section of a mesh (截面线): the view fits them, closed chains are filled by the even-odd rule,
/// so that an outline within an outline is a hole.
/// </summary>
public sealed record SvgPolylines
{
    /// <summary>The longer side of the picture in units of SVG, at least 50.</summary>
    public int Size { get; init => field = value >= 50 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The size must be at least 50."); } = 480;

    /// <summary>What closed chains are filled with; nothing if null.</summary>
    public Color? Fill { get; init; } = new Color(0.30f, 0.47f, 0.78f, 0.25f);

    /// <summary>The lines' colour.</summary>
    public Color Stroke { get; init; } = new(0.16f, 0.32f, 0.64f);

    /// <summary>The lines' width in units of the picture.</summary>
    public double StrokeWidth { get; init; } = 1.6;

    /// <summary>Whether a scale of a round length is drawn below.</summary>
    public bool Scale { get; init; } = true;

    /// <summary>The unit written at the scale.</summary>
    public string Unit { get; init; } = "";

    /// <summary>The chains as one <c>svg</c> element, second coordinate upward.</summary>
    /// <param name="closed">Closed chains; the last point is joined to the first.</param>
    /// <param name="open">Open chains.</param>
    /// <exception cref="ArgumentException">A coordinate is not finite.</exception>
    public string ToSvg(IReadOnlyList<IReadOnlyList<Vector2D>> closed, IReadOnlyList<IReadOnlyList<Vector2D>>? open = null)
    {
        ArgumentNullException.ThrowIfNull(closed);
        open ??= [];
        var (low, high) = Bounds(closed.Concat(open));
        double width = high.X - low.X, height = high.Y - low.Y, largest = Math.Max(width, height);
        const double margin = 16;
        double scale = largest > 0 ? (Size - 2 * margin) / largest : 1;
        double w = Math.Max(width * scale, 1) + 2 * margin, h = Math.Max(height * scale, 1) + 2 * margin, below = Scale && largest > 0 ? 28 : 0;

        var svg = new SvgWriter();
        svg.Raw($"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {SvgWriter.Number(w)} {SvgWriter.Number(h + below)}" width="{SvgWriter.Number(w)}" height="{SvgWriter.Number(h + below)}" role="img" font-family="system-ui,sans-serif">""");
        string style = $"stroke=\"{SvgWriter.Css(Stroke)}\" stroke-width=\"{SvgWriter.Number(StrokeWidth)}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
        if (closed.Count > 0)
            svg.Raw($"""<path d="{Data(closed, "Z")}" fill="{(Fill is { } fill ? SvgWriter.Css(fill) : "none")}" fill-rule="evenodd" {style}/>""");
        if (open.Count > 0)
            svg.Raw($"""<path d="{Data(open, "")}" fill="none" {style}/>""");
        if (below > 0)
            DrawScale(svg, margin, h + 8, largest, scale);
        svg.Raw("</svg>");
        return svg.ToString();

        string Data(IReadOnlyList<IReadOnlyList<Vector2D>> chains, string end)
        {
            var data = new StringBuilder();
            foreach (IReadOnlyList<Vector2D> chain in chains)
            {
                for (int i = 0; i < chain.Count; i++)
                {
                    data.Append(i == 0 ? 'M' : 'L').Append(SvgWriter.Number(margin + (chain[i].X - low.X) * scale));
                    data.Append(' ').Append(SvgWriter.Number(margin + (high.Y - chain[i].Y) * scale));
                }
                if (chain.Count > 0)
                    data.Append(end);
            }
            return data.ToString();
        }
    }

    /// <summary>Coordinates of points of space in the plane through an origin: seen from where the normal points.</summary>
    /// <param name="points">The points, taken along the normal onto the plane.</param>
    /// <param name="origin">Becomes (0, 0).</param>
    /// <param name="normal">The plane's normal, of any length above 0.</param>
    public static Vector2D[] ToPlane(IReadOnlyList<Vector3D> points, Vector3D origin, Vector3D normal)
    {
        ArgumentNullException.ThrowIfNull(points);
        Vector3D n = normal.Normalized();
        if (n == Vector3D.Zero)
            throw new ArgumentException("The normal must be finite and not zero.", nameof(normal));
        // The first axis is horizontal (z up) unless the plane is: pictures of sections then stand upright.
        Vector3D u = Math.Abs(n.Z) > 0.99 ? (Vector3D.UnitX - n * n.X).Normalized() : Vector3D.Cross(Vector3D.UnitZ, n).Normalized();
        Vector3D v = Vector3D.Cross(n, u);
        return [.. points.Select(p => new Vector2D(Vector3D.Dot(p - origin, u), Vector3D.Dot(p - origin, v)))];
    }

    private void DrawScale(SvgWriter svg, double x, double y, double largest, double scale)
    {
        double length = NiceTicks.Linear(0, largest, 4) is [_, var step, ..] ? step : largest;
        string text = NiceTicks.Format(length) + (Unit.Length > 0 ? " " + Unit : "");
        svg.Raw($"""<path d="M{SvgWriter.Number(x)} {SvgWriter.Number(y - 4)}v4h{SvgWriter.Number(length * scale)}v-4" fill="none" stroke="currentColor" stroke-width="1.2"/>""");
        svg.Text(x + length * scale + 8, y + 1, text, "font-size=\"12\" fill=\"currentColor\"");
    }

    private static (Vector2D Low, Vector2D High) Bounds(IEnumerable<IReadOnlyList<Vector2D>> chains)
    {
        double x0 = double.PositiveInfinity, y0 = x0, x1 = double.NegativeInfinity, y1 = x1;
        foreach (Vector2D p in chains.SelectMany(chain => chain))
        {
            if (!double.IsFinite(p.X) || !double.IsFinite(p.Y))
                throw new ArgumentException($"The point {p} is not finite.", nameof(chains));
            (x0, x1) = (Math.Min(x0, p.X), Math.Max(x1, p.X));
            (y0, y1) = (Math.Min(y0, p.Y), Math.Max(y1, p.Y));
        }
        return x0 <= x1 ? (new(x0, y0), new(x1, y1)) : (default, default);
    }
}
