using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>Where a text stands relative to its point.</summary>
public enum TextAlign
{
    /// <summary>The text begins at the point.</summary>
    Left,

    /// <summary>The text is centred on the point.</summary>
    Center,

    /// <summary>The text ends at the point.</summary>
    Right,
}

/// <summary>Smooth lines, discs and text on an <see cref="Image"/>; coordinates in pixels from the top left corner, pixel centres at halves.</summary>
public static class ImageDrawing
{
    /// <summary>Draws an open chain of segments with round ends.</summary>
    /// <param name="image">The picture drawn on.</param>
    /// <param name="points">The chain's points.</param>
    /// <param name="color">Colour with opacity; where the chain crosses itself it is not laid on twice.</param>
    /// <param name="width">The pen's width in pixels.</param>
    public static void DrawLine(this Image image, IReadOnlyList<Vector2D> points, Color color, double width = 1)
    {
        ArgumentNullException.ThrowIfNull(image);
        ArgumentNullException.ThrowIfNull(points);
        Stroke(image, [points.Select(p => new Vector2((float)p.X, (float)p.Y)).ToArray()], color, (float)width);
    }

    /// <summary>Draws a filled disc.</summary>
    public static void DrawDisc(this Image image, double x, double y, double radius, Color color)
    {
        ArgumentNullException.ThrowIfNull(image);
        Stroke(image, [[new((float)x, (float)y)]], color, 2 * (float)radius);
    }

    /// <summary>Draws one line of text: ASCII and common signs of formulas; another character becomes a box.</summary>
    /// <param name="image">The picture drawn on.</param>
    /// <param name="text">The text.</param>
    /// <param name="x">The point's column; see <paramref name="align"/>.</param>
    /// <param name="baseline">The row on which letters stand.</param>
    /// <param name="size">The font's size in pixels; capitals are 0.7 of it high.</param>
    /// <param name="color">Colour with opacity.</param>
    /// <param name="align">Where the text stands relative to the point.</param>
    /// <param name="bold">Whether the pen is broader.</param>
    public static void DrawText(
        this Image image, string text, double x, double baseline, double size, Color color, TextAlign align = TextAlign.Left, bool bold = false)
    {
        ArgumentNullException.ThrowIfNull(image);
        ArgumentNullException.ThrowIfNull(text);
        DrawText(image, text, x, baseline, size, color, align, Math.Max((float)size * (bold ? 0.125f : 0.083f), 1));
    }

    /// <summary>Draws text with a pen of a given width in pixels.</summary>
    internal static void DrawText(Image image, string text, double x, double baseline, double size, Color color, TextAlign align, float pen)
    {
        float scale = (float)size / 100;
        float left = (float)x - (float)MeasureText(text, size) * align switch { TextAlign.Left => 0, TextAlign.Center => 0.5f, _ => 1 };
        var strokes = new List<Vector2[]>();
        foreach (char c in text)
        {
            StrokeFont.Glyph glyph = StrokeFont.Of(c);
            foreach (Vector2[] stroke in glyph.Strokes)
            {
                float start = left;
                strokes.Add(Array.ConvertAll(stroke, p => new Vector2(start + p.X * scale, (float)baseline - p.Y * scale)));
            }
            left += glyph.Width * scale;
        }
        Stroke(image, strokes, color, pen);
    }

    /// <summary>The width in pixels that <c>DrawText</c> needs.</summary>
    public static double MeasureText(string text, double size)
    {
        ArgumentNullException.ThrowIfNull(text);
        return StrokeFont.Measure(text, (float)size);
    }

    // Coverage is collected for all strokes first (the largest counts), so that joints are not darker.
    private static void Stroke(Image image, IReadOnlyList<Vector2[]> strokes, Color color, float width)
    {
        float reach = width / 2 + 0.5f;
        Vector2 low = new(float.PositiveInfinity), high = new(float.NegativeInfinity);
        foreach (Vector2[] stroke in strokes)
        {
            foreach (Vector2 p in stroke)
                (low, high) = (Vector2.Min(low, p), Vector2.Max(high, p));
        }
        int x0 = Floor(low.X - reach, image.Width), x1 = Floor(high.X + reach, image.Width - 1);
        int y0 = Floor(low.Y - reach, image.Height), y1 = Floor(high.Y + reach, image.Height - 1);
        if (x1 < x0 || y1 < y0)
            return;

        int columns = x1 - x0 + 1;
        var coverage = new float[columns * (y1 - y0 + 1)];
        foreach (Vector2[] stroke in strokes)
        {
            for (int i = 0; i < Math.Max(stroke.Length - 1, 1); i++)
                Cover(stroke[i], stroke[Math.Min(i + 1, stroke.Length - 1)]);
        }
        for (int i = 0; i < coverage.Length; i++)
        {
            if (coverage[i] > 0)
                image.Blend(x0 + i % columns, y0 + i / columns, color, coverage[i]);
        }

        void Cover(Vector2 a, Vector2 b)
        {
            Vector2 d = b - a;
            float lengthSquared = d.LengthSquared();
            int left = Math.Max(Floor(Math.Min(a.X, b.X) - reach, x1), x0), right = Math.Min(Floor(Math.Max(a.X, b.X) + reach, x1), x1);
            int top = Math.Max(Floor(Math.Min(a.Y, b.Y) - reach, y1), y0), bottom = Math.Min(Floor(Math.Max(a.Y, b.Y) + reach, y1), y1);
            for (int y = top; y <= bottom; y++)
            {
                for (int x = left; x <= right; x++)
                {
                    var p = new Vector2(x + 0.5f, y + 0.5f);
                    float t = lengthSquared > 0 ? Math.Clamp(Vector2.Dot(p - a, d) / lengthSquared, 0, 1) : 0;
                    float c = Math.Clamp(reach - Vector2.Distance(p, a + d * t), 0, 1);
                    ref float cell = ref coverage[(y - y0) * columns + x - x0];
                    cell = Math.Max(cell, c);
                }
            }
        }
    }

    // Clamped to [0, most]; NaN becomes 0.
    private static int Floor(float value, int most) => value > 0 ? (int)Math.Min(value, most) : 0;
}
