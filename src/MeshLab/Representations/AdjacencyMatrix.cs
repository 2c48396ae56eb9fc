using System.Text;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>§1.3 邻接矩阵 (adjacency matrix): symmetric, 1 where an edge joins two vertices; stored sparse, shown dense when small.</summary>
/// <remarks>
/// Rows of sorted column numbers: 4(V + 1) + 8E bytes, where a dense matrix would take V² bits. Neighbours of a vertex O(valence), whether two
/// are joined O(log valence). Faces are not stored: <see cref="TryToMesh"/> can only guess them, and says when it cannot.
/// </remarks>
public sealed class AdjacencyMatrix
{
    private const int LargestDense = 4096;

    private AdjacencyMatrix(int[] rowStart, int[] columns) => (RowStart, Columns) = (rowStart, columns);

    /// <summary>Per vertex, where its row begins in <see cref="Columns"/>; one more entry at the end.</summary>
    public int[] RowStart { get; }

    /// <summary>The neighbours of each vertex, sorted.</summary>
    public int[] Columns { get; }

    /// <summary>The number of vertices: the matrix is square.</summary>
    public int Size => RowStart.Length - 1;

    /// <summary>The memory of the arrays in bytes.</summary>
    public long Bytes => 4L * (RowStart.Length + Columns.Length);

    /// <summary>Whether an edge joins two vertices. O(log valence).</summary>
    public bool this[int row, int column]
    {
        get
        {
            Source.CheckIndex(column, Size);
            return Row(row).BinarySearch(column) >= 0;
        }
    }

    /// <summary>The matrix of a mesh. O(E log valence).</summary>
    public static AdjacencyMatrix FromMesh(Mesh mesh)
    {
        mesh = Source.Compact(mesh);
        var rowStart = new int[mesh.Vertices.Count + 1];
        var columns = new int[2 * mesh.Edges.Count];
        int at = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            int first = at;
            foreach (Vertex w in v.Neighbors)
                columns[at++] = w.Index;
            columns.AsSpan(first, at - first).Sort();
            rowStart[v.Index + 1] = at;
        }
        return new(rowStart, columns);
    }

    /// <summary>The neighbours of a vertex, sorted. O(1).</summary>
    public ReadOnlySpan<int> Row(int vertex)
    {
        Source.CheckIndex(vertex, Size);
        return Columns.AsSpan(RowStart[vertex], RowStart[vertex + 1] - RowStart[vertex]);
    }

    /// <summary>The whole matrix. O(V²).</summary>
    /// <exception cref="InvalidOperationException">There are more than 4096 vertices.</exception>
    public bool[,] ToDense()
    {
        if (Size > LargestDense)
            throw new InvalidOperationException($"A dense matrix of {Size} × {Size} is not a sensible picture; {LargestDense} is the limit.");
        var dense = new bool[Size, Size];
        for (int v = 0; v < Size; v++)
        {
            foreach (int w in Row(v))
                dense[v, w] = true;
        }
        return dense;
    }

    /// <summary>Makes a mesh of all cycles of three edges, if that is a surface.</summary>
    /// <remarks>
    /// Right for triangle meshes whose only 3-cycles are their faces (as of every sphere that has no separating triangle); then the faces are those of
    /// the mesh, ordered by their smallest vertices, and turned so that the volume (of a closed mesh) is positive. A hole of three edges is filled, which no
    /// matrix can tell from a face. O(Σ valence²).
    /// </remarks>
    /// <param name="positions">Per vertex.</param>
    /// <param name="mesh">The mesh.</param>
    /// <returns>False if an edge lies in more than two 3-cycles or in none, or if the triangles cannot be oriented: then the matrix does not determine a surface this way.</returns>
    /// <exception cref="ArgumentException">The number of positions is not the matrix's size.</exception>
    public bool TryToMesh(ReadOnlySpan<Vector3D> positions, out Mesh mesh)
    {
        if (positions.Length != Size)
            throw new ArgumentException($"There are {positions.Length} positions for {Size} vertices.", nameof(positions));
        mesh = new Mesh();
        List<int[]> cycles = ThreeCycles();
        if (!Orient(cycles))
            return false;
        if (Volume(positions, cycles) < 0)
        {
            foreach (int[] cycle in cycles)
                (cycle[1], cycle[2]) = (cycle[2], cycle[1]);
        }
        try
        {
            mesh = MeshBuilder.FromPolygons(positions, [.. cycles]);
        }
        catch (TopologyException)
        {
            // Two fans of triangles may touch in one vertex; then the cycles are no surface.
            return false;
        }
        return true;
    }

    /// <summary>The matrix as rows of 0 and 1, if it is small; its size otherwise.</summary>
    public override string ToString()
    {
        if (Size > 64)
            return $"{Size} × {Size}, {Columns.Length} ones";
        var text = new StringBuilder();
        for (int v = 0; v < Size; v++)
        {
            for (int w = 0; w < Size; w++)
                text.Append(w > 0 ? " " : "").Append(this[v, w] ? '1' : '0');
            text.Append('\n');
        }
        return text.ToString();
    }

    private List<int[]> ThreeCycles()
    {
        var cycles = new List<int[]>();
        for (int a = 0; a < Size; a++)
        {
            foreach (int b in Row(a))
            {
                if (b < a)
                    continue;
                foreach (int c in Row(b))
                {
                    if (c > b && this[a, c])
                        cycles.Add([a, b, c]);
                }
            }
        }
        return cycles;
    }

    /// <summary>Turns the cycles so that neighbours run along their common edge in opposite directions.</summary>
    private bool Orient(List<int[]> cycles)
    {
        var beside = new Dictionary<(int, int), List<int>>();
        for (int f = 0; f < cycles.Count; f++)
        {
            for (int k = 0; k < 3; k++)
                ListOf(cycles[f][k], cycles[f][(k + 1) % 3]).Add(f);
        }
        if (2 * beside.Count != Columns.Length || beside.Values.Any(list => list.Count > 2))
            return false;
        var done = new bool[cycles.Count];
        var queue = new Queue<int>();
        for (int start = 0; start < cycles.Count; start++)
        {
            if (done[start])
                continue;
            done[start] = true;
            queue.Enqueue(start);
            while (queue.TryDequeue(out int f))
            {
                for (int k = 0; k < 3; k++)
                {
                    int a = cycles[f][k], b = cycles[f][(k + 1) % 3];
                    int g = ListOf(a, b).Find(other => other != f) is var other && ListOf(a, b).Count == 2 ? other : -1;
                    if (g < 0)
                        continue;
                    bool opposed = Follows(cycles[g], b, a);
                    if (done[g] && !opposed)
                        return false;
                    if (done[g])
                        continue;
                    if (!opposed)
                        (cycles[g][1], cycles[g][2]) = (cycles[g][2], cycles[g][1]);
                    done[g] = true;
                    queue.Enqueue(g);
                }
            }
        }
        return true;

        List<int> ListOf(int a, int b)
        {
            (int, int) edge = a < b ? (a, b) : (b, a);
            return beside.TryGetValue(edge, out List<int>? list) ? list : beside[edge] = [];
        }
    }

    private static bool Follows(int[] cycle, int from, int to) => cycle[(Array.IndexOf(cycle, from) + 1) % 3] == to;

    private static double Volume(ReadOnlySpan<Vector3D> positions, List<int[]> cycles)
    {
        double sum = 0;
        foreach (int[] cycle in cycles)
            sum += Vector3D.Determinant(positions[cycle[0]], positions[cycle[1]], positions[cycle[2]]);
        return sum;
    }
}
