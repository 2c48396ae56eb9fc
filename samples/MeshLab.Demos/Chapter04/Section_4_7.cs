using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.7 切换边: flips every edge whose flip brings the four valences around it closer to six.</summary>
[Demo("4.7", "切换边", "Edge flip")]
public static class Section_4_7
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Picture("before", mesh, Coloring.ByValence(mesh));

        int flipped = 0, refused = 0;
        foreach (Edge edge in mesh.Edges)
        {
            if (ValenceGain(edge) <= 0)
                continue;
            if (edge.TryFlip(out _))
                flipped++;
            else
                refused++;
        }

        output.Line($"{flipped} edges flipped, {refused} refused, of {mesh.Edges.Count}");
        output.Table("valence", [.. mesh.Vertices.GroupBy(v => v.Valence).OrderBy(g => g.Key).Select(g => ($"{g.Key}", (object)g.Count()))]);
        output.Picture("after", mesh, Coloring.ByValence(mesh));
    }

    private static int ValenceGain(Edge edge)
    {
        if (edge.IsBoundary)
            return 0;
        HalfEdge h = edge.HalfEdge0;
        return Surplus(h.Target) + Surplus(h.Source) - Surplus(h.Next.Target) - Surplus(h.Twin.Next.Target) - 2;

        static int Surplus(Vertex v) => v.Valence - (v.IsBoundary ? 4 : 6);
    }
}
