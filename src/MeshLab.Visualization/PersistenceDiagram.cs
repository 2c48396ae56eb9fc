using MeshLab.Morse;

namespace MeshLab.Visualization;

/// <summary>§12.6 持续性图 (persistence diagram): a point per pair of critical points, birth to the right and death upwards; what matters lies far above the diagonal.</summary>
public static class PersistenceDiagram
{
    /// <summary>Draws the diagram.</summary>
    /// <param name="pairs">The pairs of a function.</param>
    /// <param name="title">The title.</param>
    /// <returns>A chart; <see cref="SvgChart.ToSvg"/> makes the file of it.</returns>
    public static SvgChart Of(PersistencePairs pairs, string title = "persistence diagram")
    {
        ArgumentNullException.ThrowIfNull(pairs);
        double low = double.PositiveInfinity, high = double.NegativeInfinity;
        foreach (CriticalPoint point in pairs.Critical.Points)
        {
            low = Math.Min(low, point.Value);
            high = Math.Max(high, point.Value);
        }
        double[] ends = low <= high ? [low, high] : [0, 1];
        return new SvgChart
        {
            Title = title,
            XLabel = "birth",
            YLabel = "death",
            Width = 560,
            Height = 500,
            Series =
            [
                Points(pairs, PairKind.MinimumSaddle, "minimum and saddle"),
                Points(pairs, PairKind.SaddleMaximum, "saddle and maximum"),
                new ChartSeries("birth = death", ends, ends, SeriesStyle.Dashed),
            ],
        };
    }

    private static ChartSeries Points(PersistencePairs pairs, PairKind kind, string name)
    {
        PersistencePair[] own = [.. pairs.Pairs.Where(pair => pair.Kind == kind)];
        MorseFunction function = pairs.Critical.Function;
        return new ChartSeries(name, [.. own.Select(p => function[p.Birth])], [.. own.Select(p => function[p.Death])], SeriesStyle.Points);
    }
}
