using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>Options of <see cref="JetFitting"/>.</summary>
public sealed record JetFittingOptions
{
    /// <summary>The number of rings of neighbours, at least 1. Two rings suit clean meshes, more suit noise.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 1.</exception>
    public int Rings
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            field = value;
        }
    } = 2;
}

/// <summary>Principal curvatures and directions from a quadric fitted to the neighbours of each vertex (Cazals, Pouget 2003: a jet of degree 2).</summary>
/// <remarks>
/// In a frame whose third axis is the vertex normal the surface is a height z(x, y) = c + aₓx + a_y y + ½bₓₓx² + bₓᵧxy + ½b_yy y²; the six numbers are the
/// least-squares fit to the vertices within k rings, the vertex itself included. First and second fundamental form of the fitted quadric at the vertex give the shape
/// operator; its eigenvalues are the curvatures, positive where the surface is convex. The error is of first order in the mesh size, of second on
/// symmetric neighbourhoods. Where fewer than six points, or points on a conic, do not determine the quadric, one more ring is taken; if that does
/// not help the vertex gets NaN. O(V · ring), in parallel.
/// </remarks>
public static class JetFitting
{
    /// <summary>The principal curvatures and directions of every vertex.</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static PrincipalCurvatures Compute(Mesh mesh, JetFittingOptions options)
    {
        mesh.RequireTriangles();
        ArgumentNullException.ThrowIfNull(options);
        Vector3D[] normals = mesh.ComputeVertexNormals();
        PrincipalCurvatures result = PrincipalCurvatures.Undefined(mesh.VertexSlots);
        // Every thread that is at work holds its own marks; which one a block gets makes no difference to the result.
        var idle = new System.Collections.Concurrent.ConcurrentBag<RingWalk>();
        Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
        {
            if (!idle.TryTake(out RingWalk? walk))
                walk = new RingWalk(mesh);
            for (int v = from; v < to; v++)
            {
                if (normals[v] != default)
                    FitAt(mesh, v, normals[v], options.Rings, walk, result);
            }
            idle.Add(walk);
        });
        return result;
    }

    private static void FitAt(Mesh mesh, int v, Vector3D normal, int rings, RingWalk walk, PrincipalCurvatures result)
    {
        var frame = new TangentFrame(normal);
        for (int extra = 0; extra <= 1; extra++)
        {
            ReadOnlySpan<int> points = walk.Collect(v, rings + extra);
            if (points.Length < QuadricFit.Unknowns || !QuadricFit.TryFit(mesh.positions, points, v, frame, normal, out QuadricFit fit))
                continue;
            Store(fit, frame, normal, result, v);
            return;
        }
    }

    /// <summary>Curvatures of the graph of a quadric at its middle, from the fundamental forms.</summary>
    private static void Store(QuadricFit fit, TangentFrame frame, Vector3D normal, PrincipalCurvatures result, int v)
    {
        double a = fit.X, b = fit.Y;
        // An orthonormal basis of the fitted tangent plane: along the gradient g and across.
        double g2 = a * a + b * b, stretch = Math.Sqrt(1 + g2);
        double cos = 1, sin = 0;
        if (g2 > 0)
        {
            double g = Math.Sqrt(g2);
            (cos, sin) = (a / g, b / g);
        }
        double along = fit.XX * cos * cos + 2 * fit.XY * cos * sin + fit.YY * sin * sin;
        double mixed = (fit.YY - fit.XX) * cos * sin + fit.XY * (cos * cos - sin * sin);
        double across = fit.XX * sin * sin - 2 * fit.XY * cos * sin + fit.YY * cos * cos;
        // Going one unit along the tangent plane up the gradient covers 1/√(1+g²) of the base; the height bends away from n where convex.
        var shape = new SymmetricTensor2(
            -along / (stretch * stretch * stretch), -mixed / (stretch * stretch), -across / stretch);
        Vector3D e1 = (frame.X * cos + frame.Y * sin + normal * Math.Sqrt(g2)) / stretch;
        Vector3D e2 = frame.Y * cos - frame.X * sin;
        shape.Store(result, v, e1, e2);
    }
}

/// <summary>The vertices within some rings of a vertex, with marks that are stamped instead of cleared.</summary>
internal sealed class RingWalk(Mesh mesh)
{
    private readonly int[] mark = new int[mesh.VertexSlots];
    private readonly List<int> found = [];
    private int stamp;

    /// <summary>The vertex itself, then ring after ring; valid until the next call.</summary>
    public ReadOnlySpan<int> Collect(int v, int rings)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing;
        stamp++;
        found.Clear();
        found.Add(v);
        mark[v] = stamp;
        int from = 0;
        for (int ring = 0; ring < rings; ring++)
        {
            int to = found.Count;
            for (; from < to; from++)
            {
                int start = outgoing[found[from]], h = start;
                do
                {
                    int p = target[h];
                    if (mark[p] != stamp)
                    {
                        mark[p] = stamp;
                        found.Add(p);
                    }
                    h = next[h ^ 1];
                }
                while (h != start);
            }
        }
        return System.Runtime.InteropServices.CollectionsMarshal.AsSpan(found);
    }
}
