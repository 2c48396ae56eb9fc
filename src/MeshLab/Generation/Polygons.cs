using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>§2.1 正多边形与圆 (regular polygons and the circle), flat in z = const, facing up.</summary>
/// <remarks>
/// Vertex i lies at (r cos 2πi/n, r sin 2πi/n, z). Three corners make one triangle, four make two, five and more a fan around a centre vertex,
/// which comes last. O(n).
/// </remarks>
public static class Polygons
{
    /// <summary>A regular polygon.</summary>
    /// <param name="n">The number of corners, at least 3.</param>
    /// <param name="radius">The distance of the corners from the centre.</param>
    /// <param name="z">The height of the plane.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="n"/> is below 3, or a length is not finite and positive.</exception>
    public static Mesh Polygon(int n, double radius = 0.5, double z = 0)
    {
        Check.Count(n, 3);
        Check.Positive(radius);
        Check.Finite(z);
        var builder = new MeshBuilder();
        AddRing(builder, n, radius, z);
        AddCap(builder, 0, n, z, up: true);
        Mesh mesh = builder.Build();
        var uv = new Vector2D[mesh.VertexSlots];
        for (int v = 0; v < uv.Length; v++)
            uv[v] = v < n ? 0.5 * (UnitCircle.At(v, n) + new Vector2D(1, 1)) : new(0.5, 0.5);
        TextureMapping.SetVertices(mesh, uv);
        return mesh;
    }

    /// <summary>A circle (圆): the textbook's is the 50-gon. Its area misses that of the disc by O(1/n²).</summary>
    /// <inheritdoc cref="Polygon"/>
    public static Mesh Circle(int n = 50, double radius = 0.5, double z = 0) => Polygon(n, radius, z);

    /// <summary>A flat ring (圆环): χ = 0, two boundary loops, 2 · segments · rings triangles.</summary>
    /// <param name="inner">The radius of the hole.</param>
    /// <param name="outer">The radius of the rim, larger.</param>
    /// <param name="segments">Cells around, at least 3.</param>
    /// <param name="rings">Cells from the hole to the rim.</param>
    /// <exception cref="ArgumentException">A count is too small, a radius is not positive, or the rim is not outside the hole.</exception>
    public static Mesh Annulus(double inner = 0.25, double outer = 0.5, int segments = 48, int rings = 4)
    {
        Check.Positive(inner);
        Check.Positive(outer);
        if (outer <= inner)
            throw new ArgumentOutOfRangeException(nameof(outer), outer, $"The outer radius must be above the inner one, {inner}.");
        Check.Count(segments, 3);
        Check.Count(rings, 1);
        Check.Elements(segments, rings + 1L, nameof(segments));
        // u turns clockwise so that ∂u × ∂v is +z while v grows outward.
        return new Patch(segments, rings, JoinU: true).Build((i, j) => OnCircle(-i, segments, inner + (outer - inner) * j / rings, 0));
    }

    internal static Vector3D OnCircle(long i, long n, double radius, double z)
    {
        Vector2D p = UnitCircle.At(i, n);
        return new(radius * p.X, radius * p.Y, z);
    }

    internal static void AddRing(MeshBuilder builder, int n, double radius, double z)
    {
        for (int i = 0; i < n; i++)
            builder.AddVertex(OnCircle(i, n, radius, z));
    }

    /// <summary>Fills the ring of vertices <paramref name="first"/> … <paramref name="first"/> + n − 1 as §2.1 says.</summary>
    internal static void AddCap(MeshBuilder builder, int first, int n, double z, bool up)
    {
        if (n <= 4)
        {
            for (int i = 1; i + 1 < n; i++)
                AddTriangle(first, first + i, first + i + 1);
            return;
        }
        int center = builder.AddVertex(new(0, 0, z));
        for (int i = 0; i < n; i++)
            AddTriangle(center, first + i, first + (i + 1) % n);

        void AddTriangle(int a, int b, int c)
        {
            if (up)
                builder.AddFace(a, b, c);
            else
                builder.AddFace(a, c, b);
        }
    }
}
