using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>The smallest, mean and largest of a quantity over the elements that have it; NaN if none has.</summary>
/// <param name="Min">The smallest.</param>
/// <param name="Mean">The mean.</param>
/// <param name="Max">The largest.</param>
/// <param name="Count">How many there are.</param>
public readonly record struct ValueRange(double Min, double Mean, double Max, int Count)
{
    /// <summary>Of the values that are not NaN. O(n).</summary>
    public static ValueRange Of(ReadOnlySpan<double> values)
    {
        double min = double.PositiveInfinity, max = double.NegativeInfinity, sum = 0;
        int count = 0;
        foreach (double value in values)
        {
            if (double.IsNaN(value))
                continue;
            min = Math.Min(min, value);
            max = Math.Max(max, value);
            sum += value;
            count++;
        }
        return count == 0 ? new(double.NaN, double.NaN, double.NaN, 0) : new(min, sum / count, max, count);
    }
}

/// <summary>What there is to measure on a whole mesh at a glance.</summary>
/// <param name="Mass">Area, volume, centroids, inertia, faces of zero area.</param>
/// <param name="BoundingBox">The box of all live vertices.</param>
/// <param name="EdgeLength">Over all edges.</param>
/// <param name="Valence">Over the vertices that are not isolated.</param>
/// <param name="ValenceHistogram">How many vertices of each valence, isolated ones not counted.</param>
/// <param name="FaceDegrees">How many faces of each degree.</param>
/// <param name="Dihedral">The signed dihedral angle over the interior edges, in radians.</param>
/// <param name="AngleDefectSum">The sum of the angle defects: 2πχ.</param>
public sealed record MeshMeasures(
    MassProperties Mass,
    BoundingBox BoundingBox,
    ValueRange EdgeLength,
    ValueRange Valence,
    IReadOnlyDictionary<int, int> ValenceHistogram,
    IReadOnlyDictionary<int, int> FaceDegrees,
    ValueRange Dihedral,
    double AngleDefectSum)
{
    /// <summary>Measures a mesh. O(V + H).</summary>
    public static MeshMeasures Of(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        int[] valences = Valences(mesh);
        var valence = new double[valences.Length];
        for (int v = 0; v < valence.Length; v++)
            valence[v] = valences[v] > 0 ? valences[v] : double.NaN;
        return new(
            mesh.ComputeMassProperties(),
            mesh.BoundingBox,
            ValueRange.Of(mesh.ComputeEdgeLengths()),
            ValueRange.Of(valence),
            Histogram(valences),
            Histogram(Degrees(mesh)),
            ValueRange.Of(mesh.ComputeDihedralAngles()),
            SumOfDefects(mesh));
    }

    /// <summary>The number of edges per vertex slot; 0 for isolated and deleted vertices. O(E).</summary>
    public static int[] Valences(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        var valences = new int[mesh.VertexSlots];
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target;
        for (int h = 0; h < next.Length; h++)
        {
            if (next[h] >= 0)
                valences[target[h]]++;
        }
        return valences;
    }

    private static int[] Degrees(Mesh mesh)
    {
        var degrees = new int[mesh.FaceSlots];
        foreach (int f in mesh.FaceOf)
        {
            if (f >= 0)
                degrees[f]++;
        }
        return degrees;
    }

    private static SortedDictionary<int, int> Histogram(int[] numbers)
    {
        var histogram = new SortedDictionary<int, int>();
        foreach (int n in numbers)
        {
            if (n > 0)
                histogram[n] = histogram.GetValueOrDefault(n) + 1;
        }
        return histogram;
    }

    private static double SumOfDefects(Mesh mesh)
    {
        double[] defects = mesh.ComputeAngleDefects();
        return Parallelism.SumBlocks(defects.Length, (from, to) =>
        {
            double sum = 0;
            for (int v = from; v < to; v++)
            {
                if (!double.IsNaN(defects[v]))
                    sum += defects[v];
            }
            return sum;
        });
    }
}
