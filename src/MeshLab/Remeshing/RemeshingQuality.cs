using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>How regular a triangle mesh is.</summary>
/// <param name="SmallestAngle">The smallest angle of all, in radians.</param>
/// <param name="MeanSmallestAngle">The mean over the faces of their smallest angle, in radians; π/3 at best.</param>
/// <param name="Valence6">The share of inner vertices with valence 6.</param>
/// <param name="Valence567">The share of inner vertices with valence 5, 6 or 7.</param>
/// <param name="MeanValence">The mean valence of all vertices with edges.</param>
/// <param name="ValenceHistogram">How many vertices have each valence, boundary ones included.</param>
public sealed record RemeshingQuality(
    double SmallestAngle, double MeanSmallestAngle, double Valence6, double Valence567, double MeanValence, IReadOnlyDictionary<int, int> ValenceHistogram)
{
    /// <summary>Measures a mesh. O(V + F). NaN where there is nothing to measure.</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static RemeshingQuality Of(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        double smallest = double.NaN, sum = 0;
        foreach (double angle in mesh.ComputeFaceQualities(QualityMeasure.MinAngle))
        {
            if (double.IsNaN(angle))
                continue;
            smallest = angle < smallest || double.IsNaN(smallest) ? angle : smallest;
            sum += angle;
        }

        int[] valences = MeshMeasures.Valences(mesh);
        var histogram = new SortedDictionary<int, int>();
        int inner = 0, six = 0, nearSix = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            int valence = valences[v.Index];
            histogram[valence] = histogram.GetValueOrDefault(valence) + 1;
            if (v.IsBoundary)
                continue;
            inner++;
            six += valence == 6 ? 1 : 0;
            nearSix += valence is >= 5 and <= 7 ? 1 : 0;
        }
        int used = histogram.Values.Sum();
        return new(
            smallest, sum / mesh.Faces.Count, (double)six / inner, (double)nearSix / inner,
            histogram.Sum(pair => (double)pair.Key * pair.Value) / used, histogram);
    }
}
