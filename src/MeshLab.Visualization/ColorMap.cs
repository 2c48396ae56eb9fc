using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// A colour map (颜色映射): numbers from 0 to 1 to colours. Given by a few colours, joined in the perceptual space OKLab by monotone cubic
/// curves (Fritsch and Carlson, 1980), so that lightness between two given colours never turns back.
/// </summary>
public sealed class ColorMap
{
    private readonly double[][] knots;
    private readonly double[][] slopes;

    private ColorMap(string name, params uint[] colors)
        : this(name, Array.ConvertAll(colors, FromHex))
    {
    }

    /// <summary>An own map through colours at equal distances.</summary>
    /// <param name="name">The name, for listings.</param>
    /// <param name="colors">At least two colours; the first belongs to 0, the last to 1.</param>
    public ColorMap(string name, IReadOnlyList<Color> colors)
    {
        ArgumentException.ThrowIfNullOrEmpty(name);
        ArgumentNullException.ThrowIfNull(colors);
        if (colors.Count < 2)
            throw new ArgumentException("A colour map needs at least two colours.", nameof(colors));
        Name = name;
        knots = [new double[colors.Count], new double[colors.Count], new double[colors.Count]];
        for (int i = 0; i < colors.Count; i++)
            (knots[0][i], knots[1][i], knots[2][i]) = Oklab.FromColor(colors[i]);
        slopes = Array.ConvertAll(knots, MonotoneSlopes);
    }

    /// <summary>Dark violet over teal to yellow; the default for quantities without a natural middle.</summary>
    public static ColorMap Viridis { get; } = new("viridis", 0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E, 0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725);

    /// <summary>Black over purple and orange to cream.</summary>
    public static ColorMap Magma { get; } = new("magma", 0x000004, 0x180F3D, 0x440F76, 0x721F81, 0x9E2F7F, 0xCD4071, 0xF1605D, 0xFD9668, 0xFECA8D, 0xFCFDBF);

    /// <summary>Blue over grey to yellow: the same for eyes with and without colour-vision deficiency.</summary>
    public static ColorMap Cividis { get; } = new("cividis", 0x00224E, 0x123570, 0x3B496C, 0x575D6D, 0x707173, 0x8A8678, 0xA59C74, 0xC3B369, 0xE1CC55, 0xFEE838);

    /// <summary>Blue over near white to red; for signed quantities such as curvature, with 0 in the middle.</summary>
    public static ColorMap Coolwarm { get; } = new("coolwarm", 0x2F4FB0, 0x5479D6, 0x8AABEF, 0xC3D6F3, 0xF0EEEA, 0xF5C7B0, 0xE8906F, 0xCF5246, 0xA81529);

    /// <summary>Cyclic: 0 and 1 are the same colour; for angles and phases.</summary>
    public static ColorMap Cyclic { get; } = new("cyclic", Wheel());

    /// <summary>Near black to near white.</summary>
    public static ColorMap Gray { get; } = new("gray", 0x1A1A1A, 0xF5F5F5);

    /// <summary>All built-in maps.</summary>
    public static IReadOnlyList<ColorMap> All { get; } = [Viridis, Magma, Cividis, Coolwarm, Cyclic, Gray];

    /// <summary>What a value that is not a number is painted with.</summary>
    public static Color NotANumber { get; } = Color.FromBytes(158, 158, 158);

    /// <summary>The name in lower case, such as <c>viridis</c>.</summary>
    public string Name { get; }

    /// <summary>The built-in map of a name (any case).</summary>
    /// <exception cref="ArgumentException">There is none; the message lists the names.</exception>
    public static ColorMap Parse(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        foreach (ColorMap map in All)
        {
            if (string.Equals(map.Name, name, StringComparison.OrdinalIgnoreCase))
                return map;
        }
        throw new ArgumentException($"No colour map is called '{name}'; there are {string.Join(", ", All.Select(m => m.Name))}.", nameof(name));
    }

    /// <summary>The colour of a number: 0 to 1, clamped outside; NaN gives <see cref="NotANumber"/>.</summary>
    public Color Sample(double t)
    {
        if (double.IsNaN(t))
            return NotANumber;
        double at = Math.Clamp(t, 0, 1) * (knots[0].Length - 1);
        int i = Math.Min((int)at, knots[0].Length - 2);
        double s = at - i;
        return Oklab.ToColor(Hermite(0, i, s), Hermite(1, i, s), Hermite(2, i, s));
    }

    /// <summary>The map the other way round.</summary>
    public ColorMap Reversed() => new(Name + "-reversed", Enumerable.Range(0, 33).Select(i => Sample(1 - i / 32.0)).ToArray());

    /// <inheritdoc/>
    public override string ToString() => Name;

    internal static Color FromHex(uint rgb) => Color.FromBytes((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb);

    private double Hermite(int channel, int i, double s)
    {
        double p0 = knots[channel][i], p1 = knots[channel][i + 1], m0 = slopes[channel][i], m1 = slopes[channel][i + 1];
        double s2 = s * s, s3 = s2 * s;
        return (2 * s3 - 3 * s2 + 1) * p0 + (s3 - 2 * s2 + s) * m0 + (3 * s2 - 2 * s3) * p1 + (s3 - s2) * m1;
    }

    // The harmonic mean of the neighbouring differences, 0 where they change sign: the interpolant stays monotone.
    private static double[] MonotoneSlopes(double[] values)
    {
        var slope = new double[values.Length];
        for (int i = 0; i < values.Length; i++)
        {
            double before = i > 0 ? values[i] - values[i - 1] : values[1] - values[0];
            double after = i + 1 < values.Length ? values[i + 1] - values[i] : before;
            slope[i] = before * after > 0 ? 2 * before * after / (before + after) : 0;
        }
        return slope;
    }

    private static Color[] Wheel()
    {
        var colors = new Color[25];
        for (int i = 0; i < colors.Length; i++)
        {
            double turn = 2 * Math.PI * (i % 24) / 24;
            colors[i] = Oklab.FromLch(0.71 + 0.06 * Math.Cos(turn), 0.112, turn + 0.4);
        }
        return colors;
    }
}
