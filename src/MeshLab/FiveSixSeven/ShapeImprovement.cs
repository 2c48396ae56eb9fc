using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Rounder triangles at the same valences: tangential smoothing on the input (redistribution, 重新分布), flips, and slivers collapsed.</summary>
internal sealed class ShapeImprovement(Guard guard, FaceCount faceCount, CancellationToken cancellationToken)
{
    private readonly WorkMesh mesh = guard.Mesh;
    // A vertex that would move by less than about a hundredth of an edge stays: the square of it, as a share of the area around.
    private const double LeastMove = 2e-5;

    // A pass of remeshing that splits and collapses fewer edges than this share of the faces has nothing left to do.
    private const double FewChanges = 0.1;

    // Needles have long edges on little area: splitting them all to the length of even triangles may take any number of faces.
    private const long MostGrowth = 20;

    private int[] hints = [];

    /// <summary>Moves every vertex towards the area-weighted mean of its faces' centroids, in its tangent plane, and back onto the input; never where
    /// a face would turn, or the worst face around it get worse.</summary>
    /// <remarks>Vertices of one colour are no neighbours: they may move at the same time, and the number of threads makes no difference.</remarks>
    public void Smooth(int sweeps, double minimumCosine, double goodQuality, GuardLevel level)
    {
        const int BlockSize = 256;
        if (hints.Length < mesh.VertexSlots)
            Array.Resize(ref hints, mesh.VertexSlots + mesh.VertexSlots / 4);
        int[][] colors = VertexColors.Of(mesh);
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            foreach (int[] movable in colors)
            {
                Parallelism.ForBlocks(movable.Length, BlockSize, (first, end) =>
                {
                    cancellationToken.ThrowIfCancellationRequested();
                    Guard own = guard.Fork();
                    for (int i = first; i < end; i++)
                    {
                        if (TryTarget(movable[i], out Vector3D target))
                            Move(own, movable[i], target, minimumCosine, goodQuality, level);
                    }
                });
            }
            mesh.Trace?.Move("smooth", mesh.Positions.AsSpan(0, mesh.VertexSlots));
        }
    }

    private bool TryTarget(int v, out Vector3D target)
    {
        Vector3D p = mesh.Positions[v], sum = default, normal = default;
        double weight = 0;
        bool onLine = mesh.Kind[v] == VertexKind.OnCrease;
        int start = mesh.Outgoing[v], x = start;
        do
        {
            Vector3D a = mesh.Positions[mesh.Target[x]];
            if (onLine && mesh.Crease[x >> 1] != 0)
            {
                sum += a;
                weight++;
            }
            else if (!onLine)
            {
                Vector3D b = mesh.Positions[mesh.Apex(x)], cross = Vector3D.Cross(a - p, b - p);
                double area = cross.Length;
                normal += cross;
                sum += (a + b + p) * (area / 3);
                weight += area;
            }
            x = mesh.Next[x ^ 1];
        }
        while (x != start);
        target = p;
        if (onLine ? weight != 2 : weight <= 0)
            return false;
        target = sum / weight;
        if (!onLine && normal.LengthSquared > 0)
        {
            normal = normal.Normalized();
            target -= normal * Vector3D.Dot(target - p, normal);
        }
        return Vector3D.DistanceSquared(target, p) >= (onLine ? 1e-12 : LeastMove * weight);
    }

    private void Move(Guard own, int v, Vector3D target, double minimumCosine, double goodQuality, in GuardLevel level)
    {
        Vector3D old = mesh.Positions[v];
        own.Surface.Hint = hints[v] - 1;
        foreach (double part in (ReadOnlySpan<double>)[1, 0.5, 0.2])
        {
            Vector3D p = old + (target - old) * part;
            p = mesh.Kind[v] == VertexKind.OnCrease ? own.Surface.ProjectToLines(p) : own.Surface.Project(p);
            if (!IsBetter(v, old, p, minimumCosine, goodQuality) || !own.IsStarNear(v, p, level))
                continue;
            mesh.Positions[v] = p;
            hints[v] = own.Surface.Hint + 1;
            return;
        }
    }

    private bool IsBetter(int v, Vector3D old, Vector3D p, double minimumCosine, double goodQuality)
    {
        double before = 1, after = 1;
        int start = mesh.Outgoing[v], x = start;
        do
        {
            if (mesh.Face[x] >= 0)
            {
                Vector3D a = mesh.Positions[mesh.Target[x]], b = mesh.Positions[mesh.Apex(x)];
                double was = Shape.Quality(old, a, b), now = Shape.Quality(p, a, b);
                before = Math.Min(before, was);
                after = Math.Min(after, now);
                if (now < 1e-6 || (was > 1e-3 && Vector3D.Dot(Shape.Normal(old, a, b), Shape.Normal(p, a, b)) < minimumCosine))
                    return false;
            }
            x = mesh.Next[x ^ 1];
        }
        while (x != start);
        return after >= before || after >= goodQuality;
    }

    /// <summary>What a flip must do.</summary>
    public enum FlipRule
    {
        /// <summary>Bring the valences closer to 6.</summary>
        Regularity,

        /// <summary>Raise the least quality of the two triangles without raising Φ.</summary>
        QualityKeepingPenalty,

        /// <summary>Raise the least quality of the two triangles.</summary>
        Quality,
    }

    public void Flip(in GuardLevel level, int sweeps, FlipRule rule)
    {
        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            int flips = 0;
            cancellationToken.ThrowIfCancellationRequested();
            for (int e = 0; e < mesh.EdgeSlots; e++)
            {
                int h = 2 * e;
                if (!mesh.IsLiveEdge(e) || mesh.Crease[e] != 0 || mesh.Face[h] < 0 || mesh.Face[h + 1] < 0 || !IsWanted(h, rule)
                    || !mesh.CanFlip(h) || !guard.AllowsFlip(h, level, mustImprove: rule != FlipRule.Regularity))
                {
                    continue;
                }
                mesh.Flip(h);
                flips++;
            }
            if (flips == 0)
                return;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private bool IsWanted(int h, FlipRule rule)
    {
        if (rule == FlipRule.Quality)
            return true;
        int a = mesh.Source(h), b = mesh.Target[h], c = mesh.Apex(h), d = mesh.Apex(h ^ 1);
        return rule == FlipRule.Regularity
            ? mesh.IrregularityChange(a, -1) + mesh.IrregularityChange(b, -1) + mesh.IrregularityChange(c, 1) + mesh.IrregularityChange(d, 1) < 0
            : mesh.PenaltyChange(a, -1) + mesh.PenaltyChange(b, -1) + mesh.PenaltyChange(c, 1) + mesh.PenaltyChange(d, 1) <= 0;
    }

    /// <summary>Collapses the shorter sides of triangles below a quality, worst first.</summary>
    public void CollapseSlivers(double quality, in GuardLevel level)
    {
        var worst = new List<(double Quality, int Face)>();
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            if (mesh.IsLiveFace(f) && mesh.QualityOf(f) is var q && q < quality)
                worst.Add((q, f));
        }
        worst.Sort();
        foreach ((_, int f) in worst)
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (!mesh.IsLiveFace(f) || mesh.QualityOf(f) >= quality)
                continue;
            int h = mesh.HalfEdgeOf[f];
            int[] sides = [h >> 1, mesh.Next[h] >> 1, mesh.Previous[h] >> 1];
            Array.Sort(sides, (a, b) => mesh.LengthSquared(a) != mesh.LengthSquared(b) ? mesh.LengthSquared(a).CompareTo(mesh.LengthSquared(b)) : a.CompareTo(b));
            if (!faceCount.TryCollapse(sides[0], level, keepsPenalty: true) && !faceCount.TryCollapseAndRepair(sides[0], level)
                && !faceCount.TryCollapse(sides[1], level, keepsPenalty: true))
            {
                faceCount.TryCollapseAndRepair(sides[1], level);
            }
        }
    }

    /// <summary>Before the repair, where the input's triangles are bad: a few passes of isotropic remeshing at the asked number of faces.</summary>
    /// <remarks>Needles are flipped first, so that fewer long edges are split. Ends early when a pass splits and collapses few edges.</remarks>
    public void Remesh(int targetFaces, int passes, in GuardLevel level)
    {
        double length = Math.Sqrt(4 * guard.Surface.Area / (Math.Sqrt(3) * targetFaces));
        // A surface without area has no even triangles.
        if (!(length > 0))
            return;
        Flip(level, 4, FlipRule.Quality);
        for (int pass = 0; pass < passes; pass++)
        {
            int changes = SplitLong(length * 4 / 3, level, MostGrowth * targetFaces) + CollapseShort(length * 4 / 5, length * 4 / 3, level);
            Flip(level, 4, FlipRule.Regularity);
            Flip(new(0.98, 0, level.Tolerance), 2, FlipRule.Quality);
            Smooth(3, 0.7, 0.6, level);
            length *= Math.Sqrt((double)mesh.LiveFaces / targetFaces);
            if (changes < FewChanges * mesh.LiveFaces)
                return;
        }
    }

    /// <summary>Splits edges above a length, longest first, in rounds, up to a number of faces; the number of splits.</summary>
    private int SplitLong(double limit, in GuardLevel level, long mostFaces)
    {
        const int Rounds = 12;
        int splits = 0;
        for (int round = 0; round < Rounds; round++)
        {
            int[] order = faceCount.Sorted(e => -mesh.LengthSquared(e), -limit * limit);
            foreach (int e in order)
            {
                if (mesh.LiveFaces >= mostFaces)
                    return splits;
                cancellationToken.ThrowIfCancellationRequested();
                splits++;
                int h = 2 * e;
                Vector3D p = guard.SplitPosition(h);
                if (!guard.AllowsSplit(h, p, new(0.5, 0, 0)))
                    p = (mesh.Positions[mesh.Target[h]] + mesh.Positions[mesh.Source(h)]) * 0.5;
                mesh.Split(h, p);
            }
            Flip(level, 2, FlipRule.Quality);
            if (order.Length == 0)
                break;
        }
        return splits;
    }

    /// <summary>Collapses edges below a length, shortest first, where no edge gets too long; the number of collapses.</summary>
    private int CollapseShort(double limit, double maxLength, in GuardLevel level)
    {
        int collapses = 0;
        foreach (int e in faceCount.Sorted(mesh.LengthSquared, limit * limit))
        {
            cancellationToken.ThrowIfCancellationRequested();
            // Collapses before this one may have moved its ends apart.
            if (mesh.IsLiveEdge(e) && mesh.LengthSquared(e) < limit * limit && faceCount.TryCollapse(e, level, keepsPenalty: false, maxLength))
                collapses++;
        }
        return collapses;
    }
}
