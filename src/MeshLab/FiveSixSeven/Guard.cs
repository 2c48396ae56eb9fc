using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>How much an operation may harm the shape.</summary>
/// <param name="MinimumCosine">Least cosine between new and replaced normals; below −1 nothing is asked of the shape.</param>
/// <param name="MinimumQuality">Least quality of a new triangle, unless an old one was worse.</param>
/// <param name="Tolerance">Largest distance of new triangles and edges from the input, in diagonals.</param>
internal readonly record struct GuardLevel(double MinimumCosine, double MinimumQuality, double Tolerance)
{
    public static GuardLevel TopologyOnly { get; } = new(-2, 0, double.PositiveInfinity);

    public bool AsksNothing => MinimumCosine < -1.5;
}

/// <summary>Whether flips, splits and collapses keep to the input's shape.</summary>
internal sealed class Guard(WorkMesh mesh, InputSurface surface)
{
    /// <summary>Below this a triangle's normal says nothing.</summary>
    private const double MeaningfulQuality = 1e-3;
    private const double LeastQuality = 1e-7;

    public WorkMesh Mesh { get; } = mesh;

    public InputSurface Surface { get; } = surface;

    /// <summary>The same guard for use at the same time by another thread.</summary>
    public Guard Fork() => new(Mesh, Surface.Fork());

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public bool AllowsFlip(int h, in GuardLevel level, bool mustImprove = false)
    {
        if (level.AsksNothing)
            return true;
        int t = h ^ 1;
        Vector3D a = At(Mesh.Target[t]), b = At(Mesh.Target[h]), c = At(Mesh.Apex(h)), d = At(Mesh.Apex(t));
        double q1 = Shape.Quality(a, b, c), q2 = Shape.Quality(b, a, d);
        double before = Math.Min(q1, q2), after = Math.Min(Shape.Quality(d, c, a), Shape.Quality(c, d, b));
        if (after < Math.Min(level.MinimumQuality, before) || after < LeastQuality || (mustImprove && after < before * 1.02 + 1e-9))
            return false;
        Vector3D left = Shape.Normal(d, c, a), right = Shape.Normal(c, d, b);
        double cosine = level.MinimumCosine;
        if ((q1 > MeaningfulQuality && Turns(Shape.Normal(a, b, c), left, right, cosine))
            || (q2 > MeaningfulQuality && Turns(Shape.Normal(b, a, d), left, right, cosine))
            || Vector3D.Dot(left, right) < cosine)
        {
            return false;
        }
        return IsFlat(a, b, c, d, level.Tolerance)
            || (Near((c + d) * 0.5, level) && Near((a + c + d) / 3, level) && Near((b + c + d) / 3, level));
    }

    private static bool Turns(Vector3D old, Vector3D left, Vector3D right, double cosine) =>
        Vector3D.Dot(left, old) < cosine || Vector3D.Dot(right, old) < cosine;

    /// <summary>Whether the two diagonals pass each other so closely that the flip does not move the surface.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static bool IsFlat(Vector3D a, Vector3D b, Vector3D c, Vector3D d, double tolerance)
    {
        if (double.IsPositiveInfinity(tolerance))
            return true;
        Vector3D across = Vector3D.Cross(b - a, d - c);
        double length = across.Length;
        return length <= 1e-150 || Math.Abs(Vector3D.Dot(across, c - a)) <= 1e-3 * tolerance * length;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public bool AllowsSplit(int h, Vector3D p, in GuardLevel level)
    {
        if (level.AsksNothing)
            return true;
        for (int side = 0; side < 2; side++)
        {
            int x = h ^ side;
            if (Mesh.Face[x] < 0)
                continue;
            Vector3D a = At(Mesh.Source(x)), b = At(Mesh.Target[x]), c = At(Mesh.Apex(x));
            double before = Shape.Quality(a, b, c), after = Math.Min(Shape.Quality(a, p, c), Shape.Quality(p, b, c));
            if (after < Math.Min(level.MinimumQuality, before * 0.5) || after < LeastQuality)
                return false;
            if (before > MeaningfulQuality && Turns(Shape.Normal(a, b, c), Shape.Normal(a, p, c), Shape.Normal(p, b, c), level.MinimumCosine))
                return false;
        }
        return true;
    }

    /// <summary>Where a split puts its vertex: the midpoint, on the input.</summary>
    public Vector3D SplitPosition(int h)
    {
        Vector3D middle = (At(Mesh.Target[h]) + At(Mesh.Source(h))) * 0.5;
        return Mesh.Crease[h >> 1] != 0 ? Surface.ProjectToLines(middle) : Surface.Project(middle);
    }

    /// <summary>Where a collapse puts its vertex, if the source may vanish at all: lines collapse along themselves, corners stay.</summary>
    public bool TryCollapsePosition(int h, out Vector3D p)
    {
        int a = Mesh.Source(h), b = Mesh.Target[h];
        p = At(b);
        if (Mesh.Kind[a] == VertexKind.Corner || (Mesh.Kind[a] == VertexKind.OnCrease && Mesh.Crease[h >> 1] == 0))
            return false;
        if (Mesh.Kind[a] == VertexKind.Smooth && Mesh.Kind[b] == VertexKind.Smooth)
            p = Surface.Project((At(a) + p) * 0.5);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public bool AllowsCollapse(int h, Vector3D p, in GuardLevel level)
    {
        if (level.AsksNothing)
            return true;
        int a = Mesh.Source(h), b = Mesh.Target[h];
        bool moves = p != At(b);
        double before = 1, after = 1;
        if (!KeepsShape(a, a, b, p, true, level.MinimumCosine, ref before, ref after)
            || !KeepsShape(b, a, b, p, moves, level.MinimumCosine, ref before, ref after)
            || after < Math.Min(level.MinimumQuality, before))
        {
            return false;
        }
        if (double.IsPositiveInfinity(level.Tolerance))
            return true;
        double weight = Mesh.Quadrics[a].Weight + Mesh.Quadrics[b].Weight;
        if (weight > 0 && (Mesh.Quadrics[a].At(p) + Mesh.Quadrics[b].At(p)) / weight > level.Tolerance * level.Tolerance)
            return false;
        return IsStarNear(a, a, b, p, level) && (!moves || IsStarNear(b, a, b, p, level)) && Near((At(a) + p) * 0.5, level);
    }

    private bool KeepsShape(int v, int a, int b, Vector3D p, bool moves, double cosine, ref double before, ref double after)
    {
        int start = Mesh.Outgoing[v], x = start;
        Vector3D old = At(v);
        do
        {
            if (Mesh.Face[x] >= 0)
            {
                int u = Mesh.Target[x], w = Mesh.Apex(x);
                Vector3D pu = At(u), pw = At(w);
                double quality = Shape.Quality(old, pu, pw);
                before = Math.Min(before, quality);
                if (moves && u != a && u != b && w != a && w != b)
                {
                    double now = Shape.Quality(p, pu, pw);
                    after = Math.Min(after, now);
                    if (now < LeastQuality
                        || (quality > MeaningfulQuality && Vector3D.Dot(Shape.Normal(p, pu, pw), Shape.Normal(old, pu, pw)) < cosine))
                    {
                        return false;
                    }
                }
            }
            x = Mesh.Next[x ^ 1];
        }
        while (x != start);
        return true;
    }

    private bool IsStarNear(int v, int a, int b, Vector3D p, in GuardLevel level)
    {
        int start = Mesh.Outgoing[v], x = start;
        do
        {
            int u = Mesh.Target[x], w = Mesh.Apex(x);
            bool isOther = u != a && u != b;
            if (Mesh.Face[x] >= 0 && isOther && w != a && w != b && !Near((p + At(u) + At(w)) / 3, level))
                return false;
            if (isOther && !Near((p + At(u)) * 0.5, level))
                return false;
            x = Mesh.Next[x ^ 1];
        }
        while (x != start);
        return true;
    }

    /// <summary>Whether the faces and edges around a vertex stay near the input if it moves.</summary>
    public bool IsStarNear(int v, Vector3D p, in GuardLevel level) => IsStarNear(v, v, v, p, level);

    private bool Near(Vector3D p, in GuardLevel level) => Surface.IsNear(p, level.Tolerance);

    private Vector3D At(int v) => Mesh.Positions[v];
}
