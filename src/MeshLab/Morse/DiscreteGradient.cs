using System.Buffers;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>§12.4 离散梯度: a discrete gradient (Forman 1998) by lower stars (Robins, Wood, Sheppard 2011), the robust engine beside the book's.</summary>
/// <remarks>
/// Vertices, edges and faces are cells. Every cell is paired with one neighbour of the next dimension, or is critical: a critical vertex is a minimum, a
/// critical edge a saddle, a critical face a maximum. All pairs are made inside the lower star of one vertex v (the cells whose highest vertex is v):
/// <code>
///   v with the edge to its lowest neighbour; in every other lower run the edge to the lowest is critical;
///   from these edges outwards every face of the run with the next edge;
///   where all neighbours are lower, the faces go both ways from the first edge, the smaller first, and the last one is critical.
/// </code>
/// So vertex arrows are steepest descent, and every critical cell belongs to the vertex that the classification of §12.2 finds, m critical edges to a
/// saddle of multiplicity m. Arrows never run in circles. One half-edge per vertex and one per face is all that is stored. O(V + E + F), in parallel.
/// </remarks>
public sealed class DiscreteGradient
{
    private const int LongestOnStack = 256;

    private DiscreteGradient(MorseFunction function)
    {
        Function = function;
        Mesh mesh = function.Mesh;
        VertexArrow = new int[mesh.VertexSlots];
        FaceArrow = new int[mesh.FaceSlots];
        IsCriticalEdge = new bool[mesh.EdgeSlots];
    }

    /// <summary>The function.</summary>
    public MorseFunction Function { get; }

    /// <summary>Per vertex the half-edge that it flows along, −1 for a minimum; −2 for unused vertices.</summary>
    internal int[] VertexArrow { get; }

    /// <summary>Per face its half-edge whose edge it is paired with: ascending leads across it. −1 for a maximum; −2 for deleted faces.</summary>
    internal int[] FaceArrow { get; }

    /// <summary>Per edge whether it is a saddle.</summary>
    internal bool[] IsCriticalEdge { get; }

    /// <summary>The number of critical vertices.</summary>
    public int MinimumCount => VertexArrow.Count(h => h == -1);

    /// <summary>The number of critical edges.</summary>
    public int SaddleCount => IsCriticalEdge.Count(critical => critical);

    /// <summary>The number of critical faces.</summary>
    public int MaximumCount => FaceArrow.Count(h => h == -1);

    /// <summary>The critical edges in index order.</summary>
    public IEnumerable<Edge> CriticalEdges => Function.Mesh.Edges.Where(e => IsCriticalEdge[e.Index]);

    /// <summary>Makes the gradient of a function.</summary>
    public static DiscreteGradient Of(MorseFunction function)
    {
        ArgumentNullException.ThrowIfNull(function);
        var gradient = new DiscreteGradient(function);
        Array.Fill(gradient.FaceArrow, -2);
        if (function.Ranks is null)
            gradient.PairLowerStars(new ByValue(function.Data));
        else
            gradient.PairLowerStars(new ByRank(function.Ranks));
        return gradient;
    }

    /// <summary>A copy that can be changed without changing this one.</summary>
    internal DiscreteGradient Copy()
    {
        var copy = new DiscreteGradient(Function);
        VertexArrow.CopyTo(copy.VertexArrow, 0);
        FaceArrow.CopyTo(copy.FaceArrow, 0);
        IsCriticalEdge.CopyTo(copy.IsCriticalEdge, 0);
        return copy;
    }

    /// <summary>The highest vertex of an edge: the saddle that a critical edge belongs to.</summary>
    internal int HighestOfEdge(int e)
    {
        int a = Function.Mesh.Target[2 * e], b = Function.Mesh.Target[2 * e + 1];
        return Function.IsLower(a, b) ? b : a;
    }

    /// <summary>The highest vertex of a face: the maximum that a critical face belongs to.</summary>
    internal int HighestOfFace(int f)
    {
        Mesh mesh = Function.Mesh;
        int h = mesh.HalfEdgeOf[f];
        int a = mesh.Target[h], b = mesh.Target[mesh.Next[h]], c = mesh.Target[mesh.Previous[h]];
        if (Function.IsLower(a, b))
            a = b;
        return Function.IsLower(a, c) ? c : a;
    }

    /// <summary>The minimum that steepest descent from a vertex ends in.</summary>
    internal int Descend(int v)
    {
        while (VertexArrow[v] >= 0)
            v = Function.Mesh.Target[VertexArrow[v]];
        return v;
    }

    /// <summary>The critical face that ascending from a face ends in; −1 if it leaves through the boundary.</summary>
    internal int Ascend(int f)
    {
        while (f >= 0 && FaceArrow[f] >= 0)
            f = Function.Mesh.FaceOf[FaceArrow[f] ^ 1];
        return f;
    }

    private void PairLowerStars<TOrder>(TOrder order)
        where TOrder : struct, IVertexOrder
    {
        Mesh mesh = Function.Mesh;
        Parallelism.ForBlocks(mesh.VertexSlots, 2048, (first, end) =>
        {
            Span<int> stack = stackalloc int[LongestOnStack];
            int[]? rented = null;
            for (int v = first; v < end; v++)
            {
                int start = mesh.Outgoing[v];
                if (start < 0)
                {
                    VertexArrow[v] = -2;
                    continue;
                }
                Span<int> spokes = stack;
                int count = CollectSpokes(mesh, start, ref spokes, ref rented);
                PairLowerStar(order, v, spokes[..count], mesh.FaceOf[start] < 0);
            }
            if (rented is not null)
                ArrayPool<int>.Shared.Return(rented);
        });
    }

    /// <summary>The half-edges that leave a vertex, clockwise; on the boundary beginning with the boundary one.</summary>
    private static int CollectSpokes(Mesh mesh, int start, ref Span<int> spokes, ref int[]? rented)
    {
        ReadOnlySpan<int> next = mesh.Next;
        int count = 0, h = start;
        do
        {
            if (count == spokes.Length)
            {
                int[] larger = ArrayPool<int>.Shared.Rent(2 * count);
                spokes.CopyTo(larger);
                if (rented is not null)
                    ArrayPool<int>.Shared.Return(rented);
                rented = larger;
                spokes = larger;
            }
            spokes[count++] = h;
            h = next[h ^ 1];
        }
        while (h != start);
        return count;
    }

    private void PairLowerStar<TOrder>(TOrder order, int v, Span<int> spokes, bool boundary)
        where TOrder : struct, IVertexOrder
    {
        ReadOnlySpan<int> target = Function.Mesh.Target;
        int lowest = -1, firstHigher = -1;
        for (int i = 0; i < spokes.Length; i++)
        {
            int w = target[spokes[i]];
            if (!order.Less(w, v))
            {
                if (firstHigher < 0)
                    firstHigher = i;
            }
            else if (lowest < 0 || order.Less(w, target[spokes[lowest]]))
            {
                lowest = i;
            }
        }
        if (lowest < 0)
        {
            VertexArrow[v] = -1;
            return;
        }
        VertexArrow[v] = spokes[lowest];
        if (!boundary && firstHigher < 0)
            PairAroundMaximum(order, spokes, lowest);
        else
            PairRuns(order, v, spokes, boundary ? 0 : firstHigher, spokes[lowest]);
    }

    /// <summary>Every lower run: its lowest edge is v's own or critical; outwards from it each face takes the next edge.</summary>
    private void PairRuns<TOrder>(TOrder order, int v, ReadOnlySpan<int> spokes, int seam, int own)
        where TOrder : struct, IVertexOrder
    {
        ReadOnlySpan<int> target = Function.Mesh.Target;
        int n = spokes.Length;
        for (int i = 0; i < n;)
        {
            if (!order.Less(target[spokes[(seam + i) % n]], v))
            {
                i++;
                continue;
            }
            int first = i, lowest = i;
            for (; i < n && order.Less(target[spokes[(seam + i) % n]], v); i++)
            {
                if (order.Less(target[spokes[(seam + i) % n]], target[spokes[(seam + lowest) % n]]))
                    lowest = i;
            }
            int middle = spokes[(seam + lowest) % n];
            if (middle != own)
                IsCriticalEdge[middle >> 1] = true;
            for (int k = lowest + 1; k < i; k++)
                PairFace(spokes[(seam + k - 1) % n], spokes[(seam + k) % n]);
            for (int k = lowest - 1; k >= first; k--)
                PairFace(spokes[(seam + k) % n], spokes[(seam + k) % n]);
        }
    }

    /// <summary>All neighbours are lower: from the lowest edge both ways, always the smaller of the two faces next; the last one is left critical.</summary>
    private void PairAroundMaximum<TOrder>(TOrder order, ReadOnlySpan<int> spokes, int lowest)
        where TOrder : struct, IVertexOrder
    {
        int n = spokes.Length, right = lowest, left = lowest;
        for (int taken = 0; taken < n - 1; taken++)
        {
            int nextRight = right + 1 == n ? 0 : right + 1, nextLeft = left == 0 ? n - 1 : left - 1;
            if (FaceIsSmaller(order, spokes[right], spokes[nextRight], spokes[left], spokes[nextLeft]))
            {
                PairFace(spokes[right], spokes[nextRight]);
                right = nextRight;
            }
            else
            {
                PairFace(spokes[nextLeft], spokes[nextLeft]);
                left = nextLeft;
            }
        }
        FaceArrow[Function.Mesh.FaceOf[spokes[right] ^ 1]] = -1;
    }

    /// <summary>Whether the face of the first two link vertices comes before that of the last two: by their higher, then their lower vertex.</summary>
    private bool FaceIsSmaller<TOrder>(TOrder order, int spokeA, int spokeB, int spokeC, int spokeD)
        where TOrder : struct, IVertexOrder
    {
        ReadOnlySpan<int> target = Function.Mesh.Target;
        int a = target[spokeA], b = target[spokeB], c = target[spokeC], d = target[spokeD];
        (int highAb, int lowAb) = order.Less(a, b) ? (b, a) : (a, b);
        (int highCd, int lowCd) = order.Less(c, d) ? (d, c) : (c, d);
        return highAb == highCd ? !order.Less(lowCd, lowAb) : order.Less(highAb, highCd);
    }

    /// <summary>Pairs the face clockwise after a spoke with an edge.</summary>
    /// <param name="spoke">The face lies between this spoke and the next one clockwise.</param>
    /// <param name="edge">A half-edge of the edge that it is paired with.</param>
    private void PairFace(int spoke, int edge)
    {
        ReadOnlySpan<int> face = Function.Mesh.FaceOf;
        int f = face[spoke ^ 1];
        FaceArrow[f] = face[edge] == f ? edge : edge ^ 1;
    }
}
