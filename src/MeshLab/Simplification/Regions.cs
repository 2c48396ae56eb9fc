using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>Parts of a large mesh that can be simplified at once: runs of vertices along a space-filling curve. Vertices with a neighbour in another part
/// are locked, so that no two parts write the same element. The parts depend on the mesh alone, not on the number of threads.</summary>
internal sealed class Regions
{
    private const byte Locked = byte.MaxValue;
    private readonly WorkingMesh mesh;
    private readonly UncheckedArray<byte> regionOf;

    public Regions(WorkingMesh mesh, int count)
    {
        this.mesh = mesh;
        Count = count;
        int[] rank = MortonOrder.Ranks(mesh.Positions.Items);
        var all = new UncheckedArray<byte>(new byte[rank.Length]);
        for (int v = 0; v < rank.Length; v++)
            all[v] = (byte)((long)rank[v] * count / rank.Length);
        regionOf = new byte[rank.Length];
        Parallelism.ForBlocks(rank.Length, (first, end) =>
        {
            for (int v = first; v < end; v++)
                regionOf[v] = HasNeighborElsewhere(v, all) ? Locked : all[v];
        });
    }

    /// <summary>The number of parts.</summary>
    public int Count { get; }

    /// <summary>How many parts a mesh of that size has: as many as pay, whatever the number of threads.</summary>
    public static int CountFor(int faces) => faces < 20_000 ? 1 : faces < 200_000 ? 2 : faces < 800_000 ? 4 : 16;

    /// <summary>What <see cref="RegionsOfEdges"/> says of an edge that may be contracted in no region.</summary>
    public const byte None = Locked;

    /// <summary>Per edge, the region in which it may be contracted.</summary>
    public byte[] RegionsOfEdges()
    {
        byte[] regions = GC.AllocateUninitializedArray<byte>(mesh.EdgeSlots);
        Parallelism.ForBlocks(regions.Length, (first, end) =>
        {
            for (int e = first; e < end; e++)
            {
                if (mesh.States[e] == EdgeState.Deleted)
                {
                    regions[e] = None;
                    continue;
                }
                byte a = regionOf[mesh.Rows[2 * e].Target], b = regionOf[mesh.Rows[2 * e + 1].Target];
                regions[e] = a == b ? a : None;
            }
        });
        return regions;
    }

    /// <summary>The number of faces at which the parts stop, so that the locked strips between them can be thinned out like the rest.</summary>
    public int WhereToStop(int targetFaces)
    {
        double locked = Parallelism.SumBlocks(mesh.HalfEdgeOf.Length, (first, end) =>
        {
            int count = 0;
            for (int f = first; f < end; f++)
            {
                if (mesh.HalfEdgeOf[f] >= 0 && TouchesLocked(mesh.HalfEdgeOf[f]))
                    count++;
            }
            return count;
        });
        return targetFaces + (int)(locked * (1 - targetFaces / (double)mesh.FaceCount));
    }

    private bool TouchesLocked(int h)
    {
        ref HalfEdgeRow row = ref mesh.Rows[h];
        return regionOf[row.Target] == Locked || regionOf[mesh.Rows[row.Next].Target] == Locked || regionOf[mesh.Rows[row.Previous].Target] == Locked;
    }

    private bool HasNeighborElsewhere(int vertex, UncheckedArray<byte> all)
    {
        int start = mesh.Outgoing[vertex];
        if (start < 0)
            return true;
        int g = start;
        do
        {
            if (all[mesh.Rows[g].Target] != all[vertex])
                return true;
            g = mesh.Rows[g ^ 1].Next;
        }
        while (g != start);
        return false;
    }
}

/// <summary>The order of points along the Z curve (Morton 1966) through a box of unit diagonal around the origin.</summary>
internal static class MortonOrder
{
    private const int BitsPerAxis = 10;
    private const int RadixBits = 10;

    /// <summary>Per point its place on the curve; equal codes in order of index. O(n).</summary>
    public static int[] Ranks(Vector3D[] points)
    {
        uint[] codes = GC.AllocateUninitializedArray<uint>(points.Length);
        Parallelism.ForBlocks(points.Length, (first, end) =>
        {
            for (int i = first; i < end; i++)
                codes[i] = Code(points[i]);
        });
        int[] order = Sort(codes);
        int[] ranks = GC.AllocateUninitializedArray<int>(points.Length);
        for (int i = 0; i < order.Length; i++)
            ranks[order[i]] = i;
        return ranks;
    }

    private static uint Code(Vector3D p) => Spread(Cell(p.X)) | Spread(Cell(p.Y)) << 1 | Spread(Cell(p.Z)) << 2;

    private static uint Cell(double x) => (uint)Math.Clamp((int)((x + 0.5) * ((1 << BitsPerAxis) - 0.01)), 0, (1 << BitsPerAxis) - 1);

    /// <summary>Puts two zeros between the bits.</summary>
    private static uint Spread(uint x)
    {
        x = (x | x << 16) & 0x030000FF;
        x = (x | x << 8) & 0x0300F00F;
        x = (x | x << 4) & 0x030C30C3;
        return (x | x << 2) & 0x09249249;
    }

    /// <summary>Radix sort of the indices by code.</summary>
    private static int[] Sort(uint[] codes)
    {
        int[] order = GC.AllocateUninitializedArray<int>(codes.Length), sorted = GC.AllocateUninitializedArray<int>(codes.Length);
        for (int i = 0; i < order.Length; i++)
            order[i] = i;
        for (int shift = 0; shift < 3 * BitsPerAxis; shift += RadixBits)
        {
            var starts = new int[(1 << RadixBits) + 1];
            foreach (uint code in codes)
                starts[((code >> shift) & ((1 << RadixBits) - 1)) + 1]++;
            for (int i = 1; i < starts.Length; i++)
                starts[i] += starts[i - 1];
            foreach (int i in order)
                sorted[starts[(codes[i] >> shift) & ((1 << RadixBits) - 1)]++] = i;
            (order, sorted) = (sorted, order);
        }
        return order;
    }
}
