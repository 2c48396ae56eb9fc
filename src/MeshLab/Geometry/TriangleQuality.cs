using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>Which measure of a triangle's shape (三角形质量).</summary>
public enum QualityMeasure
{
    /// <summary>4√3·A / (a² + b² + c²): 1 best, 0 for zero area.</summary>
    MeanRatio,

    /// <summary>Twice the inradius over the circumradius: 1 best, 0 for zero area.</summary>
    RadiusRatio,

    /// <summary>The smallest angle, in radians: π/3 best, 0 for zero area.</summary>
    MinAngle,

    /// <summary>The largest angle, in radians: π/3 best, π for zero area.</summary>
    MaxAngle,

    /// <summary>Longest side over its altitude: 2/√3 best, infinite for zero area.</summary>
    AspectRatio,
}

/// <summary>三角形质量 (triangle quality) per face.</summary>
public static class TriangleQuality
{
    extension(Mesh mesh)
    {
        /// <summary>The quality per face slot; NaN for deleted faces. O(F), in parallel.</summary>
        /// <param name="measure">Which measure.</param>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        /// <exception cref="ArgumentOutOfRangeException">There is no such measure.</exception>
        public double[] ComputeFaceQualities(QualityMeasure measure = QualityMeasure.MeanRatio)
        {
            mesh.RequireTriangles();
            if (!Enum.IsDefined(measure))
                throw new ArgumentOutOfRangeException(nameof(measure), measure, "There is no such measure.");
            int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
            Vector3D[] positions = mesh.positions;
            var qualities = new double[mesh.FaceSlots];
            Parallelism.ForBlocks(qualities.Length, (from, to) =>
            {
                for (int f = from; f < to; f++)
                {
                    int h = halfEdgeOf[f];
                    qualities[f] = h < 0
                        ? double.NaN
                        : Of(new(positions[target[h ^ 1]], positions[target[h]], positions[target[next[h]]]), measure);
                }
            });
            return qualities;
        }
    }

    private static double Of(Triangle triangle, QualityMeasure measure) => measure switch
    {
        QualityMeasure.MeanRatio => triangle.Quality,
        QualityMeasure.RadiusRatio => triangle.RadiusRatio,
        QualityMeasure.MinAngle => triangle.MinAngle,
        QualityMeasure.MaxAngle => triangle.MaxAngle,
        _ => triangle.AspectRatio,
    };
}
