using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>The smallest possible numbers of faces of 5-6-7 meshes.</summary>
/// <remarks>Closed: Σ(6 − val) = 6χ. With χ = 2 at least 12 vertices of valence 5: the icosahedron, 20 faces; 13 vertices, 22 faces, is impossible.
/// With χ = 0 the smallest torus has 7 vertices, 14 faces. With χ &lt; 0 at least 6|χ| vertices of valence 7 … 14·|χ| faces.</remarks>
internal static class SmallestCounts
{
    public const int Impossible = 22;

    public static int Of(int characteristic) => characteristic switch
    {
        > 0 => 20,
        0 => 14,
        _ => 14 * -characteristic,
    };

    /// <summary>Sums the bounds of all components; open ones count as one face.</summary>
    public static int Of(Mesh mesh, out bool isOneSphere)
    {
        int[] labels = Label(mesh, out int components);
        var characteristic = new int[components];
        var isOpen = new bool[components];
        foreach (Vertex v in mesh.Vertices)
            characteristic[labels[v.Index]]++;
        foreach (Edge e in mesh.Edges)
        {
            characteristic[labels[e.Vertex0.Index]]--;
            isOpen[labels[e.Vertex0.Index]] |= e.IsBoundary;
        }
        foreach (Face f in mesh.Faces)
            characteristic[labels[f.HalfEdge.Target.Index]]++;
        int sum = 0;
        for (int c = 0; c < components; c++)
            sum += isOpen[c] ? 1 : Of(characteristic[c]);
        isOneSphere = components == 1 && !isOpen[0] && characteristic[0] == 2;
        return sum;
    }

    private static int[] Label(Mesh mesh, out int components)
    {
        var labels = new int[mesh.VertexSlots];
        Array.Fill(labels, -1);
        components = 0;
        var open = new Stack<Vertex>();
        foreach (Vertex seed in mesh.Vertices)
        {
            if (labels[seed.Index] >= 0)
                continue;
            labels[seed.Index] = components;
            open.Push(seed);
            while (open.TryPop(out Vertex v))
            {
                foreach (Vertex w in v.Neighbors)
                {
                    if (labels[w.Index] >= 0)
                        continue;
                    labels[w.Index] = components;
                    open.Push(w);
                }
            }
            components++;
        }
        return labels;
    }
}
