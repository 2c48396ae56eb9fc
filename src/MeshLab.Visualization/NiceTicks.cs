using System.Globalization;

namespace MeshLab.Visualization;

/// <summary>Round numbers for axes and legends: steps of 1, 2 or 5 times a power of ten (Heckbert, "Nice numbers for graph labels", 1990).</summary>
internal static class NiceTicks
{
    /// <summary>About <paramref name="wanted"/> round numbers within [min, max]; the range itself if it is empty.</summary>
    public static double[] Linear(double min, double max, int wanted = 6)
    {
        if (!(max > min) || !double.IsFinite(max - min))
            return [min];
        double step = RoundStep((max - min) / Math.Max(wanted, 1));
        double first = Math.Ceiling(min / step - 1e-9), last = Math.Floor(max / step + 1e-9);
        int count = (int)Math.Clamp(last - first + 1, 0, 1000);
        if (count < 2)
            return [min, max];
        var ticks = new double[count];
        for (int i = 0; i < count; i++)
        {
            // n·10^k is one rounding; n / 10^-k is too, and exact where k < 0 gives a decimal such as 0.3.
            double n = first + i;
            ticks[i] = step >= 1 ? n * step : Math.Round(n * step, Decimals(step));
        }
        return ticks;
    }

    /// <summary>Powers of ten within [min, max], thinned to about <paramref name="wanted"/>.</summary>
    public static double[] Logarithmic(double min, double max, int wanted = 7)
    {
        int first = (int)Math.Ceiling(Math.Log10(min) - 1e-9), last = (int)Math.Floor(Math.Log10(max) + 1e-9);
        if (last < first)
            return [min, max];
        int stride = Math.Max(1, (int)Math.Ceiling((last - first + 1) / (double)Math.Max(wanted, 1)));
        var ticks = new List<double>();
        for (int e = first; e <= last; e += stride)
            ticks.Add(PowerOfTen(e));
        return [.. ticks];
    }

    /// <summary>The range widened to round numbers.</summary>
    public static (double Min, double Max) Widen(double min, double max, int wanted = 6)
    {
        if (!(max > min))
        {
            double pad = min == 0 ? 1 : Math.Abs(min) * 0.1;
            return (min - pad, max + pad);
        }
        double step = RoundStep((max - min) / Math.Max(wanted, 1));
        return (Math.Floor(min / step + 1e-9) * step, Math.Ceiling(max / step - 1e-9) * step);
    }

    /// <summary>All ticks written with the same number of digits, short, with the invariant culture.</summary>
    public static string[] Format(ReadOnlySpan<double> ticks)
    {
        var texts = new string[ticks.Length];
        double largest = 0, step = double.PositiveInfinity;
        for (int i = 0; i < ticks.Length; i++)
        {
            largest = Math.Max(largest, Math.Abs(ticks[i]));
            if (i > 0)
                step = Math.Min(step, Math.Abs(ticks[i] - ticks[i - 1]));
        }
        if (largest == 0)
            step = 1;
        else if (!double.IsFinite(step) || step == 0)
            step = largest / 1000;
        bool scientific = largest >= 1e6 || (largest < 1e-3 && largest > 0);
        int decimals = Decimals(step);
        for (int i = 0; i < ticks.Length; i++)
            texts[i] = scientific ? Scientific(ticks[i]) : ticks[i].ToString("F" + decimals, CultureInfo.InvariantCulture);
        return texts;
    }

    /// <summary>A number in at most four significant digits.</summary>
    public static string Format(double value) => !double.IsFinite(value) || value == 0 || Math.Abs(value) is >= 1e-3 and < 1e6
        ? value.ToString("G4", CultureInfo.InvariantCulture)
        : Scientific(value);

    private static string Scientific(double value) => value == 0 ? "0" : value.ToString("0.###e0", CultureInfo.InvariantCulture);

    private static double RoundStep(double rough)
    {
        double power = PowerOfTen((int)Math.Floor(Math.Log10(rough)));
        return (rough / power) switch
        {
            < 1.5 => power,
            < 3.5 => 2 * power,
            < 7.5 => 5 * power,
            _ => 10 * power,
        };
    }

    private static double PowerOfTen(int exponent) => double.Parse("1e" + exponent.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    private static int Decimals(double step)
    {
        if (step >= 1 && step == Math.Floor(step))
            return 0;
        return Math.Clamp((int)-Math.Floor(Math.Log10(step) + 1e-9), 0, 15);
    }
}
