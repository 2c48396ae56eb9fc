using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Numerics;

[Trait("Section", "10.6")]
public class ArctangentTests
{
    [Fact]
    public void Of_AnyAngle_IsWithinTwoUnitsOfTheSystemsFunction()
    {
        var random = new Random(11);
        for (int i = 0; i < 200_000; i++)
        {
            double angle = Math.PI * random.NextDouble(), size = Math.Pow(10, (random.NextDouble() * 40) - 20);
            double cross = size * Math.Sin(angle), dot = size * Math.Cos(angle), expected = Math.Atan2(cross, dot);
            Assert.True(Math.Abs(Arctangent.Of(cross, dot) - expected) <= 2 * Math.BitIncrement(expected) - (2 * expected), $"{cross:R} {dot:R}");
        }
    }

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(0, -1, Math.PI)]
    [InlineData(1, 0, Math.PI / 2)]
    [InlineData(2, 2, Math.PI / 4)]
    [InlineData(2, -2, 3 * Math.PI / 4)]
    [InlineData(0, 0, 0)]
    [InlineData(1e-300, 1, 1e-300)]
    public void Of_SpecialAngles_AreExact(double cross, double dot, double expected) => Assert.Equal(expected, Arctangent.Of(cross, dot));
}
