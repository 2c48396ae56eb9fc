using MeshLab.IO;
using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>A picture (图像): rows of pixels from the top, 8 bits each of red, green, blue (sRGB) and opacity.</summary>
public sealed class Image
{
    private const int LargestSide = 32768;

    private readonly byte[] bytes;

    /// <summary>A picture of one colour.</summary>
    /// <param name="width">Pixels per row, 1 to 32768.</param>
    /// <param name="height">Rows, 1 to 32768.</param>
    /// <param name="fill">The colour of every pixel.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is not in 1 … 32768, or both are so large that the bytes do not fit into one array.</exception>
    public Image(int width, int height, Color fill = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(width, LargestSide);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(height, LargestSide);
        ArgumentOutOfRangeException.ThrowIfGreaterThan((long)width * height * 4, Array.MaxLength, nameof(height));
        Width = width;
        Height = height;
        bytes = new byte[width * height * 4];
        FillRectangle(0, 0, width, height, fill);
    }

    /// <summary>Pixels per row.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>Red, green, blue, opacity of each pixel, row by row from the top left.</summary>
    public Span<byte> Bytes => bytes;

    /// <summary>The colour of a pixel.</summary>
    /// <param name="x">Column from the left.</param>
    /// <param name="y">Row from the top.</param>
    public Color this[int x, int y]
    {
        get
        {
            int i = Index(x, y);
            return Color.FromBytes(bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]);
        }
        set
        {
            int i = Index(x, y);
            bytes[i] = ToByte(value.R);
            bytes[i + 1] = ToByte(value.G);
            bytes[i + 2] = ToByte(value.B);
            bytes[i + 3] = ToByte(value.A);
        }
    }

    /// <summary>Sets every pixel of a rectangle (what reaches out of the picture is left out) to one colour.</summary>
    public void FillRectangle(int left, int top, int width, int height, Color color)
    {
        int x0 = Math.Max(left, 0), x1 = (int)Math.Min((long)left + width, Width);
        int y0 = Math.Max(top, 0), y1 = (int)Math.Min((long)top + height, Height);
        for (int y = y0; y < y1; y++)
        {
            for (int x = x0; x < x1; x++)
                this[x, y] = color;
        }
    }

    /// <summary>Copies another picture into this one; what reaches out is left out.</summary>
    /// <param name="source">The picture to copy.</param>
    /// <param name="left">Column of its left side here.</param>
    /// <param name="top">Row of its top here.</param>
    public void Paste(Image source, int left, int top)
    {
        ArgumentNullException.ThrowIfNull(source);
        int x0 = Math.Max(left, 0), x1 = Math.Min(left + source.Width, Width);
        if (x0 >= x1)
            return;
        for (int y = Math.Max(top, 0); y < Math.Min(top + source.Height, Height); y++)
            source.bytes.AsSpan(source.Index(x0 - left, y - top), 4 * (x1 - x0)).CopyTo(bytes.AsSpan(Index(x0, y)));
    }

    /// <summary>Pictures of any sizes side by side, middles aligned, on white: for before and after.</summary>
    /// <param name="pictures">At least one picture, from left to right.</param>
    public static Image SideBySide(params ReadOnlySpan<Image> pictures)
    {
        if (pictures.IsEmpty)
            throw new ArgumentException("At least one picture is needed.", nameof(pictures));
        int width = 0, height = 0;
        foreach (Image picture in pictures)
        {
            width += picture.Width;
            height = Math.Max(height, picture.Height);
        }
        var all = new Image(width, height, Color.White);
        int left = 0;
        foreach (Image picture in pictures)
        {
            all.Paste(picture, left, (height - picture.Height) / 2);
            left += picture.Width;
        }
        return all;
    }

    /// <summary>The picture as the bytes of a PNG file.</summary>
    public byte[] ToPng() => PngWriter.Encode(this);

    /// <summary>Writes the picture as a PNG file; folders on the way are made.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void SavePng(string path)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        byte[] png = ToPng();
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        AtomicFile.Write(path, stream => stream.Write(png));
    }

    /// <summary>Lays a colour over a pixel, mixing light, not stored values.</summary>
    internal void Blend(int x, int y, Color color, float coverage)
    {
        float a = color.A * coverage;
        if (a <= 0 || (uint)x >= (uint)Width || (uint)y >= (uint)Height)
            return;
        int i = Index(x, y);
        float below = bytes[i + 3] / 255f;
        float alpha = a + below * (1 - a);
        var old = new Vector3(Oklab.ToLinear(bytes[i]), Oklab.ToLinear(bytes[i + 1]), Oklab.ToLinear(bytes[i + 2]));
        Vector3 mixed = (Oklab.ToLinear(color) * a + old * (below * (1 - a))) / alpha;
        this[x, y] = Oklab.ToColor(mixed, alpha);
    }

    /// <summary>The nearest byte of a channel in [0, 1]; what is outside, or NaN, is clamped.</summary>
    internal static byte ToByte(float channel) => channel > 0 ? (byte)(Math.Min(channel, 1) * 255 + 0.5f) : (byte)0;

    private int Index(int x, int y)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)x, (uint)Width, nameof(x));
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)y, (uint)Height, nameof(y));
        return 4 * (y * Width + x);
    }
}
