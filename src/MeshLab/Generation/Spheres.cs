using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>§2.4 球面 (spheres): by meridians and parallels, and by subdividing the icosahedron; ellipsoids.</summary>
public static class Spheres
{
    /// <summary>The UV sphere: n meridians, n − 1 parallels and two pole vertices. V = n(n − 1) + 2, F = 2n(n − 1), χ = 2. O(n²).</summary>
    /// <remarks>Vertex 0 is the south pole (0, 0, −r), then the parallels upward, the north pole last. Area and volume converge with 1/n².</remarks>
    /// <param name="n">At least 3.</param>
    /// <param name="radius">The radius.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="n"/> is below 3, or the radius is not finite and positive.</exception>
    public static Mesh UVSphere(int n = 32, double radius = 1) => Ellipsoid(radius, radius, radius, n);

    /// <summary>An ellipsoid (椭球) with half-axes a, b, c, cut like the UV sphere: volume 4/3 πabc in the limit.</summary>
    /// <param name="a">The half-axis along x.</param>
    /// <param name="b">The half-axis along y.</param>
    /// <param name="c">The half-axis along z.</param>
    /// <param name="n">At least 3.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="n"/> is below 3, or a half-axis is not finite and positive.</exception>
    public static Mesh Ellipsoid(double a = 1, double b = 0.75, double c = 0.5, int n = 32)
    {
        Check.Count(n, 3);
        Check.Positive(a);
        Check.Positive(b);
        Check.Positive(c);
        var profile = new Vector2D[n + 1];
        for (int j = 0; j <= n; j++)
        {
            // Half a turn from the south pole to the north pole.
            Vector2D p = UnitCircle.At(j, 2L * n);
            profile[j] = new(p.Y, -p.X);
        }
        Mesh mesh = Revolutions.Revolve(profile, n);
        foreach (ref Vector3D p in mesh.Positions)
            p = new(a * p.X, b * p.Y, c * p.Z);
        return mesh;
    }

    /// <summary>The icosahedron subdivided (经细分的二十面体), every vertex on the sphere: V = 10 · 4ˡ + 2, F = 20 · 4ˡ. O(F).</summary>
    /// <param name="level">How often each triangle is cut into four, from 0 to 9.</param>
    /// <param name="radius">The radius.</param>
    /// <exception cref="ArgumentOutOfRangeException">The level is out of range, or the radius is not finite and positive.</exception>
    public static Mesh Icosphere(int level = 3, double radius = 1)
    {
        Check.Count(level, 0, 9);
        Check.Positive(radius);
        PolygonSoup soup = PolygonSoup.From(Polyhedra.Icosahedron());
        for (int step = 0; step < level; step++)
            soup = SplitEveryTriangle(soup);
        foreach (ref Vector3D p in soup.Positions.AsSpan())
            p *= radius;
        return MeshBuilder.FromSoup(soup, NonManifoldPolicy.Throw, out _);
    }

    private static PolygonSoup SplitEveryTriangle(PolygonSoup soup)
    {
        int[] old = soup.Corners;
        var positions = new List<Vector3D>(4 * soup.VertexCount);
        positions.AddRange(soup.Positions);
        var middles = new Dictionary<(int, int), int>(old.Length);
        var corners = new int[4 * old.Length];
        for (int c = 0, d = 0; c < old.Length; c += 3)
        {
            int a = old[c], b = old[c + 1], e = old[c + 2];
            int ab = Middle(a, b), be = Middle(b, e), ea = Middle(e, a);
            foreach (int corner in (ReadOnlySpan<int>)[a, ab, ea, ab, b, be, ea, be, e, ab, be, ea])
                corners[d++] = corner;
        }
        return new([.. positions], PolygonSoup.TriangleStarts(corners.Length, nameof(soup)), corners);

        int Middle(int a, int b)
        {
            (int, int) edge = a < b ? (a, b) : (b, a);
            if (!middles.TryGetValue(edge, out int middle))
            {
                middles[edge] = middle = positions.Count;
                positions.Add((positions[a] + positions[b]).Normalized());
            }
            return middle;
        }
    }
}
