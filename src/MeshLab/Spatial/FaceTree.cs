using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Spatial;

/// <summary>
/// A bounding volume tree (层次包围盒) over the faces of a mesh: closest points, rays, boxes and self-intersections in about logarithmic time.
/// </summary>
/// <remarks>
/// <para>
/// Every inner node holds the boxes of up to eight children in single precision, rounded outward, so that one test serves all eight; every
/// leaf holds up to four triangles in double precision, coordinate by coordinate. Boxes only exclude; every answer is decided in double
/// precision on the triangles themselves, or exactly (<see cref="ExactPredicates"/>). Wald, Benthin, Boulos 2008, <em>Getting rid of packets</em>.
/// </para>
/// <para>
/// The tree is a copy: changing the mesh later does not change it. It is immutable and may be asked from several threads at once. The same
/// input gives the same tree and the same answers, bit for bit, on every thread count; between equally good faces the lowest index wins.
/// Polygons are cut into fans from their first corner; answers name the face. Building costs O(n log n), a query about O(log n), the memory
/// is about 100 bytes per triangle. Coordinates up to about 1e150.
/// </para>
/// </remarks>
public sealed partial class FaceTree
{
    /// <summary>Children of a node: one 256-bit register of floats.</summary>
    internal const int Width = 8;

    /// <summary>Triangles of a leaf: one 256-bit register of doubles.</summary>
    internal const int LeafSize = 4;

    /// <summary>Floats of a node: rows of 8 for min x, y, z and max x, y, z of the children.</summary>
    internal const int NodeFloats = 6 * Width;

    /// <summary>Doubles of a leaf: rows of 4 for ax, ay, az, bx, by, bz, cx, cy, cz.</summary>
    internal const int LeafDoubles = 9 * LeafSize;

    /// <summary>What stands for a child that is not there.</summary>
    internal const int NoChild = int.MinValue;

    /// <summary>Enough for every tree: at most 28 levels, seven waiting children each.</summary>
    private const int StackSize = 256;

    private readonly float[] _boxes;      // NodeFloats per node, relative to _center, times _scale
    private readonly int[] _children;     // Width per node: ≥ 0 a node, else ~leaf, or NoChild
    private readonly double[] _leaves;    // LeafDoubles per leaf
    private readonly int[] _triangles;    // LeafSize per leaf; a leaf with fewer repeats its last
    private readonly int[] _corners;      // three vertices per triangle
    private readonly int[]? _faceOf;      // face of each triangle, or null: the triangle itself
    private readonly Frame _frame;

    internal FaceTree(FaceTreeBuilder built, int[] corners, int[]? faceOf)
    {
        _boxes = built.Boxes;
        _children = built.Children;
        _leaves = built.Leaves;
        _triangles = built.Triangles;
        _corners = corners;
        _faceOf = faceOf;
        _frame = built.Frame;
        Bounds = built.Bounds;
    }

    /// <summary>Number of triangles in the tree; polygons count as often as they were cut.</summary>
    public int TriangleCount => _corners.Length / 3;

    /// <summary>The smallest box that holds all triangles.</summary>
    public BoundingBox Bounds { get; }

    /// <summary>The tree over triangles given as arrays.</summary>
    /// <param name="positions">The vertices.</param>
    /// <param name="corners">Three vertex indices per triangle; degenerate triangles are allowed.</param>
    /// <exception cref="ArgumentException">The corners are not a multiple of three, name a vertex that is not there, or one with a coordinate that is not finite.</exception>
    public static FaceTree Build(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> corners)
    {
        if (corners.Length % 3 != 0)
            throw new ArgumentException($"There are {corners.Length} corners; triangles need a multiple of three.", nameof(corners));
        foreach (int v in corners)
        {
            if ((uint)v >= (uint)positions.Length)
                throw new ArgumentException($"A triangle names vertex {v}; there are {positions.Length} vertices.", nameof(corners));
        }
        return Build(positions.ToArray(), corners.ToArray(), null);
    }

    /// <summary>The tree over the faces of a mesh; polygons are cut into fans.</summary>
    /// <param name="mesh">The mesh; it is copied.</param>
    /// <exception cref="ArgumentException">A vertex of a face has a coordinate that is not finite.</exception>
    public static FaceTree Build(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        (int[] corners, int[]? faceOf) = FaceFans.Cut(mesh);
        return Build(mesh.positions, corners, faceOf);
    }

    // The corners are the tree's own from here on.
    internal static FaceTree Build(Vector3D[] positions, int[] corners, int[]? faceOf) =>
        new(FaceTreeBuilder.Build(positions, corners), corners, faceOf);

    /// <summary>The face a triangle of the tree belongs to.</summary>
    internal int FaceOfTriangle(int triangle) => _faceOf is null ? triangle : _faceOf[triangle];

    /// <summary>The vertices of a triangle of the tree.</summary>
    internal (int A, int B, int C) CornersOf(int triangle) => (_corners[3 * triangle], _corners[3 * triangle + 1], _corners[3 * triangle + 2]);

    /// <summary>Hashes the whole tree, so that tests can compare two of them.</summary>
    internal ulong Hash()
    {
        ulong hash = 14695981039346656037;
        foreach (float x in _boxes)
            hash = (hash ^ BitConverter.SingleToUInt32Bits(x)) * 1099511628211;
        foreach (int x in _children)
            hash = (hash ^ (uint)x) * 1099511628211;
        foreach (int x in _triangles)
            hash = (hash ^ (uint)x) * 1099511628211;
        return hash;
    }
}
