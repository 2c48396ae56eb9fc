using System.Globalization;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>The legend (图例) of a <see cref="Coloring"/>: a bar with round numbers, or named colours.</summary>
public static class Legend
{
    private const int Pad = 14;
    private const double FontSize = 15;
    private const int MaxEntries = 24;

    private static readonly Color Ink = new(0.16f, 0.18f, 0.22f);

    /// <summary>The width in pixels that the legend needs at the picture's right side; 0 if the coloring has none.</summary>
    public static int Width(Coloring coloring)
    {
        ArgumentNullException.ThrowIfNull(coloring);
        if (coloring.Title.Length == 0)
            return 0;
        double title = ImageDrawing.MeasureText(Title(coloring), FontSize), body = 0;
        if (coloring.Values is not null)
        {
            foreach (string text in NiceTicks.Format(Ticks(coloring)))
                body = Math.Max(body, 30 + ImageDrawing.MeasureText(text, FontSize));
            if (coloring.CountNonFinite() > 0)
                body = Math.Max(body, 30 + ImageDrawing.MeasureText(NotANumberText(coloring), FontSize));
        }
        else
        {
            foreach (LegendEntry entry in Entries(coloring))
                body = Math.Max(body, 26 + ImageDrawing.MeasureText(entry.Name, FontSize));
        }
        return 2 * Pad + (int)Math.Ceiling(Math.Max(title, body));
    }

    /// <summary>Draws the legend into a column of the picture.</summary>
    /// <param name="image">The picture.</param>
    /// <param name="coloring">The coloring.</param>
    /// <param name="left">The column's left side; its width is <see cref="Width"/>.</param>
    public static void Draw(Image image, Coloring coloring, int left)
    {
        ArgumentNullException.ThrowIfNull(image);
        ArgumentNullException.ThrowIfNull(coloring);
        if (coloring.Title.Length == 0)
            return;
        if (coloring.Values is not null)
            DrawBar(image, coloring, left + Pad);
        else
            DrawEntries(image, coloring, left + Pad);
    }

    /// <summary>The named colours of a coloring: those given, or one for each label that occurs, ascending.</summary>
    internal static IReadOnlyList<LegendEntry> Entries(Coloring coloring, int most = MaxEntries)
    {
        IReadOnlyList<LegendEntry> entries = coloring.Entries;
        if (entries.Count == 0 && coloring.Labels is { } labels)
        {
            entries = [.. labels.Distinct().Order().Select(label =>
                new LegendEntry(label < 0 ? "none" : label.ToString(CultureInfo.InvariantCulture), coloring.LabelColor(label)))];
        }
        if (entries.Count <= most)
            return entries;
        string more = string.Create(CultureInfo.InvariantCulture, $"… {entries.Count - most + 1} more");
        return [.. entries.Take(most - 1), new LegendEntry(more.Replace("…", "...", StringComparison.Ordinal), new Color(0, 0, 0, 0))];
    }

    internal static string Title(Coloring coloring) => coloring.Unit.Length == 0 ? coloring.Title : $"{coloring.Title} [{coloring.Unit}]";

    internal static double[] Ticks(Coloring coloring, int wanted = 6) => NiceTicks.Linear(coloring.Minimum, coloring.Maximum, wanted);

    internal static string NotANumberText(Coloring coloring) =>
        string.Create(CultureInfo.InvariantCulture, $"no value ({coloring.CountNonFinite()})");

    private static void DrawBar(Image image, Coloring coloring, int x)
    {
        const int barWidth = 18;
        bool gaps = coloring.CountNonFinite() > 0;
        int height = Math.Max(20, Math.Min((int)(image.Height * 0.62), 420)), top = Math.Max(34, (image.Height - height) / 2), bottom = top + height;
        image.DrawText(Title(coloring), x, top - 16, FontSize, Ink);
        for (int y = top; y < bottom; y++)
            image.FillRectangle(x, y, barWidth, 1, coloring.Map.Sample(1 - (y + 0.5 - top) / height));
        Frame(image, x, top, barWidth, height);

        double[] ticks = Ticks(coloring, Math.Clamp(height / 40, 1, 6));
        string[] texts = NiceTicks.Format(ticks);
        for (int i = 0; i < ticks.Length; i++)
        {
            double y = bottom - (ticks[i] - coloring.Minimum) / (coloring.Maximum - coloring.Minimum) * height;
            image.DrawLine([new(x + barWidth, y), new(x + barWidth + 5, y)], Ink, 1.1);
            image.DrawText(texts[i], x + barWidth + 10, y + 0.35 * FontSize, FontSize, Ink);
        }
        if (gaps)
        {
            image.FillRectangle(x, bottom + 16, barWidth, 14, ColorMap.NotANumber);
            Frame(image, x, bottom + 16, barWidth, 14);
            image.DrawText(NotANumberText(coloring), x + barWidth + 10, bottom + 28, FontSize, Ink);
        }
    }

    private static void DrawEntries(Image image, Coloring coloring, int x)
    {
        const int line = 23;
        IReadOnlyList<LegendEntry> entries = Entries(coloring, Math.Clamp((image.Height - 60) / line, 2, MaxEntries));
        int top = Math.Max(34, (image.Height - entries.Count * line) / 2);
        image.DrawText(Title(coloring), x, top - 14, FontSize, Ink);
        for (int i = 0; i < entries.Count; i++)
        {
            int y = top + i * line;
            if (entries[i].Color.A > 0)
            {
                image.FillRectangle(x, y, 16, 16, entries[i].Color);
                Frame(image, x, y, 16, 16);
            }
            image.DrawText(entries[i].Name, x + 26, y + 13, FontSize, Ink);
        }
    }

    private static void Frame(Image image, int x, int y, int width, int height) =>
        image.DrawLine([new(x, y), new(x + width, y), new(x + width, y + height), new(x, y + height), new(x, y)], Ink with { A = 0.55f }, 1);
}
