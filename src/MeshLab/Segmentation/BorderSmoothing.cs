using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>§13 边界光滑: straightens the borders between segments by giving faces to a neighbouring segment where that makes the borders shorter.</summary>
/// <remarks>Each change lowers the total length of the borders, so it ends. A segment never loses its last face. O(rounds · F).</remarks>
public static class BorderSmoothing
{
    /// <summary>Smooths the borders.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="segmentation">Its segmentation; not changed.</param>
    /// <param name="maxRounds">The most sweeps over all faces.</param>
    public static FaceSegmentation Smooth(Mesh mesh, FaceSegmentation segmentation, int maxRounds = 10)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(segmentation);
        ArgumentOutOfRangeException.ThrowIfNegative(maxRounds);
        int[] labels = [.. segmentation.Labels], sizes = segmentation.Sizes;
        int rounds = 0;
        bool changed = true;
        while (changed && rounds < maxRounds)
        {
            changed = false;
            rounds++;
            foreach (Face f in mesh.Faces)
            {
                int better = BetterLabel(f, labels);
                if (better == labels[f.Index] || sizes[labels[f.Index]] == 1)
                    continue;
                sizes[labels[f.Index]]--;
                sizes[better]++;
                labels[f.Index] = better;
                changed = true;
            }
        }
        return segmentation with { Labels = labels, Steps = rounds, StopReason = changed ? SegmentationStop.RoundLimit : SegmentationStop.Converged };
    }

    /// <summary>The total length of the borders between segments.</summary>
    public static double BorderLength(Mesh mesh, IReadOnlyList<int> labels)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(labels);
        double length = 0;
        foreach (Edge e in mesh.Edges)
        {
            if (!e.IsBoundary && labels[e.Face0.Index] != labels[e.Face1.Index])
                length += e.Length;
        }
        return length;
    }

    /// <summary>The label with which the face has the longest common edges, if that is clearly more than with its own; the lowest on a tie.</summary>
    private static int BetterLabel(Face f, int[] labels)
    {
        int own = labels[f.Index], best = own;
        double longest = Common(f, own, labels);
        foreach (HalfEdge h in f.HalfEdges)
        {
            if (h.Edge.IsBoundary)
                continue;
            int label = labels[h.Twin.Face.Index];
            double common = Common(f, label, labels);
            if (common > longest * (1 + 1e-9) || (common == longest && best != own && label < best))
                (best, longest) = (label, common);
        }
        return best;
    }

    private static double Common(Face f, int label, int[] labels)
    {
        double length = 0;
        foreach (HalfEdge h in f.HalfEdges)
        {
            if (!h.Edge.IsBoundary && labels[h.Twin.Face.Index] == label)
                length += h.Edge.Length;
        }
        return length;
    }
}
