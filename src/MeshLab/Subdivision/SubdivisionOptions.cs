namespace MeshLab.Subdivision;

/// <summary>The weight of the neighbours of an interior vertex in Loop's scheme.</summary>
public enum LoopWeights
{
    /// <summary>β = (5/8 − (3/8 + ¼ cos 2π/n)²)/n: Loop 1987, the textbook's.</summary>
    Loop1987,

    /// <summary>β = 3/(8n), and 3/16 for n = 3: Warren 1995.</summary>
    Warren,
}

/// <summary>A subdivision scheme (细分格式).</summary>
public enum SubdivisionScheme
{
    /// <summary>§8.1, triangles, approximating; with <see cref="SubdivisionOptions.Weights"/>.</summary>
    Loop,

    /// <summary>§8.2, triangles, interpolating.</summary>
    ModifiedButterfly,

    /// <summary>§8.3, triangles, approximating.</summary>
    Sqrt3,

    /// <summary>Polygons to quadrilaterals, approximating.</summary>
    CatmullClark,

    /// <summary>Polygons, approximating, dual.</summary>
    DooSabin,

    /// <summary>Triangles cut into four without moving anything.</summary>
    Midpoint,
}

/// <summary>How to subdivide.</summary>
public sealed record SubdivisionOptions
{
    /// <summary>One step with the textbook's weights.</summary>
    public static SubdivisionOptions Default { get; } = new();

    /// <summary>How often; 0 gives a copy.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative.</exception>
    public int Steps
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            field = value;
        }
    } = 1;

    /// <summary>Loop's weights.</summary>
    public LoopWeights Weights { get; init; } = LoopWeights.Loop1987;

    /// <summary>The most faces that the result may have; more is refused before anything is allocated.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive.</exception>
    public long FaceBudget
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            field = value;
        }
    } = 50_000_000;

    /// <summary>Whether the edge trait <see cref="Creases.TraitName"/> makes creases in Loop's and Catmull and Clark's schemes.</summary>
    public bool UseCreases { get; init; } = true;

    /// <summary>Whether every vertex is moved to its limit (极限位置) after the last step: Loop's scheme and Catmull and Clark's. See <see cref="LimitSurface"/>.</summary>
    public bool ToLimit { get; init; }

    /// <summary>Takes the step trace: a line of JSON with the counts and a hash of the mesh per step, and one for the move to the limit; <see langword="null"/> for none.</summary>
    public TextWriter? Trace { get; init; }

    /// <summary>§8.3: whether the first step trisects the boundary, as the second of two √3 steps does. Faces may then have one boundary edge at most.</summary>
    public bool BeginWithBoundaryTrisection { get; init; }
}
