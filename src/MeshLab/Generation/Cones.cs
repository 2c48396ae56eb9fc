using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>§2.2 锥体 (cones): a regular polygon at z = −h/2 facing down, joined to an apex at (0, 0, h/2).</summary>
/// <remarks>
/// Corners come first, then the centre of the base if it has one (n ≥ 5), the apex last. n = 3: V = 4, F = 4; n = 4: V = 5, F = 6;
/// n ≥ 5: V = n + 2, F = 2n. Closed, χ = 2. O(n).
/// </remarks>
public static class Cones
{
    private static readonly double HalfRootOfTwo = Math.Sqrt(0.5);

    /// <summary>A cone over a regular polygon.</summary>
    /// <param name="n">The number of corners of the base, at least 3.</param>
    /// <param name="height">The distance of the apex from the base.</param>
    /// <param name="radius">The radius of the base.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="n"/> is below 3, or a length is not finite and positive.</exception>
    public static Mesh Create(int n, double height, double radius = 0.5)
    {
        Check.Count(n, 3);
        Check.Positive(height);
        Check.Positive(radius);
        var builder = new MeshBuilder();
        Polygons.AddRing(builder, n, radius, -height / 2);
        Polygons.AddCap(builder, 0, n, -height / 2, up: false);
        int apex = builder.AddVertex(new(0, 0, height / 2));
        for (int i = 0; i < n; i++)
            builder.AddFace(i, (i + 1) % n, apex);
        return builder.Build();
    }

    /// <summary>A square pyramid (四棱锥), height √2/2: half of a regular octahedron on its square.</summary>
    public static Mesh Pyramid() => Create(4, HalfRootOfTwo);

    /// <summary>The tetrahedron (四面体), height √2/2, which is regular.</summary>
    public static Mesh Tetrahedron() => Create(3, HalfRootOfTwo);

    /// <summary>A cone (圆锥): the textbook's has 50 sides.</summary>
    /// <inheritdoc cref="Create"/>
    public static Mesh Cone(int n = 50, double height = 0.70710678118654757, double radius = 0.5) => Create(n, height, radius);
}
