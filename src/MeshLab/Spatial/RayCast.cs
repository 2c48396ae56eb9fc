using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using MeshLab.Numerics;
using Doubles = System.Runtime.Intrinsics.Vector256<double>;
using Floats = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>Where a ray meets a mesh.</summary>
/// <param name="Face">The face that is hit; −1 if none is.</param>
/// <param name="Triangle">The triangle of the tree that is hit: the face itself on a triangle mesh. −1 if none is.</param>
/// <param name="Parameter">The hit is at origin + parameter · direction; +∞ if there is none.</param>
/// <param name="Barycentric">The weights (重心坐标) of the hit at the triangle's three corners.</param>
public readonly record struct RayHit(int Face, int Triangle, double Parameter, Vector3D Barycentric)
{
    /// <summary>What a ray that meets nothing returns.</summary>
    public static RayHit None { get; } = new(-1, -1, double.PositiveInfinity, default);

    /// <summary>Whether the ray meets nothing.</summary>
    public bool IsNone => Triangle < 0;
}

/// <summary>Rays. Watertight after Woop, Benthin, Wald 2013: a ray through an edge or a vertex never slips between the faces around it.</summary>
/// <remarks>Faces seen edge-on are not hit; whether a face without area is hit is left to rounding.</remarks>
public sealed partial class FaceTree
{
    private enum RayMode
    {
        First,
        Any,
        All,
    }

    // A direction almost along an axis counts as this much off it: multiplying zero by infinity would give NaN.
    private const double Parallel = 1e-30;

    /// <summary>The first face along a ray; of faces hit at the same parameter the one with the lowest index. Both sides of a face count.</summary>
    /// <param name="origin">Where the ray starts.</param>
    /// <param name="direction">Where it goes; need not have length 1.</param>
    /// <param name="maxParameter">The end of the ray, as a multiple of the direction.</param>
    /// <exception cref="ArgumentOutOfRangeException">The origin or the direction is not finite, the direction is zero, or the end is NaN.</exception>
    public RayHit CastRay(Vector3D origin, Vector3D direction, double maxParameter = double.PositiveInfinity) =>
        Cast(origin, direction, maxParameter, RayMode.First, null);

    /// <summary>Whether a ray meets any face; stops at the first one found.</summary>
    /// <inheritdoc cref="CastRay"/>
    public bool HitsAny(Vector3D origin, Vector3D direction, double maxParameter = double.PositiveInfinity) =>
        !Cast(origin, direction, maxParameter, RayMode.Any, null).IsNone;

    /// <summary>All triangles along a ray, by parameter, then by index. A ray through an edge hits both triangles beside it.</summary>
    /// <inheritdoc cref="CastRay"/>
    public RayHit[] CastRayThrough(Vector3D origin, Vector3D direction, double maxParameter = double.PositiveInfinity)
    {
        var hits = new List<RayHit>();
        Cast(origin, direction, maxParameter, RayMode.All, hits);
        hits.Sort(static (a, b) => (a.Parameter, a.Triangle).CompareTo((b.Parameter, b.Triangle)));
        return [.. hits];
    }

    // The ray turned so that it runs along z: the largest component of the direction is z, x and y are sheared away.
    private readonly struct Shear
    {
        public readonly int X, Y, Z;
        public readonly double ShearX, ShearY, ShearZ;

        public Shear(Vector3D d)
        {
            double x = Math.Abs(d.X), y = Math.Abs(d.Y), z = Math.Abs(d.Z);
            Z = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
            X = (Z + 1) % 3;
            Y = (Z + 2) % 3;
            // Keeps the winding, so that positive weights are those of faces seen from the front.
            if (d[Z] < 0)
                (X, Y) = (Y, X);
            (ShearX, ShearY, ShearZ) = (d[X] / d[Z], d[Y] / d[Z], 1 / d[Z]);
        }
    }

    [SkipLocalsInit]
    private RayHit Cast(Vector3D origin, Vector3D direction, double maxParameter, RayMode mode, List<RayHit>? hits)
    {
        double size = Math.Max(Math.Abs(direction.X), Math.Max(Math.Abs(direction.Y), Math.Abs(direction.Z)));
        if (!origin.IsFinite)
            throw new ArgumentOutOfRangeException(nameof(origin), origin, "The origin is not finite.");
        if (!direction.IsFinite || size == 0)
            throw new ArgumentOutOfRangeException(nameof(direction), direction, "A direction is finite and not zero.");
        if (double.IsNaN(maxParameter))
            throw new ArgumentOutOfRangeException(nameof(maxParameter), maxParameter, "The end is NaN.");
        if (_triangles.Length == 0)
            return RayHit.None;

        BoxRay ray = new(_frame, origin, direction / size);
        Floats nearScale = Vector256.Create(1 - 1e-6f), farScale = Vector256.Create(1 + 1e-6f);
        Shear shear = new(direction);
        Doubles ox = Vector256.Create(origin[shear.X]), oy = Vector256.Create(origin[shear.Y]), oz = Vector256.Create(origin[shear.Z]);
        Doubles sx = Vector256.Create(shear.ShearX), sy = Vector256.Create(shear.ShearY), sz = Vector256.Create(shear.ShearZ);

        ref float boxes = ref MemoryMarshal.GetArrayDataReference(_boxes);
        ref int children = ref MemoryMarshal.GetArrayDataReference(_children);
        ref double leaves = ref MemoryMarshal.GetArrayDataReference(_leaves);
        Span<Waiting> stack = stackalloc Waiting[StackSize];
        Span<float> bounds = stackalloc float[Width];

        RayHit best = RayHit.None with { Parameter = maxParameter };
        double toFrame = size * _frame.Scale;
        float bound = FrameParameter(maxParameter, toFrame);
        int waiting = 0, child = 0;
        while (true)
        {
            if (child >= 0)
            {
                ref float box = ref Unsafe.Add(ref boxes, NodeFloats * child);
                Floats near = Vector256.MaxNative(
                    Vector256.MaxNative(
                        (Vector256.LoadUnsafe(ref box, (nuint)ray.NearX) - ray.NearOriginX) * ray.InverseX,
                        (Vector256.LoadUnsafe(ref box, (nuint)ray.NearY) - ray.NearOriginY) * ray.InverseY),
                    Vector256.MaxNative((Vector256.LoadUnsafe(ref box, (nuint)ray.NearZ) - ray.NearOriginZ) * ray.InverseZ, Floats.Zero)) * nearScale;
                Floats far = Vector256.MinNative(
                    Vector256.MinNative(
                        (Vector256.LoadUnsafe(ref box, (nuint)ray.FarX) - ray.FarOriginX) * ray.InverseX,
                        (Vector256.LoadUnsafe(ref box, (nuint)ray.FarY) - ray.FarOriginY) * ray.InverseY),
                    (Vector256.LoadUnsafe(ref box, (nuint)ray.FarZ) - ray.FarOriginZ) * ray.InverseZ) * farScale;
                uint met = Vector256.LessThanOrEqual(near, Vector256.MinNative(far, Vector256.Create(bound))).ExtractMostSignificantBits();
                near.CopyTo(bounds);
                int floor = waiting;
                while (met != 0)
                {
                    int k = BitOperations.TrailingZeroCount(met);
                    met &= met - 1;
                    int entry = Unsafe.Add(ref children, Width * child + k);
                    if (entry == NoChild)
                        continue;
                    int place = waiting++;
                    while (place > floor && stack[place - 1].Bound < bounds[k])
                    {
                        stack[place] = stack[place - 1];
                        place--;
                    }
                    stack[place] = new Waiting { Child = entry, Bound = bounds[k] };
                }
            }
            else
            {
                int leaf = ~child;
                ref double rows = ref Unsafe.Add(ref leaves, LeafDoubles * leaf);
                nuint x = (nuint)(LeafSize * shear.X), y = (nuint)(LeafSize * shear.Y), z = (nuint)(LeafSize * shear.Z);
                Doubles az = Vector256.LoadUnsafe(ref rows, z) - oz, bz = Vector256.LoadUnsafe(ref rows, z + 12) - oz, cz = Vector256.LoadUnsafe(ref rows, z + 24) - oz;
                Doubles ax = Vector256.LoadUnsafe(ref rows, x) - ox - sx * az, ay = Vector256.LoadUnsafe(ref rows, y) - oy - sy * az;
                Doubles bx = Vector256.LoadUnsafe(ref rows, x + 12) - ox - sx * bz, by = Vector256.LoadUnsafe(ref rows, y + 12) - oy - sy * bz;
                Doubles cx = Vector256.LoadUnsafe(ref rows, x + 24) - ox - sx * cz, cy = Vector256.LoadUnsafe(ref rows, y + 24) - oy - sy * cz;
                // Two faces compute the same two products for their common edge, so its sign is opposite in them, exactly.
                Doubles u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
                Doubles front = Vector256.GreaterThanOrEqual(u, Doubles.Zero) & Vector256.GreaterThanOrEqual(v, Doubles.Zero) & Vector256.GreaterThanOrEqual(w, Doubles.Zero);
                Doubles back = Vector256.LessThanOrEqual(u, Doubles.Zero) & Vector256.LessThanOrEqual(v, Doubles.Zero) & Vector256.LessThanOrEqual(w, Doubles.Zero);
                Doubles hit = front | back;
                if (hit.ExtractMostSignificantBits() != 0)
                {
                    Doubles determinant = u + v + w;
                    // 0/0 = NaN for triangles seen edge-on: no hit.
                    Doubles parameter = (u * az + v * bz + w * cz) * sz / determinant;
                    hit &= Vector256.GreaterThanOrEqual(parameter, Doubles.Zero) & Vector256.LessThanOrEqual(parameter, Vector256.Create(best.Parameter));
                    uint lanes = hit.ExtractMostSignificantBits();
                    while (lanes != 0)
                    {
                        int k = BitOperations.TrailingZeroCount(lanes);
                        lanes &= lanes - 1;
                        int lane = LeafSize * leaf + k, triangle = _triangles[lane];
                        if (k > 0 && triangle == _triangles[lane - 1])
                            continue;
                        var found = new RayHit(
                            FaceOfTriangle(triangle), triangle, parameter[k], new(u[k] / determinant[k], v[k] / determinant[k], w[k] / determinant[k]));
                        if (mode == RayMode.All)
                            hits!.Add(found);
                        else if (best.IsNone || found.Parameter < best.Parameter || (found.Parameter == best.Parameter && triangle < best.Triangle))
                            best = found;
                    }
                    if (mode == RayMode.Any && !best.IsNone)
                        return best;
                    bound = FrameParameter(best.Parameter, toFrame);
                }
            }

            do
            {
                if (waiting == 0)
                    return best.IsNone ? RayHit.None : best;
                waiting--;
            }
            while (stack[waiting].Bound > bound);
            child = stack[waiting].Child;
        }
    }

    // A ray's parameter in the units of the boxes, rounded up.
    private static float FrameParameter(double parameter, double toFrame) =>
        parameter < 0 ? -1 : (float)Math.Min(parameter * toFrame * (1 + 1e-6) + 1e-30, 3e38);

    // The ray in the frame of the boxes: which rows of a node are entered and left first, and the origin rounded to the safe side for each.
    private readonly struct BoxRay
    {
        public readonly int NearX, NearY, NearZ, FarX, FarY, FarZ;
        public readonly Floats NearOriginX, NearOriginY, NearOriginZ, FarOriginX, FarOriginY, FarOriginZ, InverseX, InverseY, InverseZ;

        public BoxRay(Frame frame, Vector3D origin, Vector3D direction)
        {
            (NearX, FarX, NearOriginX, FarOriginX, InverseX) = Axis(frame, origin.X, frame.Center.X, direction.X, 0);
            (NearY, FarY, NearOriginY, FarOriginY, InverseY) = Axis(frame, origin.Y, frame.Center.Y, direction.Y, Width);
            (NearZ, FarZ, NearOriginZ, FarOriginZ, InverseZ) = Axis(frame, origin.Z, frame.Center.Z, direction.Z, 2 * Width);
        }

        private static (int Near, int Far, Floats NearOrigin, Floats FarOrigin, Floats Inverse) Axis(
            Frame frame, double origin, double center, double direction, int row)
        {
            if (Math.Abs(direction) < Parallel)
                direction = direction < 0 ? -Parallel : Parallel;
            Floats below = Vector256.Create(frame.Below(origin, center)), above = Vector256.Create(frame.Above(origin, center));
            Floats inverse = Vector256.Create((float)(1 / direction));
            return direction > 0 ? (row, row + 3 * Width, above, below, inverse) : (row + 3 * Width, row, below, above, inverse);
        }
    }
}
