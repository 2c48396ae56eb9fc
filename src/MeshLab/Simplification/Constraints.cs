using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Edges that may only be contracted along themselves (features, seams, borders of labels), and vertices that may not move.</summary>
/// <remarks>A vertex is free, on a line (two special edges), or a corner (one special edge, or three and more, or locked). A free vertex may be pulled into
/// a line or a corner, a vertex on a line along the line into another or into its corner; nothing else.</remarks>
internal sealed class Constraints
{
    private const byte Free = 0;
    private const byte OnLine = 1;
    private const byte Corner = 2;
    private readonly UncheckedArray<byte> kinds;
    private readonly UncheckedArray<bool> special;

    private Constraints(byte[] kinds, bool[] special)
    {
        this.kinds = kinds;
        this.special = special;
    }

    /// <summary>The constraints that options put on a mesh; <see langword="null"/> if there are none.</summary>
    public static Constraints? From(Mesh mesh, QuadricOptions options)
    {
        bool[]? special = SpecialEdges.Find(mesh, options);
        bool locked = options.Boundary == BoundaryTreatment.Locked && !mesh.IsClosed;
        if (special is null && !locked)
            return null;

        special ??= new bool[mesh.EdgeSlots];
        var kinds = new byte[mesh.VertexSlots];
        CountSpecialEdges(mesh, special, kinds);
        for (int v = 0; v < kinds.Length; v++)
        {
            int h = mesh.Outgoing[v];
            kinds[v] = locked && h >= 0 && mesh.FaceOf[h] < 0 ? Corner
                : kinds[v] == 0 ? Free
                : kinds[v] == 2 ? OnLine
                : Corner;
        }
        return new Constraints(kinds, special);
    }

    public bool IsSpecial(int edge) => special[edge];

    public bool IsFree(int vertex) => kinds[vertex] == Free;

    /// <summary>Whether the edge of a half-edge may be contracted at all.</summary>
    public bool Allow(WorkingMesh mesh, int h)
    {
        ref HalfEdgeRow left = ref mesh.Rows[h], right = ref mesh.Rows[h ^ 1];
        byte a = kinds[right.Target], b = kinds[left.Target];
        if (a != Free && b != Free && (!special[h >> 1] || (a == Corner && b == Corner)))
            return false;
        // Two lines must not become one.
        return !(left.Face >= 0 && special[left.Next >> 1] && special[left.Previous >> 1])
            && !(right.Face >= 0 && special[right.Next >> 1] && special[right.Previous >> 1]);
    }

    /// <summary>Where the vertex of the contracted edge may lie.</summary>
    public Freedom FreedomOf(int edge, int u, int v)
    {
        byte a = kinds[u], b = kinds[v];
        if (a == b)
            return a == Free ? Freedom.Anywhere : Freedom.OnSegment;
        return a > b ? Freedom.AtSource : Freedom.AtTarget;
    }

    public void VertexMerged(int kept, int removed) => kinds[kept] = Math.Max(kinds[kept], kinds[removed]);

    /// <summary>Notes that two edges became one.</summary>
    public void Merge(int stays, int goes) => special[stays] |= special[goes];

    private static void CountSpecialEdges(Mesh mesh, bool[] special, byte[] counts)
    {
        for (int e = 0; e < special.Length; e++)
        {
            if (!special[e])
                continue;
            for (int h = 2 * e; h <= 2 * e + 1; h++)
            {
                ref byte count = ref counts[mesh.Target[h]];
                count = (byte)Math.Min(count + 1, 3);
            }
        }
    }
}

/// <summary>Finds the edges that are to be kept as lines.</summary>
internal static class SpecialEdges
{
    /// <summary>Per edge, whether it is a feature, a texture seam or a border of labels; <see langword="null"/> if none is.</summary>
    public static bool[]? Find(Mesh mesh, QuadricOptions options)
    {
        bool[]? special = null;
        if (options.FeatureAngle is double angle)
            Mark(mesh, ref special, e => TurnsBy(mesh, e, Math.Cos(angle)));
        if (options.FeatureEdges is { } edges)
            MarkGiven(mesh, ref special, edges);
        if (options.KeepTextureSeams && mesh.TryGetHalfEdgeTrait(TraitNames.TextureCoordinate, out HalfEdgeTrait<Vector2D>? texture))
            Mark(mesh, ref special, e => IsSeam(mesh, texture, e));
        if (options.KeepLabelBorders)
        {
            foreach (FaceLabels labels in mesh.FaceLabels)
                Mark(mesh, ref special, e => labels.Labels[mesh.FaceOf[2 * e]] != labels.Labels[mesh.FaceOf[2 * e + 1]]);
        }
        return special;
    }

    private static void Mark(Mesh mesh, ref bool[]? special, Func<int, bool> isSpecial)
    {
        ReadOnlySpan<int> face = mesh.FaceOf;
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (face[2 * e] >= 0 && face[2 * e + 1] >= 0 && isSpecial(e))
                (special ??= new bool[mesh.EdgeSlots])[e] = true;
        }
    }

    private static void MarkGiven(Mesh mesh, ref bool[]? special, IReadOnlyCollection<int> edges)
    {
        foreach (int e in edges)
        {
            if ((uint)e >= (uint)mesh.EdgeSlots || mesh.IsDeletedEdge(e))
                throw new ArgumentException($"The feature e{e} is not an edge of the mesh.", nameof(edges));
            (special ??= new bool[mesh.EdgeSlots])[e] = true;
        }
    }

    private static bool TurnsBy(Mesh mesh, int edge, double cosine)
    {
        Vector3D n = Normal(mesh, 2 * edge), m = Normal(mesh, 2 * edge + 1);
        return Vector3D.Dot(n, m) < cosine * n.Length * m.Length;
    }

    private static Vector3D Normal(Mesh mesh, int h)
    {
        Vector3D a = mesh.Positions[mesh.Target[h ^ 1]];
        return Vector3D.Cross(mesh.Positions[mesh.Target[h]] - a, mesh.Positions[mesh.Target[mesh.Next[h]]] - a);
    }

    /// <summary>Whether the two faces of an edge disagree at one of its ends. NaN agrees with NaN, so that broken coordinates do not tear everything.</summary>
    private static bool IsSeam(Mesh mesh, HalfEdgeTrait<Vector2D> texture, int edge)
    {
        int h = 2 * edge, o = h + 1;
        return !texture[h].Equals(texture[mesh.Previous[o]]) || !texture[o].Equals(texture[mesh.Previous[h]]);
    }
}
