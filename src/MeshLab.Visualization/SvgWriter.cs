using System.Globalization;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>Puts SVG elements together: numbers short and with the invariant culture, texts escaped.</summary>
internal sealed class SvgWriter
{
    private readonly StringBuilder text = new();

    /// <summary>A number with at most two decimals.</summary>
    public static string Number(double value) => Math.Round(value, 2).ToString("0.##", CultureInfo.InvariantCulture) is var s && s == "-0" ? "0" : s;

    /// <summary>A colour as CSS writes it.</summary>
    public static string Css(Color color) =>
        $"#{Image.ToByte(color.R):x2}{Image.ToByte(color.G):x2}{Image.ToByte(color.B):x2}{(color.A < 1 ? Image.ToByte(color.A).ToString("x2", CultureInfo.InvariantCulture) : "")}";

    /// <summary>Text made safe for element content and attributes.</summary>
    public static string Escape(string value)
    {
        var result = new StringBuilder(value.Length + 8);
        foreach (char c in value)
        {
            _ = c switch
            {
                '&' => result.Append("&amp;"),
                '<' => result.Append("&lt;"),
                '>' => result.Append("&gt;"),
                '"' => result.Append("&quot;"),
                '\'' => result.Append("&#39;"),
                // Control characters are not allowed in XML.
                < ' ' when c is not ('\n' or '\t' or '\r') => result.Append('\uFFFD'),
                _ => result.Append(c),
            };
        }
        return result.ToString();
    }

    /// <summary>Adds a line of SVG as it is.</summary>
    public void Raw(string line) => text.Append(line).Append('\n');

    /// <summary>Adds a straight line.</summary>
    public void Line(double x0, double y0, double x1, double y1, string style) =>
        Raw($"""<line x1="{Number(x0)}" y1="{Number(y0)}" x2="{Number(x1)}" y2="{Number(y1)}" {style}/>""");

    /// <summary>Adds a text.</summary>
    public void Text(double x, double y, string value, string style) => Raw($"""<text x="{Number(x)}" y="{Number(y)}" {style}>{Escape(value)}</text>""");

    /// <summary>Everything added.</summary>
    public override string ToString() => text.ToString();
}
