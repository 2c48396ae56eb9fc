using MeshLab.Numerics;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

[Trait("Section", "pictures")]
public class PngWriterTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(7, 3)]
    [InlineData(64, 41)]
    public void Encode_OpaquePicture_DecodesToTheSamePixels(int width, int height)
    {
        Image image = Noise(width, height, opaque: true);

        Png png = Png.Read(image.ToPng());

        Assert.Equal((width, height, 3), (png.Width, png.Height, png.Channels));
        Assert.Equal(image.Bytes.ToArray().Where((_, i) => i % 4 != 3), png.Pixels);
    }

    [Fact]
    public void Encode_SeeThroughPicture_KeepsTheOpacity()
    {
        Image image = Noise(33, 20, opaque: false);

        Png png = Png.Read(image.ToPng());

        Assert.Equal(4, png.Channels);
        Assert.Equal(image.Bytes.ToArray(), png.Pixels);
    }

    [Fact]
    public void Encode_Twice_GivesTheSameBytes() => Assert.Equal(Noise(50, 50, true).ToPng(), Noise(50, 50, true).ToPng());

    [Theory]
    [InlineData(0, 5)]
    [InlineData(5, 0)]
    [InlineData(-1, 5)]
    [InlineData(40000, 5)]
    public void Image_BadSize_Throws(int width, int height) => Assert.Throws<ArgumentOutOfRangeException>(() => new Image(width, height));

    [Fact]
    public void SavePng_NewFolder_IsMade()
    {
        string folder = Directory.CreateTempSubdirectory().FullName;
        try
        {
            string path = Path.Combine(folder, "a", "b.png");
            new Image(2, 2, Color.White).SavePng(path);
            Assert.Equal(2, Png.Read(File.ReadAllBytes(path)).Width);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void DrawText_OutsideThePicture_ChangesNothing()
    {
        var image = new Image(20, 20, Color.White);
        image.DrawText("far away", 500, 500, 14, Color.Black);
        image.DrawText("far away", -500, -500, 14, Color.Black);
        Assert.All(image.Bytes.ToArray(), b => Assert.Equal(255, b));
    }

    [Fact]
    public void DrawText_EveryPrintableCharacter_LeavesInkExceptSpace()
    {
        for (char c = '!'; c <= '~'; c++)
        {
            var image = new Image(40, 40, Color.White);
            image.DrawText(c.ToString(), 8, 28, 20, Color.Black);
            Assert.Contains(image.Bytes.ToArray(), b => b < 200);
            Assert.True(ImageDrawing.MeasureText(c.ToString(), 20) > 2, $"'{c}' has no width");
        }
    }

    [Fact]
    public void DrawLine_Horizontal_CoversItsWidth()
    {
        var image = new Image(20, 11, Color.White);
        image.DrawLine([new(-5, 5.5), new(25, 5.5)], Color.Black, 3);
        Assert.Equal([255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255], Enumerable.Range(0, 11).Select(y => (int)image.Bytes[4 * (y * 20 + 10)]));
    }

    private static Image Noise(int width, int height, bool opaque)
    {
        var random = new Random(width * 1000 + height);
        var image = new Image(width, height);
        for (int y = 0; y < height; y++)
        {
            // Half of the rows smooth, so that different filters are chosen.
            for (int x = 0; x < width; x++)
            {
                byte r = y % 2 == 0 ? (byte)(x * 3 + y) : (byte)random.Next(256);
                image[x, y] = Color.FromBytes(r, (byte)(x + y * 5), (byte)random.Next(8), opaque ? (byte)255 : (byte)random.Next(256));
            }
        }
        return image;
    }
}
