using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Surfaces of revolution (旋转面) about the z axis, the catenoid and a vase of quadrilaterals among them.</summary>
/// <remarks>
/// The profile is a row of points (r, z); walking along it, the outside is to the right, so it goes upward along an outer wall. Where it begins
/// or ends on the axis (r = 0) there is one pole vertex; elsewhere the surface is open there, or closed by a flat polygon when asked.
/// Vertices are numbered along the profile, ring after ring. O(points · segments).
/// </remarks>
public static class Revolutions
{
    /// <summary>Turns a profile about the z axis.</summary>
    /// <param name="profile">At least two points (r, z); r above 0, except 0 at either end.</param>
    /// <param name="segments">Cells around, at least 3.</param>
    /// <param name="faces">Triangles or quadrilaterals (triangles at poles in any case).</param>
    /// <param name="closeEnds">Whether ends off the axis are closed by one polygon each.</param>
    /// <exception cref="ArgumentException">The profile is too short, not finite, or touches the axis between its ends; the count is below 3.</exception>
    public static Mesh Revolve(
        ReadOnlySpan<Vector2D> profile, int segments, PatchFaces faces = PatchFaces.Triangles, bool closeEnds = false)
    {
        CheckProfile(profile, segments);
        int last = profile.Length - 1;
        var builder = new MeshBuilder();
        var first = new int[profile.Length];
        for (int j = 0; j <= last; j++)
        {
            first[j] = builder.VertexCount;
            if (profile[j].X == 0)
                builder.AddVertex(new(0, 0, profile[j].Y));
            else
                Polygons.AddRing(builder, segments, profile[j].X, profile[j].Y);
        }
        var uv = new List<Vector2D>();
        if (closeEnds && profile[0].X > 0)
            AddEnd(builder, uv, first[0], segments, up: false);
        for (int j = 0; j < last; j++)
        {
            for (int i = 0; i < segments; i++)
                AddCell(i, j, profile[j].X == 0, profile[j + 1].X == 0);
        }
        if (closeEnds && profile[last].X > 0)
            AddEnd(builder, uv, first[last], segments, up: true);
        Mesh mesh = builder.Build();
        TextureMapping.SetCorners(mesh, [.. uv]);
        return mesh;

        void AddCell(int i, int j, bool poleBelow, bool poleAbove)
        {
            int k = (i + 1) % segments;
            int a = first[j] + i, b = first[j] + k, c = first[j + 1] + k, d = first[j + 1] + i;
            double u = (double)i / segments, u1 = (i + 1.0) / segments, middle = (i + 0.5) / segments, v = (double)j / last, v1 = (j + 1.0) / last;
            if (poleBelow && poleAbove)
                throw new ArgumentException("The profile has two points on the axis in a row.", nameof(profile));
            if (poleBelow)
                Add([first[j], c, d], [new(middle, v), new(u1, v1), new(u, v1)]);
            else if (poleAbove)
                Add([a, b, first[j + 1]], [new(u, v), new(u1, v), new(middle, v1)]);
            else if (faces == PatchFaces.Quads)
                Add([a, b, c, d], [new(u, v), new(u1, v), new(u1, v1), new(u, v1)]);
            else
            {
                Add([a, b, c], [new(u, v), new(u1, v), new(u1, v1)]);
                Add([a, c, d], [new(u, v), new(u1, v1), new(u, v1)]);
            }
        }

        void Add(ReadOnlySpan<int> corners, ReadOnlySpan<Vector2D> coordinates)
        {
            builder.AddFace(corners);
            uv.AddRange(coordinates);
        }
    }

    /// <summary>The catenoid r = c cosh(z/c) (悬链面), the minimal surface between two rings: mean curvature 0 everywhere.</summary>
    /// <param name="c">The radius of the waist.</param>
    /// <param name="height">The distance of the rings.</param>
    /// <param name="segments">Cells around, at least 3.</param>
    /// <param name="rings">Cells along the axis, at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is too small, or a length is not finite and positive.</exception>
    public static Mesh Catenoid(double c = 0.5, double height = 1, int segments = 64, int rings = 32)
    {
        Check.Positive(c);
        Check.Positive(height);
        Check.Count(rings, 1);
        var profile = new Vector2D[rings + 1];
        for (int j = 0; j <= rings; j++)
        {
            double z = height * HeightFields.Centered(j, rings + 1);
            profile[j] = new(c * Math.Cosh(z / c), z);
        }
        return Revolve(profile, segments);
    }

    /// <summary>A closed vase, mostly of quadrilaterals: triangles around the pole inside, one polygon as its foot.</summary>
    /// <param name="segments">Cells around, at least 3.</param>
    /// <param name="rings">Cells along the outer wall, at least 4.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is too small.</exception>
    public static Mesh Vase(int segments = 48, int rings = 40)
    {
        Check.Count(segments, 3);
        Check.Count(rings, 4);
        const double thickness = 0.03;
        var profile = new List<Vector2D>();
        for (int j = 0; j <= rings; j++)
            profile.Add(new(Wall((double)j / rings), (double)j / rings));
        for (int j = rings; j >= 1; j--)
        {
            double z = Math.Max(0.06, (double)j / rings);
            profile.Add(new(Wall(z) - thickness, z - (j == rings ? 0.012 : 0)));
            if (z == 0.06)
                break;
        }
        profile.Add(new(0, 0.06));
        return Revolve([.. profile], segments, PatchFaces.Quads, closeEnds: true);

        static double Wall(double z) => 0.22 + 0.13 * Math.Sin(0.6 + 5.2 * z) * (1 - 0.35 * z);
    }

    private static void CheckProfile(ReadOnlySpan<Vector2D> profile, int segments)
    {
        Check.Count(segments, 3);
        if (profile.Length < 2)
            throw new ArgumentException("A profile has at least two points.", nameof(profile));
        Check.Finite(profile, nameof(profile));
        Check.Elements(segments, profile.Length, nameof(segments));
        for (int j = 0; j < profile.Length; j++)
        {
            if (profile[j].X < 0 || (profile[j].X == 0 && j > 0 && j < profile.Length - 1))
                throw new ArgumentException($"Point {j} of the profile, {profile[j]}, lies on the axis or beyond it.", nameof(profile));
        }
    }

    private static void AddEnd(MeshBuilder builder, List<Vector2D> uv, int first, int segments, bool up)
    {
        var corners = new int[segments];
        for (int i = 0; i < segments; i++)
        {
            int k = up ? i : segments - 1 - i;
            corners[i] = first + k;
            uv.Add(0.5 * (UnitCircle.At(k, segments) + new Vector2D(1, 1)));
        }
        builder.AddFace(corners);
    }
}
