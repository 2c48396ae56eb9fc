using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>A cell (胞腔) of the Morse complex: a piece of the surface between its arcs.</summary>
/// <param name="EulerCharacteristic">χ of the piece after cutting along the arcs; 1 for a disk.</param>
/// <param name="Triangles">How many triangles of the barycentric subdivision it has.</param>
/// <param name="Corners">Vertices of the critical points that its outline passes, in the order of its outline; empty if the outline is not one loop.</param>
public sealed record MorseCell(int EulerCharacteristic, int Triangles, IReadOnlyList<int> Corners);

/// <summary>§12.4 The cells: the barycentric subdivision cut along all arcs falls into them.</summary>
/// <remarks>
/// Every face is six small triangles (vertex, middle of an edge, centre of the face). A small triangle has three neighbours: across the half of the mesh's
/// edge, which descending arcs cut; across the segment from the edge's middle to the face's centre, which ascending arcs cut; and across the one from the
/// vertex to the centre, which nothing cuts. Cells are numbered by their lowest small triangle. O(F).
/// </remarks>
public sealed class MorseCells
{
    private readonly Mesh mesh;
    private readonly DiscreteGradient gradient;
    private readonly bool[] cutHalf;
    private readonly bool[] cutInto;
    private readonly int[] cellOf;

    private MorseCells(MorseComplex complex)
    {
        gradient = complex.Gradient;
        mesh = gradient.Function.Mesh;
        cutHalf = new bool[mesh.HalfEdgeSlots];
        cutInto = new bool[mesh.HalfEdgeSlots];
        cellOf = new int[2 * mesh.HalfEdgeSlots];
        foreach (MorseArc arc in complex.Arcs)
            Cut(arc);
        int count = Label();
        Cells = Describe(count);
        OfVertex = LabelVertices();
    }

    /// <summary>The cells.</summary>
    public IReadOnlyList<MorseCell> Cells { get; }

    /// <summary>Per vertex slot a cell that it lies in, the lowest if it lies on an arc; −1 for unused vertices.</summary>
    public IReadOnlyList<int> OfVertex { get; }

    /// <summary>Finds the cells of a complex.</summary>
    public static MorseCells Of(MorseComplex complex)
    {
        ArgumentNullException.ThrowIfNull(complex);
        return new(complex);
    }

    // The small triangle 2h lies in the face of h at the source of h, 2h + 1 at its target. cutHalf[h] cuts the half of the edge at the target of h,
    // cutInto[h] the segment from the edge's middle into the face of h.

    private void Cut(MorseArc arc)
    {
        for (int i = 0; i + 1 < arc.Points.Count; i++)
        {
            PathPoint from = arc.Points[i], to = arc.Points[i + 1];
            (int edge, PathPoint other) = from.Kind == ElementKind.Edge ? (from.Index, to) : (to.Index, from);
            int h = 2 * edge;
            if (other.Kind == ElementKind.Vertex)
                cutHalf[mesh.Target[h] == other.Index ? h : h + 1] = true;
            else
                cutInto[mesh.FaceOf[h] == other.Index ? h : h + 1] = true;
        }
        // An arc that leaves through the boundary ends at the middle of a boundary edge; nothing beyond is left to cut.
    }

    /// <summary>The neighbour across one of a small triangle's sides, or −1 beyond the boundary: 0 the half of the edge, 1 the segment into the face, 2 the segment to the vertex.</summary>
    private int Neighbor(int triangle, int side)
    {
        int h = triangle >> 1, end = triangle & 1;
        switch (side)
        {
            case 0:
                return mesh.FaceOf[h ^ 1] < 0 ? -1 : 2 * (h ^ 1) + (1 - end);
            case 1:
                return triangle ^ 1;
            default:
                return end == 1 ? 2 * mesh.Next[h] : 2 * mesh.Previous[h] + 1;
        }
    }

    private bool IsCut(int triangle, int side)
    {
        int h = triangle >> 1;
        return side switch
        {
            0 => cutHalf[(triangle & 1) == 1 ? h : h ^ 1],
            1 => cutInto[h],
            _ => false,
        };
    }

    private int Label()
    {
        Array.Fill(cellOf, -1);
        var stack = new Stack<int>();
        int count = 0;
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
        {
            if (mesh.Next[h] < 0 || mesh.FaceOf[h] < 0 || cellOf[2 * h] >= 0 && cellOf[2 * h + 1] >= 0)
                continue;
            for (int seed = 2 * h; seed <= 2 * h + 1; seed++)
            {
                if (cellOf[seed] >= 0)
                    continue;
                cellOf[seed] = count;
                stack.Push(seed);
                while (stack.TryPop(out int t))
                {
                    for (int side = 0; side < 3; side++)
                    {
                        int other = Neighbor(t, side);
                        if (other < 0 || cellOf[other] >= 0 || IsCut(t, side))
                            continue;
                        cellOf[other] = count;
                        stack.Push(other);
                    }
                }
                count++;
            }
        }
        return count;
    }

    private List<MorseCell> Describe(int count)
    {
        // χ = V − E + F of each piece after cutting: an uncut side is shared by two triangles, a cut one belongs to each alone; a corner of the piece is a
        // fan of triangles around a point that are joined across uncut sides.
        var triangles = new int[count];
        var twiceEdges = new int[count];
        var corners = new int[count];
        for (int t = 0; t < cellOf.Length; t++)
        {
            if (cellOf[t] < 0)
                continue;
            triangles[cellOf[t]]++;
            for (int side = 0; side < 3; side++)
                twiceEdges[cellOf[t]] += Neighbor(t, side) < 0 || IsCut(t, side) ? 2 : 1;
        }
        CountFans(corners);
        List<int>[] outlines = Outlines(count);
        var cells = new List<MorseCell>(count);
        for (int c = 0; c < count; c++)
            cells.Add(new(corners[c] - twiceEdges[c] / 2 + triangles[c], triangles[c], outlines[c]));
        return cells;
    }

    // The corners of a small triangle: 0 the vertex (between sides 0 and 2), 1 the middle of the edge (0 and 1), 2 the centre of the face (1 and 2).
    private static (int A, int B) SidesAt(int corner) => corner switch
    {
        0 => (0, 2),
        1 => (0, 1),
        _ => (1, 2),
    };

    /// <summary>Adds, for every cell, its number of fans: each is counted where walking one way ends, or at its lowest triangle if it is a full circle.</summary>
    private void CountFans(int[] corners)
    {
        for (int t = 0; t < cellOf.Length; t++)
        {
            if (cellOf[t] < 0)
                continue;
            for (int corner = 0; corner < 3; corner++)
            {
                (int a, int b) = SidesAt(corner);
                // Every triangle of a fan has one side of each sort; the one whose walk over its first side ends at once is the fan's end. Walk out and
                // count the fan at its end only, or at its lowest triangle.
                if (IsFanRepresentative(t, a, b))
                    corners[cellOf[t]]++;
            }
        }
    }

    private bool IsFanRepresentative(int t, int a, int b)
    {
        int lowest = t;
        for (int direction = 0; direction < 2; direction++)
        {
            int side = direction == 0 ? a : b, x = t;
            while (true)
            {
                int next = Neighbor(x, side);
                if (next < 0 || IsCut(x, side))
                    break;
                if (next == t)
                    return lowest == t;
                lowest = Math.Min(lowest, next);
                if (lowest < t)
                    return false;
                x = next;
                side = side == a ? b : a;
            }
        }
        return lowest == t;
    }

    /// <summary>Per cell the critical vertices along its outline, if that is one loop.</summary>
    private List<int>[] Outlines(int count)
    {
        var outlines = new List<int>[count];
        var loops = new int[count];
        for (int c = 0; c < count; c++)
            outlines[c] = [];
        var seen = new bool[3 * cellOf.Length];
        for (int t = 0; t < cellOf.Length; t++)
        {
            if (cellOf[t] < 0)
                continue;
            for (int side = 0; side < 3; side++)
            {
                if (seen[3 * t + side] || !(Neighbor(t, side) < 0 || IsCut(t, side)))
                    continue;
                loops[cellOf[t]]++;
                WalkOutline(t, side, seen, outlines[cellOf[t]]);
            }
        }
        for (int c = 0; c < count; c++)
        {
            if (loops[c] != 1)
                outlines[c] = [];
        }
        return outlines;
    }

    private void WalkOutline(int t, int side, bool[] seen, List<int> outline)
    {
        int startTriangle = t, startSide = side;
        do
        {
            seen[3 * t + side] = true;
            int corner = EndCorner(t, side);
            int node = CriticalNode(t, corner);
            if (node >= 0 && (outline.Count == 0 || outline[^1] != node))
                outline.Add(node);
            // Turn around the corner, inside the cell, to the next side that is cut.
            (int a, int b) = SidesAt(corner);
            int other = side == a ? b : a;
            while (!(Neighbor(t, other) < 0 || IsCut(t, other)))
            {
                t = Neighbor(t, other);
                other = other == a ? b : a;
            }
            side = other;
        }
        while (t != startTriangle || side != startSide);
        if (outline.Count > 1 && outline[0] == outline[^1])
            outline.RemoveAt(outline.Count - 1);
    }

    /// <summary>The corner in which a side ends, walking with the cell on the left. Small triangles at the source and the target of a half-edge are mirror images.</summary>
    private static int EndCorner(int t, int side) => ((t & 1) == 1, side) switch
    {
        // At the target: middle → vertex → centre → middle.
        (true, 0) => 0,
        (true, 2) => 2,
        (true, _) => 1,
        // At the source: vertex → middle → centre → vertex.
        (false, 0) => 1,
        (false, 1) => 2,
        _ => 0,
    };

    /// <summary>The vertex of the critical point that stands at a corner, or −1.</summary>
    private int CriticalNode(int t, int corner)
    {
        int h = t >> 1;
        switch (corner)
        {
            case 0:
                int v = mesh.Target[(t & 1) == 1 ? h : h ^ 1];
                return gradient.VertexArrow[v] == -1 ? v : -1;
            case 1:
                return gradient.IsCriticalEdge[h >> 1] ? gradient.HighestOfEdge(h >> 1) : -1;
            default:
                int f = mesh.FaceOf[h];
                return gradient.FaceArrow[f] == -1 ? gradient.HighestOfFace(f) : -1;
        }
    }

    private int[] LabelVertices()
    {
        var label = new int[mesh.VertexSlots];
        Array.Fill(label, -1);
        for (int t = 0; t < cellOf.Length; t++)
        {
            if (cellOf[t] < 0)
                continue;
            int h = t >> 1, v = mesh.Target[(t & 1) == 1 ? h : h ^ 1];
            if (label[v] < 0 || cellOf[t] < label[v])
                label[v] = cellOf[t];
        }
        return label;
    }
}
