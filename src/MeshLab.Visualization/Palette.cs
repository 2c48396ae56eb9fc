using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// Colours for labels (分类颜色): 24 chosen to lie far apart in OKLab, then an endless row whose hues turn by the golden angle.
/// </summary>
public static class Palette
{
    private static readonly uint[] Chosen =
    [
        0x4C78C8, 0xF28E3C, 0x3FA66B, 0xD9534F, 0x8E6BBF, 0x9C6B4E, 0xE583B6, 0xE8C547, 0x45B5C4, 0x9DBF4A, 0x970D63, 0x09672E,
        0xCACAEE, 0x55516F, 0x36EDC8, 0x044CB6, 0x6D2EA3, 0x8A3819, 0x138282, 0x7A97FB, 0xC64998, 0xAA9E7B, 0x697B1A, 0xC07AF1,
    ];

    /// <summary>How many colours were chosen one by one.</summary>
    public static int ChosenCount => Chosen.Length;

    /// <summary>The colour of a label; a negative label (none) is neutral grey.</summary>
    public static Color Categorical(int label)
    {
        if (label < 0)
            return ColorMap.NotANumber;
        if (label < Chosen.Length)
            return ColorMap.FromHex(Chosen[label]);
        const double goldenAngle = 2.399963229728653;
        int k = label - Chosen.Length;
        double lightness = 0.52 + 0.11 * (k % 4);
        double chroma = 0.10 + 0.03 * (k / 4 % 3);
        return Oklab.FromLch(lightness, chroma, k * goldenAngle);
    }

    /// <summary>
    /// The colour of a valence (度数): near white where it is the regular one, ever bluer below, ever redder above.
    /// </summary>
    /// <param name="valence">The number of edges at the vertex.</param>
    /// <param name="regular">The regular valence: 6 in a triangle mesh, 4 in a quad mesh.</param>
    public static Color Valence(int valence, int regular = 6)
    {
        int d = Math.Clamp(valence - regular, -3, 3);
        return d switch
        {
            -3 => ColorMap.FromHex(0x2B3F8F),
            -2 => ColorMap.FromHex(0x3E6BC4),
            -1 => ColorMap.FromHex(0x7FB2E5),
            0 => ColorMap.FromHex(0xEFECE4),
            1 => ColorMap.FromHex(0xF2A56B),
            2 => ColorMap.FromHex(0xD8573F),
            _ => ColorMap.FromHex(0x98203A),
        };
    }
}
