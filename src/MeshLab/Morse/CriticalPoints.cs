using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>The kinds of points of a function on a surface.</summary>
public enum CriticalKind : byte
{
    /// <summary>Regular (正则点): the level curve passes through.</summary>
    Regular,

    /// <summary>Minimum (极小点): every neighbour is higher.</summary>
    Minimum,

    /// <summary>Saddle (鞍点): the lower neighbours make two or more runs.</summary>
    Saddle,

    /// <summary>Maximum (极大点): every neighbour is lower, and the vertex is not on the boundary.</summary>
    Maximum,

    /// <summary>A boundary vertex all of whose neighbours are lower: its index is 0, it is no critical point.</summary>
    BoundaryMaximum,
}

/// <summary>A critical point (临界点).</summary>
/// <param name="Vertex">The vertex.</param>
/// <param name="Kind">Minimum, saddle or maximum.</param>
/// <param name="Multiplicity">1; for a saddle with k + 1 lower runs, k.</param>
/// <param name="Value">The function's value.</param>
public readonly record struct CriticalPoint(Vertex Vertex, CriticalKind Kind, int Multiplicity, double Value)
{
    /// <summary>The index that Morse's theorem sums: +1 for extrema, minus the multiplicity for saddles.</summary>
    public int Index => Kind == CriticalKind.Saddle ? -Multiplicity : Kind is CriticalKind.Minimum or CriticalKind.Maximum ? 1 : 0;
}

/// <summary>§12.2–12.3 临界点与莫斯定理: the critical points of a function, by the sign changes around the link.</summary>
/// <remarks>
/// <code>
///     interior vertex: signs of the neighbours, once round the link
///     all +  → minimum      all −  → maximum      2 changes → regular      2m + 2 changes → saddle of multiplicity m
/// </code>
/// In general index(v) = 1 − χ(lower link) (Banchoff 1970). On the boundary the link is a path, not a circle: with r runs of lower neighbours the index
/// is 1 − r, so that a boundary vertex above all its neighbours has index 0; the mesh is never closed or changed. Morse's theorem (莫斯定理):
/// #minima − Σ multiplicities + #maxima = χ, for every function and every mesh with or without boundary. O(V + E), in parallel.
/// </remarks>
public sealed class CriticalPoints
{
    private readonly byte[] kind;
    private readonly List<CriticalPoint> points = [];

    private CriticalPoints(MorseFunction function, byte[] kind, int[] lowest, int[] highest)
    {
        Function = function;
        this.kind = kind;
        Lowest = lowest;
        Highest = highest;
        Collect();
    }

    /// <summary>The function.</summary>
    public MorseFunction Function { get; }

    /// <summary>All critical points in index order.</summary>
    public IReadOnlyList<CriticalPoint> Points => points;

    /// <summary>The minima in index order.</summary>
    public IReadOnlyList<Vertex> Minima { get; private set; } = [];

    /// <summary>The saddles in index order.</summary>
    public IReadOnlyList<Vertex> Saddles { get; private set; } = [];

    /// <summary>The maxima in index order.</summary>
    public IReadOnlyList<Vertex> Maxima { get; private set; } = [];

    /// <summary>Boundary vertices above all their neighbours: not critical.</summary>
    public IReadOnlyList<Vertex> BoundaryMaxima { get; private set; } = [];

    /// <summary>The sum of the saddles' multiplicities.</summary>
    public int SaddleCount { get; private set; }

    /// <summary>#minima − Σ multiplicities + #maxima.</summary>
    public int IndexSum => Minima.Count - SaddleCount + Maxima.Count;

    /// <summary>χ of the mesh over its used vertices; equal to <see cref="IndexSum"/> by Morse's theorem.</summary>
    public int EulerCharacteristic { get; private set; }

    /// <summary>Per vertex its lowest neighbour, or itself for a minimum: the steepest way down in the order of the function.</summary>
    internal int[] Lowest { get; }

    /// <summary>Per vertex its highest neighbour, itself for a maximum; −1 on the boundary, where the way up leads out to a point at infinity.</summary>
    internal int[] Highest { get; }

    /// <summary>The kind of a vertex.</summary>
    public CriticalKind KindOf(Vertex vertex) => Decode(kind[vertex.Index]);

    /// <summary>The multiplicity of a saddle, 1 for an extremum, 0 for a regular vertex.</summary>
    public int MultiplicityOf(Vertex vertex) => MultiplicityOf(vertex.Index);

    internal int MultiplicityOf(int v) => kind[v] >= SaddleCode ? Multiplicity(v) : kind[v] is (byte)CriticalKind.Minimum or (byte)CriticalKind.Maximum ? 1 : 0;

    internal CriticalKind KindOf(int v) => Decode(kind[v]);

    // Codes above 3 are saddles: code − 3 is the multiplicity; 255 stands for 252 and more, which are counted again when asked for.
    private const byte SaddleCode = 4;
    private const byte BoundaryMaximumCode = 2;
    private const byte MaximumCode = 3;
    private const byte MinimumCode = 1;

    /// <summary>Classifies every vertex.</summary>
    public static CriticalPoints Of(MorseFunction function)
    {
        ArgumentNullException.ThrowIfNull(function);
        int n = function.Mesh.VertexSlots;
        var kind = new byte[n];
        int[] lowest = GC.AllocateUninitializedArray<int>(n), highest = GC.AllocateUninitializedArray<int>(n);
        if (function.Ranks is null)
            Classify(function.Mesh, new ByValue(function.Data), kind, lowest, highest);
        else
            Classify(function.Mesh, new ByRank(function.Ranks), kind, lowest, highest);
        return new CriticalPoints(function, kind, lowest, highest);
    }

    private static void Classify<TOrder>(Mesh mesh, TOrder order, byte[] kind, int[] lowest, int[] highest)
        where TOrder : struct, IVertexOrder
    {
        Parallelism.ForBlocks(mesh.VertexSlots, (first, end) =>
        {
            ReadOnlySpan<int> outgoing = mesh.Outgoing, next = mesh.Next, target = mesh.Target, face = mesh.FaceOf;
            for (int v = first; v < end; v++)
            {
                int start = outgoing[v];
                lowest[v] = highest[v] = v;
                if (start < 0)
                    continue;
                bool boundary = face[start] < 0;
                // Clockwise from the boundary half-edge the link of a boundary vertex is met from one end to the other.
                bool firstIsLower = false, lastIsLower = false;
                int changes = 0, lowerRuns = 0, low = v, high = v, h = start;
                bool begun = false;
                do
                {
                    int w = target[h];
                    bool isLower = order.Less(w, v);
                    if (!begun || isLower != lastIsLower)
                    {
                        if (begun)
                            changes++;
                        else
                            firstIsLower = isLower;
                        if (isLower)
                            lowerRuns++;
                        begun = true;
                        lastIsLower = isLower;
                    }
                    if (isLower)
                    {
                        if (order.Less(w, low))
                            low = w;
                    }
                    else if (order.Less(high, w))
                    {
                        high = w;
                    }
                    h = next[h ^ 1];
                }
                while (h != start);
                // Around an interior vertex the first and the last run are one if they have the same sign.
                if (!boundary && changes > 0 && firstIsLower && lastIsLower)
                    lowerRuns--;
                kind[v] = Code(lowerRuns, changes == 0, boundary);
                lowest[v] = low;
                highest[v] = boundary ? -1 : high;
            }
        });
    }

    private static byte Code(int lowerRuns, bool allAlike, bool boundary)
    {
        if (lowerRuns == 0)
            return MinimumCode;
        if (lowerRuns > 1)
            return (byte)Math.Min(byte.MaxValue, SaddleCode - 2 + lowerRuns);
        return !allAlike ? (byte)0 : boundary ? BoundaryMaximumCode : MaximumCode;
    }

    private static CriticalKind Decode(byte code) => code switch
    {
        0 => CriticalKind.Regular,
        MinimumCode => CriticalKind.Minimum,
        BoundaryMaximumCode => CriticalKind.BoundaryMaximum,
        MaximumCode => CriticalKind.Maximum,
        _ => CriticalKind.Saddle,
    };

    private int Multiplicity(int v) => kind[v] < byte.MaxValue ? kind[v] - SaddleCode + 1 : LinkRuns.Of(Function, v, lower: true).Count - 1;

    private void Collect()
    {
        Mesh mesh = Function.Mesh;
        List<Vertex> minima = [], saddles = [], maxima = [], boundaryMaxima = [];
        for (int v = 0; v < kind.Length; v++)
        {
            if (kind[v] == 0)
                continue;
            Vertex vertex = mesh.Vertices[v];
            CriticalKind decoded = Decode(kind[v]);
            if (decoded == CriticalKind.BoundaryMaximum)
            {
                boundaryMaxima.Add(vertex);
                continue;
            }
            (decoded switch
            {
                CriticalKind.Minimum => minima,
                CriticalKind.Maximum => maxima,
                _ => saddles,
            }).Add(vertex);
            points.Add(new(vertex, decoded, MultiplicityOf(v), Function.Data[v]));
            if (decoded == CriticalKind.Saddle)
                SaddleCount += MultiplicityOf(v);
        }
        (Minima, Saddles, Maxima, BoundaryMaxima) = (minima, saddles, maxima, boundaryMaxima);
        int used = 0;
        foreach (int h in mesh.Outgoing)
        {
            if (h >= 0)
                used++;
        }
        EulerCharacteristic = used - mesh.Edges.Count + mesh.Faces.Count;
    }
}
