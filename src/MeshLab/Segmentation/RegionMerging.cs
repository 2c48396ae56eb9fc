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
        List<Crossing> crossings = InnerEdges(mesh, angle);
        while (true)
        {
            ((int A, int B) pair, double flattest) = FlattestBorder(crossings, labels);
            if (!(flattest < 0.5))
                return;
            for (int f = 0; f < labels.Length; f++)
            {
                if (labels[f] == pair.B)
                    labels[f] = pair.A;
            }
        }
    }

    /// <summary>An inner edge as borders see it.</summary>
    private readonly record struct Crossing(int Face0, int Face1, double Length, double SharpLength);

    private static List<Crossing> InnerEdges(Mesh mesh, double angle)
    {
        var geometry = new FaceGeometry(mesh);
        var crossings = new List<Crossing>(mesh.Edges.Count);
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary)
                continue;
            int f = e.Face0.Index, g = e.Face1.Index;
            // A face without area has no normal and says nothing about the border.
            bool known = geometry.Normals[f] != Vector3D.Zero && geometry.Normals[g] != Vector3D.Zero;
            double length = known ? e.Length : 0;
            crossings.Add(new(f, g, length, known && Vector3D.Angle(geometry.Normals[f], geometry.Normals[g]) > angle ? length : 0));
        }
        return crossings;
    }

    /// <summary>The border with the smallest part that is sharp; the pair with the lowest labels on a tie.</summary>
    private static ((int A, int B) Pair, double SharpPart) FlattestBorder(List<Crossing> crossings, int[] labels)
    {
        var borders = new SortedDictionary<(int, int), (double Length, double Sharp)>();
        foreach (Crossing c in crossings)
        {
            int a = Math.Min(labels[c.Face0], labels[c.Face1]), b = Math.Max(labels[c.Face0], labels[c.Face1]);
            if (a == b)
                continue;
            (double length, double sharp) = borders.GetValueOrDefault((a, b));
            borders[(a, b)] = (length + c.Length, sharp + c.SharpLength);
        }
        (int, int) best = (-1, -1);
        double flattest = double.PositiveInfinity;
        foreach (((int, int) pair, (double length, double sharp)) in borders)
        {
            double part = length > 0 ? sharp / length : 0;
            if (part < flattest)
                (best, flattest) = (pair, part);
        }
        return (best, flattest);
    }
}
