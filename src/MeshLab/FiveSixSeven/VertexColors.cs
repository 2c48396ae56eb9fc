using System.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Groups of vertices of which no two are neighbours (着色): each vertex in index order gets the lowest colour that no neighbour has.</summary>
internal static class VertexColors
{
    private const int MostColors = 63;

    /// <summary>Per colour the vertices that may move, in index order. Vertices that find no colour come one by one.</summary>
    public static int[][] Of(WorkMesh mesh)
    {
        var colors = new byte[mesh.VertexSlots];
        var groups = new List<int>[MostColors];
        var rest = new List<int[]>();
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (!mesh.IsLiveVertex(v) || mesh.Kind[v] == VertexKind.Corner)
                continue;
            int color = BitOperations.TrailingZeroCount(~TakenAround(mesh, v, colors));
            if (color >= MostColors)
            {
                rest.Add([v]);
                continue;
            }
            colors[v] = (byte)(color + 1);
            (groups[color] ??= []).Add(v);
        }
        return [.. groups.TakeWhile(group => group is not null).Select(group => group.ToArray()), .. rest];
    }

    private static ulong TakenAround(WorkMesh mesh, int v, byte[] colors)
    {
        ulong taken = 0;
        int start = mesh.Outgoing[v], h = start;
        do
        {
            int color = colors[mesh.Target[h]];
            if (color > 0)
                taken |= 1UL << (color - 1);
            h = mesh.Next[h ^ 1];
        }
        while (h != start);
        return taken;
    }
}
