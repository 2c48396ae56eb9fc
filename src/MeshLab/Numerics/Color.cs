namespace MeshLab.Numerics;

/// <summary>A colour (颜色) with alpha; every channel from 0 to 1, sRGB as stored in files.</summary>
/// <param name="R">Red.</param>
/// <param name="G">Green.</param>
/// <param name="B">Blue.</param>
/// <param name="A">Opacity.</param>
public readonly record struct Color(float R, float G, float B, float A = 1)
{
    /// <summary>Opaque white.</summary>
    public static Color White => new(1, 1, 1);

    /// <summary>Opaque black.</summary>
    public static Color Black => new(0, 0, 0);

    /// <summary>From channels of 0 to 255.</summary>
    public static Color FromBytes(byte r, byte g, byte b, byte a = 255) => new(r / 255f, g / 255f, b / 255f, a / 255f);

    /// <summary>The colour at parameter <paramref name="t"/> from <paramref name="a"/> (0) to <paramref name="b"/> (1).</summary>
    public static Color Lerp(Color a, Color b, double t)
    {
        float s = (float)t;
        return new(a.R + (b.R - a.R) * s, a.G + (b.G - a.G) * s, a.B + (b.B - a.B) * s, a.A + (b.A - a.A) * s);
    }
}
