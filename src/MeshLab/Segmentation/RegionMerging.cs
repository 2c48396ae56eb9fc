using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>Merges neighbouring regions where the border between them is not sharp.</summary>
public static class RegionMerging
{
    /// <summary>Merges regions, the flattest border first, while less than half of its length is sharper than an angle.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="labels">Labels per face slot; changed.</param>
    /// <param name="angle">In radians.</param>
    public static void MergeAcrossFlatBorders(Mesh mesh, int[] labels, double angle)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(labels);
        while (true)
        {
            ((int A, int B) pair, double flattest) = FlattestBorder(mesh, labels, angle);
            if (!(flattest < 0.5))
                return;
            for (int f = 0; f < labels.Length; f++)
            {
                if (labels[f] == pair.B)
                    labels[f] = pair.A;
            }
        }
    }

    /// <summary>The border with the smallest part that is sharp.</summary>
    private static ((int A, int B) Pair, double SharpPart) FlattestBorder(Mesh mesh, int[] labels, double angle)
    {
        var geometry = new FaceGeometry(mesh);
        var borders = new SortedDictionary<(int, int), (double Length, double Turn)>();
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary)
                continue;
            int f = e.Face0.Index, g = e.Face1.Index, a = Math.Min(labels[f], labels[g]), b = Math.Max(labels[f], labels[g]);
            if (a == b)
                continue;
            double length = e.Length;
            // A face without area has no normal and says nothing about the border.
            bool known = geometry.Normals[f] != Vector3D.Zero && geometry.Normals[g] != Vector3D.Zero;
            (double sum, double turn) = borders.GetValueOrDefault((a, b));
            borders[(a, b)] = known ? (sum + length, turn + (Vector3D.Angle(geometry.Normals[f], geometry.Normals[g]) > angle ? length : 0)) : (sum, turn);
        }
        (int, int) best = (-1, -1);
        double flattest = double.PositiveInfinity;
        foreach (((int, int) pair, (double length, double turn)) in borders)
        {
            double mean = length > 0 ? turn / length : 0;
            if (mean < flattest)
                (best, flattest) = (pair, mean);
        }
        return (best, flattest);
    }
}
