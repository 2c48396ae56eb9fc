using System.Globalization;
using System.Text;
using MeshLab.IO;
using Xunit;

namespace MeshLab.Tests.IO;

[Trait("Section", "14")]
public class ShortestDecimalTests
{
    [Theory]
    [InlineData(0.0, "0")]
    [InlineData(-0.0, "-0")]
    [InlineData(1.0, "1")]
    [InlineData(-120.0, "-120")]
    [InlineData(0.1, "0.1")]
    [InlineData(1 / 3.0, "0.3333333333333333")]
    [InlineData(1e-4, "0.0001")]
    [InlineData(1e-5, "1E-05")]
    [InlineData(1.25e-7, "1.25E-07")]
    [InlineData(123456789012345, "123456789012345")]
    [InlineData(1e15, "1E+15")]
    [InlineData(9007199254740992, "9007199254740992")]
    [InlineData(1e22, "1E+22")]
    [InlineData(5e22, "5E+22")]
    [InlineData(5e-324, "5E-324")]
    [InlineData(double.MaxValue, "1.7976931348623157E+308")]
    [InlineData(2.2250738585072014E-308, "2.2250738585072014E-308")]
    public void Format_KnownNumbers_GivesTheShortestText(double value, string expected) => Assert.Equal(expected, Format(value));

    [Fact]
    public void Format_PowersOfTwo_AreReadBack()
    {
        for (int e = -1074; e < 1024; e++)
        {
            double x = Math.ScaleB(1, e);
            Assert.Equal(x, double.Parse(Format(x), CultureInfo.InvariantCulture));
        }
    }

    [Fact]
    public void Format_RandomDoubles_GivesTheRuntimesDigitsAndTheSameBits()
    {
        Random random = new(17);
        for (int i = 0; i < 120_000; i++)
        {
            double x = (i % 6) switch
            {
                0 => BitConverter.Int64BitsToDouble(random.NextInt64(long.MinValue, long.MaxValue)),
                1 => random.NextDouble() * 2 - 1,
                2 => (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-60, 60)),
                3 => (float)(random.NextDouble() * 200 - 100),
                4 => Math.Round(random.NextDouble() * 1000, random.Next(0, 12)),
                _ => Math.ScaleB(1, random.Next(-190, 190)),
            };
            if (i % 12 == 5)
                x = Math.BitDecrement(x);
            if (!double.IsFinite(x))
                continue;
            string expected = x.ToString(CultureInfo.InvariantCulture), text = Format(x);
            // The runtime's text of 2⁻²⁵ reads back as another number; there it is no measure.
            if (double.Parse(expected, CultureInfo.InvariantCulture) == x)
                Assert.True(Digits(expected) == Digits(text), $"{text} instead of {expected}");
            Assert.Equal(BitConverter.DoubleToInt64Bits(x), BitConverter.DoubleToInt64Bits(double.Parse(text, CultureInfo.InvariantCulture)));
        }
    }

    private static string Digits(string number) => number.Split('E')[0].Replace(".", "", StringComparison.Ordinal).Trim('-', '0').TrimEnd('0');

    private static string Format(double value)
    {
        Span<byte> buffer = stackalloc byte[40];
        return Encoding.ASCII.GetString(buffer[..ShortestDecimal.Format(value, buffer)]);
    }
}
