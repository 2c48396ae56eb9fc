namespace MeshLab.FiveSixSeven;

/// <summary>Which way to a 5-6-7 mesh.</summary>
public enum FiveSixSevenEngine
{
    /// <summary>Repair in place by short guarded walks: nearly every vertex keeps its place. The default.</summary>
    Repair,

    /// <summary>§9.2–9.6 step by step: raise valences 3 and 4, cut every face into nine, split high valences, simplify.</summary>
    Textbook,
}

/// <summary>How a 5-6-7 mesh is made.</summary>
public sealed record FiveSixSevenOptions
{
    /// <summary>The engine.</summary>
    public FiveSixSevenEngine Engine { get; init; } = FiveSixSevenEngine.Repair;

    /// <summary>The number of faces asked for; the input's if not given (or the smallest possible one, if that is more).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is not positive.</exception>
    public int? TargetFaces
    {
        get;
        init
        {
            if (value is int faces)
                ArgumentOutOfRangeException.ThrowIfNegativeOrZero(faces);
            field = value;
        }
    }

    /// <summary>The most faces that may be asked for.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive.</exception>
    public int FaceBudget
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            field = value;
        }
    } = 50_000_000;

    /// <summary>Edges with a larger dihedral angle than this are creases and stay, in radians. π for none. A surface that is folded back on itself at more than a
    /// twentieth of its edges has none.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The angle is not between 0 and π.</exception>
    public double FeatureAngle
    {
        get;
        init
        {
            if (!(value >= 0 && value <= Math.PI))
                throw new ArgumentOutOfRangeException(nameof(value), value, "The feature angle lies between 0 and π.");
            field = value;
        }
    } = 40 * Math.PI / 180;

    /// <summary>A connected set of sharp edges without a cycle and with at most so many edges is taken for noise of a scan.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is negative.</exception>
    public int NoiseEdges
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            field = value;
        }
    } = 10;

    /// <summary>Whether triangles are made rounder in the end: smoothing on the input, flips, slivers collapsed.</summary>
    public bool ImproveShape { get; init; } = true;

    /// <summary>Takes the step trace: a line of JSON per flip, split and collapse that stays, per round of smoothing, and per cut into nine; <see langword="null"/> for none.</summary>
    public TextWriter? Trace { get; init; }
}

/// <summary>Why the work on a 5-6-7 mesh ended.</summary>
public enum FiveSixSevenStop
{
    /// <summary>Every inner vertex has valence 5, 6 or 7, and the number of faces is within 0.5 % of the one aimed at (or two faces).</summary>
    Reached,

    /// <summary>The valences are right, but no step towards the number of faces is left that keeps them and the shape.</summary>
    CountOutOfReach,

    /// <summary>There are no faces, or (in the book's step of simplification) no more than asked for.</summary>
    NothingToDo,
}

/// <summary>A 5-6-7 mesh and how it came about.</summary>
/// <param name="Mesh">The new mesh, with the traits of the input by place: values of vertices and corners blended as each trait says, those of faces and labels from
/// the face nearby, those of edges where one lies along an old one.</param>
/// <param name="Before">How many inner vertices of each valence the input had.</param>
/// <param name="After">How many the result has.</param>
/// <param name="TargetFaces">The number of faces aimed at.</param>
/// <param name="Walks">How many repair walks were tried.</param>
/// <param name="Level">The guard level at which Φ became 0: 0 if nothing was to repair, 1 the strictest, 6 topology only, 7 topology only with growth.</param>
/// <param name="UsedLastResort">Whether walks were not enough, so that every face was cut into nine.</param>
/// <param name="StopReason">Why the work ended.</param>
/// <param name="IsComplete">Whether every inner vertex has valence 5, 6 or 7.</param>
public sealed record FiveSixSevenResult(
    Structure.Mesh Mesh,
    IReadOnlyDictionary<int, int> Before,
    IReadOnlyDictionary<int, int> After,
    int TargetFaces,
    long Walks,
    int Level,
    bool UsedLastResort,
    FiveSixSevenStop StopReason,
    bool IsComplete);
