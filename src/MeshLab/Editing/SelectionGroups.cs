using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.8 选择分组 (groups of selected vertices): numbers the connected groups of selected vertices.</summary>
/// <remarks>A group is a set of selected vertices joined by edges whose both ends are selected. Groups are numbered from 1 by their smallest vertex.
/// O(V + E).</remarks>
public static class SelectionGroups
{
    extension(Mesh mesh)
    {
        /// <summary>Replaces the flag of every selected vertex (<see cref="TraitNames.SelectedFlag"/> ≠ 0) by the number of its group.</summary>
        /// <returns>The number of groups.</returns>
        public int LabelSelectedGroups()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            if (!mesh.TryGetVertexTrait(TraitNames.SelectedFlag, out VertexTrait<int>? flags))
                return 0;
            int[] labels = mesh.LabelGroups(v => flags[v] != 0, out int count);
            labels.CopyTo(flags.Values);
            return count;
        }

        /// <summary>Numbers the connected groups of the vertices that a condition selects; nothing is written to the mesh.</summary>
        /// <param name="isSelected">Which vertices are meant.</param>
        /// <param name="count">The number of groups.</param>
        /// <returns>Per vertex slot, the number of its group from 1; 0 for the others.</returns>
        public int[] LabelGroups(Func<Vertex, bool> isSelected, out int count)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(isSelected);
            const int Waiting = -1;
            var labels = new int[mesh.VertexSlots];
            foreach (Vertex v in mesh.Vertices)
                labels[v.Index] = isSelected(v) ? Waiting : 0;

            count = 0;
            var open = new Stack<Vertex>();
            foreach (Vertex seed in mesh.Vertices)
            {
                if (labels[seed.Index] != Waiting)
                    continue;
                labels[seed.Index] = ++count;
                open.Push(seed);
                while (open.TryPop(out Vertex v))
                {
                    foreach (Vertex w in v.Neighbors)
                    {
                        if (labels[w.Index] != Waiting)
                            continue;
                        labels[w.Index] = count;
                        open.Push(w);
                    }
                }
            }
            return labels;
        }
    }
}
