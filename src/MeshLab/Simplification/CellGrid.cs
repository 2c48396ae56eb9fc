using System.Globalization;
using System.Numerics;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>A grid of cubes that begins at the lowest corner of a mesh's bounding box.</summary>
internal readonly struct CellGrid
{
    private const int BitsPerAxis = 21;

    /// <summary>A table of all cells is used up to this multiple of the number of vertices; beyond, a table of the keys that occur.</summary>
    private const long DenseFactor = 16;

    private readonly Vector3D end;
    private readonly double size;
    private readonly long countX;
    private readonly long countY;
    private readonly double countZ;

    private CellGrid(BoundingBox box, double size, double x, double y, double z)
    {
        Origin = box.Min;
        end = box.Max;
        this.size = size;
        (countX, countY, countZ) = ((long)x, (long)y, z);
    }

    /// <summary>The lowest corner.</summary>
    public Vector3D Origin { get; }

    /// <summary>The grid that options put on a mesh.</summary>
    /// <exception cref="ArgumentException">Neither size nor number of cells is set, or the cells are too small to be numbered.</exception>
    public static CellGrid For(Mesh mesh, ClusteringOptions options)
    {
        BoundingBox box = mesh.BoundingBox;
        double size = options.CellSize ?? options.Cells switch
        {
            int cells => ShortestSide(box) / cells,
            null => throw new ArgumentException("Set the size of the cells or their number.", nameof(options)),
        };
        // The numbers of cells, before anything is allocated.
        double x = Along(box.Size.X, size), y = Along(box.Size.Y, size), z = Along(box.Size.Z, size);
        if (!(Math.Max(x, Math.Max(y, z)) < 1 << BitsPerAxis))
        {
            throw new ArgumentException(
                string.Create(CultureInfo.InvariantCulture, $"Cells of size {size:G6} would number {x:G6} × {y:G6} × {z:G6}; at most {1 << BitsPerAxis} along a side can be told apart."),
                nameof(options));
        }
        return new(box, size, x, y, z);
    }

    /// <summary>The key of the cell that a point lies in. Keys of cells in the grid are below the number of all cells.</summary>
    public long KeyOf(Vector3D p) =>
        Cell(p.X, Origin.X, end.X) + countX * (Cell(p.Y, Origin.Y, end.Y) + countY * Cell(p.Z, Origin.Z, end.Z));

    /// <summary>Whether a point, that may lie anywhere, lies in the same cell as a point of the mesh.</summary>
    public bool AreTogether(Vector3D p, Vector3D q) =>
        Cell(p.X, Origin.X, end.X) == Cell(q.X, Origin.X, end.X)
        && Cell(p.Y, Origin.Y, end.Y) == Cell(q.Y, Origin.Y, end.Y)
        && Cell(p.Z, Origin.Z, end.Z) == Cell(q.Z, Origin.Z, end.Z);

    /// <summary>Per vertex the number of its cell, by first appearance; −1 for vertices without faces.</summary>
    public int[] NumberCells(Mesh mesh, out int count)
    {
        CellGrid grid = this;
        int vertices = mesh.VertexSlots;
        long[] keys = GC.AllocateUninitializedArray<long>(vertices);
        Parallelism.ForBlocks(vertices, (first, last) =>
        {
            ReadOnlySpan<Vector3D> positions = mesh.Positions;
            ReadOnlySpan<int> outgoing = mesh.Outgoing;
            for (int v = first; v < last; v++)
                keys[v] = outgoing[v] >= 0 ? grid.KeyOf(positions[v]) : -1;
        });
        int[] cellOf = GC.AllocateUninitializedArray<int>(vertices);
        double cells = countX * countY * countZ;
        count = cells <= DenseFactor * vertices ? NumberByTable(keys, cellOf, (int)cells) : NumberByHash(keys, cellOf);
        return cellOf;
    }

    private static int NumberByTable(long[] keys, int[] cellOf, int cells)
    {
        // Numbers plus one: a fresh table of zeros says "not seen".
        var numbers = new int[cells];
        int count = 0;
        for (int v = 0; v < keys.Length; v++)
        {
            if (keys[v] < 0)
            {
                cellOf[v] = -1;
                continue;
            }
            ref int number = ref numbers[keys[v]];
            if (number == 0)
                number = ++count;
            cellOf[v] = number - 1;
        }
        return count;
    }

    /// <summary>Open addressing, at most half full.</summary>
    private static int NumberByHash(long[] keys, int[] cellOf)
    {
        int bits = BitOperations.Log2((uint)Math.Max(8, keys.Length)) + 2, shift = 64 - bits, mask = (1 << bits) - 1, count = 0;
        var numbers = new int[1 << bits];
        long[] keyAt = GC.AllocateUninitializedArray<long>(1 << bits);
        for (int v = 0; v < keys.Length; v++)
        {
            if (keys[v] < 0)
            {
                cellOf[v] = -1;
                continue;
            }
            int at = (int)((ulong)keys[v] * 0x9E3779B97F4A7C15 >> shift);
            while (numbers[at] != 0 && keyAt[at] != keys[v])
                at = (at + 1) & mask;
            if (numbers[at] == 0)
                (numbers[at], keyAt[at]) = (++count, keys[v]);
            cellOf[v] = numbers[at] - 1;
        }
        return count;
    }

    /// <summary>The number along an axis. The upper side of the box belongs to the last cell, not to an empty one beyond.</summary>
    private long Cell(double x, double first, double last)
    {
        double slack = 1e-9 * size;
        if (x > last - slack && x <= last + slack)
            x = Math.Max(first, last - slack);
        return (long)Math.Floor((x - first) / size);
    }

    private static double Along(double side, double size) => side == 0 ? 1 : Math.Ceiling(side / size);

    private static double ShortestSide(BoundingBox box)
    {
        double shortest = double.PositiveInfinity;
        foreach (double side in (ReadOnlySpan<double>)[box.Size.X, box.Size.Y, box.Size.Z])
            shortest = side > 0 ? Math.Min(shortest, side) : shortest;
        return double.IsFinite(shortest) ? shortest : 1;
    }
}
