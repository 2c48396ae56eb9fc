using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Brings the number of faces to the one asked for, without raising Φ.</summary>
internal sealed class FaceCount(Guard guard, RepairWalk walk, CancellationToken cancellationToken)
{
    private readonly WorkMesh mesh = guard.Mesh;

    /// <summary>Up to so many rounds of collapses, or of splits; ends early when a round changes nothing.</summary>
    public void Approach(int target, in GuardLevel level, int rounds)
    {
        for (int round = 0; round < rounds; round++)
        {
            int before = mesh.LiveFaces;
            if (before > target + 1)
                CollapseRound(target, level, withRepair: round > 0);
            else if (before < target - 1)
                SplitRound(target, level);
            if (mesh.LiveFaces == before && round > 0)
                return;
        }
    }

    /// <summary>Collapses in the order of quadric error and length; from the second round on with a repair walk after each.</summary>
    private void CollapseRound(int target, in GuardLevel level, bool withRepair)
    {
        foreach (int e in Sorted(CollapseCost))
        {
            if (mesh.LiveFaces <= target)
                return;
            cancellationToken.ThrowIfCancellationRequested();
            if (mesh.IsLiveEdge(e) && !TryCollapse(e, level, keepsPenalty: true) && withRepair)
                TryCollapseAndRepair(e, level);
        }
    }

    private void SplitRound(int target, in GuardLevel level)
    {
        const double StillLong = 0.8 * 0.8;
        int[] order = Sorted(e => -mesh.LengthSquared(e), double.PositiveInfinity, out double[] costs);
        for (int i = 0; i < order.Length && mesh.LiveFaces < target - 1; i++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (mesh.IsLiveEdge(order[i]) && mesh.LengthSquared(order[i]) >= -costs[i] * StillLong)
                TrySplitAndRepair(order[i], level);
        }
    }

    /// <summary>The live edges whose cost is below a limit, cheapest first; ties by index.</summary>
    public int[] Sorted(Func<int, double> cost, double limit = double.PositiveInfinity) => Sorted(cost, limit, out _);

    private int[] Sorted(Func<int, double> cost, double limit, out double[] costs)
    {
        var keys = new List<(double Cost, int Edge)>();
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (mesh.IsLiveEdge(e) && cost(e) is var key && !(key >= limit))
                keys.Add((key, e));
        }
        keys.Sort();
        costs = [.. keys.Select(k => k.Cost)];
        return [.. keys.Select(k => k.Edge)];
    }

    private double CollapseCost(int e)
    {
        const double ErrorWeight = 100;
        int a = mesh.Target[2 * e], b = mesh.Target[2 * e + 1];
        Vector3D middle = (mesh.Positions[a] + mesh.Positions[b]) * 0.5;
        double weight = mesh.Quadrics[a].Weight + mesh.Quadrics[b].Weight;
        double error = weight > 0 ? (mesh.Quadrics[a].At(middle) + mesh.Quadrics[b].At(middle)) / weight : 0;
        return ErrorWeight * Math.Max(error, 0) + mesh.LengthSquared(e);
    }

    /// <summary>Whether this direction of the edge is one to try: the other is the same where both ends are free.</summary>
    private bool IsWayToCollapse(int h)
    {
        int a = mesh.Source(h), b = mesh.Target[h];
        if (mesh.Kind[a] == VertexKind.Corner || (mesh.Kind[a] == VertexKind.OnCrease && mesh.Crease[h >> 1] == 0))
            return false;
        return (h & 1) == 0 || mesh.Kind[a] != VertexKind.Smooth || mesh.Kind[b] != VertexKind.Smooth;
    }

    /// <summary>Collapses an edge where it is legal, keeps the shape and, if wanted, does not raise Φ.</summary>
    public bool TryCollapse(int e, in GuardLevel level, bool keepsPenalty, double maxLength = double.PositiveInfinity)
    {
        for (int h = 2 * e; h <= 2 * e + 1; h++)
        {
            if (!IsWayToCollapse(h) || (keepsPenalty && PenaltyChange(h) > 0) || !mesh.CanCollapse(h)
                || !guard.TryCollapsePosition(h, out Vector3D p) || !guard.AllowsCollapse(h, p, level) || MakesLong(h, p, maxLength))
            {
                continue;
            }
            mesh.Collapse(h, p);
            return true;
        }
        return false;
    }

    private bool MakesLong(int h, Vector3D p, double maxLength)
    {
        if (double.IsPositiveInfinity(maxLength))
            return false;
        int start = mesh.Outgoing[mesh.Source(h)], x = start;
        do
        {
            if (Vector3D.Distance(mesh.Positions[mesh.Target[x]], p) > maxLength)
                return true;
            x = mesh.Next[x ^ 1];
        }
        while (x != start);
        return false;
    }

    private int PenaltyChange(int h)
    {
        int a = mesh.Source(h), b = mesh.Target[h], f = mesh.Face[h], g = mesh.Face[h ^ 1];
        int valence = mesh.Valence[a] + mesh.Valence[b] - (f < 0 || g < 0 ? 3 : 4);
        int change = WorkMesh.PenaltyOf(valence, mesh.OnRim[a] | mesh.OnRim[b])
            - WorkMesh.PenaltyOf(mesh.Valence[a], mesh.OnRim[a]) - WorkMesh.PenaltyOf(mesh.Valence[b], mesh.OnRim[b]);
        if (f >= 0)
            change += mesh.PenaltyChange(mesh.Apex(h), -1);
        if (g >= 0)
            change += mesh.PenaltyChange(mesh.Apex(h ^ 1), -1);
        return change;
    }

    /// <summary>A collapse that may raise Φ, and a walk that lowers it again without new faces; both or none.</summary>
    public bool TryCollapseAndRepair(int e, in GuardLevel level)
    {
        const int Steps = 8, Starts = 6;
        for (int h = 2 * e; h <= 2 * e + 1; h++)
        {
            if (!IsWayToCollapse(h) || !mesh.CanCollapse(h) || !guard.TryCollapsePosition(h, out Vector3D p) || !guard.AllowsCollapse(h, p, level))
                continue;
            long bound = mesh.Penalty;
            int b = mesh.Target[h], c = mesh.Face[h] >= 0 ? mesh.Apex(h) : -1, d = mesh.Face[h ^ 1] >= 0 ? mesh.Apex(h ^ 1) : -1;
            WorkMesh.Mark mark = mesh.StartRecording();
            mesh.Collapse(h, p);
            bool ok = mesh.Penalty <= bound || walk.TryContinue([b, c, d], level, Steps, Starts, bound, 0, 0);
            if (!ok)
                mesh.UndoTo(mark);
            mesh.StopRecording();
            if (ok)
                return true;
        }
        return false;
    }

    private void TrySplitAndRepair(int e, in GuardLevel level)
    {
        const int Steps = 6, Starts = 6;
        int h = 2 * e;
        Vector3D p = guard.SplitPosition(h);
        if (!guard.AllowsSplit(h, p, level))
            return;
        long bound = mesh.Penalty;
        int c = mesh.Face[h] >= 0 ? mesh.Apex(h) : -1, d = mesh.Face[h ^ 1] >= 0 ? mesh.Apex(h ^ 1) : -1;
        WorkMesh.Mark mark = mesh.StartRecording();
        int v = mesh.Split(h, p);
        if (mesh.Penalty > bound && !walk.TryContinue([v, c, d], level, Steps, Starts, bound, 2, mesh.LiveFaces))
            mesh.UndoTo(mark);
        mesh.StopRecording();
    }
}
