using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>What is left of a working mesh, without gaps and in the old order; ready to become the mesh.</summary>
internal sealed class CompactResult
{
    private readonly WorkingMesh working;

    /// <summary>Takes what is left of a working mesh.</summary>
    /// <param name="mesh">The mesh that the working mesh was copied from.</param>
    /// <param name="working">The working mesh.</param>
    public CompactResult(Mesh mesh, WorkingMesh working)
    {
        this.working = working;
        int[] vertexNumbers = Number(working.Positions.Length, v => working.Outgoing[v] != WorkingMesh.DeletedVertex, out int vertices);
        int[] edgeNumbers = Number(working.EdgeSlots, e => working.States[e] != EdgeState.Deleted, out int edges);
        int[] faceNumbers = Number(working.HalfEdgeOf.Length, f => working.HalfEdgeOf[f] >= 0, out int faces);
        Positions = new Vector3D[vertices];
        Origins = new int[vertices];
        Outgoing = new int[vertices];
        (Next, Previous, Target, Face) = (new int[2 * edges], new int[2 * edges], new int[2 * edges], new int[2 * edges]);
        HalfEdgeOf = new int[faces];
        Parallelism.ForBlocks(vertexNumbers.Length, (first, end) => FillVertices(vertexNumbers, edgeNumbers, first, end));
        Parallelism.ForBlocks(edgeNumbers.Length, (first, end) => FillEdges(vertexNumbers, edgeNumbers, faceNumbers, first, end));
        Parallelism.ForBlocks(faceNumbers.Length, (first, end) =>
        {
            for (int f = first; f < end; f++)
            {
                if (faceNumbers[f] >= 0)
                    HalfEdgeOf[faceNumbers[f]] = NumberOf(edgeNumbers, working.HalfEdgeOf[f]);
            }
        });
        // Only those maps are kept that traits move along.
        Maps = new(
            vertexNumbers,
            mesh.HalfEdgeTraits.Any() ? HalfEdgeNumbers(edgeNumbers) : [],
            mesh.EdgeTraits.Any() ? edgeNumbers : [],
            mesh.FaceTraits.Any() ? faceNumbers : []);
    }

    /// <summary>Old slots → new ones: of vertices, and of those elements that have traits.</summary>
    public CompactionMaps Maps { get; }

    /// <summary>In working units.</summary>
    public Vector3D[] Positions { get; }

    /// <summary>Per vertex the input vertex on which it lies; −1 if on none.</summary>
    public int[] Origins { get; }

    public int[] Next { get; }

    public int[] Previous { get; }

    public int[] Target { get; }

    public int[] Face { get; }

    public int[] Outgoing { get; }

    public int[] HalfEdgeOf { get; }

    /// <summary>Makes the mesh that the working mesh was copied from into this.</summary>
    public void WriteTo(Mesh mesh)
    {
        Span<Vector3D> input = mesh.Positions;
        for (int v = 0; v < Positions.Length; v++)
            Positions[v] = Origins[v] >= 0 ? input[Origins[v]] : working.Restored(Positions[v]);
        mesh.ReplaceConnectivity(Positions, Next, Previous, Target, Face, Outgoing, HalfEdgeOf, Maps);
    }

    private static int[] Number(int slots, Func<int, bool> isLive, out int count)
    {
        int[] numbers = GC.AllocateUninitializedArray<int>(slots);
        count = 0;
        for (int i = 0; i < slots; i++)
            numbers[i] = isLive(i) ? count++ : -1;
        return numbers;
    }

    private static int[] HalfEdgeNumbers(int[] edgeNumbers)
    {
        int[] numbers = GC.AllocateUninitializedArray<int>(2 * edgeNumbers.Length);
        for (int h = 0; h < numbers.Length; h++)
            numbers[h] = edgeNumbers[h >> 1] < 0 ? -1 : NumberOf(edgeNumbers, h);
        return numbers;
    }

    private static int NumberOf(int[] edgeNumbers, int halfEdge) => 2 * edgeNumbers[halfEdge >> 1] + (halfEdge & 1);

    private void FillVertices(int[] vertexNumbers, int[] edgeNumbers, int first, int end)
    {
        for (int v = first; v < end; v++)
        {
            int to = vertexNumbers[v];
            if (to < 0)
                continue;
            Positions[to] = working.Positions[v];
            Origins[to] = working.OriginOf(v);
            int h = working.Outgoing[v];
            Outgoing[to] = h < 0 ? h : NumberOf(edgeNumbers, h);
        }
    }

    private void FillEdges(int[] vertexNumbers, int[] edgeNumbers, int[] faceNumbers, int first, int end)
    {
        for (int e = first; e < end; e++)
        {
            if (edgeNumbers[e] < 0)
                continue;
            for (int h = 2 * e; h <= 2 * e + 1; h++)
            {
                int to = NumberOf(edgeNumbers, h);
                ref HalfEdgeRow row = ref working.Rows[h];
                Next[to] = NumberOf(edgeNumbers, row.Next);
                Previous[to] = NumberOf(edgeNumbers, row.Previous);
                Target[to] = vertexNumbers[row.Target];
                Face[to] = row.Face < 0 ? -1 : faceNumbers[row.Face];
            }
        }
    }
}
