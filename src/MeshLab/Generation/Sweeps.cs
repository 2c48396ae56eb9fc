using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Surfaces swept by a polygon along a path (扫描表示): tubes, knots, a spring.</summary>
/// <remarks>
/// The profile lies in the plane across the path, in frames that turn about the path as little as possible (double reflection: Wang, Jüttler,
/// Zheng, Liu 2008). Around a closed path the remaining angle is spread evenly. O(path · profile).
/// </remarks>
public static class Sweeps
{
    /// <summary>Sweeps a closed profile along a path.</summary>
    /// <param name="profile">A polygon, counter-clockwise seen against the path's direction.</param>
    /// <param name="path">Points in order, neighbours apart; a closed path does not repeat its first point.</param>
    /// <param name="closed">Whether the path returns to its start: a torus-like surface; otherwise both ends are capped.</param>
    /// <param name="faces">Triangles or quadrilaterals for the walls; the caps are triangles.</param>
    /// <exception cref="ArgumentException">Too few points, points that are not finite, or two equal points in a row on the path.</exception>
    public static Mesh Sweep(ReadOnlySpan<Vector2D> profile, ReadOnlySpan<Vector3D> path, bool closed, PatchFaces faces = PatchFaces.Triangles)
    {
        CheckArguments(profile, path, closed);
        Vector2D[] shape = profile.ToArray();
        Frame[] frames = Frames(path, closed);
        var patch = new Patch(shape.Length, closed ? frames.Length : frames.Length - 1, JoinU: true, JoinV: closed, faces);
        if (closed)
            return patch.Build((i, j) => frames[j].Place(shape[i]));

        List<int> cap = EarClipping.Triangulate(shape, [0, shape.Length], nameof(profile));
        var builder = new MeshBuilder();
        foreach (Frame frame in frames)
        {
            foreach (Vector2D p in shape)
                builder.AddVertex(frame.Place(p));
        }
        int[] start = patch.FaceStarts(), corners = patch.Corners();
        for (int f = 0; f + 1 < start.Length; f++)
            builder.AddFace(corners.AsSpan(start[f], start[f + 1] - start[f]));
        int last = (frames.Length - 1) * shape.Length;
        for (int c = 0; c < cap.Count; c += 3)
        {
            builder.AddFace(cap[c], cap[c + 2], cap[c + 1]);
            builder.AddFace(last + cap[c], last + cap[c + 1], last + cap[c + 2]);
        }
        return builder.Build();
    }

    /// <summary>A tube along the (p, q) torus knot (环面纽结): a closed surface of genus 1. (2, 3) is the trefoil.</summary>
    /// <param name="p">Turns around the axis; no common factor with <paramref name="q"/>.</param>
    /// <param name="q">Turns through the hole.</param>
    /// <param name="segments">Cells along the knot, at least 3.</param>
    /// <param name="around">Cells around the tube, at least 3.</param>
    /// <param name="tube">The radius of the tube; up to about 0.35 the trefoil does not cut itself.</param>
    /// <exception cref="ArgumentException">A count is too small, p and q have a common factor, or the radius is not positive.</exception>
    public static Mesh TorusKnot(int p = 2, int q = 3, int segments = 240, int around = 20, double tube = 0.25)
    {
        Check.Count(p, 1, 1000);
        Check.Count(q, 1, 1000);
        if (System.Numerics.BigInteger.GreatestCommonDivisor(p, q) != 1)
            throw new ArgumentException($"{p} and {q} have a common factor: that is a link of several knots.", nameof(q));
        Check.Count(segments, 3);
        Check.Positive(tube);
        var path = new Vector3D[segments];
        for (int i = 0; i < segments; i++)
        {
            double r = 2 + UnitCircle.At((long)i * q, segments).X;
            path[i] = Polygons.OnCircle((long)i * p, segments, r, -UnitCircle.At((long)i * q, segments).Y);
        }
        return Sweep(Circle(around, tube), path, closed: true);
    }

    /// <summary>A spring (弹簧): a round wire along a helix, capped at both ends; χ = 2.</summary>
    /// <param name="turns">Turns of the helix.</param>
    /// <param name="segments">Cells per turn, at least 3.</param>
    /// <param name="around">Cells around the wire, at least 3.</param>
    /// <param name="wire">The radius of the wire.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is too small, or the radius is not positive.</exception>
    public static Mesh Spring(int turns = 5, int segments = 48, int around = 12, double wire = 0.1)
    {
        Check.Count(turns, 1, 10_000);
        Check.Count(segments, 3, 10_000);
        Check.Positive(wire);
        var path = new Vector3D[turns * segments + 1];
        for (int i = 0; i < path.Length; i++)
            path[i] = Polygons.OnCircle(i, segments, 0.5, 0.35 * (i - (path.Length - 1) / 2.0) / segments);
        return Sweep(Circle(around, wire), path, closed: false);
    }

    private static Vector2D[] Circle(int n, double radius)
    {
        Check.Count(n, 3, Check.MostSegments, "around");
        var circle = new Vector2D[n];
        for (int i = 0; i < n; i++)
            circle[i] = radius * UnitCircle.At(i, n);
        return circle;
    }

    private static void CheckArguments(ReadOnlySpan<Vector2D> profile, ReadOnlySpan<Vector3D> path, bool closed)
    {
        if (profile.Length < 3)
            throw new ArgumentException("A profile has at least three points.", nameof(profile));
        if (path.Length < (closed ? 3 : 2))
            throw new ArgumentException($"A path has at least {(closed ? 3 : 2)} points.", nameof(path));
        Check.Finite(profile, nameof(profile));
        Check.Finite(path, nameof(path));
        Check.Elements(profile.Length, path.Length, nameof(path));
        for (int i = closed ? 0 : 1; i < path.Length; i++)
        {
            if (path[i] == path[(i + path.Length - 1) % path.Length])
                throw new ArgumentException($"Point {i} of the path repeats the one before.", nameof(path));
        }
    }

    private static Frame[] Frames(ReadOnlySpan<Vector3D> path, bool closed)
    {
        int n = path.Length;
        var frames = new Frame[n];
        Vector3D tangent = Tangent(path, 0, closed);
        Vector3D across = Vector3D.Cross(tangent, Math.Abs(tangent.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX).Normalized();
        frames[0] = new(path[0], tangent, across);
        for (int i = 1; i < n; i++)
            frames[i] = frames[i - 1].TransportedTo(path[i], Tangent(path, i, closed));
        if (!closed)
            return frames;
        Frame around = frames[n - 1].TransportedTo(path[0], frames[0].Tangent);
        double twist = Math.Atan2(Vector3D.Dot(around.Normal, frames[0].Binormal), Vector3D.Dot(around.Normal, frames[0].Normal));
        for (int i = 1; i < n; i++)
            frames[i] = frames[i].Turned(-twist * i / n);
        return frames;
    }

    private static Vector3D Tangent(ReadOnlySpan<Vector3D> path, int i, bool closed)
    {
        int n = path.Length;
        int before = closed ? (i + n - 1) % n : Math.Max(0, i - 1), after = closed ? (i + 1) % n : Math.Min(n - 1, i + 1);
        Vector3D tangent = (path[after] - path[before]).Normalized();
        // A path that turns back on itself has no middle direction; the next segment's will do.
        return tangent == default ? (path[after] - path[i]).Normalized() : tangent;
    }

    private readonly record struct Frame(Vector3D Origin, Vector3D Tangent, Vector3D Normal)
    {
        public Vector3D Binormal => Vector3D.Cross(Tangent, Normal);

        public Vector3D Place(Vector2D p) => Origin + p.X * Normal + p.Y * Binormal;

        public Frame Turned(double angle) => this with { Normal = (Math.Cos(angle) * Normal + Math.Sin(angle) * Binormal).Normalized() };

        /// <summary>Reflects in the plane between the points, then in the plane between the tangents.</summary>
        public Frame TransportedTo(Vector3D origin, Vector3D tangent)
        {
            Vector3D step = origin - Origin;
            Vector3D normal = Reflect(Normal, step), reflected = Reflect(Tangent, step);
            normal = Reflect(normal, tangent - reflected);
            normal = (normal - Vector3D.Dot(normal, tangent) * tangent).Normalized();
            return new(origin, tangent, normal);
        }

        private static Vector3D Reflect(Vector3D v, Vector3D mirror)
        {
            double squared = mirror.LengthSquared;
            return squared < 1e-300 ? v : v - 2 * Vector3D.Dot(v, mirror) / squared * mirror;
        }
    }
}
