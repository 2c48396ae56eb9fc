using MeshLab.Numerics;

namespace MeshLab.Remeshing;

/// <summary>The fourth step: every vertex moves towards the middle of its neighbours, along the surface only (切向平滑).</summary>
/// <remarks>All new places come from all old ones, so that the order and the number of threads do not matter.</remarks>
internal static class TangentialSmoothing
{
    /// <summary>Writes the new places of the vertices from … to; vertices on lines slide towards the middle of their two neighbours on the line.</summary>
    /// <param name="s">The surface.</param>
    /// <param name="places">Per vertex, the new place.</param>
    /// <param name="from">The first vertex.</param>
    /// <param name="to">The vertex after the last.</param>
    /// <param name="byArea">Towards the mean of the triangles' middles weighted by area, in place of the mean of the neighbours.</param>
    public static void Run(RemeshSurface s, Vector3D[] places, int from, int to, bool byArea)
    {
        for (int v = from; v < to; v++)
        {
            if (!s.IsLiveVertex(v))
                continue;
            places[v] = s.IsCorner[v] ? s.Positions[v] : s.LineCount[v] != 0 ? OnLine(s, v) : Inside(s, v, byArea);
        }
    }

    private static Vector3D OnLine(RemeshSurface s, int v)
    {
        Vector3D sum = default;
        int start = s.Outgoing[v], h = start;
        do
        {
            if (s.OnLine[h >> 1])
                sum += s.Positions[s.Target[h]];
            h = s.Next[h ^ 1];
        }
        while (h != start);
        return s.Positions[v] * 0.5 + sum * 0.25;
    }

    private static Vector3D Inside(RemeshSurface s, int v, bool byArea)
    {
        int[] next = s.Next, target = s.Target;
        Vector3D[] positions = s.Positions;
        Vector3D p = positions[v], sum = default, normal = default;
        double weights = 0;
        int start = s.Outgoing[v], h = start;
        // Clockwise: the face before h is between the last neighbour and this one.
        Vector3D last = positions[target[next[h]]];
        do
        {
            Vector3D q = positions[target[h]], n = Vector3D.Cross(q - p, last - p);
            normal += n;
            if (byArea)
            {
                double area = n.Length;
                sum += (q + last) * (area / 3);
                weights += area;
            }
            else
            {
                sum += q;
                weights++;
            }
            last = q;
            h = next[h ^ 1];
        }
        while (h != start);
        if (!(weights > 0))
            return p;

        Vector3D middle = byArea ? (sum + p * (weights / 3)) * (1 / weights) : sum * (1 / weights);
        Vector3D move = middle - p;
        double squared = normal.LengthSquared;
        return p + (squared > 0 ? move - normal * (Vector3D.Dot(move, normal) / squared) : move);
    }
}
