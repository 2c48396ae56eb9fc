using MeshLab.Numerics;

namespace MeshLab.Remeshing;

/// <summary>What <see cref="IsotropicRemeshing"/> should do.</summary>
public sealed record RemeshingOptions
{
    /// <summary>The edge length asked for, in model units; null for <see cref="RelativeLength"/> times the input's mean.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive or not finite.</exception>
    public double? EdgeLength
    {
        get;
        init
        {
            if (value is { } length)
                ThrowIfNotPositive(length, nameof(EdgeLength));
            field = value;
        }
    }

    /// <summary>The edge length asked for, as a multiple of the input's mean edge length L̄; only if <see cref="EdgeLength"/> is null.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive or not finite.</exception>
    public double RelativeLength
    {
        get;
        init
        {
            ThrowIfNotPositive(value, nameof(RelativeLength));
            field = value;
        }
    }
    = 1;

    /// <summary>How often split, collapse, flip and smooth are done.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 1.</exception>
    public int Passes
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            field = value;
        }
    }
    = 5;

    /// <summary>Edges whose faces meet at a sharper dihedral angle than this are features and stay (radians); π for none.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not in (0, π].</exception>
    public double FeatureAngle
    {
        get;
        init
        {
            if (!(value is > 0 and <= Math.PI))
                throw new ArgumentOutOfRangeException(nameof(FeatureAngle), value, "A feature angle is in (0, π].");
            field = value;
        }
    }
    = Math.PI;

    /// <summary>Whether vertices are moved back to the input's surface after every pass.</summary>
    public bool Projection { get; init; } = true;

    /// <summary>
    /// Asks the tree for every vertex and weights by area in every pass: nearer to the input and rounder at about twice the time.
    /// </summary>
    public bool HighQuality { get; init; }

    /// <summary>
    /// The largest deviation of an edge from the surface (chord height) as a multiple of the edge length asked for; edges become shorter where the
    /// surface is more curved than that. Null for one length everywhere. Dunyach, Vanderhaeghe, Barthe, Botsch 2013, eq. 1.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive or not finite.</exception>
    public double? CurvatureTolerance
    {
        get;
        init
        {
            if (value is { } tolerance)
                ThrowIfNotPositive(tolerance, nameof(CurvatureTolerance));
            field = value;
        }
    }

    /// <summary>With <see cref="CurvatureTolerance"/>, the shortest length as a multiple of the one asked for.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not in (0, 1].</exception>
    public double SmallestRelativeLength
    {
        get;
        init
        {
            if (!(value is > 0 and <= 1))
                throw new ArgumentOutOfRangeException(nameof(SmallestRelativeLength), value, "The shortest length is a share of the one asked for.");
            field = value;
        }
    }
    = 0.2;

    /// <summary>The most faces that the result may have, reckoned from area and length; more is refused before anything is allocated.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive.</exception>
    public long FaceBudget
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value, nameof(FaceBudget));
            field = value;
        }
    }
    = DefaultFaceBudget;

    internal const long DefaultFaceBudget = 50_000_000;

    /// <summary>What to say if equilateral triangles of that length on the mesh's surface, or edges of it along the mesh's edges, are more than a budget; else null.</summary>
    internal static string? BeyondBudget(Structure.Mesh mesh, double length, long budget)
    {
        ReadOnlySpan<int> first = mesh.HalfEdgeOf, next = mesh.Next, target = mesh.Target;
        ReadOnlySpan<Vector3D> positions = mesh.Positions;
        double area = 0, sides = 0;
        foreach (int h in first)
        {
            if (h < 0)
                continue;
            Vector3D a = positions[target[h]], ab = positions[target[next[h]]] - a, ac = positions[target[next[next[h]]]] - a;
            area += 0.5 * Vector3D.Cross(ab, ac).Length;
            sides += ab.Length + ac.Length + (ac - ab).Length;
        }
        double faces = Math.Max(area / (Math.Sqrt(3) / 4 * length * length), 0.5 * sides / length);
        return faces <= budget ? null : FormattableString.Invariant($"Edges of length {length:G6} would make about {faces:G3} faces; the budget is {budget}.");
    }

    /// <summary>Takes the step trace: a line of JSON per split, collapse and flip, and per smoothing; <see langword="null"/> for none.</summary>
    public TextWriter? Trace { get; init; }

    private static void ThrowIfNotPositive(double value, string name)
    {
        if (!(value > 0) || !double.IsFinite(value))
            throw new ArgumentOutOfRangeException(name, value, "A length is positive and finite.");
    }
}
