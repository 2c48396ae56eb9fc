using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>What is left of a working mesh, without gaps and in the old order; ready to become the mesh.</summary>
internal sealed class CompactResult
{
    private readonly WorkingMesh working;

    public CompactResult(WorkingMesh working)
    {
        this.working = working;
        int[] vertexNumbers = Number(working.Positions.Length, v => working.Outgoing[v] != WorkingMesh.DeletedVertex, out int vertices);
        int[] edgeNumbers = Number(working.EdgeSlots, e => working.States[e] != EdgeState.Deleted, out int edges);
        int[] faceNumbers = Number(working.HalfEdgeOf.Length, f => working.HalfEdgeOf[f] >= 0, out int faces);
        int[] halfEdgeNumbers = GC.AllocateUninitializedArray<int>(2 * edgeNumbers.Length);
        for (int e = 0; e < edgeNumbers.Length; e++)
        {
            halfEdgeNumbers[2 * e] = edgeNumbers[e] < 0 ? -1 : 2 * edgeNumbers[e];
            halfEdgeNumbers[2 * e + 1] = edgeNumbers[e] < 0 ? -1 : 2 * edgeNumbers[e] + 1;
        }
        Maps = new(vertexNumbers, halfEdgeNumbers, edgeNumbers, faceNumbers);
        Positions = new Vector3D[vertices];
        Outgoing = new int[vertices];
        (Next, Previous, Target, Face) = (new int[2 * edges], new int[2 * edges], new int[2 * edges], new int[2 * edges]);
        HalfEdgeOf = new int[faces];
        Fill();
    }

    /// <summary>Old slots → new ones.</summary>
    public CompactionMaps Maps { get; }

    /// <summary>In working units.</summary>
    public Vector3D[] Positions { get; }

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
        for (int v = 0; v < Maps.Vertices.Length; v++)
        {
            int to = Maps.Vertices[v];
            if (to < 0)
                continue;
            // A vertex that lies on one of the input gets that one's bits.
            int origin = working.OriginOf(v);
            Positions[to] = origin >= 0 && Positions[to] == working.Positions[v] ? input[origin] : working.Restored(Positions[to]);
        }
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

    private void Fill()
    {
        Parallelism.ForBlocks(Maps.Vertices.Length, FillVertices);
        Parallelism.ForBlocks(Maps.HalfEdges.Length, FillHalfEdges);
        Parallelism.ForBlocks(Maps.Faces.Length, (first, end) =>
        {
            for (int f = first; f < end; f++)
            {
                if (Maps.Faces[f] >= 0)
                    HalfEdgeOf[Maps.Faces[f]] = Maps.HalfEdges[working.HalfEdgeOf[f]];
            }
        });
    }

    private void FillVertices(int first, int end)
    {
        for (int v = first; v < end; v++)
        {
            int to = Maps.Vertices[v];
            if (to < 0)
                continue;
            Positions[to] = working.Positions[v];
            int h = working.Outgoing[v];
            Outgoing[to] = h < 0 ? h : Maps.HalfEdges[h];
        }
    }

    private void FillHalfEdges(int first, int end)
    {
        for (int h = first; h < end; h++)
        {
            int to = Maps.HalfEdges[h];
            if (to < 0)
                continue;
            ref HalfEdgeRow row = ref working.Rows[h];
            Next[to] = Maps.HalfEdges[row.Next];
            Previous[to] = Maps.HalfEdges[row.Previous];
            Target[to] = Maps.Vertices[row.Target];
            Face[to] = row.Face < 0 ? -1 : Maps.Faces[row.Face];
        }
    }
}
