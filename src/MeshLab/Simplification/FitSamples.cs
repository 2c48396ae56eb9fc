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

    public void Add(ref readonly FaceSums other)
    {
        Energy += other.Energy;
        Largest = Math.Max(Largest, other.Largest);
        M00 += other.M00;
        M01 += other.M01;
        M02 += other.M02;
        M11 += other.M11;
        M12 += other.M12;
        M22 += other.M22;
        G0 += other.G0;
        G1 += other.G1;
        G2 += other.G2;
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
    private readonly FitSurface surface;
    private readonly UncheckedArray<Vector3D> vertices;
    private readonly UncheckedArray<int> survivors;
    private readonly int[] faces;
    private readonly UncheckedArray<(int A, int B, int C)> corners;
    private readonly UncheckedArray<double> vertexWeights;
    private readonly UncheckedArray<double> faceWeights;
    private readonly UncheckedArray<int> nearest;
    private readonly UncheckedArray<int> nearestToCentroid;
    private UncheckedArray<double> distances;
    private UncheckedArray<double> centroidDistances;
    private UncheckedArray<FaceSums>[]? halves;

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
        faces = LiveFaces(mesh);
        corners = UncheckedArray<(int, int, int)>.Uninitialized(faces.Length);
        vertexWeights = new double[vertices.Length];
        faceWeights = UncheckedArray<double>.Uninitialized(faces.Length);
        nearest = UncheckedArray<int>.Uninitialized(vertices.Length);
        nearestToCentroid = UncheckedArray<int>.Uninitialized(faces.Length);
        Parallelism.ForBlocks(faces.Length, (first, end) => MeasureFaces(mesh, first, end));
        double total = 0;
        for (int i = 0; i < faces.Length; i++)
        {
            double area = faceWeights[i];
            total += area;
            var (a, b, c) = corners[i];
            vertexWeights[a] += VertexShare * area;
            vertexWeights[b] += VertexShare * area;
            vertexWeights[c] += VertexShare * area;
            faceWeights[i] = CentroidShare * area;
        }
        TotalWeight = total;
    }

    /// <summary>The area of the original.</summary>
    public double TotalWeight { get; }

    /// <summary>Finds the nearest face of every sample and sums per face. In two fixed halves, so that two threads can share the work.</summary>
    public UncheckedArray<FaceSums> Project()
    {
        if (halves is null)
            Locate();
        // What is summed up is done with when the next sweep begins.
        halves ??= [new FaceSums[surface.FaceCount], new FaceSums[surface.FaceCount]];
        foreach (UncheckedArray<FaceSums> half in halves)
            Array.Clear(half.Items);
        int halfVertices = vertices.Length / 2, halfFaces = faces.Length / 2;
        Parallelism.Invoke(
            () => AddSamples(0, halfVertices, 0, halfFaces, halves[0]),
            () => AddSamples(halfVertices, vertices.Length, halfFaces, faces.Length, halves[1]));
        UncheckedArray<FaceSums> sums = halves[0];
        for (int f = 0; f < sums.Length; f++)
            sums[f].Add(in halves[1][f]);
        return sums;
    }

    /// <summary>Finds the first faces: by walking from where the sample's vertices went, and for those that end far away by a tree.</summary>
    private void Locate()
    {
        distances = UncheckedArray<double>.Uninitialized(vertices.Length);
        centroidDistances = UncheckedArray<double>.Uninitialized(faces.Length);
        Parallelism.ForBlocks(vertices.Length, (first, end) =>
        {
            for (int v = first; v < end; v++)
                LocateVertex(v);
        });
        Parallelism.ForBlocks(faces.Length, (first, end) =>
        {
            for (int i = first; i < end; i++)
                LocateCentroid(i);
        });
        LocateOutliers();
        distances = centroidDistances = default;
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

    private void LocateCentroid(int i)
    {
        var (a, b, c) = corners[i];
        Vector3D sample = Centroid(i);
        int face = FirstFace(sample, a, b, c);
        centroidDistances[i] = surface.Walk(sample, ref face, out _);
        nearestToCentroid[i] = face;
    }

    /// <summary>Once the worst are found, the mean falls, and more stand out; until all that do are exact.</summary>
    private void LocateOutliers()
    {
        FaceTree? tree = null;
        bool[] isExact = new bool[vertices.Length], isCentroidExact = new bool[faces.Length];
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
            for (int i = 0; i < faces.Length; i++)
            {
                if (centroidDistances[i] > limit && !isCentroidExact[i])
                {
                    isCentroidExact[i] = true;
                    changed |= LookUp(tree ??= surface.BuildTree(), Centroid(i), ref centroidDistances[i], ref nearestToCentroid[i]);
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
        for (int i = 0; i < faces.Length; i++)
            sum += faceWeights[i] * centroidDistances[i];
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

    private Vector3D Centroid(int i)
    {
        var (a, b, c) = corners[i];
        return (vertices[a] + vertices[b] + vertices[c]) * (1 / 3.0);
    }

    private void AddSamples(int firstVertex, int endVertex, int firstFace, int endFace, UncheckedArray<FaceSums> sums)
    {
        for (int v = firstVertex; v < endVertex; v++)
        {
            if (survivors[v] >= 0)
                Add(vertices[v], ref nearest[v], vertexWeights[v], sums);
        }
        for (int i = firstFace; i < endFace; i++)
            Add(Centroid(i), ref nearestToCentroid[i], faceWeights[i], sums);
    }

    private static int[] LiveFaces(Mesh mesh)
    {
        int[] live = GC.AllocateUninitializedArray<int>(mesh.Faces.Count);
        int count = 0;
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            if (!mesh.IsDeletedFace(f))
                live[count++] = f;
        }
        return live;
    }

    private void MeasureFaces(Mesh mesh, int first, int end)
    {
        ReadOnlySpan<int> target = mesh.Target, next = mesh.Next, previous = mesh.Previous, halfEdgeOf = mesh.HalfEdgeOf;
        for (int i = first; i < end; i++)
        {
            int h = halfEdgeOf[faces[i]];
            int a = target[h], b = target[next[h]], c = target[previous[h]];
            corners[i] = (a, b, c);
            faceWeights[i] = 0.5 * Vector3D.Cross(vertices[b] - vertices[a], vertices[c] - vertices[a]).Length;
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

    private void Add(Vector3D sample, ref int face, double weight, UncheckedArray<FaceSums> sums)
    {
        double d = surface.Walk(sample, ref face, out Vector3D b);
        var (i, j, k) = surface.Corners[face];
        Vector3D closest = surface.Positions[i] * b.X + surface.Positions[j] * b.Y + surface.Positions[k] * b.Z;
        sums[face].Add(weight, Vector3D.Dot(sample - closest, surface.Normals[face]), d, b);
    }
}
