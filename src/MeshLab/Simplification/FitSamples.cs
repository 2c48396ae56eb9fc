using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>What the samples on one face of the result add up to. With residuals along the face's normal, r = n·(s − c), and weights b of the closest
/// point c at the corners: Σ w b bᵀ, Σ w r b, Σ w d² and the largest d².</summary>
internal struct FaceSums
{
    public double M00;
    public double M01;
    public double M02;
    public double M11;
    public double M12;
    public double M22;
    public double G0;
    public double G1;
    public double G2;
    public double Energy;
    public double Largest;

    public void Add(double weight, double residual, double distanceSquared, Vector3D b)
    {
        double wx = weight * b.X, wy = weight * b.Y, wr = weight * residual;
        Energy += weight * distanceSquared;
        Largest = Math.Max(Largest, distanceSquared);
        M00 += wx * b.X;
        M01 += wx * b.Y;
        M02 += wx * b.Z;
        M11 += wy * b.Y;
        M12 += wy * b.Z;
        M22 += weight * b.Z * b.Z;
        G0 += wr * b.X;
        G1 += wr * b.Y;
        G2 += wr * b.Z;
    }
}

/// <summary>Samples of the original surface: its vertices, each with a twelfth of the area around, and its face centroids, each with three quarters of the
/// face's area. Each follows the nearest face of the result from sweep to sweep.</summary>
internal sealed class FitSamples
{
    private const double VertexShare = 1 / 12.0;
    private const double CentroidShare = 0.75;

    /// <summary>A sample whose squared distance is more than this many times the mean is looked up in a tree: the walk may have ended in a dead end.</summary>
    private const double Outlier = 9;
    private const int MaxOutlierRounds = 32;

    /// <summary>So many samples are projected at once, by all threads, before they are added up in order.</summary>
    private const int ChunkSize = 1 << 12;
    private const int BlockSize = 1 << 9;
    private readonly FitSurface surface;
    private readonly UncheckedArray<Vector3D> vertices;
    private UncheckedArray<int> survivors;
    private readonly int faceCount;
    private readonly UncheckedArray<int> halfEdgeOf;
    private readonly UncheckedArray<int> target;
    private readonly UncheckedArray<int> next;
    private readonly UncheckedArray<int> previous;
    private readonly UncheckedArray<float> vertexWeights;
    private readonly UncheckedArray<float> faceWeights;
    private readonly UncheckedArray<int> nearest;
    private readonly UncheckedArray<int> nearestToCentroid;
    private UncheckedArray<double> distances;
    private UncheckedArray<double> centroidDistances;
    private readonly UncheckedArray<Hit> hits = UncheckedArray<Hit>.Uninitialized(ChunkSize);
    private UncheckedArray<FaceSums>? sums;

    /// <summary>Samples that are not yet located.</summary>
    /// <param name="mesh">The original.</param>
    /// <param name="vertices">Its vertices in working units.</param>
    /// <param name="survivors">Per vertex slot the vertex of the result that it went into; −1 for slots without faces.</param>
    /// <param name="surface">The result.</param>
    public FitSamples(Mesh mesh, UncheckedArray<Vector3D> vertices, int[] survivors, FitSurface surface)
    {
        this.surface = surface;
        this.vertices = vertices;
        this.survivors = survivors;
        (halfEdgeOf, target, next, previous) = (mesh.halfEdgeOf, mesh.target, mesh.next, mesh.previous);
        faceCount = mesh.FaceSlots;
        vertexWeights = new float[vertices.Length];
        faceWeights = UncheckedArray<float>.Uninitialized(faceCount);
        nearest = UncheckedArray<int>.Uninitialized(vertices.Length);
        nearestToCentroid = UncheckedArray<int>.Uninitialized(faceCount);
        Parallelism.ForBlocks(faceCount, MeasureFaces);
        double total = 0;
        for (int f = 0; f < faceCount; f++)
        {
            if (!IsLive(f))
                continue;
            double area = faceWeights[f];
            total += area;
            var (a, b, c) = CornersOf(f);
            vertexWeights[a] += (float)(VertexShare * area);
            vertexWeights[b] += (float)(VertexShare * area);
            vertexWeights[c] += (float)(VertexShare * area);
            faceWeights[f] = (float)(CentroidShare * area);
        }
        TotalWeight = total;
    }

    /// <summary>The area of the original.</summary>
    public double TotalWeight { get; }

    /// <summary>Finds the nearest face of every sample and sums per face, in the order of the samples. Valid until the next call.</summary>
    public UncheckedArray<FaceSums> Project()
    {
        if (sums is null)
            Locate();
        UncheckedArray<FaceSums> perFace = sums ??= new FaceSums[surface.FaceCount];
        Array.Clear(perFace.Items);
        int samples = vertices.Length + faceCount;
        for (int start = 0; start < samples; start += ChunkSize)
        {
            int first = start, count = Math.Min(ChunkSize, samples - start);
            Parallelism.ForBlocks(count, BlockSize, (from, to) =>
            {
                for (int i = from; i < to; i++)
                    hits[i] = ProjectSample(first + i);
            });
            for (int i = 0; i < count; i++)
            {
                ref Hit hit = ref hits[i];
                if (hit.Weight > 0)
                    perFace[hit.Face].Add(hit.Weight, hit.Residual, hit.DistanceSquared, hit.Place);
            }
        }
        return perFace;
    }

    /// <summary>Finds the first faces: by walking from where the sample's vertices went, and for those that end far away by a tree.</summary>
    private void Locate()
    {
        distances = UncheckedArray<double>.Uninitialized(vertices.Length);
        centroidDistances = new double[faceCount];
        Parallelism.ForBlocks(vertices.Length, (first, end) =>
        {
            for (int v = first; v < end; v++)
                LocateVertex(v);
        });
        Parallelism.ForBlocks(faceCount, (first, end) =>
        {
            for (int f = first; f < end; f++)
            {
                if (IsLive(f))
                    LocateCentroid(f);
            }
        });
        LocateOutliers();
        distances = centroidDistances = default;
        survivors = default;
    }

    private void LocateVertex(int v)
    {
        distances[v] = 0;
        if (survivors[v] < 0)
            return;
        double distance = double.MaxValue;
        int face = -1;
        surface.SearchRing(survivors[v], vertices[v], ref distance, ref face);
        distances[v] = surface.Walk(vertices[v], ref face, out _);
        nearest[v] = face;
    }

    private void LocateCentroid(int f)
    {
        var (a, b, c) = CornersOf(f);
        Vector3D sample = Centroid(f);
        int face = FirstFace(sample, a, b, c);
        centroidDistances[f] = surface.Walk(sample, ref face, out _);
        nearestToCentroid[f] = face;
    }

    /// <summary>Once the worst are found, the mean falls, and more stand out; until all that do are exact.</summary>
    private void LocateOutliers()
    {
        FaceTree? tree = null;
        bool[] isExact = new bool[vertices.Length], isCentroidExact = new bool[faceCount];
        for (int round = 0; round < MaxOutlierRounds; round++)
        {
            double limit = Outlier * MeanSquare();
            bool changed = false;
            for (int v = 0; v < vertices.Length; v++)
            {
                if (distances[v] > limit && !isExact[v])
                {
                    isExact[v] = true;
                    changed |= LookUp(tree ??= surface.BuildTree(), vertices[v], ref distances[v], ref nearest[v]);
                }
            }
            for (int f = 0; f < faceCount; f++)
            {
                if (centroidDistances[f] > limit && !isCentroidExact[f])
                {
                    isCentroidExact[f] = true;
                    changed |= LookUp(tree ??= surface.BuildTree(), Centroid(f), ref centroidDistances[f], ref nearestToCentroid[f]);
                }
            }
            if (!changed)
                return;
        }
    }

    private double MeanSquare()
    {
        double sum = 0;
        for (int v = 0; v < vertices.Length; v++)
            sum += vertexWeights[v] * distances[v];
        for (int f = 0; f < faceCount; f++)
            sum += faceWeights[f] * centroidDistances[f];
        return sum / TotalWeight;
    }

    private static bool LookUp(FaceTree tree, Vector3D sample, ref double distance, ref int face)
    {
        ClosestPoint closest = tree.FindClosest(sample, distance);
        if (closest.IsNone || !(closest.DistanceSquared < distance))
            return false;
        distance = closest.DistanceSquared;
        face = closest.Face;
        return true;
    }

    private bool IsLive(int face) => halfEdgeOf[face] >= 0;

    private (int A, int B, int C) CornersOf(int face)
    {
        int h = halfEdgeOf[face];
        return (target[h], target[next[h]], target[previous[h]]);
    }

    private Vector3D Centroid(int face)
    {
        var (a, b, c) = CornersOf(face);
        return (vertices[a] + vertices[b] + vertices[c]) * (1 / 3.0);
    }

    private void MeasureFaces(int first, int end)
    {
        for (int f = first; f < end; f++)
        {
            faceWeights[f] = 0;
            if (!IsLive(f))
                continue;
            var (a, b, c) = CornersOf(f);
            faceWeights[f] = (float)(0.5 * Vector3D.Cross(vertices[b] - vertices[a], vertices[c] - vertices[a]).Length);
        }
    }

    /// <summary>Where a centroid starts: the best of its corners' faces; if that is far compared with its corners, the best around its corners' survivors.</summary>
    private int FirstFace(Vector3D sample, int a, int b, int c)
    {
        int best = nearest[a];
        double distance = surface.DistanceSquared(best, sample, out _);
        Better(nearest[b], sample, ref distance, ref best);
        Better(nearest[c], sample, ref distance, ref best);
        if (distance > 2 * Math.Max(distances[a], Math.Max(distances[b], distances[c])))
        {
            int ra = survivors[a], rb = survivors[b], rc = survivors[c];
            surface.SearchRing(ra, sample, ref distance, ref best);
            if (rb != ra)
                surface.SearchRing(rb, sample, ref distance, ref best);
            if (rc != ra && rc != rb)
                surface.SearchRing(rc, sample, ref distance, ref best);
        }
        return best;
    }

    private void Better(int face, Vector3D sample, ref double distance, ref int best)
    {
        if (face == best)
            return;
        double d = surface.DistanceSquared(face, sample, out _);
        if (d < distance)
            (distance, best) = (d, face);
    }

    /// <summary>Samples are numbered from the vertices on to the centroids. Those without weight are not looked at.</summary>
    private Hit ProjectSample(int sample)
    {
        if (sample < vertices.Length)
            return vertexWeights[sample] > 0 ? Project(vertices[sample], ref nearest[sample], vertexWeights[sample]) : default;
        int f = sample - vertices.Length;
        return faceWeights[f] > 0 ? Project(Centroid(f), ref nearestToCentroid[f], faceWeights[f]) : default;
    }

    private Hit Project(Vector3D sample, ref int face, double weight)
    {
        double d = surface.Walk(sample, ref face, out Vector3D b);
        var (i, j, k) = surface.Corners[face];
        Vector3D closest = surface.Positions[i] * b.X + surface.Positions[j] * b.Y + surface.Positions[k] * b.Z;
        return new Hit(face, weight, Vector3D.Dot(sample - closest, surface.Normals[face]), d, b);
    }

    /// <summary>Where a sample's closest point lies: the face and the weights at its corners.</summary>
    private readonly record struct Hit(int Face, double Weight, double Residual, double DistanceSquared, Vector3D Place);
}
