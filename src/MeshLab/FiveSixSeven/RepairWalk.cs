using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Lowers Φ by short walks of flips, splits and collapses that begin at a bad vertex; a walk that does not get below where it began is taken back.</summary>
internal sealed class RepairWalk(Guard guard)
{
    private const int BadVerticesPerStep = 4;
    private const int CandidatesPerStep = 60;
    private const int CountBias = 10;
    private const int CollapseCost = 4;
    private const int SplitCost = 12;
    private const int UnlimitedGrowth = 99;

    private const int FlipType = 0;
    private const int SplitType = 1;
    private const int CollapseType = 2;

    private readonly WorkMesh mesh = guard.Mesh;
    private readonly List<int> changed = [];
    private readonly List<int> also = [];
    private long[] candidates = new long[256];
    private int candidateCount;
    private int[] seenEdge = [], tabooEdge = [], seenVertex = [];
    private int step, walk;

    /// <summary>Below so many faces, walks rather split; above, they rather collapse.</summary>
    public int TargetFaces { get; set; }

    public long Walks { get; private set; }

    /// <summary>Starts a walk from every bad vertex in index order, as long as walks succeed.</summary>
    public void Pass(in GuardLevel level, int steps, int starts, CancellationToken cancellationToken)
    {
        const int WalksPerVertex = 40;
        for (int v = 0; v < mesh.VertexSlots && mesh.Penalty > 0; v++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            for (int i = 0; i < WalksPerVertex && mesh.IsLiveVertex(v) && mesh.IsBad(v); i++)
            {
                if (!TryRepair(v, level, steps, starts))
                    break;
            }
        }
    }

    /// <summary>Walks from a vertex until Φ is lower than now.</summary>
    public bool TryRepair(int v, in GuardLevel level, int steps, int starts)
    {
        also.Clear();
        bool repaired = Run(v, level, steps, starts, mesh.Penalty - 1, mesh.LiveFaces, UnlimitedGrowth, 0);
        mesh.StopRecording();
        return repaired;
    }

    /// <summary>Goes on with what an operation left behind, until Φ is no higher than a bound; the caller records, and takes back on failure.</summary>
    public bool TryContinue(ReadOnlySpan<int> touched, in GuardLevel level, int steps, int starts, long bound, int maxGrowth, int minFaces)
    {
        also.Clear();
        foreach (int v in touched)
        {
            if (v >= 0)
                also.Add(v);
        }
        return Run(also[0], level, steps, starts, bound, mesh.LiveFaces, maxGrowth, minFaces);
    }

    private bool Run(int v, in GuardLevel level, int steps, int starts, long bound, int facesBefore, int maxGrowth, int minFaces)
    {
        for (int start = 0; start < starts; start++)
        {
            Walks++;
            walk++;
            WorkMesh.Mark mark = mesh.StartRecording();
            changed.Clear();
            EnsureStamps();
            NewRound();
            Touch(v);
            foreach (int u in also)
                Touch(u);
            bool anything = false;
            for (int i = 0; i < steps; i++)
            {
                if (!TakeStep(level, i == 0 ? start : 0, facesBefore + maxGrowth, minFaces))
                    break;
                anything = true;
                if (mesh.Penalty <= bound)
                    return true;
            }
            mesh.UndoTo(mark);
            if (!anything)
                return false;
        }
        return false;
    }

    // Which vertices a walk has touched is a matter of the walk; which edges were looked at, of the step.
    private void NewRound() => vertexRound++;

    private int vertexRound;

    private void Touch(int v)
    {
        if (seenVertex[v] == vertexRound)
            return;
        seenVertex[v] = vertexRound;
        changed.Add(v);
    }

    private void EnsureStamps()
    {
        // A walk adds at most one vertex and three edges per step.
        const int Slack = 256;
        if (seenVertex.Length < mesh.VertexSlots + Slack)
            Array.Resize(ref seenVertex, mesh.VertexSlots + mesh.VertexSlots / 2 + 2 * Slack);
        if (seenEdge.Length < mesh.EdgeSlots + 3 * Slack)
        {
            Array.Resize(ref seenEdge, mesh.EdgeSlots + mesh.EdgeSlots / 2 + 6 * Slack);
            Array.Resize(ref tabooEdge, seenEdge.Length);
        }
    }

    /// <summary>Does the best operation that is legal and allowed, after passing over <paramref name="skip"/> of them.</summary>
    private bool TakeStep(in GuardLevel level, int skip, int maxFaces, int minFaces)
    {
        GatherCandidates();
        candidates.AsSpan(0, candidateCount).Sort();
        for (int i = 0; i < Math.Min(candidateCount, CandidatesPerStep); i++)
        {
            int h = (int)(candidates[i] & 0x7FFFFFFF), type = (int)(candidates[i] >> 31) & 3;
            bool done = type switch
            {
                FlipType => TryFlip(h, level, ref skip),
                SplitType => mesh.LiveFaces < maxFaces && TrySplit(h, level, ref skip),
                _ => mesh.LiveFaces - 2 >= minFaces && TryCollapse(h, level, ref skip),
            };
            if (done)
                return true;
        }
        return false;
    }

    private bool TryFlip(int h, in GuardLevel level, ref int skip)
    {
        if (!mesh.CanFlip(h) || !guard.AllowsFlip(h, level) || skip-- > 0)
            return false;
        int a = mesh.Source(h), b = mesh.Target[h], c = mesh.Apex(h), d = mesh.Apex(h ^ 1);
        mesh.Flip(h);
        tabooEdge[h >> 1] = walk;
        Touch(a);
        Touch(b);
        Touch(c);
        Touch(d);
        return true;
    }

    private bool TrySplit(int h, in GuardLevel level, ref int skip)
    {
        Vector3D p = guard.SplitPosition(h);
        if (!guard.AllowsSplit(h, p, level) || skip-- > 0)
            return false;
        (int c, int d) = ApexesOf(h);
        Touch(mesh.Split(h, p));
        TouchIfAny(c);
        TouchIfAny(d);
        return true;
    }

    private bool TryCollapse(int h, in GuardLevel level, ref int skip)
    {
        if (!mesh.CanCollapse(h) || !guard.TryCollapsePosition(h, out Vector3D p))
            return false;
        if (!guard.AllowsCollapse(h, p, level))
        {
            p = mesh.Positions[mesh.Target[h]];
            if (mesh.Kind[mesh.Target[h]] != VertexKind.Smooth || !guard.AllowsCollapse(h, p, level))
                return false;
        }
        if (skip-- > 0)
            return false;
        int b = mesh.Target[h];
        (int c, int d) = ApexesOf(h);
        mesh.Collapse(h, p);
        Touch(b);
        TouchIfAny(c);
        TouchIfAny(d);
        return true;
    }

    private (int C, int D) ApexesOf(int h) =>
        (mesh.Face[h] >= 0 ? mesh.Apex(h) : -1, mesh.Face[h ^ 1] >= 0 ? mesh.Apex(h ^ 1) : -1);

    private void TouchIfAny(int v)
    {
        if (v >= 0)
            Touch(v);
    }

    /// <summary>Every edge at the first bad vertices among those changed, and at their neighbours, in all its ways.</summary>
    private void GatherCandidates()
    {
        step++;
        candidateCount = 0;
        int bad = 0;
        for (int i = 0; i < changed.Count && bad < BadVerticesPerStep; i++)
        {
            int v = changed[i];
            if (!mesh.IsLiveVertex(v) || !mesh.IsBad(v))
                continue;
            bad++;
            int start = mesh.Outgoing[v], x = start;
            do
            {
                AddEdge(x >> 1);
                int first = mesh.Outgoing[mesh.Target[x]], y = first;
                do
                {
                    AddEdge(y >> 1);
                    y = mesh.Next[y ^ 1];
                }
                while (y != first);
                x = mesh.Next[x ^ 1];
            }
            while (x != start);
        }
    }

    /// <summary>Scores 8ΔΦ + ΔΣ(val − 6)² and the cost of the operation.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void AddEdge(int e)
    {
        if (seenEdge[e] == step || tabooEdge[e] == walk)
            return;
        seenEdge[e] = step;
        int h = 2 * e, t = h + 1, a = mesh.Target[t], b = mesh.Target[h], f = mesh.Face[h], g = mesh.Face[t];
        int c = f >= 0 ? mesh.Apex(h) : -1, d = g >= 0 ? mesh.Apex(t) : -1;
        int bias = mesh.LiveFaces < TargetFaces ? CountBias : 0;
        int apexesGain = (f >= 0 ? Change(c, 1) : 0) + (g >= 0 ? Change(d, 1) : 0);
        int apexesLose = (f >= 0 ? Change(c, -1) : 0) + (g >= 0 ? Change(d, -1) : 0);

        if (f >= 0 && g >= 0 && mesh.Crease[e] == 0)
            AddCandidate(Change(a, -1) + Change(b, -1) + apexesGain, FlipType, h);
        // The new vertex has valence 4 inside.
        AddCandidate(SplitCost - bias + apexesGain + (f >= 0 && g >= 0 ? Weight(4, 0) : 0), SplitType, h);
        for (int side = 0; side < 2; side++)
        {
            int x = h ^ side, from = mesh.Source(x), to = mesh.Target[x];
            if (mesh.Kind[from] == VertexKind.Corner || (mesh.Kind[from] == VertexKind.OnCrease && mesh.Crease[e] == 0))
                continue;
            int rim = mesh.OnRim[from] | mesh.OnRim[to], valence = mesh.Valence[from] + mesh.Valence[to] - (f < 0 || g < 0 ? 3 : 4);
            int merged = Weight(valence, rim) - Weight(mesh.Valence[from], mesh.OnRim[from]) - Weight(mesh.Valence[to], mesh.OnRim[to]);
            AddCandidate(CollapseCost + bias + merged + apexesLose, CollapseType, x);
        }
    }

    private static int Weight(int valence, int rim) => 8 * WorkMesh.PenaltyOf(valence, rim) + WorkMesh.IrregularityOf(valence, rim);

    private int Change(int v, int d) => 8 * mesh.PenaltyChange(v, d) + mesh.IrregularityChange(v, d);

    // Score, type and half-edge in one number, so that sorting numbers sorts candidates and leaves no tie.
    private void AddCandidate(int score, int type, int h)
    {
        if (candidateCount == candidates.Length)
            Array.Resize(ref candidates, 2 * candidates.Length);
        candidates[candidateCount++] = ((long)score << 33) | ((long)type << 31) | (uint)h;
    }
}
