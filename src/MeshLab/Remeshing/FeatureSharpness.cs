using MeshLab.Numerics;

namespace MeshLab.Remeshing;

/// <summary>Keeps features sharp: no step brings the angle between the two faces beside a feature down to the feature angle, or further down where it is there already.</summary>
/// <remarks>A feature can lie where it was and yet be one no more: on a thin strip, as the wall of a hole, a face that reaches from the rim to a vertex far along the
/// wall leans over. Whoever looks for the features of the result would not find it.</remarks>
internal sealed class FeatureSharpness(RemeshSurface s, double featureAngle)
{
    private readonly double _cosine = Math.Cos(featureAngle);

    /// <summary>Whether the features around the quadrilateral beside the edge stay sharp if it is flipped.</summary>
    public bool AllowsFlip(int h)
    {
        int t = h ^ 1, c = s.Target[s.Next[h]], d = s.Target[s.Next[t]];
        Vector3D pc = s.Positions[c], pd = s.Positions[d];
        return Keeps(s.Next[h], pd) && Keeps(s.Previous[h], pd) && Keeps(s.Next[t], pc) && Keeps(s.Previous[t], pc);
    }

    /// <summary>Whether the features around stay sharp if the edge is contracted to a position; its target stays on its line, or neither end is on one.</summary>
    public bool AllowsCollapse(int h, Vector3D position)
    {
        int u = s.Target[h ^ 1], v = s.Target[h];
        return RingStaysSharp(u, h, position)
            && (s.LineCount[v] != 0 || RingStaysSharp(v, h, position))
            && MergedStaysSharp(h, s.Next[h], s.Previous[h], position)
            && MergedStaysSharp(h ^ 1, s.Previous[h ^ 1], s.Next[h ^ 1], position);
    }

    /// <summary>Takes back the moves of all vertices around features that would not stay sharp.</summary>
    public void TakeBackMoves(Vector3D[] places)
    {
        bool again;
        do
        {
            again = false;
            for (int h = 0; h < s.HalfEdgeSlots; h += 2)
            {
                if (s.IsFreeEdge(h) || !IsFeature(h))
                    continue;
                int t = h ^ 1, a = s.Target[t], b = s.Target[h], c = s.Target[s.Next[h]], d = s.Target[s.Next[t]];
                if (StaysSharp(Now(h), Cosine(places[a], places[b], places[c], places[d])))
                    continue;
                foreach (int v in (ReadOnlySpan<int>)[a, b, c, d])
                {
                    again |= places[v] != s.Positions[v];
                    places[v] = s.Positions[v];
                }
            }
        }
        while (again);
    }

    private bool IsFeature(int h) => s.OnLine[h >> 1] && s.Face[h] >= 0 && s.Face[h ^ 1] >= 0;

    // The edge's face gets another apex.
    private bool Keeps(int h, Vector3D apex) => !IsFeature(h)
        || StaysSharp(Now(h), Cosine(s.Positions[s.Target[h ^ 1]], s.Positions[s.Target[h]], apex, s.Positions[s.Target[s.Next[h ^ 1]]]));

    // The faces around w, which moves to the position, but those beside the edge h: the edges opposite w, and those from it.
    private bool RingStaysSharp(int w, int h, Vector3D position)
    {
        int f = s.Face[h], g = s.Face[h ^ 1], c = f >= 0 ? s.Target[s.Next[h]] : -1, d = g >= 0 ? s.Target[s.Next[h ^ 1]] : -1;
        int start = s.Outgoing[w], k = start;
        do
        {
            int face = s.Face[k], x = s.Target[k], opposite = s.Next[k];
            if (face >= 0 && face != f && face != g && IsFeature(opposite)
                && !StaysSharp(Now(opposite), Cosine(s.Positions[x], s.Positions[s.Target[opposite]], position, Moved(s.Target[s.Next[opposite ^ 1]], h, position))))
            {
                return false;
            }
            if (k >> 1 != h >> 1 && x != c && x != d && IsFeature(k)
                && !StaysSharp(Now(k), Cosine(position, s.Positions[x], s.Positions[s.Target[opposite]], s.Positions[s.Target[s.Next[k ^ 1]]])))
            {
                return false;
            }
            k = s.Next[k ^ 1];
        }
        while (k != start);
        return true;
    }

    // The face beside h vanishes; its side at the target and its side at the source become one edge, with the faces beyond both.
    private bool MergedStaysSharp(int h, int atTarget, int atSource, Vector3D position)
    {
        if (s.Face[h] < 0)
            return true;
        int across = atTarget ^ 1, beyond = atSource ^ 1;
        bool isFeature = IsFeature(atTarget);
        if ((!isFeature && !IsFeature(atSource)) || s.Face[across] < 0 || s.Face[beyond] < 0)
            return true;
        int from = s.Target[across], to = s.Target[atTarget];
        double after = Cosine(
            Moved(from, h, position), Moved(to, h, position), s.Positions[s.Target[s.Next[beyond]]], s.Positions[s.Target[s.Next[across]]]);
        return StaysSharp(Now(isFeature ? atTarget : atSource), after);
    }

    private Vector3D Moved(int v, int h, Vector3D position) => v == s.Target[h] || v == s.Target[h ^ 1] ? position : s.Positions[v];

    private bool StaysSharp(double before, double after) => after < _cosine || after <= before;

    private double Now(int h) => Cosine(
        s.Positions[s.Target[h ^ 1]], s.Positions[s.Target[h]], s.Positions[s.Target[s.Next[h]]], s.Positions[s.Target[s.Next[h ^ 1]]]);

    // Of the angle between the normals of the faces left and right of the edge ab; a face without area has none, which counts as flat.
    private static double Cosine(Vector3D a, Vector3D b, Vector3D left, Vector3D right)
    {
        Vector3D ab = b - a, m = Vector3D.Cross(ab, left - a), n = Vector3D.Cross(right - a, ab);
        double lengths = Math.Sqrt(m.LengthSquared * n.LengthSquared);
        return lengths > 0 ? Vector3D.Dot(m, n) / lengths : 1;
    }
}
