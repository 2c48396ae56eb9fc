using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Finds the lines that stay: the boundary and sharp creases, and the corners where they end, meet or turn.</summary>
internal static class Creases
{
    /// <summary>Lines turn at a corner by more than the angle with this cosine between the directions to both neighbours.</summary>
    private const double CornerCosine = -0.6;

    // Faces that turn back on their neighbours: beyond 150°. Where more than this share of all edges does, the surface is crumpled, and what bends sharply is no feature.
    private static readonly double FoldCosine = Math.Cos(150 * Math.PI / 180);
    private const double FoldedShare = 0.05;

    /// <summary>Marks crease edges and vertex kinds; returns the lines' segments.</summary>
    /// <param name="mesh">The mesh to mark.</param>
    /// <param name="angle">Dihedral angle from which an edge is sharp, in radians.</param>
    /// <param name="noiseEdges">A connected set of sharp edges without a cycle and with at most so many edges is noise of a scan.</param>
    public static List<(int A, int B)> Mark(WorkMesh mesh, double angle, int noiseEdges)
    {
        bool[] sharp = IsCrumpled(mesh) ? new bool[mesh.EdgeSlots] : SharpEdges(mesh, Math.Cos(angle));
        DropNoise(mesh, sharp, noiseEdges);
        var segments = new List<(int, int)>();
        var lines = new int[mesh.VertexSlots];
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            bool isRim = mesh.Face[2 * e] < 0 || mesh.Face[2 * e + 1] < 0;
            if (!isRim && !sharp[e])
                continue;
            int a = mesh.Target[2 * e + 1], b = mesh.Target[2 * e];
            mesh.Crease[e] = 1;
            lines[a]++;
            lines[b]++;
            segments.Add((a, b));
        }
        SetKinds(mesh, lines);
        return segments;
    }

    /// <summary>From the number of line edges at each vertex, what it is: on a line if there are two in about one direction, else a corner.</summary>
    public static void SetKinds(WorkMesh mesh, int[] lines)
    {
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            mesh.Kind[v] = lines[v] == 0 ? VertexKind.Smooth
                : lines[v] != 2 || Turns(mesh, v) ? VertexKind.Corner
                : VertexKind.OnCrease;
        }
    }

    private static bool[] SharpEdges(WorkMesh mesh, double cosine)
    {
        var sharp = new bool[mesh.EdgeSlots];
        for (int e = 0; e < sharp.Length; e++)
        {
            int h = 2 * e;
            if (mesh.Face[h] < 0 || mesh.Face[h + 1] < 0)
                continue;
            Vector3D m = mesh.AreaNormal(h), n = mesh.AreaNormal(h + 1);
            double product = m.Length * n.Length;
            sharp[e] = product > 0 && Vector3D.Dot(m, n) < cosine * product;
        }
        return sharp;
    }

    /// <summary>Whether many faces turn back on their neighbours, as after random flips.</summary>
    public static bool IsCrumpled(WorkMesh mesh) => SharpEdges(mesh, FoldCosine).Count(folded => folded) > FoldedShare * mesh.EdgeSlots;

    private static void DropNoise(WorkMesh mesh, bool[] sharp, int noiseEdges)
    {
        var parent = new int[mesh.VertexSlots];
        for (int v = 0; v < parent.Length; v++)
            parent[v] = v;
        int Root(int v)
        {
            while (parent[v] != v)
                v = parent[v] = parent[parent[v]];
            return v;
        }
        for (int e = 0; e < sharp.Length; e++)
        {
            if (!sharp[e])
                continue;
            int a = Root(mesh.Target[2 * e]), b = Root(mesh.Target[2 * e + 1]);
            if (a != b)
                parent[Math.Max(a, b)] = Math.Min(a, b);
        }
        var edges = new int[parent.Length];
        var vertices = new int[parent.Length];
        for (int e = 0; e < sharp.Length; e++)
        {
            if (sharp[e])
                edges[Root(mesh.Target[2 * e])]++;
        }
        for (int v = 0; v < parent.Length; v++)
            vertices[Root(v)]++;
        for (int e = 0; e < sharp.Length; e++)
        {
            if (!sharp[e])
                continue;
            int root = Root(mesh.Target[2 * e]);
            sharp[e] = edges[root] >= vertices[root] || edges[root] > noiseEdges;
        }
    }

    private static bool Turns(WorkMesh mesh, int v)
    {
        Vector3D first = default, second = default;
        int start = mesh.Outgoing[v], h = start;
        do
        {
            if (mesh.Crease[h >> 1] != 0)
                (first, second) = (second, (mesh.Positions[mesh.Target[h]] - mesh.Positions[v]).Normalized());
            h = mesh.Next[h ^ 1];
        }
        while (h != start);
        return Vector3D.Dot(first, second) > CornerCosine;
    }
}
