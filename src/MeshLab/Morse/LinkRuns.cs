using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>A run of neighbours, one after the other around a vertex, that are all lower (or all higher) than it: a wedge of the surface that falls (or rises).</summary>
/// <param name="Steepest">The lowest (highest) of them.</param>
/// <param name="HalfEdge">The half-edge to it.</param>
internal readonly record struct LinkRun(int Steepest, int HalfEdge);

/// <summary>The wedges at a vertex. Only asked at critical points, so it need not be fast.</summary>
internal static class LinkRuns
{
    /// <summary>The lower or upper wedges of a vertex, clockwise; on the boundary from one end of the link to the other.</summary>
    public static List<LinkRun> Of(MorseFunction function, int v, bool lower)
    {
        Mesh mesh = function.Mesh;
        var runs = new List<LinkRun>();
        int start = mesh.Outgoing[v];
        if (start < 0)
            return runs;
        if (mesh.FaceOf[start] >= 0)
            start = AfterAChange(function, v, start, lower);

        bool inside = false;
        int h = start;
        do
        {
            int w = mesh.Target[h];
            bool belongs = function.IsLower(w, v) == lower;
            if (belongs && !inside)
                runs.Add(new(w, h));
            else if (belongs && function.IsLower(w, runs[^1].Steepest) == lower)
                runs[^1] = new(w, h);
            inside = belongs;
            h = mesh.Next[h ^ 1];
        }
        while (h != start);
        return runs;
    }

    /// <summary>A spoke to a neighbour that does not belong, so that no run goes over the seam; the given one if all belong.</summary>
    private static int AfterAChange(MorseFunction function, int v, int start, bool lower)
    {
        Mesh mesh = function.Mesh;
        int h = start;
        do
        {
            if (function.IsLower(mesh.Target[h], v) != lower)
                return h;
            h = mesh.Next[h ^ 1];
        }
        while (h != start);
        return start;
    }
}
