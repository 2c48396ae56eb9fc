using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>Which vertices are connected by edges.</summary>
internal static class VertexComponents
{
    /// <summary>Per vertex slot the lowest vertex of its component; −1 at isolated and deleted vertices. O(V + H).</summary>
    public static int[] Of(Mesh mesh)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing;
        var component = new int[mesh.VertexSlots];
        Array.Fill(component, -1);
        var stack = new int[component.Length];
        for (int lowest = 0; lowest < component.Length; lowest++)
        {
            if (component[lowest] >= 0 || outgoing[lowest] < 0)
                continue;
            component[lowest] = lowest;
            int depth = 0;
            stack[depth++] = lowest;
            while (depth > 0)
            {
                int first = outgoing[stack[--depth]], h = first;
                do
                {
                    if (component[target[h]] < 0)
                    {
                        component[target[h]] = lowest;
                        stack[depth++] = target[h];
                    }
                    h = next[h ^ 1];
                }
                while (h != first);
            }
        }
        return component;
    }
}
