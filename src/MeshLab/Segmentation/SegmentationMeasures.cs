using MeshLab.Geodesics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>§13 How much two segmentations of the same mesh agree.</summary>
public static class SegmentationMeasures
{
    /// <summary>Rand index (Rand 1971): the part of the pairs of faces on which the two agree that they belong together or apart. 1 for equal ones. O(F).</summary>
    /// <param name="first">Labels; entries below 0 in either are left out.</param>
    /// <param name="second">Labels, as many.</param>
    /// <exception cref="ArgumentException">The lengths differ.</exception>
    public static double RandIndex(IReadOnlyList<int> first, IReadOnlyList<int> second)
    {
        (double both, double inFirst, double inSecond, double all) = PairCounts(first, second);
        return all == 0 ? 1 : (all + 2 * both - inFirst - inSecond) / all;
    }

    /// <summary>Adjusted Rand index (Hubert, Arabie 1985): 1 for equal segmentations, 0 on average for random ones of the same sizes. O(F).</summary>
    /// <inheritdoc cref="RandIndex"/>
    public static double AdjustedRandIndex(IReadOnlyList<int> first, IReadOnlyList<int> second)
    {
        (double both, double inFirst, double inSecond, double all) = PairCounts(first, second);
        if (all == 0)
            return 1;
        double expected = inFirst * inSecond / all, largest = (inFirst + inSecond) / 2;
        return largest == expected ? 1 : (both - expected) / (largest - expected);
    }

    /// <summary>Cut discrepancy (Chen, Golovinskiy, Funkhouser 2009): the mean distance along edges from the borders of each segmentation to those of the other,
    /// both ways added, divided by the mean distance of the vertices from their centroid. 0 for equal borders; +∞ if only one has borders.</summary>
    /// <exception cref="ArgumentException">There are not as many labels as face slots.</exception>
    public static double CutDiscrepancy(Mesh mesh, IReadOnlyList<int> first, IReadOnlyList<int> second)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        CheckLength(mesh, first, nameof(first));
        CheckLength(mesh, second, nameof(second));
        Vertex[] a = BorderVertices(mesh, first), b = BorderVertices(mesh, second);
        if (a.Length == 0 && b.Length == 0)
            return 0;
        if (a.Length == 0 || b.Length == 0)
            return double.PositiveInfinity;
        return (MeanDistance(mesh, a, b) + MeanDistance(mesh, b, a)) / MeanRadius(mesh);
    }

    private static (double Both, double InFirst, double InSecond, double All) PairCounts(IReadOnlyList<int> first, IReadOnlyList<int> second)
    {
        ArgumentNullException.ThrowIfNull(first);
        ArgumentNullException.ThrowIfNull(second);
        if (first.Count != second.Count)
            throw new ArgumentException($"There are {first.Count} and {second.Count} labels.", nameof(second));
        var cells = new Dictionary<(int, int), long>();
        var rows = new Dictionary<int, long>();
        var columns = new Dictionary<int, long>();
        long n = 0;
        for (int f = 0; f < first.Count; f++)
        {
            if (first[f] < 0 || second[f] < 0)
                continue;
            cells[(first[f], second[f])] = cells.GetValueOrDefault((first[f], second[f])) + 1;
            rows[first[f]] = rows.GetValueOrDefault(first[f]) + 1;
            columns[second[f]] = columns.GetValueOrDefault(second[f]) + 1;
            n++;
        }
        return (cells.Values.Sum(Pairs), rows.Values.Sum(Pairs), columns.Values.Sum(Pairs), Pairs(n));
    }

    private static double Pairs(long n) => 0.5 * n * (n - 1);

    private static void CheckLength(Mesh mesh, IReadOnlyList<int> labels, string name)
    {
        ArgumentNullException.ThrowIfNull(labels, name);
        if (labels.Count != mesh.FaceSlots)
            throw new ArgumentException($"There are {labels.Count} labels for {mesh.FaceSlots} faces.", name);
    }

    private static Vertex[] BorderVertices(Mesh mesh, IReadOnlyList<int> labels)
    {
        var found = new SortedSet<Vertex>();
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary || labels[e.Face0.Index] == labels[e.Face1.Index])
                continue;
            found.Add(e.Vertex0);
            found.Add(e.Vertex1);
        }
        return [.. found];
    }

    private static double MeanDistance(Mesh mesh, Vertex[] from, Vertex[] to)
    {
        double[] distance = mesh.ComputeEdgeDistances(to);
        return from.Average(v => distance[v.Index]);
    }

    private static double MeanRadius(Mesh mesh)
    {
        var center = mesh.Vertices.Aggregate(default(Numerics.Vector3D), (sum, v) => sum + v.Position) / mesh.Vertices.Count;
        return mesh.Vertices.Average(v => (v.Position - center).Length);
    }
}
