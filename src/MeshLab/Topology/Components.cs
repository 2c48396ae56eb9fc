using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>The connected components (连通分量) of a mesh, numbered by their lowest vertex. Isolated vertices belong to none.</summary>
/// <param name="Count">The number of components.</param>
/// <param name="VertexLabels">Per vertex slot its component; −1 for isolated and deleted vertices.</param>
/// <param name="FaceLabels">Per face slot its component; −1 for deleted faces.</param>
public sealed record MeshComponents(int Count, int[] VertexLabels, int[] FaceLabels);

/// <summary>§11.1 连通分量 (components): vertices joined by edges.</summary>
/// <remarks>
/// Union–find over the edges in index order; the lower vertex always becomes the root, so the result does not depend on the order of edges
/// and numbering needs one pass. O(E α(V)).
/// </remarks>
public static class Components
{
    extension(Mesh mesh)
    {
        /// <summary>Finds the components.</summary>
        public MeshComponents FindComponents()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            int[] labels = Roots(mesh);
            int count = NumberRoots(mesh, labels);
            return new(count, labels, LabelsOfFaces(mesh, labels));
        }

        /// <summary>The number of components, isolated vertices not counted. O(E α(V)).</summary>
        public int ComponentCount
        {
            get
            {
                ArgumentNullException.ThrowIfNull(mesh);
                return NumberRoots(mesh, Roots(mesh));
            }
        }
    }

    /// <summary>Per vertex a lower or equal vertex of its component; following them ends at the lowest.</summary>
    private static int[] Roots(Mesh mesh)
    {
        ReadOnlySpan<int> target = mesh.Target;
        var parent = new int[mesh.VertexSlots];
        for (int v = 0; v < parent.Length; v++)
            parent[v] = v;
        for (int h = 0; h + 1 < target.Length; h += 2)
        {
            int a = target[h], b = target[h + 1];
            // Deleted edges have no ends. Most edges join what is joined already.
            if (a < 0 || parent[a] == parent[b])
                continue;
            a = Root(parent, a);
            b = Root(parent, b);
            if (a < b)
                parent[b] = a;
            else
                parent[a] = b;
        }
        return parent;
    }

    private static int Root(int[] parent, int v)
    {
        while (true)
        {
            int up = parent[v];
            if (up == v)
                return v;
            int further = parent[up];
            parent[v] = further;
            v = further;
        }
    }

    /// <summary>Replaces roots by numbers in order. A parent is lower than its child, so it is done first.</summary>
    private static int NumberRoots(Mesh mesh, int[] labels)
    {
        ReadOnlySpan<int> outgoing = mesh.Outgoing;
        int count = 0;
        for (int v = 0; v < labels.Length; v++)
        {
            if (outgoing[v] < 0)
                labels[v] = -1;
            else
                labels[v] = labels[v] == v ? count++ : labels[labels[v]];
        }
        return count;
    }

    private static int[] LabelsOfFaces(Mesh mesh, int[] vertexLabels)
    {
        ReadOnlySpan<int> halfEdgeOf = mesh.HalfEdgeOf, target = mesh.Target;
        var labels = new int[halfEdgeOf.Length];
        for (int f = 0; f < labels.Length; f++)
            labels[f] = halfEdgeOf[f] < 0 ? -1 : vertexLabels[target[halfEdgeOf[f]]];
        return labels;
    }
}
