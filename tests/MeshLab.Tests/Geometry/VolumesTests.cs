using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Geometry;

[Trait("Section", "10.2")]
public class VolumesTests
{
    /// <summary>The unit cube of quads with one corner at the place given.</summary>
    internal static Mesh Cube(Vector3D corner = default, double size = 1) => MeshBuilder.FromPolygons(
        [.. Enumerable.Range(0, 8).Select(i => corner + (size * new Vector3D(i & 1, (i >> 1) & 1, i >> 2)))],
        [0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]);

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1e6, 1)]
    [InlineData(-3e-6, 1e-6)]
    [InlineData(5, 1e6)]
    public void MassProperties_CubeAnywhere_AreExact(double offset, double size)
    {
        MassProperties mass = Cube(new(offset, 2 * offset, -offset), size).ComputeMassProperties();
        Assert.Equal(6 * size * size, mass.Area, 1e-9 * size * size);
        Assert.Equal(1, mass.Volume / (size * size * size), 1e-9);
        Vector3D center = new(offset + (size / 2), (2 * offset) + (size / 2), -offset + (size / 2));
        Assert.True(Vector3D.Distance(center, mass.VolumeCentroid) <= 1e-9 * Math.Max(size, Math.Abs(offset) * 1e-6));
        Assert.True(Vector3D.Distance(center, mass.SurfaceCentroid) <= 1e-9 * Math.Max(size, Math.Abs(offset) * 1e-6));
        double unit = Math.Pow(size, 5);
        Assert.Equal(1 / 6.0, mass.Inertia.XX / unit, 1e-8);
        Assert.Equal(1 / 6.0, mass.Inertia.YY / unit, 1e-8);
        Assert.Equal(0.5, mass.Inertia.Trace / unit, 1e-8);
        Assert.Equal(0, mass.Inertia.XY / unit, 1e-8);
        Assert.Equal(0, mass.Inertia.YZ / unit, 1e-8);
        Assert.Equal(0, mass.Inertia.ZX / unit, 1e-8);
    }

    [Fact]
    public void Volume_TurnedInsideOut_ChangesItsSign()
    {
        Mesh cube = MeshBuilder.FromPolygons(
            [.. Enumerable.Range(0, 8).Select(i => new Vector3D(i & 1, (i >> 1) & 1, i >> 2))],
            [1, 3, 2, 0], [6, 7, 5, 4], [4, 5, 1, 0], [5, 7, 3, 1], [7, 6, 2, 3], [6, 4, 0, 2]);
        Assert.Equal(-1, cube.Volume, 1e-15);
        Assert.Equal(0.5, cube.ComputeMassProperties().VolumeCentroid.X, 1e-15);
    }

    [Fact]
    public void Volume_OpenMesh_IsThatOfTheConeFromTheOrigin()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(1, 0, 0), new(0, 2, 0), new(0, 0, 3)], [0, 1, 2]);
        Assert.Equal(1, mesh.Volume, 1e-15);
    }

    [Fact]
    public void MassProperties_EmptyMesh_AreZeroWithoutCentroid()
    {
        MassProperties mass = new Mesh().ComputeMassProperties();
        Assert.Equal(0, mass.Area);
        Assert.Equal(0, mass.Volume);
        Assert.True(double.IsNaN(mass.SurfaceCentroid.X));
    }

    /// <summary>A box of sides a, b, c has the principal moments V(b² + c²)/12, …; turned by R the tensor is R diag Rᵀ, with all products.</summary>
    [Fact]
    public void Inertia_TurnedBox_HasTheTurnedTensor()
    {
        double[] side = [1, 2, 4], moment = [8 * 20 / 12.0, 8 * 17 / 12.0, 8 * 5 / 12.0];
        Vector3D[] axes = [new Vector3D(2, 1, 2) / 3, new Vector3D(-2, 2, 1) / 3, new Vector3D(-1, -2, 2) / 3];
        Mesh box = Cube(new(-0.5, -0.5, -0.5));
        foreach (ref Vector3D p in box.Positions)
            p = new Vector3D(10, -20, 30) + (side[0] * p.X * axes[0]) + (side[1] * p.Y * axes[1]) + (side[2] * p.Z * axes[2]);
        InertiaTensor inertia = box.ComputeMassProperties().Inertia;
        double Tensor(int i, int j) => Enumerable.Range(0, 3).Sum(k => moment[k] * axes[k][i] * axes[k][j]);
        Assert.Equal(Tensor(0, 0), inertia.XX, 1e-12);
        Assert.Equal(Tensor(1, 1), inertia.YY, 1e-12);
        Assert.Equal(Tensor(2, 2), inertia.ZZ, 1e-12);
        Assert.Equal(Tensor(0, 1), inertia.XY, 1e-12);
        Assert.Equal(Tensor(1, 2), inertia.YZ, 1e-12);
        Assert.Equal(Tensor(2, 0), inertia.ZX, 1e-12);
    }
}
