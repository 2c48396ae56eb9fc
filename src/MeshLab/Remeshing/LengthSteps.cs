using MeshLab.Numerics;

namespace MeshLab.Remeshing;

/// <summary>The first two steps: long edges are split (分裂长边), short ones are collapsed (合并短边).</summary>
internal sealed class LengthSteps(RemeshSurface s, FeatureLines lines, FeatureSharpness? sharpness)
{
    /// <summary>Edges longer than this times the length wanted are split, and no collapse may make one.</summary>
    public const double Long = 1.4;

    /// <summary>Edges shorter than this times the length wanted are collapsed.</summary>
    public const double Short = 0.7;

    // Edges up to this length go too where that brings the valences closer to six.
    private const double ShortForValence = 1.2;

    // A face may turn by 18° at most: more would cut the tips off thin parts, a little in every pass.
    private static readonly double LeastTurnCosineSquared = Math.Pow(Math.Cos(18 * Math.PI / 180), 2);

    public int Splits { get; private set; }

    public int Collapses { get; private set; }

    /// <summary>Splits long edges at their midpoints: sweeps in index order, the longest first, by factors of √2; new edges are seen in the same sweep.</summary>
    /// <remarks>In any other order, a needle whose long sides need n pieces would be filled with fans of n² of them; this way there are about n^1.6.</remarks>
    public void SplitLong()
    {
        double longest = 0;
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            if (!s.IsFreeEdge(h))
                longest = Math.Max(longest, Math.Sqrt(s.LengthSquared(h)) / Wanted(s.Target[h], s.Target[h ^ 1]));
        }
        for (double limit = longest / Math.Sqrt(2); limit > Long; limit /= Math.Sqrt(2))
            SplitLongerThan(limit);
        SplitLongerThan(Long);
    }

    private void SplitLongerThan(double factor)
    {
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            while (!s.IsFreeEdge(h) && IsLonger(h, factor))
            {
                s.Split(h, (s.Positions[s.Target[h]] + s.Positions[s.Target[h ^ 1]]) * 0.5);
                Splits++;
            }
        }
    }

    /// <summary>Collapses short edges, and edges that are not long where the valences get better, in index order.</summary>
    public void CollapseShort()
    {
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            if (s.IsFreeEdge(h) || IsLonger(h, ShortForValence))
                continue;
            if ((!IsLonger(h, Short) || ImprovesValences(h)) && TryCollapse(h))
                Collapses++;
        }
    }

    private double Wanted(int u, int v) => (s.Size[u] + s.Size[v]) * 0.5;

    private bool IsLonger(int h, double factor)
    {
        double limit = factor * Wanted(s.Target[h], s.Target[h ^ 1]);
        return s.LengthSquared(h) > limit * limit;
    }

    // Whether collapsing the edge lowers Σ (valence − 6)²; all four vertices must be inside.
    private bool ImprovesValences(int h)
    {
        int t = h ^ 1;
        if (s.Face[h] < 0 || s.Face[t] < 0)
            return false;
        int u = s.Target[t], v = s.Target[h], c = s.Target[s.Next[h]], d = s.Target[s.Next[t]];
        if ((s.LineCount[u] | s.LineCount[v] | s.LineCount[c] | s.LineCount[d]) != 0)
            return false;
        int before = Square(s.Valence[u] - 6) + Square(s.Valence[v] - 6) + Square(s.Valence[c] - 6) + Square(s.Valence[d] - 6);
        int after = Square(s.Valence[u] + s.Valence[v] - 10) + Square(s.Valence[c] - 7) + Square(s.Valence[d] - 7);
        return after < before;

        static int Square(int x) => x * x;
    }

    // The target stays. Between two free vertices it goes to the midpoint; a vertex on a line, or a corner, stays where it is.
    private bool TryCollapse(int h)
    {
        int u = s.Target[h ^ 1], v = s.Target[h];
        bool onLine = s.OnLine[h >> 1];
        if (s.LineCount[u] != 0 && s.LineCount[v] != 0 && !onLine)
            return false;
        if (s.LineCount[u] != 0 && (s.LineCount[v] == 0 || s.IsCorner[u]))
        {
            if (s.IsCorner[v])
                return false;
            h ^= 1;
            (u, v) = (v, u);
        }
        if (onLine && (ClosesALine(h) || ClosesALine(h ^ 1)))
            return false;

        bool free = s.LineCount[u] == 0 && s.LineCount[v] == 0;
        Vector3D position = free ? (s.Positions[u] + s.Positions[v]) * 0.5 : s.Positions[v];
        if (onLine && !lines.AllowsChord(s.Positions[OtherLineNeighbor(u, h)], position, s.Positions[u]))
            return false;
        if (!RingAllows(u, h, position) || (free && !RingAllows(v, h, position)) || !s.CanCollapse(h))
            return false;
        if (sharpness is not null && !sharpness.AllowsCollapse(h, position))
            return false;
        s.Collapse(h, position);
        return true;
    }

    // A triangle whose three edges are on lines would fold two lines onto each other.
    private bool ClosesALine(int h) => s.Face[h] >= 0 && s.OnLine[s.Next[h] >> 1] && s.OnLine[s.Previous[h] >> 1];

    // The line through u: h is its one edge at u, this is the other one's far end.
    private int OtherLineNeighbor(int u, int h)
    {
        int k = s.Next[h ^ 1];
        while (!s.OnLine[k >> 1])
            k = s.Next[k ^ 1];
        return s.Target[k];
    }

    // Whether the edges around w stay short enough and its faces keep their direction if it moves to the position.
    private bool RingAllows(int w, int h, Vector3D position)
    {
        int u = s.Target[h ^ 1], v = s.Target[h], f = s.Face[h], g = s.Face[h ^ 1], start = s.Outgoing[w], k = start;
        Vector3D old = s.Positions[w];
        do
        {
            int x = s.Target[k];
            Vector3D px = s.Positions[x];
            double limit = Long * Wanted(x, v);
            if (x != u && x != v && Vector3D.DistanceSquared(px, position) > limit * limit)
                return false;
            int face = s.Face[k];
            if (face >= 0 && face != f && face != g)
            {
                Vector3D py = s.Positions[s.Target[s.Next[k]]];
                Vector3D before = Vector3D.Cross(px - old, py - old), after = Vector3D.Cross(px - position, py - position);
                double dot = Vector3D.Dot(before, after);
                if (dot <= 0 || dot * dot < LeastTurnCosineSquared * before.LengthSquared * after.LengthSquared)
                    return false;
            }
            k = s.Next[k ^ 1];
        }
        while (k != start);
        return true;
    }
}
