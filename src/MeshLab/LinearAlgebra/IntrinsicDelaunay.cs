using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>内蕴 Delaunay 三角剖分 (intrinsic Delaunay triangulation): the same surface and vertices, other edges, all cotangent weights ≥ 0.</summary>
/// <remarks>
/// <para>
/// An edge is flipped <em>within</em> the surface: two neighbouring triangles are unfolded into the plane and get the other diagonal. Only lengths
/// change hands, the surface stays what it was; edges may bend over old ones, join the same two vertices twice, or come back to their start. While
/// an edge with α + β &gt; π is left it is flipped; that ends. Bobenko, Springborn 2007; Fisher, Springborn, Bobenko, Schröder 2007, "An algorithm
/// for the construction of intrinsic Delaunay triangulations with applications to digital geometry processing", Computing 81.
/// </para>
/// <para>
/// Degenerate triangles are first made a little fatter by adding the same tiny length to all edges (Sharp, Crane 2020, §4.5), so that every
/// triangle can be unfolded.
/// </para>
/// </remarks>
public sealed class IntrinsicDelaunay
{
    private const double Tolerance = 1e-12;

    private readonly int[] next, target, face, halfEdgeOf;
    private readonly double[] length;
    private readonly int vertexSlots;

    private IntrinsicDelaunay(Mesh mesh)
    {
        vertexSlots = mesh.VertexSlots;
        next = mesh.Next.ToArray();
        target = mesh.Target.ToArray();
        face = mesh.FaceOf.ToArray();
        halfEdgeOf = mesh.HalfEdgeOf.ToArray();
        length = new double[mesh.EdgeSlots];
        for (int e = 0; e < length.Length; e++)
        {
            if (!mesh.IsDeletedEdge(e))
                length[e] = Vector3D.Distance(mesh.Positions[target[2 * e]], mesh.Positions[target[2 * e + 1]]);
        }
    }

    /// <summary>The number of edges that were flipped.</summary>
    public int FlipCount { get; private set; }

    /// <summary>The length of each edge slot.</summary>
    public ReadOnlySpan<double> EdgeLengths => length;

    /// <summary>Flips until all cotangent weights are positive or zero. O(E) flips in practice.</summary>
    /// <param name="mesh">A triangle mesh; it is not changed.</param>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static IntrinsicDelaunay Of(Mesh mesh)
    {
        OppositeCotangents.RequireTriangles(mesh);
        var triangulation = new IntrinsicDelaunay(mesh);
        triangulation.Fatten();
        triangulation.FlipAll();
        return triangulation;
    }

    /// <summary>(cot α + cot β)/2 of an edge of this triangulation.</summary>
    /// <param name="edge">The edge slot.</param>
    public double CotangentWeight(int edge) => 0.5 * (Cotangent(2 * edge) + Cotangent(2 * edge + 1));

    internal int[] Next => next;

    internal int[] Target => target;

    internal int[] HalfEdgeOf => halfEdgeOf;

    /// <summary>Per half-edge the cotangent of the angle opposite to it; 0 on the boundary.</summary>
    internal double[] ComputeCotangents() => [.. Enumerable.Range(0, next.Length).Select(h => next[h] < 0 ? 0 : Cotangent(h))];

    /// <summary>A triangle unfolded into the plane: the vectors along its half-edge and the next one.</summary>
    internal (Vector3D First, Vector3D Second) Unfold(int h)
    {
        double ab = Length(h);
        (double x, double y) = Apex(ab, Length(next[next[h]]), Length(next[h]));
        return (new(ab, 0, 0), new(x - ab, y, 0));
    }

    /// <summary>The Laplace matrix over the vertex slots.</summary>
    public SparseMatrix ComputeLaplacian()
    {
        var entries = new List<(int, int, double)>(3 * length.Length);
        for (int e = 0; e < length.Length; e++)
        {
            int i = target[2 * e], j = target[2 * e + 1];
            // An edge from a vertex to itself pulls it nowhere.
            if (next[2 * e] < 0 || i == j)
                continue;
            double w = CotangentWeight(e);
            entries.Add((i, j, -w));
            entries.Add((i, i, w));
            entries.Add((j, j, w));
        }
        return SparseMatrix.FromEntries(vertexSlots, entries);
    }

    // The least length that, added to all edges, leaves every triangle inequality strict.
    private void Fatten()
    {
        double sum = 0, missing = 0;
        int edges = 0;
        for (int e = 0; e < length.Length; e++)
        {
            if (next[2 * e] < 0)
                continue;
            sum += length[e];
            edges++;
        }
        double margin = edges == 0 ? 0 : 1e-10 * sum / edges;
        foreach (int h in halfEdgeOf)
        {
            if (h < 0)
                continue;
            double a = Length(h), b = Length(next[h]), c = Length(next[next[h]]);
            missing = Math.Max(missing, margin + Math.Max(a - b - c, Math.Max(b - c - a, c - a - b)));
        }
        if (missing <= 0)
            return;
        for (int e = 0; e < length.Length; e++)
            length[e] += missing;
    }

    private void FlipAll()
    {
        var queue = new Queue<int>();
        var isQueued = new bool[length.Length];
        for (int e = 0; e < length.Length; e++)
            Ask(e);
        // Rounding could make two flips undo each other; the bound is far beyond what any mesh needs.
        long most = 1000L * length.Length;
        while (queue.TryDequeue(out int e) && FlipCount < most)
        {
            isQueued[e] = false;
            if (CotangentWeight(e) >= -Tolerance)
                continue;
            int h = 2 * e, t = h + 1;
            Flip(h);
            foreach (int around in (ReadOnlySpan<int>)[next[h], next[next[h]], next[t], next[next[t]]])
                Ask(around >> 1);
        }

        void Ask(int e)
        {
            if (isQueued[e] || next[2 * e] < 0 || face[2 * e] < 0 || face[2 * e + 1] < 0)
                return;
            isQueued[e] = true;
            queue.Enqueue(e);
        }
    }

    //        c                  c
    //      /   \              / | \
    //    a ─ h→ b     ⟶     a   h   b
    //      \   /              \ | /
    //        d                  d
    private void Flip(int h)
    {
        int t = h ^ 1, bc = next[h], ca = next[bc], ad = next[t], db = next[ad];
        double ab = Length(h);
        // Unfolded with a at the origin and b on the x axis.
        (double cx, double cy) = Apex(ab, Length(ca), Length(bc));
        (double dx, double dy) = Apex(ab, Length(ad), Length(db));
        length[h >> 1] = Math.Sqrt((cx - dx) * (cx - dx) + (cy + dy) * (cy + dy));

        int f = face[h], g = face[t];
        target[h] = target[bc];
        target[t] = target[ad];
        (next[h], next[ca], next[ad]) = (ca, ad, h);
        (next[t], next[db], next[bc]) = (db, bc, t);
        (face[ad], face[bc]) = (f, g);
        (halfEdgeOf[f], halfEdgeOf[g]) = (h, t);
        FlipCount++;
    }

    // The third corner of a triangle with a base from (0, 0) to (ab, 0) and the given other sides.
    private static (double X, double Y) Apex(double ab, double fromA, double fromB)
    {
        double x = (ab * ab + fromA * fromA - fromB * fromB) / (2 * ab);
        return (x, Math.Sqrt(Math.Max(0, fromA * fromA - x * x)));
    }

    private double Length(int h) => length[h >> 1];

    // The cotangent of the angle opposite h, from lengths: (b² + c² − a²)/(4 A), A by Heron's formula in the stable form of Kahan.
    private double Cotangent(int h)
    {
        if (face[h] < 0)
            return 0;
        double a = Length(h), b = Length(next[h]), c = Length(next[next[h]]);
        double top = Math.Max(a, Math.Max(b, c)), bottom = Math.Min(a, Math.Min(b, c)), middle = a + b + c - top - bottom;
        double fourAreas = Math.Sqrt(Math.Max(0, (top + (middle + bottom)) * (bottom - (top - middle)) * (bottom + (top - middle)) * (top + (middle - bottom))));
        return (b * b + c * c - a * a) / Math.Max(fourAreas, 1e-300);
    }
}
