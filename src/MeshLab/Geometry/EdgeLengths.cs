using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>边长 (edge lengths), in model units.</summary>
public static class EdgeLengths
{
    extension(Mesh mesh)
    {
        /// <summary>The length per edge slot; NaN for deleted edges. O(E), in parallel.</summary>
        public double[] ComputeEdgeLengths()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            int[] next = mesh.next, target = mesh.target;
            Vector3D[] positions = mesh.positions;
            var lengths = new double[mesh.EdgeSlots];
            Parallelism.ForBlocks(lengths.Length, (from, to) =>
            {
                for (int e = from; e < to; e++)
                    lengths[e] = next[2 * e] < 0 ? double.NaN : (positions[target[2 * e]] - positions[target[2 * e + 1]]).Length;
            });
            return lengths;
        }

        /// <summary>The mean length over all edges, L̄; NaN without edges. O(E).</summary>
        public double MeanEdgeLength
        {
            get
            {
                double[] lengths = mesh.ComputeEdgeLengths();
                double sum = Parallelism.SumBlocks(lengths.Length, (from, to) =>
                {
                    double part = 0;
                    for (int e = from; e < to; e++)
                    {
                        if (!double.IsNaN(lengths[e]))
                            part += lengths[e];
                    }
                    return part;
                });
                return sum / mesh.Edges.Count;
            }
        }
    }
}
