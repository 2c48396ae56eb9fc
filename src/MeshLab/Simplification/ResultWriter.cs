using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Puts what is left of a working mesh back into the mesh that it was copied from, without gaps and in the old order.</summary>
internal static class ResultWriter
{
    public static void Write(WorkingMesh working, Mesh mesh)
    {
        var maps = new CompactionMaps(
            NumberVertices(working, out int vertices),
            new int[mesh.HalfEdgeSlots],
            NumberEdges(working, out int edges),
            NumberFaces(working, out int faces));
        for (int h = 0; h < maps.HalfEdges.Length; h++)
        {
            int e = maps.Edges[h >> 1];
            maps.HalfEdges[h] = e < 0 ? -1 : 2 * e + (h & 1);
        }

        var positions = new Vector3D[vertices];
        var outgoing = new int[vertices];
        Span<Vector3D> old = mesh.Positions;
        for (int v = 0; v < maps.Vertices.Length; v++)
        {
            int to = maps.Vertices[v];
            if (to < 0)
                continue;
            positions[to] = working.FinalPosition(v, old);
            int h = working.Outgoing[v];
            outgoing[to] = h < 0 ? h : maps.HalfEdges[h];
        }

        int[] next = new int[2 * edges], previous = new int[2 * edges], target = new int[2 * edges], face = new int[2 * edges];
        for (int h = 0; h < maps.HalfEdges.Length; h++)
        {
            int to = maps.HalfEdges[h];
            if (to < 0)
                continue;
            HalfEdgeRow row = working.Rows[h];
            next[to] = maps.HalfEdges[row.Next];
            previous[to] = maps.HalfEdges[row.Previous];
            target[to] = maps.Vertices[row.Target];
            face[to] = row.Face < 0 ? -1 : maps.Faces[row.Face];
        }

        var halfEdgeOf = new int[faces];
        for (int f = 0; f < maps.Faces.Length; f++)
        {
            if (maps.Faces[f] >= 0)
                halfEdgeOf[maps.Faces[f]] = maps.HalfEdges[working.HalfEdgeOf[f]];
        }
        mesh.ReplaceConnectivity(positions, next, previous, target, face, outgoing, halfEdgeOf, maps);
    }

    private static int[] NumberVertices(WorkingMesh working, out int count)
    {
        int[] numbers = GC.AllocateUninitializedArray<int>(working.Positions.Length);
        count = 0;
        for (int v = 0; v < numbers.Length; v++)
            numbers[v] = working.Outgoing[v] != WorkingMesh.DeletedVertex ? count++ : -1;
        return numbers;
    }

    private static int[] NumberEdges(WorkingMesh working, out int count)
    {
        int[] numbers = GC.AllocateUninitializedArray<int>(working.EdgeSlots);
        count = 0;
        for (int e = 0; e < numbers.Length; e++)
            numbers[e] = working.States[e] != EdgeState.Deleted ? count++ : -1;
        return numbers;
    }

    private static int[] NumberFaces(WorkingMesh working, out int count)
    {
        int[] numbers = GC.AllocateUninitializedArray<int>(working.HalfEdgeOf.Length);
        count = 0;
        for (int f = 0; f < numbers.Length; f++)
            numbers[f] = working.HalfEdgeOf[f] >= 0 ? count++ : -1;
        return numbers;
    }
}
