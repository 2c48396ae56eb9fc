using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// Conversions between stored colours (sRGB), light (linear RGB) and the perceptual space OKLab
/// (Björn Ottosson, 2020), in which equal steps look equally large.
/// </summary>
internal static class Oklab
{
    private static readonly float[] ByteToLinear = BuildByteToLinear();

    /// <summary>The light of a stored channel in [0, 1] (IEC 61966-2-1).</summary>
    public static float ToLinear(float stored) =>
        stored <= 0.04045f ? stored / 12.92f : MathF.Pow((stored + 0.055f) / 1.055f, 2.4f);

    /// <summary>The light of a stored byte.</summary>
    public static float ToLinear(byte stored) => ByteToLinear[stored];

    /// <summary>The stored channel of a light, clamped to [0, 1].</summary>
    public static float ToStored(float light)
    {
        if (!(light > 0))
            return 0;
        if (light >= 1)
            return 1;
        return light <= 0.0031308f ? light * 12.92f : 1.055f * MathF.Pow(light, 1 / 2.4f) - 0.055f;
    }

    /// <summary>The light of a stored colour; alpha is left out.</summary>
    public static Vector3 ToLinear(Color color) => new(ToLinear(color.R), ToLinear(color.G), ToLinear(color.B));

    /// <summary>The stored colour of a light.</summary>
    public static Color ToColor(Vector3 light, float alpha = 1) => new(ToStored(light.X), ToStored(light.Y), ToStored(light.Z), alpha);

    /// <summary>Lightness, a (green–red) and b (blue–yellow) of a stored colour.</summary>
    public static (double L, double A, double B) FromColor(Color color)
    {
        Vector3 c = ToLinear(color);
        double l = Math.Cbrt(0.4122214708 * c.X + 0.5363325363 * c.Y + 0.0514459929 * c.Z);
        double m = Math.Cbrt(0.2119034982 * c.X + 0.6806995451 * c.Y + 0.1073969566 * c.Z);
        double s = Math.Cbrt(0.0883024619 * c.X + 0.2817188376 * c.Y + 0.6299787005 * c.Z);
        return (0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s);
    }

    /// <summary>The stored colour; what the screen cannot show is clamped.</summary>
    public static Color ToColor(double lightness, double a, double b)
    {
        double l = Cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
        double m = Cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
        double s = Cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
        return ToColor(new Vector3(
            (float)(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            (float)(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            (float)(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)));
    }

    /// <summary>The stored colour of a lightness, chroma and hue in radians.</summary>
    public static Color FromLch(double lightness, double chroma, double hue)
    {
        var (sin, cos) = Math.SinCos(hue);
        return ToColor(lightness, chroma * cos, chroma * sin);
    }

    /// <summary>How different two colours look; 0.02 is barely visible, 1 is black to white.</summary>
    public static double Difference(Color first, Color second)
    {
        var (l0, a0, b0) = FromColor(first);
        var (l1, a1, b1) = FromColor(second);
        return Math.Sqrt((l0 - l1) * (l0 - l1) + (a0 - a1) * (a0 - a1) + (b0 - b1) * (b0 - b1));
    }

    private static double Cube(double x) => x * x * x;

    private static float[] BuildByteToLinear()
    {
        var table = new float[256];
        for (int i = 0; i < 256; i++)
            table[i] = ToLinear(i / 255f);
        return table;
    }
}
