using System.Text;
using System.Text.Json;
using MeshLab.Cli.Hosting;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Cli;

[Trait("Section", "command line")]
public sealed class ResultFieldsTests
{
    [Fact]
    public void WriteTo_EveryPowerOfTwo_ReadsBackAsItself()
    {
        double[] powers = [.. Enumerable.Range(-1074, 2098).Select(power => Math.ScaleB(1, power))];
        AssertReadsBack(powers);
        AssertReadsBack([.. powers.Select(power => -Math.BitIncrement(power))]);
    }

    [Fact]
    public void WriteTo_RandomBits_ReadBackAsThemselves()
    {
        var random = new Random(5);
        AssertReadsBack([.. Enumerable.Range(0, 5000).Select(_ => BitConverter.Int64BitsToDouble(random.NextInt64())).Where(double.IsFinite)]);
    }

    [Theory]
    [InlineData(0.1, "0.1")]
    [InlineData(1, "1")]
    [InlineData(-0.0, "-0")]
    [InlineData(100, "100")]
    [InlineData(double.NaN, "\"NaN\"")]
    [InlineData(double.PositiveInfinity, "\"Infinity\"")]
    [InlineData(double.NegativeInfinity, "\"-Infinity\"")]
    public void WriteTo_Number_IsTheShortestText(double number, string text) => Assert.Equal($"{{\"x\":{text}}}", Json(new ResultFields().Add("x", number)));

    [Fact]
    public void WriteTo_EveryKindOfValue_IsJson()
    {
        string json = Json(new ResultFields()
            .Add("none", null)
            .Add("truth", true)
            .Add("vector", new Vector3D(1, 0.5, double.NaN))
            .Add("integers", (int[])[1, 2])
            .Add("nested", new ResultFields().Add("text", "a \"quoted\" 中文"))
            .Add("list", (object[])["a", 1, 2L]));
        Assert.Equal("{\"none\":null,\"truth\":true,\"vector\":[1,0.5,\"NaN\"],\"integers\":[1,2],\"nested\":{\"text\":\"a \\\"quoted\\\" 中文\"},\"list\":[\"a\",1,2]}", json);
        Assert.Throws<InvalidOperationException>(() => Json(new ResultFields().Add("type", typeof(int))));
    }

    private static void AssertReadsBack(double[] numbers)
    {
        using JsonDocument document = JsonDocument.Parse(Json(new ResultFields().Add("x", numbers)));
        int i = 0;
        foreach (JsonElement number in document.RootElement.GetProperty("x").EnumerateArray())
            Assert.Equal(BitConverter.DoubleToInt64Bits(numbers[i++]), BitConverter.DoubleToInt64Bits(number.GetDouble()));
        Assert.Equal(numbers.Length, i);
    }

    private static string Json(ResultFields fields)
    {
        using var buffer = new MemoryStream();
        using (var json = new Utf8JsonWriter(buffer, new JsonWriterOptions { Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
            fields.WriteTo(json);
        return Encoding.UTF8.GetString(buffer.ToArray());
    }
}
