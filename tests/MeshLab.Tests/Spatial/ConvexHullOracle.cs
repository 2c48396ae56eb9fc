namespace MeshLab.Tests.Spatial;

/// <summary>
/// Whether the convex hulls of two small sets of integer points have a common point, by separating planes in integers: another method
/// than the library's, slow and without special cases. The normal of a separating plane can be chosen among the products of edges,
/// their products with edges (all points in a plane) and the edges themselves (all on a line).
/// </summary>
internal static class ConvexHullOracle
{
    public static bool Meet((long X, long Y, long Z)[] p, (long X, long Y, long Z)[] q)
    {
        (long X, long Y, long Z)[] all = [.. p, .. q];
        var edges = new HashSet<(long X, long Y, long Z)>();
        foreach (var a in all)
        {
            foreach (var b in all)
                edges.Add((b.X - a.X, b.Y - a.Y, b.Z - a.Z));
        }
        foreach (var e in edges)
        {
            if (Separates(e, p, q))
                return false;
            foreach (var f in edges)
            {
                var n = Cross(e, f);
                if (n == default)
                    continue;
                if (Separates(n, p, q) || Separates(Cross(n, e), p, q))
                    return false;
            }
        }
        return true;
    }

    private static bool Separates((long X, long Y, long Z) n, (long X, long Y, long Z)[] p, (long X, long Y, long Z)[] q) =>
        p.Max(v => Dot(n, v)) < q.Min(v => Dot(n, v));

    private static long Dot((long X, long Y, long Z) a, (long X, long Y, long Z) b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    private static (long X, long Y, long Z) Cross((long X, long Y, long Z) a, (long X, long Y, long Z) b) =>
        (a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
