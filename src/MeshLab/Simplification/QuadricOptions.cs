namespace MeshLab.Simplification;

/// <summary>How quadric simplification works.</summary>
public enum QuadricMode
{
    /// <summary>Summed quadrics, a queue of lower bounds, regions in parallel: for every day.</summary>
    Fast,

    /// <summary>As fast mode until three times the target, then costs from the current faces alone, then a guarded fit to the original surface.</summary>
    Accurate,

    /// <summary>The book's steps with handles and an indexed heap, one edge after the other: to be read. The book's own program is this with
    /// <see cref="QuadricOptions.AreaWeights"/> off, a free boundary and flips allowed. Vertices on features and seams are locked. Corner traits are blended
    /// only where edges merge, as <see cref="Editing.EdgeCollapse"/> does.</summary>
    Textbook,
}

/// <summary>What happens to boundaries.</summary>
public enum BoundaryTreatment
{
    /// <summary>Boundary edges have no quadric of their own; open borders may shrink.</summary>
    Free,

    /// <summary>Each boundary edge adds a plane through itself, perpendicular to its face.</summary>
    Weighted,

    /// <summary>Boundary vertices neither move nor disappear.</summary>
    Locked,
}

/// <summary>Where the vertex that an edge becomes may lie.</summary>
public enum VertexPlacement
{
    /// <summary>Where the quadric is smallest; on flat ground the best of the midpoint and the ends.</summary>
    Optimal,

    /// <summary>On the edge, where the quadric is smallest.</summary>
    Segment,

    /// <summary>At the better end of the edge: the result's vertices are vertices of the input.</summary>
    Endpoint,
}

/// <summary>Options of <see cref="QuadricErrorMetric"/>. One or more of the targets must be set; simplification stops at the first that is reached.</summary>
public sealed record QuadricOptions
{
    /// <summary>The way to work.</summary>
    public QuadricMode Mode { get; init; }

    /// <summary>The number of faces to reach, at least 1 and at most the mesh's number.</summary>
    public int? TargetFaces
    {
        get;
        init
        {
            if (value is int faces)
                ArgumentOutOfRangeException.ThrowIfNegativeOrZero(faces, nameof(TargetFaces));
            field = value;
        }
    }

    /// <summary>The part of the faces to keep, in (0, 1]; rounded down, but at least one face.</summary>
    public double? TargetRatio
    {
        get;
        init
        {
            if (value is double ratio && !(ratio > 0 && ratio <= 1))
                throw new ArgumentOutOfRangeException(nameof(TargetRatio), ratio, "The ratio of faces to keep lies in (0, 1].");
            field = value;
        }
    }

    /// <summary>The largest error of one contraction, in model units: the root of the mean squared distance of the new vertex to the planes that it
    /// stands for. Contractions above it are refused.</summary>
    public double? MaxError
    {
        get;
        init
        {
            if (value is double error && !(error >= 0 && double.IsFinite(error)))
                throw new ArgumentOutOfRangeException(nameof(MaxError), error, "The largest error is a finite number that is not negative.");
            field = value;
        }
    }

    /// <summary>What happens to boundaries.</summary>
    public BoundaryTreatment Boundary { get; init; } = BoundaryTreatment.Weighted;

    /// <summary>The weight of a boundary edge's plane is this times the squared length of the edge; also that of feature edges and texture seams.</summary>
    public double BoundaryWeight
    {
        get;
        init
        {
            if (!(value >= 0 && double.IsFinite(value)))
                throw new ArgumentOutOfRangeException(nameof(BoundaryWeight), value, "The weight is a finite number that is not negative.");
            field = value;
        }
    }

    = 10;

    /// <summary>Whether the plane of a face weighs as much as its area; otherwise every plane weighs 1, as in the book's program.</summary>
    public bool AreaWeights { get; init; } = true;

    /// <summary>Whether a face may turn over (翻转). Otherwise a contraction that turns a face by more than acos 0.05 = 87° is refused.</summary>
    public bool AllowFlips { get; init; }

    /// <summary>Where new vertices may lie.</summary>
    public VertexPlacement Placement { get; init; }

    /// <summary>Edges whose normals differ by more than this angle in radians are features: they are only contracted along themselves.
    /// <see langword="null"/> for none.</summary>
    public double? FeatureAngle
    {
        get;
        init
        {
            if (value is double angle && !(angle > 0 && angle <= Math.PI))
                throw new ArgumentOutOfRangeException(nameof(FeatureAngle), angle, "The feature angle lies in (0, π].");
            field = value;
        }
    }

    /// <summary>Indices of edges that are features besides those of <see cref="FeatureAngle"/>.</summary>
    public IReadOnlyCollection<int>? FeatureEdges { get; init; }

    /// <summary>Whether edges across which a corner's texture coordinates jump are kept as seams (接缝): they are only contracted along themselves.</summary>
    public bool KeepTextureSeams { get; init; } = true;

    /// <summary>Whether borders between faces of different labels (materials, groups) are kept likewise.</summary>
    public bool KeepLabelBorders { get; init; } = true;

    /// <summary>Takes one line of JSON per contraction (step, edge, vertices, cost, position, running hash); <see langword="null"/> for no trace.</summary>
    public TextWriter? Trace { get; init; }
}
