using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>How K-means runs.</summary>
public sealed record KMeansOptions
{
    /// <summary>Faces at which clusters begin; if given, there are as many clusters.</summary>
    public IReadOnlyList<int> Seeds { get; init; } = [];

    /// <summary>How seeds are found if none are given.</summary>
    public SeedingMethod Seeding { get; init; } = SeedingMethod.FarthestPoint;

    /// <summary>Seed of the random numbers of <see cref="SeedingMethod.PlusPlus"/>.</summary>
    public int RandomSeed { get; init; } = 1;

    /// <summary>Weight of the normals beside the places, 0 for places only: places are measured in box diagonals.</summary>
    public double NormalWeight
    {
        get;
        init => field = value >= 0 && double.IsFinite(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A weight is 0 or more.");
    }

    /// <summary>The most rounds.</summary>
    public int MaxRounds
    {
        get;
        init => field = value >= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is at least one round.");
    } = 200;

    /// <summary>Whether every cluster is made connected at the end: stray pieces go to the neighbour with the longest common border.</summary>
    public bool Connect { get; init; }
}

/// <summary>§13.3 K-均值: Lloyd's algorithm on the barycentres of the faces, weighted by area (Lloyd 1982).</summary>
/// <remarks>
/// Objective: Σ area·(|b − c|²/D² + w²|n − m|²) with b, n the face's barycentre and normal, c, m those of its cluster, D the diagonal of the box. Neither half of a
/// round can raise it: each face goes to its nearest cluster (the lowest on a tie), each cluster to the mean of its faces. A cluster that has lost all its
/// faces begins again at the face that is farthest from its own. O(rounds · F · K), in parallel, the same bits on every number of threads.
/// </remarks>
public static class KMeans
{
    private const int Block = 4096;

    /// <summary>Clusters the faces.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="clusters">How many clusters; ignored if seeds are given.</param>
    /// <param name="options">Seeds, weights, limits.</param>
    /// <param name="progress">Told the part of the rounds that is done.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="ArgumentException">There are more clusters than faces, or a seed is no live face or given twice.</exception>
    public static FaceSegmentation Segment(
        Mesh mesh, int clusters, KMeansOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        options ??= new KMeansOptions();
        var geometry = new FaceGeometry(mesh);
        if (options.Seeds.Count > 0)
            clusters = options.Seeds.Count;
        ArgumentOutOfRangeException.ThrowIfLessThan(clusters, 1);
        if (clusters > geometry.Live.Length)
            throw new ArgumentException($"{clusters} clusters cannot be made of {geometry.Live.Length} faces.", nameof(clusters));

        var space = new FeatureSpace(mesh, geometry, options.NormalWeight);
        int[] seeds = options.Seeds.Count > 0 ? CheckSeeds(mesh, options.Seeds) : ChooseSeeds(space, clusters, options);
        Feature[] centers = Array.ConvertAll(seeds, space.Of);
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        var history = new List<double>();
        SegmentationStop stop = SegmentationStop.RoundLimit;
        while (history.Count < options.MaxRounds)
        {
            cancellationToken.ThrowIfCancellationRequested();
            bool changed = Assign(space, centers, labels);
            bool reseeded = Reseed(space, centers, labels);
            MoveCenters(space, centers, labels);
            history.Add(Objective(space, centers, labels));
            progress?.Report((double)history.Count / options.MaxRounds);
            if (!changed && !reseeded)
            {
                stop = SegmentationStop.Converged;
                break;
            }
        }
        progress?.Report(1);
        double objective = history[^1];
        if (options.Connect)
        {
            Relabeling.JoinStrayPieces(mesh, labels, geometry.Areas);
            Feature[] moved = [.. centers];
            MoveCenters(space, moved, labels);
            objective = Objective(space, moved, labels);
        }
        int count = options.Connect ? Relabeling.Compact(labels) : clusters;
        return new FaceSegmentation(labels, count, objective, history.Count, stop) { History = history };
    }

    private static int[] CheckSeeds(Mesh mesh, IReadOnlyList<int> seeds)
    {
        var seen = new HashSet<int>();
        foreach (int f in seeds)
        {
            if (f < 0 || f >= mesh.FaceSlots || mesh.IsDeletedFace(f))
                throw new ArgumentException($"The seed {f} is no live face.", nameof(seeds));
            if (!seen.Add(f))
                throw new ArgumentException($"The seed {f} is given twice.", nameof(seeds));
        }
        return [.. seeds];
    }

    /// <summary>The first seed is the face farthest from the mean, the others as the method says.</summary>
    private static int[] ChooseSeeds(FeatureSpace space, int clusters, KMeansOptions options)
    {
        int[] live = space.Live;
        var random = new Random(options.RandomSeed);
        var nearest = new double[live.Length];
        Array.Fill(nearest, double.PositiveInfinity);
        var taken = new bool[live.Length];
        var seeds = new int[clusters];
        int next = options.Seeding == SeedingMethod.PlusPlus ? Draw(random, live.Length, i => space.Areas[live[i]], taken) : Farthest(space, space.Mean());
        for (int k = 0; k < clusters; k++)
        {
            seeds[k] = live[next];
            taken[next] = true;
            Feature center = space.Of(live[next]);
            for (int i = 0; i < live.Length; i++)
                nearest[i] = Math.Min(nearest[i], space.Distance(live[i], center));
            if (k + 1 < clusters)
                next = options.Seeding == SeedingMethod.PlusPlus ? Draw(random, live.Length, i => space.Areas[live[i]] * nearest[i], taken) : Largest(nearest, taken);
        }
        return seeds;
    }

    private static int Farthest(FeatureSpace space, Feature center)
    {
        int best = 0;
        for (int i = 1; i < space.Live.Length; i++)
        {
            if (space.Distance(space.Live[i], center) > space.Distance(space.Live[best], center))
                best = i;
        }
        return best;
    }

    private static int Largest(double[] values, bool[] taken)
    {
        int best = -1;
        for (int i = 0; i < values.Length; i++)
        {
            if (!taken[i] && (best < 0 || values[i] > values[best]))
                best = i;
        }
        return best;
    }

    private static int Draw(Random random, int count, Func<int, double> weight, bool[] taken)
    {
        double total = 0;
        for (int i = 0; i < count; i++)
            total += taken[i] ? 0 : weight(i);
        double aim = random.NextDouble() * total;
        for (int i = 0; i < count; i++)
        {
            if (taken[i])
                continue;
            aim -= weight(i);
            if (aim < 0)
                return i;
        }
        return Array.IndexOf(taken, false);
    }

    private static bool Assign(FeatureSpace space, Feature[] centers, int[] labels)
    {
        int changes = 0;
        Parallelism.ForBlocks(space.Live.Length, Block, (first, end) =>
        {
            int changed = 0;
            for (int i = first; i < end; i++)
            {
                int f = space.Live[i], best = 0;
                double least = space.Distance(f, centers[0]);
                for (int k = 1; k < centers.Length; k++)
                {
                    double d = space.Distance(f, centers[k]);
                    if (d < least)
                        (best, least) = (k, d);
                }
                if (labels[f] == best)
                    continue;
                labels[f] = best;
                changed++;
            }
            Interlocked.Add(ref changes, changed);
        });
        return changes > 0;
    }

    /// <summary>An empty cluster takes the face that is farthest from the centre of its own, out of a cluster that can spare one.</summary>
    private static bool Reseed(FeatureSpace space, Feature[] centers, int[] labels)
    {
        var size = new int[centers.Length];
        foreach (int f in space.Live)
            size[labels[f]]++;
        bool reseeded = false;
        for (int k = 0; k < centers.Length; k++)
        {
            if (size[k] > 0)
                continue;
            int farthest = -1;
            foreach (int f in space.Live)
            {
                if (size[labels[f]] > 1 && (farthest < 0 || space.Distance(f, centers[labels[f]]) > space.Distance(farthest, centers[labels[farthest]])))
                    farthest = f;
            }
            size[labels[farthest]]--;
            labels[farthest] = k;
            size[k] = 1;
            centers[k] = space.Of(farthest);
            reseeded = true;
        }
        return reseeded;
    }

    private static void MoveCenters(FeatureSpace space, Feature[] centers, int[] labels)
    {
        var sums = new Feature[centers.Length];
        var weights = new double[centers.Length];
        foreach (int f in space.Live)
        {
            Feature feature = space.Of(f);
            double area = space.Areas[f];
            ref Feature sum = ref sums[labels[f]];
            sum = new(sum.Place + feature.Place * area, sum.Normal + feature.Normal * area);
            weights[labels[f]] += area;
        }
        for (int k = 0; k < centers.Length; k++)
        {
            // A cluster of faces without area stays where it is.
            if (weights[k] > 0)
                centers[k] = new(sums[k].Place / weights[k], sums[k].Normal / weights[k]);
        }
    }

    private static double Objective(FeatureSpace space, Feature[] centers, int[] labels) => Parallelism.SumBlocks(space.Live.Length, Block, (first, end) =>
    {
        double sum = 0;
        for (int i = first; i < end; i++)
        {
            int f = space.Live[i];
            sum += space.Areas[f] * space.Distance(f, centers[labels[f]]);
        }
        return sum;
    });

    private readonly record struct Feature(Vector3D Place, Vector3D Normal);

    /// <summary>Faces as points: the barycentre in box diagonals from the box's centre, and the normal times its weight.</summary>
    private sealed class FeatureSpace
    {
        private readonly Vector3D[] places;
        private readonly Vector3D[] normals;

        public FeatureSpace(Mesh mesh, FaceGeometry geometry, double normalWeight)
        {
            BoundingBox box = mesh.BoundingBox;
            double scale = box.Diagonal > 0 ? 1 / box.Diagonal : 1;
            places = Array.ConvertAll(geometry.Centers, c => (c - box.Center) * scale);
            normals = Array.ConvertAll(geometry.Normals, n => n * normalWeight);
            Live = geometry.Live;
            Areas = geometry.Areas;
        }

        public int[] Live { get; }

        public double[] Areas { get; }

        public Feature Of(int f) => new(places[f], normals[f]);

        public double Distance(int f, in Feature center) => (places[f] - center.Place).LengthSquared + (normals[f] - center.Normal).LengthSquared;

        public Feature Mean()
        {
            Vector3D place = default, normal = default;
            double area = 0;
            foreach (int f in Live)
            {
                place += places[f] * Areas[f];
                normal += normals[f] * Areas[f];
                area += Areas[f];
            }
            return area > 0 ? new(place / area, normal / area) : new(places[Live[0]], normals[Live[0]]);
        }
    }
}
