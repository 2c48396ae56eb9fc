using System.Globalization;

namespace MeshLab.Visualization;

/// <summary>Where a value of a chart stands: a range of values and a range of the picture.</summary>
internal sealed class ChartAxis
{
    private readonly double low, high, start, end;
    private readonly bool logarithmic;

    private ChartAxis(double low, double high, double start, double end, bool logarithmic, double[] ticks)
    {
        (this.low, this.high, this.start, this.end, this.logarithmic) = (low, high, start, end, logarithmic);
        Ticks = ticks;
    }

    /// <summary>The marked values.</summary>
    public double[] Ticks { get; }

    /// <summary>How they are written.</summary>
    public string[] TickTexts
    {
        get
        {
            if (!logarithmic)
                return NiceTicks.Format(Ticks);
            bool plain = Array.TrueForAll(Ticks, tick => tick is > 0.009 and < 20_000);
            return Array.ConvertAll(Ticks, tick => plain ? NiceTicks.Format(tick) : PowerText(tick));
        }
    }

    /// <summary>An axis for the values, with round ends.</summary>
    public static ChartAxis Fit(IEnumerable<double> values, AxisScale scale, double start, double end)
    {
        bool logarithmic = scale == AxisScale.Logarithmic;
        double low = double.PositiveInfinity, high = double.NegativeInfinity;
        foreach (double value in values)
        {
            if (!double.IsFinite(value) || (logarithmic && value <= 0))
                continue;
            low = Math.Min(low, value);
            high = Math.Max(high, value);
        }
        if (low > high)
            (low, high) = logarithmic ? (1, 10) : (0, 1);
        if (!logarithmic)
        {
            (low, high) = NiceTicks.Widen(low, high);
            return Exact(low, high, start, end);
        }
        // A decade is rounded up only if that does not leave most of it empty.
        if (high <= low * 1.0001)
            (low, high) = (low / 3, high * 3);
        double a = Math.Log10(low), b = Math.Log10(high), pad = 0.04 * (b - a);
        low = a - Math.Floor(a) < 0.35 ? Math.Floor(a) : a - pad;
        high = Math.Ceiling(b) - b < 0.35 ? Math.Ceiling(b) : b + pad;
        return new(low, high, start, end, true, NiceTicks.Logarithmic(Math.Pow(10, low), Math.Pow(10, high)));
    }

    /// <summary>A linear axis of exactly this range.</summary>
    public static ChartAxis Exact(double low, double high, double start, double end) =>
        new(low, high, start, end, false, NiceTicks.Linear(low, high));

    /// <summary>Whether a value has a place.</summary>
    public bool CanShow(double value) => double.IsFinite(value) && (!logarithmic || value > 0);

    /// <summary>The place of a value.</summary>
    public double Place(double value) => start + (end - start) * ((logarithmic ? Math.Log10(value) : value) - low) / (high - low);

    private static string PowerText(double value)
    {
        double exponent = Math.Log10(value);
        int whole = (int)Math.Round(exponent);
        if (Math.Abs(exponent - whole) > 1e-9)
            return NiceTicks.Format(value);
        if (whole is 0 or 1)
            return whole == 0 ? "1" : "10";
        const string digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        string raised = string.Concat(Math.Abs(whole).ToString(CultureInfo.InvariantCulture).Select(c => digits[c - '0']));
        return "10" + (whole < 0 ? "⁻" : "") + raised;
    }
}
