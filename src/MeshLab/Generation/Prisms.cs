using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>§2.3 柱体 (prisms): regular polygons at z = ±h/2, two triangles per side.</summary>
/// <remarks>
/// The lower corners come first, then the upper ones, then the centres of the caps (n ≥ 5). n = 3: V = 6, F = 8; n = 4: V = 8, F = 12;
/// n ≥ 5: V = 2n + 2, F = 4n. Closed, χ = 2. O(n).
/// </remarks>
public static class Prisms
{
    /// <summary>A prism over a regular polygon.</summary>
    /// <param name="n">The number of corners of the base, at least 3.</param>
    /// <param name="height">The distance of the caps.</param>
    /// <param name="radius">The radius of the caps.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="n"/> is below 3, or a length is not finite and positive.</exception>
    public static Mesh Create(int n, double height, double radius = 0.5)
    {
        Check.Count(n, 3);
        Check.Positive(height);
        Check.Positive(radius);
        var builder = new MeshBuilder();
        Polygons.AddRing(builder, n, radius, -height / 2);
        Polygons.AddRing(builder, n, radius, height / 2);
        Polygons.AddCap(builder, 0, n, -height / 2, up: false);
        Polygons.AddCap(builder, n, n, height / 2, up: true);
        for (int i = 0; i < n; i++)
        {
            int j = (i + 1) % n;
            builder.AddFace(i, j, n + j);
            builder.AddFace(i, n + j, n + i);
        }
        return builder.Build();
    }

    /// <summary>The cube (立方体) of edge √2/2: eight corners on the sphere of radius √6/4, twelve triangles.</summary>
    public static Mesh Cube() => Create(4, Math.Sqrt(0.5));

    /// <summary>A cylinder (圆柱) with caps: the textbook's has 50 sides and height 1.</summary>
    /// <inheritdoc cref="Create"/>
    public static Mesh Cylinder(int n = 50, double height = 1, double radius = 0.5) => Create(n, height, radius);

    /// <summary>A cylinder without caps, with texture coordinates (UV 圆柱面): V = n (rings + 1), F = 2 n · rings, χ = 0, two boundary loops.</summary>
    /// <param name="n">Cells around, at least 3.</param>
    /// <param name="rings">Cells along the axis, at least 1.</param>
    /// <param name="height">The length of the axis.</param>
    /// <param name="radius">The radius.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is too small, or a length is not finite and positive.</exception>
    public static Mesh OpenCylinder(int n = 50, int rings = 1, double height = 1, double radius = 0.5)
    {
        Check.Count(n, 3);
        Check.Count(rings, 1);
        Check.Positive(height);
        Check.Positive(radius);
        Check.Elements(n, rings + 1L, nameof(n));
        return new Patch(n, rings, JoinU: true).Build((i, j) => Polygons.OnCircle(i, n, radius, height * (2.0 * j - rings) / (2.0 * rings)));
    }
}
