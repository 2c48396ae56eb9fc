using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>A segmentation (分段): a label per face, and what the method says of it.</summary>
/// <param name="Labels">Per face slot its segment, from 0; −1 for deleted faces.</param>
/// <param name="Count">The number of segments.</param>
/// <param name="Objective">What the method made small at the end; NaN for methods without an objective.</param>
/// <param name="Steps">How many rounds it took; 0 for methods without rounds.</param>
/// <param name="StopReason">Why it stopped.</param>
public sealed record FaceSegmentation(int[] Labels, int Count, double Objective, int Steps, SegmentationStop StopReason)
{
    /// <summary>The objective after every round, if the method has rounds.</summary>
    public IReadOnlyList<double> History { get; init; } = [];

    /// <summary>The number of faces per segment.</summary>
    public int[] Sizes
    {
        get
        {
            var sizes = new int[Count];
            foreach (int label in Labels)
            {
                if (label >= 0)
                    sizes[label]++;
            }
            return sizes;
        }
    }

    /// <summary>Writes the labels to the faces' selection flags (1 for the first segment), as the textbook keeps them.</summary>
    public void WriteTo(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        FaceTrait<int> flags = mesh.GetOrAddFaceTrait(TraitNames.SelectedFlag, 0, Blend.Nearest);
        foreach (Face f in mesh.Faces)
            flags[f] = Labels[f.Index] + 1;
    }
}

/// <summary>Why a segmentation ended.</summary>
public enum SegmentationStop
{
    /// <summary>Every face has its label and nothing more is to be done.</summary>
    Complete,

    /// <summary>A further round changes nothing.</summary>
    Converged,

    /// <summary>The limit of rounds was reached.</summary>
    RoundLimit,
}

/// <summary>What region growing compares a candidate with.</summary>
public enum GrowingReference
{
    /// <summary>The element from which it is reached (父单元).</summary>
    Parent,

    /// <summary>The seed of the region (种子).</summary>
    Seed,

    /// <summary>The mean of the region so far (区域均值).</summary>
    RegionMean,
}

/// <summary>Where K-means begins.</summary>
public enum SeedingMethod
{
    /// <summary>The next seed is the face farthest from all seeds so far (最远点).</summary>
    FarthestPoint,

    /// <summary>The next seed is drawn with a probability in proportion to area times squared distance (Arthur, Vassilvitskii 2007).</summary>
    PlusPlus,
}
