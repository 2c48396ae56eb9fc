using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>The parts into which edges cut a mesh.</summary>
/// <param name="Labels">Per face slot its region; −1 for deleted faces.</param>
/// <param name="Sizes">Per region its number of faces.</param>
public sealed record FaceRegions(int[] Labels, int[] Sizes)
{
    /// <summary>The number of regions.</summary>
    public int Count => Sizes.Length;
}

/// <summary>§5.7 选中边划分的区域: regions cut out by selected edges: faces joined across edges that are not selected.</summary>
/// <remarks>Regions are numbered by their lowest face. Selected edges that do not close a loop cut nothing off. O(H).</remarks>
public static class Regions
{
    extension(Mesh mesh)
    {
        /// <summary>The regions that the edges cut out.</summary>
        /// <exception cref="ArgumentException">An edge is none, deleted, or of another mesh; it is named.</exception>
        public FaceRegions FindRegions(IEnumerable<Edge> selected)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(selected);
            var isSelected = new bool[mesh.EdgeSlots];
            foreach (Edge e in selected)
            {
                mesh.CheckOwn(e, nameof(selected));
                isSelected[e.index] = true;
            }
            return mesh.FindRegions(isSelected);
        }

        /// <summary>The regions that the edges cut out.</summary>
        /// <param name="isSelected">Per edge slot.</param>
        /// <exception cref="ArgumentException">Not one entry per edge slot.</exception>
        public FaceRegions FindRegions(bool[] isSelected)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(isSelected);
            if (isSelected.Length != mesh.EdgeSlots)
                throw new ArgumentException($"There are {isSelected.Length} entries for {mesh.EdgeSlots} edges.", nameof(isSelected));
            return Flood(mesh, isSelected);
        }

        /// <summary>The regions that the edges with the textbook's trait <see cref="EdgeTraits.SelectedFlag"/> set cut out.</summary>
        public FaceRegions FindSelectedRegions()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            var isSelected = new bool[mesh.EdgeSlots];
            foreach (Edge e in mesh.Edges)
                isSelected[e.index] = e.Traits.SelectedFlag != 0;
            return mesh.FindRegions(isSelected);
        }
    }

    private static FaceRegions Flood(Mesh mesh, bool[] isSelected)
    {
        int[] next = mesh.next, face = mesh.face, halfEdgeOf = mesh.halfEdgeOf;
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        var sizes = new List<int>();
        var waiting = new Stack<int>();
        for (int seed = 0; seed < labels.Length; seed++)
        {
            if (halfEdgeOf[seed] < 0 || labels[seed] >= 0)
                continue;
            int label = sizes.Count, size = 0;
            labels[seed] = label;
            waiting.Push(seed);
            while (waiting.TryPop(out int f))
            {
                size++;
                int first = halfEdgeOf[f], h = first;
                do
                {
                    int across = face[h ^ 1];
                    if (across >= 0 && labels[across] < 0 && !isSelected[h >> 1])
                    {
                        labels[across] = label;
                        waiting.Push(across);
                    }
                    h = next[h];
                }
                while (h != first);
            }
            sizes.Add(size);
        }
        return new(labels, [.. sizes]);
    }
}
