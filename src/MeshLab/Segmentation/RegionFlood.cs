using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>The regions of a variational approximation while they are found: labels, proxies, seeds.</summary>
internal sealed class RegionFlood
{
    private readonly Mesh mesh;
    private readonly int[][] neighbors;
    private PlanarProxy[] proxies = [];
    private int[] seeds = [];

    public RegionFlood(Mesh mesh)
    {
        this.mesh = mesh;
        Geometry = new FaceGeometry(mesh);
        Labels = new int[mesh.FaceSlots];
        Array.Fill(Labels, -1);
        neighbors = new int[mesh.FaceSlots][];
        foreach (int f in Geometry.Live)
            neighbors[f] = [.. mesh.Faces[f].Neighbors.Select(g => g.Index)];
    }

    public FaceGeometry Geometry { get; }

    public int[] Labels { get; private set; }

    public int Count => seeds.Length;

    /// <summary>What <see cref="Restore"/> brings back.</summary>
    public sealed record State(int[] Labels, PlanarProxy[] Proxies, int[] Seeds);

    public State Save() => new([.. Labels], [.. proxies], [.. seeds]);

    public void Restore(State state) => (Labels, proxies, seeds) = (state.Labels, state.Proxies, state.Seeds);

    public int[] FirstFaceOfEachComponent()
    {
        var one = new int[mesh.FaceSlots];
        for (int f = 0; f < one.Length; f++)
            one[f] = mesh.IsDeletedFace(f) ? -1 : 0;
        int[] piece = Relabeling.Pieces(mesh, one, out int count);
        var first = new int[count];
        for (int f = piece.Length - 1; f >= 0; f--)
        {
            if (piece[f] >= 0)
                first[piece[f]] = f;
        }
        return first;
    }

    /// <summary>One region per face given.</summary>
    public void Begin(int[] faces)
    {
        seeds = [.. faces];
        proxies = Array.ConvertAll(seeds, f => new PlanarProxy(Geometry.Centers[f], Geometry.Normals[f]));
        Flood();
        Fit();
    }

    /// <summary>Divides the region with the largest error: one part begins at its worst face, the other at the face that disagrees most with that one.</summary>
    public void AddAtWorstFace()
    {
        var errors = new double[Count];
        foreach (int f in Geometry.Live)
            errors[Labels[f]] += ErrorOf(f, proxies[Labels[f]]);
        var order = new int[Count];
        for (int r = 0; r < order.Length; r++)
            order[r] = r;
        Array.Sort(order, (a, b) => errors[a] != errors[b] ? errors[b].CompareTo(errors[a]) : a.CompareTo(b));
        int worst = -1, region = -1;
        for (int i = 0; worst < 0; i++)
        {
            region = order[i];
            worst = MostDifferent(region, proxies[region].Normal, seeds[region]);
        }
        int opposite = MostDifferent(region, Geometry.Normals[worst], worst);
        seeds = [.. seeds, worst];
        proxies = [.. proxies, new PlanarProxy(Geometry.Centers[worst], Geometry.Normals[worst])];
        seeds[region] = opposite;
        proxies[region] = new PlanarProxy(Geometry.Centers[opposite], Geometry.Normals[opposite]);
    }

    /// <summary>The face of a region whose normal differs most from a direction, area aside, other than one face; −1 if there is none.</summary>
    private int MostDifferent(int region, Vector3D normal, int except)
    {
        int worst = -1;
        double largest = double.NegativeInfinity;
        foreach (int f in Geometry.Live)
        {
            if (Labels[f] != region || f == except)
                continue;
            // A face without area disagrees with nothing.
            double error = Geometry.Areas[f] > 0 ? (Geometry.Normals[f] - normal).LengthSquared : -1;
            if (error > largest)
                (worst, largest) = (f, error);
        }
        return worst;
    }

    /// <summary>Grows all regions at once from their seeds, the face with the least error first; ties by face, then region.</summary>
    public void Flood()
    {
        Array.Fill(Labels, -1);
        var queue = new PriorityQueue<(int Face, int Region), (double, int, int)>();
        for (int region = 0; region < seeds.Length; region++)
        {
            Labels[seeds[region]] = region;
            Offer(queue, seeds[region], region);
        }
        while (queue.TryDequeue(out var next, out _))
        {
            if (Labels[next.Face] >= 0)
                continue;
            Labels[next.Face] = next.Region;
            Offer(queue, next.Face, next.Region);
        }
    }

    private void Offer(PriorityQueue<(int Face, int Region), (double, int, int)> queue, int f, int region)
    {
        foreach (int g in neighbors[f])
        {
            if (Labels[g] < 0)
                queue.Enqueue((g, region), (ErrorOf(g, proxies[region]), g, region));
        }
    }

    /// <summary>Fits every proxy to its region and moves the seed to the region's face with the least error.</summary>
    public void Fit()
    {
        proxies = FitProxies(Labels, Count);
        var least = new double[Count];
        Array.Fill(least, double.PositiveInfinity);
        foreach (int f in Geometry.Live)
        {
            int region = Labels[f];
            double error = (Geometry.Normals[f] - proxies[region].Normal).LengthSquared;
            if (error < least[region])
            {
                least[region] = error;
                seeds[region] = f;
            }
        }
    }

    public PlanarProxy[] FitProxies(int[] labels, int count)
    {
        var normal = new Vector3D[count];
        var center = new Vector3D[count];
        var area = new double[count];
        foreach (int f in Geometry.Live)
        {
            int region = labels[f];
            normal[region] += Geometry.Normals[f] * Geometry.Areas[f];
            center[region] += Geometry.Centers[f] * Geometry.Areas[f];
            area[region] += Geometry.Areas[f];
        }
        var fitted = new PlanarProxy[count];
        for (int r = 0; r < count; r++)
            fitted[r] = new(area[r] > 0 ? center[r] / area[r] : center[r], normal[r].Normalized());
        return fitted;
    }

    public double Error() => Error(Labels, proxies);

    public double Error(int[] labels, PlanarProxy[] of)
    {
        double sum = 0;
        foreach (int f in Geometry.Live)
            sum += ErrorOf(f, of[labels[f]]);
        return sum;
    }

    /// <summary>Merges the two neighbouring regions whose common proxy has the least error more than their own two; whether there were any.</summary>
    public bool MergeCheapestNeighbors()
    {
        var own = new double[Count];
        var vector = new Vector3D[Count];
        var area = new double[Count];
        foreach (int f in Geometry.Live)
        {
            own[Labels[f]] += ErrorOf(f, proxies[Labels[f]]);
            vector[Labels[f]] += Geometry.Normals[f] * Geometry.Areas[f];
            area[Labels[f]] += Geometry.Areas[f];
        }
        (int A, int B) best = (-1, -1);
        double least = double.PositiveInfinity;
        var seen = new HashSet<(int, int)>();
        foreach (int f in Geometry.Live)
        {
            foreach (int g in neighbors[f])
            {
                (int a, int b) = Labels[f] < Labels[g] ? (Labels[f], Labels[g]) : (Labels[g], Labels[f]);
                if (a == b || !seen.Add((a, b)))
                    continue;
                // Σ area·|n − N|² = Σ area·(1 + 1) − 2·|Σ area·n| for the best N.
                double merged = 2 * (area[a] + area[b]) - 2 * (vector[a] + vector[b]).Length;
                double loss = merged - own[a] - own[b];
                if (loss < least)
                    (best, least) = ((a, b), loss);
            }
        }
        if (best.A < 0)
            return false;
        RemoveRegion(best.B, best.A);
        return true;
    }

    private void RemoveRegion(int gone, int into)
    {
        int last = Count - 1;
        for (int f = 0; f < Labels.Length; f++)
        {
            if (Labels[f] == gone)
                Labels[f] = into;
            if (Labels[f] == last && last != gone)
                Labels[f] = gone;
        }
        if (gone != last)
            seeds[gone] = seeds[last];
        seeds = seeds[..last];
        Fit();
    }

    private double ErrorOf(int f, in PlanarProxy proxy) => Geometry.Areas[f] * (Geometry.Normals[f] - proxy.Normal).LengthSquared;
}
