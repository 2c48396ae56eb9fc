using MeshLab.Numerics;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

[Trait("Section", "pictures")]
public class ColorMapTests
{
    [Fact]
    public void Sample_Ends_AreTheGivenColors()
    {
        Near(Color.FromBytes(0x44, 0x01, 0x54), ColorMap.Viridis.Sample(0));
        Near(Color.FromBytes(0xFD, 0xE7, 0x25), ColorMap.Viridis.Sample(1));
        Near(Color.FromBytes(0x00, 0x00, 0x04), ColorMap.Magma.Sample(-3));
        Near(Color.FromBytes(0xFE, 0xE8, 0x38), ColorMap.Cividis.Sample(7));
        Near(ColorMap.Cyclic.Sample(0), ColorMap.Cyclic.Sample(1));
    }

    [Theory]
    [InlineData("viridis")]
    [InlineData("magma")]
    [InlineData("cividis")]
    [InlineData("gray")]
    public void Sample_SequentialMap_LightnessRisesThroughout(string name)
    {
        ColorMap map = ColorMap.Parse(name);
        double[] lightness = [.. Enumerable.Range(0, 201).Select(i => Oklab.FromColor(map.Sample(i / 200.0)).L)];
        for (int i = 1; i < lightness.Length; i++)
            Assert.True(lightness[i] > lightness[i - 1] - 1e-6, $"{name} at {i}: {lightness[i]} after {lightness[i - 1]}");
        Assert.True(lightness[^1] - lightness[0] > 0.5);
    }

    [Fact]
    public void Sample_Coolwarm_IsLightestInTheMiddle()
    {
        double middle = Oklab.FromColor(ColorMap.Coolwarm.Sample(0.5)).L;
        Assert.All(Enumerable.Range(0, 101), i => Assert.True(Oklab.FromColor(ColorMap.Coolwarm.Sample(i / 100.0)).L <= middle + 0.005));
        Assert.True(ColorMap.Coolwarm.Sample(0).B > ColorMap.Coolwarm.Sample(0).R);
        Assert.True(ColorMap.Coolwarm.Sample(1).R > ColorMap.Coolwarm.Sample(1).B);
    }

    [Fact]
    public void Sample_NotANumber_IsNeutralGrey() => Assert.Equal(ColorMap.NotANumber, ColorMap.Viridis.Sample(double.NaN));

    [Fact]
    public void Sample_AllMaps_ChangeSmoothly()
    {
        foreach (ColorMap map in ColorMap.All)
        {
            for (int i = 0; i < 256; i++)
                Assert.True(Oklab.Difference(map.Sample(i / 256.0), map.Sample((i + 1) / 256.0)) < 0.02, $"{map} at {i}");
        }
    }

    [Fact]
    public void Reversed_Ends_AreExchanged() => Near(ColorMap.Magma.Sample(1), ColorMap.Magma.Reversed().Sample(0));

    [Fact]
    public void Parse_UnknownName_ListsTheNames() =>
        Assert.Contains("viridis", Assert.Throws<ArgumentException>(() => ColorMap.Parse("rainbow")).Message, StringComparison.Ordinal);

    [Fact]
    public void ColorMap_OneColor_Throws() => Assert.Throws<ArgumentException>(() => new ColorMap("one", [Color.White]));

    [Fact]
    public void Categorical_First24_AreFarApart()
    {
        Color[] colors = [.. Enumerable.Range(0, Palette.ChosenCount).Select(Palette.Categorical)];
        Assert.True(colors.Length >= 20);
        for (int i = 0; i < colors.Length; i++)
        {
            for (int j = 0; j < i; j++)
                Assert.True(Oklab.Difference(colors[i], colors[j]) > 0.09, $"colours {j} and {i} look alike");
        }
    }

    [Fact]
    public void Categorical_Extension_DiffersFromNeighbours()
    {
        for (int i = 0; i < 200; i++)
            Assert.True(Oklab.Difference(Palette.Categorical(i), Palette.Categorical(i + 1)) > 0.08, $"colours {i} and {i + 1} look alike");
        Assert.Equal(ColorMap.NotANumber, Palette.Categorical(-1));
    }

    [Fact]
    public void Oklab_RoundTrip_GivesTheColorBack()
    {
        foreach (Color color in Enumerable.Range(0, 24).Select(Palette.Categorical))
        {
            var (l, a, b) = Oklab.FromColor(color);
            Near(color, Oklab.ToColor(l, a, b));
        }
    }

    private static void Near(Color expected, Color actual)
    {
        Assert.InRange(actual.R, expected.R - 0.004f, expected.R + 0.004f);
        Assert.InRange(actual.G, expected.G - 0.004f, expected.G + 0.004f);
        Assert.InRange(actual.B, expected.B - 0.004f, expected.B + 0.004f);
    }
}
