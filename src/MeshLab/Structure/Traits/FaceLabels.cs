namespace MeshLab.Structure;

/// <summary>Named groups of faces of one sort, such as the materials or the objects of a file: a number per face and a name per number.</summary>
public sealed class FaceLabels
{
    /// <summary>The number of a face in no group.</summary>
    public const int None = -1;

    private readonly List<string> names;

    internal FaceLabels(string sort, FaceTrait<int> labels, IEnumerable<string> names)
    {
        Sort = sort;
        Labels = labels;
        this.names = [.. names];
    }

    /// <summary>What the groups are: <c>object</c>, <c>group</c>, <c>material</c>, <c>smoothing</c>, or an own word.</summary>
    public string Sort { get; }

    /// <summary>The number of each face's group, <see cref="None"/> for none.</summary>
    public FaceTrait<int> Labels { get; }

    /// <summary>The groups' names by number.</summary>
    public IReadOnlyList<string> Names => names;

    /// <summary>The number of a name; a new one if it is not there yet.</summary>
    public int Number(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        int number = names.IndexOf(name);
        if (number >= 0)
            return number;
        names.Add(name);
        return names.Count - 1;
    }

    /// <summary>The name of a face's group; <see langword="null"/> for none.</summary>
    public string? NameOf(Face face) => Labels[face] == None ? null : names[Labels[face]];
}
