using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using MeshLab.Numerics;
using Doubles = System.Runtime.Intrinsics.Vector256<double>;
using Floats = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>The point of a mesh that is closest to a query point.</summary>
/// <param name="Face">The face it lies on; −1 if there is none within the bound.</param>
/// <param name="Triangle">The triangle of the tree it lies on: the face itself on a triangle mesh. −1 if there is none.</param>
/// <param name="Point">Where it is.</param>
/// <param name="Barycentric">Its weights (重心坐标) at the triangle's three corners, sum 1.</param>
/// <param name="DistanceSquared">The squared distance, +∞ if there is none.</param>
public readonly record struct ClosestPoint(int Face, int Triangle, Vector3D Point, Vector3D Barycentric, double DistanceSquared)
{
    /// <summary>What a query without an answer returns.</summary>
    public static ClosestPoint None { get; } = new(-1, -1, default, default, double.PositiveInfinity);

    /// <summary>Whether there is no such point.</summary>
    public bool IsNone => Triangle < 0;

    /// <summary>The distance.</summary>
    public double Distance => Math.Sqrt(DistanceSquared);
}

public sealed partial class FaceTree
{
    private const int QueriesPerBlock = 64;

    private struct Waiting
    {
        public int Child;
        public float Bound;
    }

    /// <summary>The point of the surface closest to the query; of equally close faces the one with the lowest index.</summary>
    /// <param name="query">The point to start from.</param>
    /// <param name="maxDistanceSquared">Looks no farther than this (squared); a good bound makes the search faster.</param>
    /// <exception cref="ArgumentOutOfRangeException">The query is not finite, or the bound is NaN.</exception>
    public ClosestPoint FindClosest(Vector3D query, double maxDistanceSquared = double.PositiveInfinity)
    {
        ThrowIfNotFinite(query);
        if (double.IsNaN(maxDistanceSquared))
            throw new ArgumentOutOfRangeException(nameof(maxDistanceSquared), maxDistanceSquared, "The bound is NaN.");
        int triangle = FindClosestTriangle(query, maxDistanceSquared, firstHit: false, out int lane);
        return triangle < 0 ? ClosestPoint.None : Locate(query, triangle, lane);
    }

    /// <summary>The closest points of many queries, in parallel; fastest if queries that follow each other are close together.</summary>
    /// <param name="queries">The points to start from.</param>
    /// <param name="results">Where the answers go, in the order of the queries.</param>
    /// <param name="cancellationToken">Ends the search.</param>
    /// <exception cref="ArgumentException">There are fewer places than queries.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A query is not finite.</exception>
    /// <exception cref="OperationCanceledException">The search was cancelled.</exception>
    public void FindClosest(ReadOnlyMemory<Vector3D> queries, Memory<ClosestPoint> results, CancellationToken cancellationToken = default)
    {
        if (results.Length < queries.Length)
            throw new ArgumentException($"There is room for {results.Length} results of {queries.Length} queries.", nameof(results));
        foreach (Vector3D query in queries.Span)
            ThrowIfNotFinite(query);
        Parallelism.ForBlocks(queries.Length, QueriesPerBlock, (start, end) =>
        {
            cancellationToken.ThrowIfCancellationRequested();
            ReadOnlySpan<Vector3D> from = queries.Span;
            Span<ClosestPoint> to = results.Span;
            double bound = double.PositiveInfinity;
            for (int i = start; i < end; i++)
            {
                to[i] = FindClosest(from[i], bound);
                // The next point is at most as far away as this one and the way to it; the answer does not depend on the bound.
                if (i + 1 < end)
                {
                    double farthest = (to[i].Distance + Vector3D.Distance(from[i], from[i + 1])) * (1 + 1e-9);
                    bound = farthest * farthest;
                }
            }
        });
    }

    /// <summary>Whether some point of the surface is within the distance; stops at the first one found.</summary>
    /// <param name="query">The point to start from.</param>
    /// <param name="distance">The largest distance that counts.</param>
    /// <exception cref="ArgumentOutOfRangeException">The query is not finite, or the distance is negative or NaN.</exception>
    public bool IsWithin(Vector3D query, double distance)
    {
        ThrowIfNotFinite(query);
        if (!(distance >= 0))
            throw new ArgumentOutOfRangeException(nameof(distance), distance, "A distance is not negative.");
        return FindClosestTriangle(query, distance * distance, firstHit: true, out _) >= 0;
    }

    /// <summary>A triangle within the distance, the first one found, or −1.</summary>
    internal int FindTriangleWithin(Vector3D query, double distance) => FindClosestTriangle(query, distance * distance, firstHit: true, out _);

    private static void ThrowIfNotFinite(Vector3D query)
    {
        if (!query.IsFinite)
            throw new ArgumentOutOfRangeException(nameof(query), query, "The query point is not finite.");
    }

    // Best first: the children of a node are visited in the order of their boxes' distances, those beyond the best distance never.
    // Returns the triangle, or −1; lane is its place
    // among the leaves.
    [SkipLocalsInit]
    private int FindClosestTriangle(Vector3D query, double maxDistanceSquared, bool firstHit, out int lane)
    {
        int best = int.MaxValue;
        double bestSquared = maxDistanceSquared;
        lane = -1;
        if (_triangles.Length == 0)
            return -1;

        Vector3D center = _frame.Center;
        Floats lowX = Vector256.Create(_frame.BelowClamped(query.X, center.X)), highX = Vector256.Create(_frame.AboveClamped(query.X, center.X));
        Floats lowY = Vector256.Create(_frame.BelowClamped(query.Y, center.Y)), highY = Vector256.Create(_frame.AboveClamped(query.Y, center.Y));
        Floats lowZ = Vector256.Create(_frame.BelowClamped(query.Z, center.Z)), highZ = Vector256.Create(_frame.AboveClamped(query.Z, center.Z));
        Floats shrink = Vector256.Create(Frame.Shrink);
        Doubles px = Vector256.Create(query.X), py = Vector256.Create(query.Y), pz = Vector256.Create(query.Z);

        ref float boxes = ref MemoryMarshal.GetArrayDataReference(_boxes);
        ref int children = ref MemoryMarshal.GetArrayDataReference(_children);
        ref double leaves = ref MemoryMarshal.GetArrayDataReference(_leaves);
        ref int triangles = ref MemoryMarshal.GetArrayDataReference(_triangles);
        Span<Waiting> stackSpace = stackalloc Waiting[StackSize];
        ref Waiting stack = ref MemoryMarshal.GetReference(stackSpace);
        Span<float> boundSpace = stackalloc float[Width];
        ref float bounds = ref MemoryMarshal.GetReference(boundSpace);

        float bound = _frame.SquaredAbove(bestSquared);
        int waiting = 0, child = 0;
        while (true)
        {
            if (child >= 0)
            {
                ref float box = ref Unsafe.Add(ref boxes, NodeFloats * child);
                Floats dx = Vector256.MaxNative(
                    Vector256.MaxNative(Vector256.LoadUnsafe(ref box) - highX, lowX - Vector256.LoadUnsafe(ref box, 3 * Width)), Floats.Zero);
                Floats dy = Vector256.MaxNative(
                    Vector256.MaxNative(Vector256.LoadUnsafe(ref box, Width) - highY, lowY - Vector256.LoadUnsafe(ref box, 4 * Width)), Floats.Zero);
                Floats dz = Vector256.MaxNative(
                    Vector256.MaxNative(Vector256.LoadUnsafe(ref box, 2 * Width) - highZ, lowZ - Vector256.LoadUnsafe(ref box, 5 * Width)), Floats.Zero);
                Floats distances = (dx * dx + dy * dy + dz * dz) * shrink;
                uint near = Vector256.LessThanOrEqual(distances, Vector256.Create(bound)).ExtractMostSignificantBits();
                distances.StoreUnsafe(ref bounds);
                ref int entries = ref Unsafe.Add(ref children, Width * child);
                int floor = waiting;
                while (near != 0)
                {
                    int k = BitOperations.TrailingZeroCount(near);
                    near &= near - 1;
                    // Nearest on top.
                    float d = Unsafe.Add(ref bounds, k);
                    int place = waiting++;
                    while (place > floor && Unsafe.Add(ref stack, place - 1).Bound < d)
                    {
                        Unsafe.Add(ref stack, place) = Unsafe.Add(ref stack, place - 1);
                        place--;
                    }
                    Unsafe.Add(ref stack, place) = new Waiting { Child = Unsafe.Add(ref entries, k), Bound = d };
                }
            }
            else
            {
                int leaf = ~child;
                Doubles squared = SquaredDistances(ref Unsafe.Add(ref leaves, LeafDoubles * leaf), px, py, pz);
                uint near = Vector256.LessThanOrEqual(squared, Vector256.Create(bestSquared)).ExtractMostSignificantBits();
                while (near != 0)
                {
                    int k = BitOperations.TrailingZeroCount(near);
                    near &= near - 1;
                    double d = squared.GetElement(k);
                    int triangle = Unsafe.Add(ref triangles, LeafSize * leaf + k);
                    if (d < bestSquared || (d == bestSquared && triangle < best))
                    {
                        bestSquared = d;
                        best = triangle;
                        lane = LeafSize * leaf + k;
                    }
                }
                if (firstHit && lane >= 0)
                    break;
                bound = _frame.SquaredAbove(bestSquared);
            }

            do
            {
                if (waiting == 0)
                    return lane < 0 ? -1 : best;
                waiting--;
            }
            while (Unsafe.Add(ref stack, waiting).Bound > bound);
            child = Unsafe.Add(ref stack, waiting).Child;
        }
        return best;
    }

    // The squared distances of the point to the four triangles of a leaf: the least of the three edges and, where the foot of the
    // perpendicular is inside, the plane. Taking the edges always keeps slivers safe, whose "inside" is decided by rounding.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Doubles SquaredDistances(ref double leaf, Doubles px, Doubles py, Doubles pz)
    {
        Doubles ax = Vector256.LoadUnsafe(ref leaf), ay = Vector256.LoadUnsafe(ref leaf, 4), az = Vector256.LoadUnsafe(ref leaf, 8);
        Doubles ux = Vector256.LoadUnsafe(ref leaf, 12) - ax, uy = Vector256.LoadUnsafe(ref leaf, 16) - ay, uz = Vector256.LoadUnsafe(ref leaf, 20) - az;
        Doubles vx = Vector256.LoadUnsafe(ref leaf, 24) - ax, vy = Vector256.LoadUnsafe(ref leaf, 28) - ay, vz = Vector256.LoadUnsafe(ref leaf, 32) - az;
        Doubles wx = px - ax, wy = py - ay, wz = pz - az;
        Doubles uu = ux * ux + uy * uy + uz * uz, uv = ux * vx + uy * vy + uz * vz, vv = vx * vx + vy * vy + vz * vz;
        Doubles uw = ux * wx + uy * wy + uz * wz, vw = vx * wx + vy * wy + vz * wz;

        Doubles best = Vector256.MinNative(ToEdge(ux, uy, uz, uu, uw, wx, wy, wz), ToEdge(vx, vy, vz, vv, vw, wx, wy, wz));
        Doubles ex = vx - ux, ey = vy - uy, ez = vz - uz, fx = wx - ux, fy = wy - uy, fz = wz - uz;
        best = Vector256.MinNative(best, ToEdge(ex, ey, ez, ex * ex + ey * ey + ez * ez, ex * fx + ey * fy + ez * fz, fx, fy, fz));

        Doubles s = vv * uw - uv * vw, t = uu * vw - uv * uw, determinant = uu * vv - uv * uv;
        Doubles inside = Vector256.GreaterThan(s, Doubles.Zero) & Vector256.GreaterThan(t, Doubles.Zero) & Vector256.LessThan(s + t, determinant);
        if (inside.ExtractMostSignificantBits() != 0)
        {
            Doubles inverse = Doubles.One / determinant, bs = s * inverse, bt = t * inverse;
            Doubles x = wx - bs * ux - bt * vx, y = wy - bs * uy - bt * vy, z = wz - bs * uz - bt * vz;
            best = Vector256.ConditionalSelect(inside, Vector256.MinNative(best, x * x + y * y + z * z), best);

            // Once more from what is left: the weights of slivers lose digits with the square of their thinness.
            Doubles ru = ux * x + uy * y + uz * z, rv = vx * x + vy * y + vz * z;
            Doubles ds = (vv * ru - uv * rv) * inverse, dt = (uu * rv - uv * ru) * inverse;
            x = x - ds * ux - dt * vx;
            y = y - ds * uy - dt * vy;
            z = z - ds * uz - dt * vz;
            bs += ds;
            bt += dt;
            inside &= Vector256.GreaterThanOrEqual(bs, Doubles.Zero) & Vector256.GreaterThanOrEqual(bt, Doubles.Zero)
                & Vector256.LessThanOrEqual(bs + bt, Doubles.One);
            best = Vector256.ConditionalSelect(inside, Vector256.MinNative(best, x * x + y * y + z * z), best);
        }
        return best;
    }

    // The squared distance to the segment from the origin along the edge; an edge of length zero is its start.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Doubles ToEdge(Doubles ex, Doubles ey, Doubles ez, Doubles lengthSquared, Doubles along, Doubles wx, Doubles wy, Doubles wz)
    {
        Doubles t = along / Vector256.MaxNative(lengthSquared, Vector256.Create(double.Epsilon * (1L << 52)));
        t = Vector256.MinNative(Vector256.MaxNative(t, Doubles.Zero), Doubles.One);
        Doubles x = wx - t * ex, y = wy - t * ey, z = wz - t * ez;
        return x * x + y * y + z * z;
    }

    // Where the closest point is, once the triangle is known: the same arithmetic as above, for one triangle.
    private ClosestPoint Locate(Vector3D query, int triangle, int lane)
    {
        (Vector3D a, Vector3D b, Vector3D c) = TriangleAt(lane);
        double distanceSquared = TriangleMath.ClosestDistanceSquared(query, a, b, c, out Vector3D weights);
        return new(FaceOfTriangle(triangle), triangle, TriangleMath.At(weights, a, b, c), weights, distanceSquared);
    }

    // The corners of the triangle at a lane of a leaf.
    internal (Vector3D A, Vector3D B, Vector3D C) TriangleAt(int lane)
    {
        ReadOnlySpan<double> rows = _leaves.AsSpan(LeafDoubles * (lane / LeafSize) + lane % LeafSize);
        return (
            new(rows[0], rows[LeafSize], rows[2 * LeafSize]),
            new(rows[3 * LeafSize], rows[4 * LeafSize], rows[5 * LeafSize]),
            new(rows[6 * LeafSize], rows[7 * LeafSize], rows[8 * LeafSize]));
    }
}
