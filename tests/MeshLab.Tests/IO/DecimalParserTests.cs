using System.Globalization;
using System.Text;
using MeshLab.IO;
using Xunit;

namespace MeshLab.Tests.IO;

[Trait("Section", "14")]
public class DecimalParserTests
{
    [Theory]
    [InlineData("0")]
    [InlineData("-0")]
    [InlineData("+0.0e5")]
    [InlineData(".5")]
    [InlineData("-5.")]
    [InlineData("1E+5")]
    [InlineData("1e23")]
    [InlineData("9007199254740993")]
    [InlineData("9007199254740993e-22")]
    [InlineData("123456789012345678901234567890")]
    [InlineData("0.000000000000000000000000000000000001")]
    [InlineData("4.9e-324")]
    [InlineData("2.2250738585072011e-308")]
    [InlineData("1.7976931348623157e308")]
    [InlineData("18446744073709551615")]
    [InlineData("18446744073709551616")]
    [InlineData("1.00000000000000011102230246251565404236316680908203125")]
    [InlineData("1.00000000000000011102230246251565404236316680908203124")]
    [InlineData("6.631236846766476e-316")]
    [InlineData("1e-400")]
    public void TryParse_EdgeCases_GivesTheNearestDouble(string text) => AssertAsRuntime(text);

    [Theory]
    [InlineData("")]
    [InlineData("-")]
    [InlineData(".")]
    [InlineData("nan")]
    [InlineData("inf")]
    [InlineData("Infinity")]
    [InlineData("1e")]
    [InlineData("1e+")]
    [InlineData("--1")]
    [InlineData("1.5abc")]
    [InlineData("1,5")]
    [InlineData("1.5.5")]
    [InlineData("0x10")]
    public void TryParse_NotANumber_IsRefused(string text) => Assert.False(DecimalParser.TryParse(Encoding.UTF8.GetBytes(text), out _, out _));

    [Fact]
    public void TryParse_ShortestTextOfRandomDoubles_GivesTheSameBits()
    {
        Random random = new(11);
        for (int i = 0; i < 60_000; i++)
        {
            double x = (i % 4) switch
            {
                0 => BitConverter.Int64BitsToDouble(random.NextInt64()),
                1 => random.NextDouble() * 2 - 1,
                2 => (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-70, 70)),
                _ => (float)(random.NextDouble() * 200 - 100),
            };
            if (double.IsFinite(x))
                AssertAsRuntime(x.ToString(CultureInfo.InvariantCulture));
        }
    }

    [Fact]
    public void TryParse_RandomDigits_GivesTheNearestDouble()
    {
        Random random = new(12);
        for (int i = 0; i < 40_000; i++)
        {
            string digits = string.Concat(Enumerable.Range(0, random.Next(1, 24)).Select(_ => (char)('0' + random.Next(10))));
            AssertAsRuntime(i % 2 == 0 ? digits : $"{digits}e{random.Next(-90, 90)}");
        }
    }

    [Fact]
    public void TryParse_HalfwayBetweenTwoDoubles_RoundsToEven()
    {
        Random random = new(13);
        for (int i = 0; i < 8_000; i++)
        {
            // An odd integer of 54 bits times a power of two lies exactly between two doubles.
            ulong halfway = (1UL << 53) + (ulong)random.NextInt64(1L << 52) * 2 + 1;
            AssertAsRuntime(halfway.ToString(CultureInfo.InvariantCulture));
            AssertAsRuntime(((UInt128)halfway * 5).ToString(CultureInfo.InvariantCulture) + "e-1");
            AssertAsRuntime(((UInt128)halfway * 5).ToString(CultureInfo.InvariantCulture) + "e1");
        }
    }

    private static void AssertAsRuntime(string text)
    {
        double expected = double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
        Assert.True(DecimalParser.TryParse(Encoding.UTF8.GetBytes(text + " 7"), out double value, out int length), text);
        Assert.Equal(text.Length, length);
        Assert.True(BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(value), $"{text}: {value} instead of {expected}");
    }
}
