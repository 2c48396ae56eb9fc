using System.Globalization;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>The topology of one component.</summary>
/// <param name="FirstVertex">Its lowest vertex.</param>
/// <param name="Vertices">The number of its vertices.</param>
/// <param name="Edges">Of its edges.</param>
/// <param name="Faces">Of its faces.</param>
/// <param name="BoundaryLoops">Of its boundary loops.</param>
public sealed record ComponentTopology(int FirstVertex, int Vertices, int Edges, int Faces, int BoundaryLoops)
{
    /// <summary>χ = V − E + F (欧拉示性数).</summary>
    public int EulerCharacteristic => Vertices - Edges + Faces;

    /// <summary>The genus g = (2 − B − χ) / 2 (亏格): the number of handles.</summary>
    public int Genus => (2 - BoundaryLoops - EulerCharacteristic) / 2;
}

/// <summary>The topology of a mesh, component by component; isolated vertices are counted apart.</summary>
/// <param name="Components">Ordered by their lowest vertex.</param>
/// <param name="IsolatedVertices">Vertices without edges, which are in no component and no sum here.</param>
public sealed record TopologyReport(IReadOnlyList<ComponentTopology> Components, int IsolatedVertices)
{
    /// <summary>V: the vertices with edges.</summary>
    public int Vertices => Components.Sum(c => c.Vertices);

    /// <summary>E.</summary>
    public int Edges => Components.Sum(c => c.Edges);

    /// <summary>F.</summary>
    public int Faces => Components.Sum(c => c.Faces);

    /// <summary>χ = V − E + F.</summary>
    public int EulerCharacteristic => Vertices - Edges + Faces;

    /// <summary>B.</summary>
    public int BoundaryLoops => Components.Sum(c => c.BoundaryLoops);

    /// <summary>The sum of the genera, g = (2C − B − χ) / 2.</summary>
    public int Genus => Components.Sum(c => c.Genus);

    /// <summary>Whether there is no boundary.</summary>
    public bool IsClosed => BoundaryLoops == 0;

    /// <summary>Euler's theorem with this mesh's numbers (欧拉公式).</summary>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture,
        $"V − E + F = {Vertices} − {Edges} + {Faces} = {EulerCharacteristic} = 2·{Components.Count} − 2·{Genus} − {BoundaryLoops} = 2C − 2g − B");
}

/// <summary>§11.1–11.3 Euler characteristic, boundary loops and genus (欧拉示性数, 边界, 亏格).</summary>
/// <remarks>An oriented closed surface is a sphere with g handles; each boundary loop takes a disk away: χ = 2 − 2g − B per component. O(V + E + F).</remarks>
public static class TopologyMeasures
{
    extension(Mesh mesh)
    {
        /// <summary>Counts everything, component by component.</summary>
        public TopologyReport ComputeTopology()
        {
            MeshComponents components = mesh.FindComponents();
            return Count(mesh, components);
        }

        /// <summary>χ = V − E + F over the vertices with edges. O(V).</summary>
        public int EulerCharacteristic
        {
            get
            {
                ArgumentNullException.ThrowIfNull(mesh);
                int used = 0;
                foreach (int h in mesh.Outgoing)
                {
                    if (h >= 0)
                        used++;
                }
                return used - mesh.Edges.Count + mesh.Faces.Count;
            }
        }

        /// <summary>The sum of the components' genera (亏格).</summary>
        public int Genus => ((2 * mesh.ComponentCount) - mesh.BoundaryLoopCount - mesh.EulerCharacteristic) / 2;
    }

    internal static TopologyReport Count(Mesh mesh, MeshComponents components)
    {
        int[] labels = components.VertexLabels;
        int[] first = new int[components.Count], vertices = new int[components.Count], edges = new int[components.Count];
        int[] faces = new int[components.Count], loops = new int[components.Count];
        ReadOnlySpan<int> target = mesh.Target;
        for (int v = labels.Length - 1; v >= 0; v--)
        {
            if (labels[v] < 0)
                continue;
            vertices[labels[v]]++;
            first[labels[v]] = v;
        }
        for (int h = 0; h < target.Length; h += 2)
        {
            if (target[h] >= 0)
                edges[labels[target[h]]]++;
        }
        foreach (int label in components.FaceLabels)
        {
            if (label >= 0)
                faces[label]++;
        }
        foreach (int h in BoundaryLoops.LoopStarts(mesh))
            loops[labels[target[h]]]++;
        int used = vertices.Sum();
        return new(
            [.. Enumerable.Range(0, components.Count).Select(c => new ComponentTopology(first[c], vertices[c], edges[c], faces[c], loops[c]))],
            mesh.Vertices.Count - used);
    }
}
