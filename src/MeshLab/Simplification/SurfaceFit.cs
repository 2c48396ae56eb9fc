using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>The end of accurate mode: moves the vertices of the result so that samples of the original lie closer to it, in the least-squares sense.
/// Every move is guarded, and taken back where it would make something worse.</summary>
/// <remarks>
/// Three sweeps of: project the samples; take back the moves of the sweep before at vertices whose star got worse; solve for displacements along the normals;
/// shorten them to a quarter of the shortest edge around; take back what turns a face by more than acos 0.8 or shrinks it below a tenth. At the end no vertex
/// is farther from the original than before, unless by less than five times the root mean square distance. Vertices on borders, features and seams stay.
/// </remarks>
internal sealed class SurfaceFit
{
    private const int Sweeps = 3;
    private const double LargestMove = 0.25;
    private const double LeastTurnCosine = 0.8;
    private const double LeastAreaSquared = 0.01;
    private const double LocalPeakFloor = 0.25;
    private const double ReverseFactor = 5;
    private const double ExactRms = 1e-7;
    private readonly FitSurface surface;
    private readonly FitSamples samples;
    private readonly OriginalDistance original;
    private readonly UncheckedArray<bool> isFixed;

    private SurfaceFit(FitSurface surface, FitSamples samples, OriginalDistance original, UncheckedArray<bool> isFixed)
    {
        this.surface = surface;
        this.samples = samples;
        this.original = original;
        this.isFixed = isFixed;
    }

    /// <summary>Fits the result's positions to the original.</summary>
    /// <param name="mesh">The original.</param>
    /// <param name="working">The working mesh, whose contractions were tracked.</param>
    /// <param name="result">What is left of it.</param>
    /// <param name="cancellationToken">Ends the work.</param>
    public static void Run(Mesh mesh, WorkingMesh working, CompactResult result, CancellationToken cancellationToken)
    {
        int[] survivors = working.Survivors();
        // The result has its own positions: the room of the working mesh's serves for the original's.
        UncheckedArray<Vector3D> vertices = working.Positions;
        var originals = new int[result.Positions.Length];
        var isFixed = new bool[result.Positions.Length];
        for (int v = 0; v < survivors.Length; v++)
        {
            vertices[v] = working.Normalized(mesh.Positions[v]);
            int to = result.Maps.Vertices[v];
            if (to >= 0)
            {
                originals[to] = v;
                isFixed[to] = result.Outgoing[to] < 0 || result.Face[result.Outgoing[to]] < 0 || (working.Constraints is { } c && !c.IsFree(v));
            }
            survivors[v] = mesh.Outgoing[v] < 0 ? -1 : survivors[v];
        }
        for (int v = 0; v < survivors.Length; v++)
            survivors[v] = survivors[v] < 0 ? -1 : result.Maps.Vertices[survivors[v]];
        var surface = new FitSurface(result);
        var samples = new FitSamples(mesh, vertices, survivors, surface);
        Vector3D[] start = [.. result.Positions];
        new SurfaceFit(surface, samples, new OriginalDistance(mesh, vertices, originals), isFixed).Run(start, cancellationToken);
        for (int v = 0; v < start.Length; v++)
        {
            if (result.Positions[v] != start[v])
                result.Origins[v] = -1;
        }
    }

    private void Run(Vector3D[] start, CancellationToken cancellationToken)
    {
        Vector3D[] before = [.. start];
        FitSystem? system = null;
        StarErrors? errors = null;
        for (int sweep = 0; ; sweep++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            surface.UpdateNormals();
            UncheckedArray<FaceSums> sums = samples.Project();
            var current = new StarErrors(surface, sums);
            double meanSquare = current.Total / samples.TotalWeight;
            if (errors is null && !(meanSquare > ExactRms * ExactRms))
                return;
            if (errors is not null)
                TakeBackWhatGotWorse(errors, current, before);
            if (sweep == Sweeps)
            {
                TakeBackWhatLeftTheOriginal(start, ReverseFactor * ReverseFactor * meanSquare);
                return;
            }
            errors = current;
            surface.Positions.Items.CopyTo(before);
            system ??= new FitSystem(surface, isFixed);
            Move(system.Solve(sums), before);
        }
    }

    private void Move(UncheckedArray<Vector3D> displacement, Vector3D[] before)
    {
        Parallelism.ForBlocks(surface.VertexCount, (first, end) =>
        {
            for (int v = first; v < end; v++)
            {
                double squared = displacement[v].LengthSquared;
                if (squared == 0)
                    continue;
                double shortest = double.MaxValue;
                int start = surface.Outgoing[v], g = start;
                do
                {
                    shortest = Math.Min(shortest, Vector3D.DistanceSquared(before[surface.Target[g]], before[v]));
                    g = surface.Next[g ^ 1];
                }
                while (g != start);
                double limit = LargestMove * LargestMove * shortest;
                surface.Positions[v] = before[v] + displacement[v] * (squared > limit ? Math.Sqrt(limit / squared) : 1);
            }
        });
        TakeBackTurnedFaces(before);
    }

    private void TakeBackWhatGotWorse(StarErrors before, StarErrors after, Vector3D[] positions)
    {
        double peak = 0;
        for (int v = 0; v < surface.VertexCount; v++)
            peak = Math.Max(peak, before.Largest[v]);
        bool any = false;
        for (int v = 0; v < surface.VertexCount; v++)
        {
            if (after.Energy[v] <= before.Energy[v] && after.Largest[v] <= Math.Max(before.Largest[v], LocalPeakFloor * peak))
                continue;
            surface.Positions[v] = positions[v];
            any = true;
        }
        if (any)
            TakeBackTurnedFaces(positions);
    }

    private void TakeBackWhatLeftTheOriginal(Vector3D[] start, double tolerated)
    {
        double[] before = original.DistancesSquared(start);
        double[] after = original.DistancesSquared(surface.Positions);
        bool any = false;
        for (int v = 0; v < surface.VertexCount; v++)
        {
            if (surface.Positions[v] == start[v] || after[v] <= before[v] || after[v] <= tolerated)
                continue;
            surface.Positions[v] = start[v];
            any = true;
        }
        if (any)
            TakeBackTurnedFaces(start);
    }

    /// <summary>Puts the corners of faces that turned too far or shrank too much back, and looks again at the faces around them.</summary>
    private void TakeBackTurnedFaces(Vector3D[] before)
    {
        var waiting = new Queue<int>();
        for (int face = 0; face < surface.FaceCount; face++)
        {
            waiting.Enqueue(face);
            while (waiting.TryDequeue(out int f))
            {
                if (IsSound(f, before))
                    continue;
                var (a, b, c) = surface.Corners[f];
                PutBack(a, before, waiting);
                PutBack(b, before, waiting);
                PutBack(c, before, waiting);
            }
        }
    }

    private bool IsSound(int face, Vector3D[] before)
    {
        var (a, b, c) = surface.Corners[face];
        Vector3D old = Vector3D.Cross(before[b] - before[a], before[c] - before[a]), now = surface.DoubledArea(face);
        double cosine = Vector3D.Dot(old, now), oldSquared = old.LengthSquared, nowSquared = now.LengthSquared;
        return cosine > 0 && cosine * cosine >= LeastTurnCosine * LeastTurnCosine * oldSquared * nowSquared && nowSquared > LeastAreaSquared * oldSquared;
    }

    private void PutBack(int vertex, Vector3D[] before, Queue<int> waiting)
    {
        if (surface.Positions[vertex] == before[vertex])
            return;
        surface.Positions[vertex] = before[vertex];
        int start = surface.Outgoing[vertex], g = start;
        do
        {
            if (surface.Face[g] >= 0)
                waiting.Enqueue(surface.Face[g]);
            g = surface.Next[g ^ 1];
        }
        while (g != start);
    }

    /// <summary>Per vertex, the summed and the largest squared distance of the samples on its faces.</summary>
    private sealed class StarErrors
    {
        public StarErrors(FitSurface surface, UncheckedArray<FaceSums> sums)
        {
            Energy = new double[surface.VertexCount];
            Largest = new double[surface.VertexCount];
            for (int f = 0; f < surface.FaceCount; f++)
            {
                ref FaceSums s = ref sums[f];
                Total += s.Energy;
                var (a, b, c) = surface.Corners[f];
                Add(a, in s);
                Add(b, in s);
                Add(c, in s);
            }
        }

        public UncheckedArray<double> Energy { get; }

        public UncheckedArray<double> Largest { get; }

        public double Total { get; }

        private void Add(int v, ref readonly FaceSums s)
        {
            Energy[v] += s.Energy;
            Largest[v] = Math.Max(Largest[v], s.Largest);
        }
    }
}

/// <summary>About how far the result's vertices are from the original: by walking down from the original vertex that each grew from.</summary>
/// <param name="mesh">The original.</param>
/// <param name="vertices">Its vertices in working units.</param>
/// <param name="originals">Per vertex of the result, the original vertex to start at.</param>
internal sealed class OriginalDistance(Mesh mesh, UncheckedArray<Vector3D> vertices, int[] originals)
{
    private const int MaxSteps = 64;

    public double[] DistancesSquared(UncheckedArray<Vector3D> positions)
    {
        var distances = new double[positions.Length];
        Parallelism.ForBlocks(positions.Length, (first, end) =>
        {
            for (int v = first; v < end; v++)
                distances[v] = mesh.Outgoing[originals[v]] < 0 ? 0 : DistanceSquared(positions[v], originals[v]);
        });
        return distances;
    }

    private double DistanceSquared(Vector3D point, int vertex)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, face = mesh.FaceOf, outgoing = mesh.Outgoing;
        double distance = Vector3D.DistanceSquared(vertices[vertex], point);
        for (int step = 0; step < MaxSteps; step++)
        {
            int best = vertex, first = outgoing[vertex], g = first;
            do
            {
                double d = Vector3D.DistanceSquared(vertices[target[g]], point);
                if (d < distance)
                    (distance, best) = (d, target[g]);
                g = next[g ^ 1];
            }
            while (g != first);
            if (best == vertex)
                break;
            vertex = best;
        }
        int start = outgoing[vertex], h = start;
        do
        {
            if (face[h] >= 0)
            {
                double d = PointOnTriangle.Closest(point, vertices[vertex], vertices[target[h]], vertices[target[next[h]]], out _);
                distance = Math.Min(distance, d);
            }
            h = next[h ^ 1];
        }
        while (h != start);
        return distance;
    }
}
