using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using MeshLab.Numerics;
using Box = System.Runtime.Intrinsics.Vector256<float>;

namespace MeshLab.Spatial;

/// <summary>Builds the arrays of a <see cref="FaceTree"/>: from the top down, each range of triangles cut at the median of its longest axis.</summary>
/// <remarks>
/// A triangle is a record of eight floats: min x, y, z, its index, then −max x, y, z: the box of two records is one minimum. A range
/// is cut in two until there are eight parts, always the part with the largest box next; the left part has a multiple of four triangles, so
/// that leaves are full. The eight subtrees of the root are built into buffers of their own, in any order and on any thread, and joined in
/// the children's order.
/// </remarks>
internal sealed class FaceTreeBuilder
{
    private const int Width = FaceTree.Width, LeafSize = FaceTree.LeafSize;

    // A part of the records with its box and the box of its doubled centroids, both as (min, −max).
    private struct Part
    {
        public int Start, End;
        public Box Bounds, Centroids;

        public readonly int Count => End - Start;

        public readonly float HalfArea
        {
            get
            {
                float x = -Bounds[4] - Bounds[0], y = -Bounds[5] - Bounds[1], z = -Bounds[6] - Bounds[2];
                return x * y + y * z + z * x;
            }
        }
    }

    [InlineArray(Width)]
    private struct Parts
    {
        private Part _first;
    }

    // Nodes and leaves of one subtree; indices count from its own beginning.
    private sealed class Subtree
    {
        public readonly List<float> Boxes = [];
        public readonly List<int> Children = [];
        public readonly List<(int First, int Count)> Leaves = [];
        public int Root;
    }

    private readonly Box[] _records;

    public required BoundingBox Bounds { get; init; }
    public required Frame Frame { get; init; }
    public float[] Boxes { get; private set; } = [];
    public int[] Children { get; private set; } = [];
    public double[] Leaves { get; private set; } = [];
    public int[] Triangles { get; private set; } = [];

    private FaceTreeBuilder(Box[] records) => _records = records;

    public static FaceTreeBuilder Build(Vector3D[] positions, int[] corners)
    {
        int count = corners.Length / 3;
        BoundingBox bounds = BoxOf(positions, corners);
        Frame frame = Frame.Of(bounds);
        var builder = new FaceTreeBuilder(GC.AllocateUninitializedArray<Box>(count)) { Bounds = bounds, Frame = frame };
        if (count == 0)
            return builder;

        Parallelism.ForBlocks(count, (start, end) => WriteRecords(builder._records, positions, corners, frame, start, end));
        builder.BuildNodes();
        builder.Leaves = GC.AllocateUninitializedArray<double>(builder.Triangles.Length / LeafSize * FaceTree.LeafDoubles);
        Parallelism.ForBlocks(builder.Triangles.Length / LeafSize, (start, end) => builder.WriteLeaves(positions, corners, start, end));
        return builder;
    }

    private static BoundingBox BoxOf(Vector3D[] positions, int[] corners)
    {
        Vector3D min = BoundingBox.Empty.Min, max = BoundingBox.Empty.Max;
        foreach (int v in corners)
        {
            Vector3D p = positions[v];
            if (!p.IsFinite)
                throw new ArgumentException($"v{v} has a coordinate that is not finite: {p}.", nameof(positions));
            min = Vector3D.Min(min, p);
            max = Vector3D.Max(max, p);
        }
        return new(min, max);
    }

    private static void WriteRecords(Box[] records, Vector3D[] positions, int[] corners, Frame frame, int start, int end)
    {
        Vector3D center = frame.Center;
        for (int i = start; i < end; i++)
        {
            Vector3D a = positions[corners[3 * i]], b = positions[corners[3 * i + 1]], c = positions[corners[3 * i + 2]];
            Vector3D min = Vector3D.Min(Vector3D.Min(a, b), c), max = Vector3D.Max(Vector3D.Max(a, b), c);
            records[i] = Vector256.Create(
                frame.Below(min.X, center.X), frame.Below(min.Y, center.Y), frame.Below(min.Z, center.Z), BitConverter.Int32BitsToSingle(i),
                -frame.Above(max.X, center.X), -frame.Above(max.Y, center.Y), -frame.Above(max.Z, center.Z), 0);
        }
    }

    private void BuildNodes()
    {
        var root = new Part { End = _records.Length };
        Measure(ref root);
        var top = new Subtree();
        if (root.Count <= LeafSize)
        {
            int only = AddNode(top, [root]);
            top.Children[only] = AddLeaf(top, root);
            Join([top]);
            return;
        }

        // The root's children: the two halves, each cut in four, so that both halves can be worked on at once.
        Cut(root, out Part left, out Part right);
        var children = new Part[Width];
        int leftCount = 0, rightCount = 0;
        Parallelism.Invoke(() => leftCount = CutInto(children.AsSpan(0, 4), left), () => rightCount = CutInto(children.AsSpan(4, 4), right));
        if (leftCount < 4)
            children.AsSpan(4, rightCount).CopyTo(children.AsSpan(leftCount));
        children = children[..(leftCount + rightCount)];

        var subtrees = new Subtree[children.Length];
        Parallelism.ForBlocks(children.Length, 1, (i, _) =>
        {
            subtrees[i] = new Subtree();
            subtrees[i].Root = BuildSubtree(subtrees[i], children[i]);
        });
        AddNode(top, children);
        Join([top, .. subtrees]);
    }

    // Returns the child entry: a node's index or the complement of a leaf's.
    private int BuildSubtree(Subtree tree, Part part)
    {
        if (part.Count <= LeafSize)
            return AddLeaf(tree, part);
        Parts parts = default;
        Span<Part> span = parts;
        span = span[..CutInto(span, part)];
        int node = AddNode(tree, span);
        for (int i = 0; i < span.Length; i++)
        {
            int child = BuildSubtree(tree, span[i]);
            tree.Children[Width * node + i] = child;
        }
        return node;
    }

    // Cuts the part into at most parts.Length, always the one with the largest box next. Returns how many there are.
    private int CutInto(Span<Part> parts, Part whole)
    {
        parts[0] = whole;
        int count = 1;
        while (count < parts.Length)
        {
            int largest = -1;
            for (int i = 0; i < count; i++)
            {
                // Boxes of triangles on one line have no area: then the longer part goes first.
                if (parts[i].Count > LeafSize && (largest < 0 || (parts[i].HalfArea, parts[i].Count).CompareTo((parts[largest].HalfArea, parts[largest].Count)) > 0))
                    largest = i;
            }
            if (largest < 0)
                break;
            Cut(parts[largest], out Part left, out Part right);
            parts[largest] = left;
            parts[count++] = right;
        }
        return count;
    }

    private void Cut(Part part, out Part left, out Part right)
    {
        Box c = part.Centroids;
        float x = -c[4] - c[0], y = -c[5] - c[1], z = -c[6] - c[2];
        int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
        int middle = part.Start + (part.Count / 2 + LeafSize - 1) / LeafSize * LeafSize;
        if (middle >= part.End)
            middle = part.Start + part.Count / 2;
        if (Math.Max(x, Math.Max(y, z)) > 0)
            MedianSelection.Select(_records.AsSpan(part.Start, part.Count), middle - part.Start, axis);

        left = new Part { Start = part.Start, End = middle };
        right = new Part { Start = middle, End = part.End };
        Measure(ref left);
        Measure(ref right);
    }

    private void Measure(ref Part part)
    {
        Box bounds = Vector256.Create(float.PositiveInfinity), centroids = bounds;
        foreach (Box record in _records.AsSpan(part.Start, part.Count))
        {
            bounds = Vector256.MinNative(bounds, record);
            Vector128<float> doubled = record.GetLower() - record.GetUpper();
            centroids = Vector256.MinNative(centroids, Vector256.Create(doubled, -doubled));
        }
        part.Bounds = bounds;
        part.Centroids = centroids;
    }

    private static int AddNode(Subtree tree, ReadOnlySpan<Part> parts)
    {
        int node = tree.Children.Count / Width;
        CollectionsMarshal.SetCount(tree.Boxes, tree.Boxes.Count + FaceTree.NodeFloats);
        CollectionsMarshal.SetCount(tree.Children, tree.Children.Count + Width);
        Span<float> boxes = CollectionsMarshal.AsSpan(tree.Boxes)[(FaceTree.NodeFloats * node)..];
        Span<int> children = CollectionsMarshal.AsSpan(tree.Children)[(Width * node)..];
        for (int i = 0; i < Width; i++)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                // The box of a missing child is inside out: no query meets it.
                boxes[Width * axis + i] = i < parts.Length ? parts[i].Bounds[axis] : float.PositiveInfinity;
                boxes[Width * (3 + axis) + i] = i < parts.Length ? -parts[i].Bounds[4 + axis] : float.NegativeInfinity;
            }
            children[i] = FaceTree.NoChild;
        }
        return node;
    }

    private static int AddLeaf(Subtree tree, Part part)
    {
        tree.Leaves.Add((part.Start, part.Count));
        return ~(tree.Leaves.Count - 1);
    }

    // Puts the subtrees one after the other; the root is the first subtree's only node, its children are the roots of the others.
    private void Join(Subtree[] subtrees)
    {
        Boxes = new float[subtrees.Sum(t => t.Boxes.Count)];
        Children = new int[subtrees.Sum(t => t.Children.Count)];
        Triangles = new int[LeafSize * subtrees.Sum(t => t.Leaves.Count)];
        int nodes = 0, leaves = 0;
        for (int k = 0; k < subtrees.Length; k++)
        {
            Subtree tree = subtrees[k];
            tree.Boxes.CopyTo(Boxes, FaceTree.NodeFloats * nodes);
            for (int i = 0; i < tree.Children.Count; i++)
                Children[Width * nodes + i] = Shift(tree.Children[i], nodes, leaves);
            if (k > 0)
                Children[k - 1] = Shift(tree.Root, nodes, leaves);
            for (int leaf = 0; leaf < tree.Leaves.Count; leaf++)
            {
                (int first, int count) = tree.Leaves[leaf];
                for (int i = 0; i < LeafSize; i++)
                    Triangles[LeafSize * (leaves + leaf) + i] = BitConverter.SingleToInt32Bits(_records[first + Math.Min(i, count - 1)][3]);
            }
            nodes += tree.Children.Count / Width;
            leaves += tree.Leaves.Count;
        }

        static int Shift(int child, int nodes, int leaves) =>
            child == FaceTree.NoChild ? child : child >= 0 ? child + nodes : ~(~child + leaves);
    }

    private void WriteLeaves(Vector3D[] positions, int[] corners, int start, int end)
    {
        for (int leaf = start; leaf < end; leaf++)
        {
            Span<double> rows = Leaves.AsSpan(FaceTree.LeafDoubles * leaf, FaceTree.LeafDoubles);
            for (int i = 0; i < LeafSize; i++)
            {
                int triangle = Triangles[LeafSize * leaf + i];
                for (int corner = 0; corner < 3; corner++)
                {
                    Vector3D p = positions[corners[3 * triangle + corner]];
                    rows[LeafSize * (3 * corner) + i] = p.X;
                    rows[LeafSize * (3 * corner + 1) + i] = p.Y;
                    rows[LeafSize * (3 * corner + 2) + i] = p.Z;
                }
            }
        }
    }
}
