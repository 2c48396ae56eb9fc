using MeshLab.Geometry;
using MeshLab.Numerics;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.1")]
[Trait("Section", "10.6")]
public class TriangleTests
{
    private static readonly Triangle Right = new(new(0, 0, 0), new(3, 0, 0), new(0, 4, 0));

    [Fact]
    public void Measures_RightTriangle345_AreExact()
    {
        Assert.Equal(6, Right.Area);
        Assert.Equal(6, Right.HeronArea);
        Assert.Equal(Vector3D.UnitZ, Right.Normal);
        Assert.Equal(new Vector3D(1, 4.0 / 3, 0), Right.Barycenter);
        Assert.Equal(new Vector3D(1.5, 2, 0), Right.Circumcenter);
        Assert.Equal(2.5, Right.Circumradius);
        Assert.Equal(1, Right.Inradius);
        Assert.Equal(Math.PI / 2, Right.AngleA, 1e-15);
        Assert.Equal(Math.PI, Right.AngleA + Right.AngleB + Right.AngleC, 1e-15);
        Assert.Equal(Math.Atan2(3, 4), Right.MinAngle, 1e-15);
        Assert.Equal(Math.PI / 2, Right.MaxAngle, 1e-15);
        Assert.Equal(2.0 * 1 / 2.5, Right.RadiusRatio, 1e-15);
        Assert.Equal(25.0 / 12, Right.AspectRatio, 1e-15);
    }

    [Fact]
    public void Quality_EquilateralTriangle_IsOne()
    {
        var triangle = new Triangle(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1));
        Assert.Equal(1, triangle.Quality, 1e-15);
        Assert.Equal(1, triangle.RadiusRatio, 1e-14);
        Assert.Equal(2 / Math.Sqrt(3), triangle.AspectRatio, 1e-15);
        Assert.Equal(Math.PI / 3, triangle.MinAngle, 1e-15);
    }

    [Fact]
    public void Quality_ZeroArea_IsZeroAndNothingIsNaN()
    {
        foreach (Triangle flat in (Triangle[])[new(default, new(1, 0, 0), new(2, 0, 0)), new(default, default, default), new(default, default, new(1, 1, 1))])
        {
            Assert.Equal(0, flat.Area);
            Assert.Equal(0, flat.HeronArea);
            Assert.Equal(default, flat.Normal);
            Assert.Equal(0, flat.Quality);
            Assert.Equal(0, flat.RadiusRatio);
            Assert.Equal(0, flat.Inradius);
            Assert.Equal(0, flat.MinAngle);
        }
    }

    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e-6)]
    [InlineData(1e-9)]
    public void HeronArea_Needle_KeepsAllDigits(double width)
    {
        // The thin end of an isosceles needle of length 1; the naive formula has no correct digit left at 1e-9.
        var needle = new Triangle(new(0, 0, 0), new(1, -width / 2, 0), new(1, width / 2, 0));
        Assert.Equal(width / 2, needle.Area, 1e-15 * width);
        Assert.Equal(width / 2, needle.HeronArea, 1e-9 * width);
    }

    [Fact]
    public void HeronArea_DoesNotDependOnTheOrderOfCorners()
    {
        var random = new Random(7);
        for (int i = 0; i < 100; i++)
        {
            Vector3D a = Next(), b = Next(), c = Next();
            double area = new Triangle(a, b, c).HeronArea;
            Assert.Equal(area, new Triangle(b, a, c).HeronArea);
            Assert.Equal(area, new Triangle(c, b, a).HeronArea);
            Assert.Equal(new Triangle(a, b, c).Area, area, 1e-12);
        }

        Vector3D Next() => new(random.NextDouble(), random.NextDouble(), random.NextDouble());
    }
}
