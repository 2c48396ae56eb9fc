using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using MeshLab.Numerics;
using Doubles = System.Runtime.Intrinsics.Vector256<double>;
using Floats = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>Two faces, the one with the lower index first.</summary>
/// <param name="First">The lower index.</param>
/// <param name="Second">The higher index.</param>
public readonly record struct FacePair(int First, int Second) : IComparable<FacePair>
{
    /// <summary>Lexicographic order.</summary>
    public int CompareTo(FacePair other) => First != other.First ? First.CompareTo(other.First) : Second.CompareTo(other.Second);

    /// <summary>Lexicographic order.</summary>
    public static bool operator <(FacePair left, FacePair right) => left.CompareTo(right) < 0;

    /// <summary>Lexicographic order.</summary>
    public static bool operator >(FacePair left, FacePair right) => left.CompareTo(right) > 0;

    /// <summary>Lexicographic order.</summary>
    public static bool operator <=(FacePair left, FacePair right) => left.CompareTo(right) <= 0;

    /// <summary>Lexicographic order.</summary>
    public static bool operator >=(FacePair left, FacePair right) => left.CompareTo(right) >= 0;
}

/// <summary>Self-intersections (自相交): pairs of faces that have more in common than their common vertices and edges.</summary>
public sealed partial class FaceTree
{
    // Leaves per block: enough blocks for many threads, few enough that their lists cost nothing.
    private const int LeavesPerBlock = 256;

    /// <summary>All pairs of faces that intersect each other, in order. Decided exactly; touching counts.</summary>
    /// <remarks>
    /// Faces without a common vertex: if they have a common point. With one common vertex: if the edge opposite to it in one meets the other.
    /// With a common edge: if they lie in one plane on the same side of it. With three: always. Equal coordinates do not make two vertices
    /// one; triangles that name a vertex twice are left out. CGAL's <c>self_intersections</c> counts the same pairs. About O(n log n + pairs).
    /// </remarks>
    /// <param name="cancellationToken">Ends the search.</param>
    /// <exception cref="OperationCanceledException">The search was cancelled.</exception>
    public FacePair[] FindSelfIntersections(CancellationToken cancellationToken = default) =>
        SelfIntersections(onlyFirst: false, cancellationToken);

    /// <summary>Whether any two faces intersect each other; see <see cref="FindSelfIntersections"/>.</summary>
    /// <inheritdoc cref="FindSelfIntersections"/>
    public bool HasSelfIntersections(CancellationToken cancellationToken = default) =>
        SelfIntersections(onlyFirst: true, cancellationToken).Length > 0;

    private FacePair[] SelfIntersections(bool onlyFirst, CancellationToken cancellationToken)
    {
        int leaves = _triangles.Length / LeafSize;
        var found = new List<FacePair>[(leaves + LeavesPerBlock - 1) / LeavesPerBlock];
        bool done = false;
        Parallelism.ForBlocks(leaves, LeavesPerBlock, (first, end) =>
        {
            int block = first / LeavesPerBlock;
            cancellationToken.ThrowIfCancellationRequested();
            found[block] = [];
            if (Volatile.Read(ref done))
                return;
            for (int leaf = first; leaf < end; leaf++)
                IntersectLeaf(leaf, found[block]);
            if (onlyFirst && found[block].Count > 0)
                Volatile.Write(ref done, true);
        });

        FacePair[] pairs = [.. found.SelectMany(list => list)];
        Array.Sort(pairs);
        // Two polygons may meet in several of their triangles.
        return _faceOf is null ? pairs : [.. pairs.Distinct()];
    }

    // A leaf's triangles with their exact boxes and the box around all of them.
    private ref struct LeafBoxes
    {
        public Span<Vector3D> Min, Max;
        public int Count;
        public Vector3D AllMin, AllMax;
    }

    // The leaf against itself and against every later leaf.
    [SkipLocalsInit]
    private void IntersectLeaf(int leaf, List<FacePair> found)
    {
        LeafBoxes own = new() { Min = stackalloc Vector3D[LeafSize], Max = stackalloc Vector3D[LeafSize] };
        MeasureLeaf(leaf, ref own);
        Vector3D center = _frame.Center;
        Floats lowX = Vector256.Create(_frame.Below(own.AllMin.X, center.X)), highX = Vector256.Create(_frame.Above(own.AllMax.X, center.X));
        Floats lowY = Vector256.Create(_frame.Below(own.AllMin.Y, center.Y)), highY = Vector256.Create(_frame.Above(own.AllMax.Y, center.Y));
        Floats lowZ = Vector256.Create(_frame.Below(own.AllMin.Z, center.Z)), highZ = Vector256.Create(_frame.Above(own.AllMax.Z, center.Z));

        ref float boxes = ref MemoryMarshal.GetArrayDataReference(_boxes);
        ref int children = ref MemoryMarshal.GetArrayDataReference(_children);
        Span<int> stack = stackalloc int[StackSize];
        int waiting = 1;
        stack[0] = 0;
        while (waiting > 0)
        {
            int child = stack[--waiting];
            if (child < 0)
            {
                IntersectLeaves(leaf, own, ~child, found);
                continue;
            }
            uint met = Overlaps(ref Unsafe.Add(ref boxes, NodeFloats * child), lowX, lowY, lowZ, highX, highY, highZ);
            while (met != 0)
            {
                int entry = Unsafe.Add(ref children, Width * child + BitOperations.TrailingZeroCount(met));
                met &= met - 1;
                // Earlier leaves have met this one already.
                if (entry >= 0 || ~entry >= leaf)
                    stack[waiting++] = entry;
            }
        }
    }

    private void MeasureLeaf(int leaf, ref LeafBoxes boxes)
    {
        boxes.AllMin = BoundingBox.Empty.Min;
        boxes.AllMax = BoundingBox.Empty.Max;
        for (int k = 0; k < LeafSize; k++)
        {
            int lane = LeafSize * leaf + k;
            if (k > 0 && _triangles[lane] == _triangles[lane - 1])
                break;
            (Vector3D a, Vector3D b, Vector3D c) = TriangleAt(lane);
            boxes.Min[k] = Vector3D.Min(Vector3D.Min(a, b), c);
            boxes.Max[k] = Vector3D.Max(Vector3D.Max(a, b), c);
            boxes.AllMin = Vector3D.Min(boxes.AllMin, boxes.Min[k]);
            boxes.AllMax = Vector3D.Max(boxes.AllMax, boxes.Max[k]);
            boxes.Count = k + 1;
        }
    }

    private void IntersectLeaves(int leaf, LeafBoxes own, int other, List<FacePair> found)
    {
        ref double rows = ref _leaves[LeafDoubles * other];
        Doubles minX = LeastOfThree(ref rows, 0), minY = LeastOfThree(ref rows, 4), minZ = LeastOfThree(ref rows, 8);
        Doubles maxX = GreatestOfThree(ref rows, 0), maxY = GreatestOfThree(ref rows, 4), maxZ = GreatestOfThree(ref rows, 8);
        for (int k = 0; k < own.Count; k++)
        {
            Vector3D min = own.Min[k], max = own.Max[k];
            Doubles met = Vector256.LessThanOrEqual(minX, Vector256.Create(max.X)) & Vector256.GreaterThanOrEqual(maxX, Vector256.Create(min.X))
                & Vector256.LessThanOrEqual(minY, Vector256.Create(max.Y)) & Vector256.GreaterThanOrEqual(maxY, Vector256.Create(min.Y))
                & Vector256.LessThanOrEqual(minZ, Vector256.Create(max.Z)) & Vector256.GreaterThanOrEqual(maxZ, Vector256.Create(min.Z));
            uint lanes = met.ExtractMostSignificantBits();
            // Within one leaf, each pair once.
            if (leaf == other)
                lanes &= ~0u << (k + 1);
            int previous = -1;
            while (lanes != 0)
            {
                int first = LeafSize * leaf + k, second = LeafSize * other + BitOperations.TrailingZeroCount(lanes);
                lanes &= lanes - 1;
                int f = _triangles[first], g = _triangles[second];
                if (f == g || g == previous)
                    continue;
                previous = g;
                int faceF = FaceOfTriangle(f), faceG = FaceOfTriangle(g);
                if (faceF != faceG && Intersect(first, f, second, g))
                    found.Add(new(Math.Min(faceF, faceG), Math.Max(faceF, faceG)));
            }
        }
    }

    // The pair's rule depends on how many vertices the two triangles share.
    private bool Intersect(int laneF, int f, int laneG, int g)
    {
        ReadOnlySpan<int> cornersF = _corners.AsSpan(3 * f, 3), cornersG = _corners.AsSpan(3 * g, 3);
        if (NamesAVertexTwice(cornersF) || NamesAVertexTwice(cornersG))
            return false;
        // The last shared corner and the last free one of each; with at most two shared they are all that is needed.
        int shared = 0, sharedF = 0, sharedG = 0, freeF = 0, freeG = 3;
        for (int i = 0; i < 3; i++)
        {
            int j = cornersF[i] == cornersG[0] ? 0 : cornersF[i] == cornersG[1] ? 1 : cornersF[i] == cornersG[2] ? 2 : -1;
            if (j < 0)
            {
                freeF = i;
                continue;
            }
            shared++;
            (sharedF, sharedG) = (i, j);
            freeG -= j;
        }

        Triangle t = new(TriangleAt(laneF)), u = new(TriangleAt(laneG));
        return shared switch
        {
            0 => TriangleTriangle.Intersect(t[0], t[1], t[2], u[0], u[1], u[2]),
            1 => TriangleTriangle.IntersectBeyondVertex(
                t[sharedF], t[(sharedF + 1) % 3], t[(sharedF + 2) % 3], u[(sharedG + 1) % 3], u[(sharedG + 2) % 3]),
            2 => TriangleTriangle.IntersectBeyondEdge(t[(freeF + 1) % 3], t[(freeF + 2) % 3], t[freeF], u[freeG]),
            _ => true,
        };
    }

    private static bool NamesAVertexTwice(ReadOnlySpan<int> corners) =>
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];

    [InlineArray(3)]
    private struct Triangle
    {
        private Vector3D _first;

        public Triangle((Vector3D A, Vector3D B, Vector3D C) corners) => (this[0], this[1], this[2]) = corners;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Doubles LeastOfThree(ref double rows, nuint row) => Vector256.MinNative(
        Vector256.MinNative(Vector256.LoadUnsafe(ref rows, row), Vector256.LoadUnsafe(ref rows, row + 12)), Vector256.LoadUnsafe(ref rows, row + 24));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Doubles GreatestOfThree(ref double rows, nuint row) => Vector256.MaxNative(
        Vector256.MaxNative(Vector256.LoadUnsafe(ref rows, row), Vector256.LoadUnsafe(ref rows, row + 12)), Vector256.LoadUnsafe(ref rows, row + 24));
}
