using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Visualization;

/// <summary>
/// A turnable model as one HTML file: orbit, shift, zoom, edges, flat or smooth shading, legend. It needs a browser with WebGL 2 and nothing else,
/// neither a network nor a server. Places are kept to 1/65535 of the model's box, which the eye cannot tell.
/// </summary>
public static class HtmlViewer
{
    /// <summary>The page.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="options">
    /// Colours, first view, lines and marks, as for a picture; sizes are in pixels of the page. Isolines, labels, shadow and background are left out.
    /// </param>
    /// <param name="title">The title.</param>
    /// <param name="embedded">Whether the page is meant for an <c>iframe</c>: without its heading.</param>
    /// <exception cref="ArgumentException">As <see cref="MeshRenderer.Render(Mesh, RenderOptions?)"/>.</exception>
    public static string ToHtml(Mesh mesh, RenderOptions? options = null, string title = "MeshLab", bool embedded = false)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(title);
        string counts = string.Create(CultureInfo.InvariantCulture, $"{mesh.Vertices.Count:N0} vertices 顶点 · {mesh.Edges.Count:N0} edges 边 · {mesh.Faces.Count:N0} faces 面");
        return ToHtml(RenderGeometry.FromMesh(mesh), options ?? new(), title, counts, embedded);
    }

    /// <summary>Writes the page as a file; folders on the way are made.</summary>
    /// <param name="path">The file.</param>
    /// <param name="mesh">The mesh.</param>
    /// <param name="options">As for <see cref="ToHtml(Mesh, RenderOptions?, string, bool)"/>.</param>
    /// <param name="title">The title.</param>
    /// <param name="embedded">Whether the page is meant for an <c>iframe</c>.</param>
    public static void Save(string path, Mesh mesh, RenderOptions? options = null, string title = "MeshLab", bool embedded = false) =>
        TextFile.Save(path, ToHtml(mesh, options, title, embedded));

    internal static string ToHtml(RenderGeometry geometry, RenderOptions options, string title, string subtitle, bool embedded)
    {
        geometry.CheckFor(options);
        var packed = new ViewerGeometry(geometry, options);
        var parts = new Dictionary<string, string>(StringComparer.Ordinal)
        {
            ["title"] = SvgWriter.Escape(title),
            ["subtitle"] = SvgWriter.Escape(subtitle),
            ["class"] = embedded ? "embedded" : "",
            ["legend"] = options.Legend ? LegendHtml(options.Coloring) : "",
            ["scene"] = Scene(geometry, options, packed).ToJsonString(),
            ["geometry"] = Convert.ToBase64String(packed.Packed),
        };
        return Fill(Template(), parts);
    }

    private static JsonObject Scene(RenderGeometry geometry, RenderOptions options, ViewerGeometry packed)
    {
        BoundingBox box = packed.Box;
        double radius = 0;
        foreach (int v in geometry.LiveVertices)
            radius = Math.Max(radius, Vector3D.Distance(geometry.Positions[v], box.Center));
        return new()
        {
            ["vertices"] = packed.VertexCount,
            ["triangles"] = geometry.TriangleCount,
            ["edges"] = packed.EdgeCount,
            ["lines"] = packed.LineCount,
            ["marks"] = packed.MarkCount,
            ["low"] = Numbers(box.Min.X, box.Min.Y, box.Min.Z),
            ["size"] = Numbers(box.Size.X, box.Size.Y, box.Size.Z),
            ["center"] = Numbers(box.Center.X, box.Center.Y, box.Center.Z),
            ["radius"] = radius > 0 ? radius : 1,
            ["edgeLength"] = MedianEdge(geometry),
            ["azimuth"] = options.View.Azimuth,
            ["elevation"] = options.View.Elevation,
            ["yUp"] = options.View.Up == UpAxis.Y,
            ["surface"] = options.Surface,
            ["wire"] = options.Wireframe,
            ["flat"] = options.Shading == Shading.Flat,
            ["unlit"] = options.Shading == Shading.None,
            ["gloss"] = options.Coloring.Kind == ColoringKind.Uniform ? 0.16 : 0.05,
            ["back"] = Numbers(options.BackFaceColor.R, options.BackFaceColor.G, options.BackFaceColor.B),
            ["wireColor"] = Numbers(options.WireframeColor.R, options.WireframeColor.G, options.WireframeColor.B, options.WireframeColor.A),
            ["ramp"] = Convert.ToBase64String(Ramp(options.Coloring.Map)),
        };
    }

    // Of at most a thousand edges spread over all.
    private static double MedianEdge(RenderGeometry g)
    {
        int count = g.Edges.Length / 2, stride = Math.Max(1, count / 1000);
        var lengths = new List<double>();
        for (int e = 0; e < count; e += stride)
        {
            if (g.Edges[2 * e] >= 0)
                lengths.Add(Vector3D.Distance(g.Positions[g.Edges[2 * e]], g.Positions[g.Edges[2 * e + 1]]));
        }
        lengths.Sort();
        return lengths.Count == 0 ? 0 : lengths[lengths.Count / 2];
    }

    private static JsonArray Numbers(params double[] values) => [.. values.Select(value => (JsonNode)value)];

    private static byte[] Ramp(ColorMap map)
    {
        var bytes = new byte[4 * 256];
        for (int i = 0; i < 256; i++)
        {
            Color color = map.Sample(i / 255.0);
            (bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3]) = (Image.ToByte(color.R), Image.ToByte(color.G), Image.ToByte(color.B), 255);
        }
        return bytes;
    }

    private static string LegendHtml(Coloring coloring)
    {
        if (coloring.Title.Length == 0)
            return "";
        var html = new StringBuilder();
        html.Append("<div class=\"legend\"><h2>").Append(SvgWriter.Escape(Legend.Title(coloring))).Append("</h2>");
        if (coloring.Values is not null)
        {
            string stops = string.Join(',', Enumerable.Range(0, 17).Select(i => SvgWriter.Css(coloring.Map.Sample(i / 16.0))));
            html.Append(CultureInfo.InvariantCulture, $"<div class=\"ramp\" style=\"background:linear-gradient(to top,{stops})\">");
            double[] ticks = Legend.Ticks(coloring);
            string[] texts = NiceTicks.Format(ticks);
            for (int i = 0; i < ticks.Length; i++)
            {
                double place = 100 * (coloring.Maximum - ticks[i]) / (coloring.Maximum - coloring.Minimum);
                html.Append(CultureInfo.InvariantCulture, $"<span style=\"top:{SvgWriter.Number(place)}%\">{texts[i]}</span>");
            }
            html.Append("</div>");
            if (coloring.CountNonFinite() > 0)
                Entry(html, new(Legend.NotANumberText(coloring), ColorMap.NotANumber));
        }
        else
        {
            foreach (LegendEntry entry in Legend.Entries(coloring))
                Entry(html, entry);
        }
        return html.Append("</div>").ToString();
    }

    private static void Entry(StringBuilder html, LegendEntry entry) => html.Append(
        CultureInfo.InvariantCulture, $"<div class=\"entry\"><i style=\"background:{SvgWriter.Css(entry.Color)}\"></i>{SvgWriter.Escape(entry.Name)}</div>");

    private static string Template()
    {
        using Stream stream = typeof(HtmlViewer).Assembly.GetManifestResourceStream("MeshLab.Visualization.Viewer.html")
            ?? throw new InvalidOperationException("The page's template is missing from the assembly.");
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }

    // One pass, so that a title that looks like a mark is not replaced.
    private static string Fill(string template, Dictionary<string, string> parts)
    {
        var page = new StringBuilder(template.Length + parts.Values.Sum(part => part.Length));
        int at = 0;
        while (template.IndexOf("{{", at, StringComparison.Ordinal) is var open && open >= 0)
        {
            int close = template.IndexOf("}}", open, StringComparison.Ordinal);
            page.Append(template, at, open - at).Append(parts[template[(open + 2)..close]]);
            at = close + 2;
        }
        return page.Append(template, at, template.Length - at).ToString();
    }
}
