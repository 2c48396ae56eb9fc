namespace MeshLab.HoleFilling;

/// <summary>How a hole is triangulated (补洞方法).</summary>
public enum HoleFillingMethod
{
    /// <summary>A fan from the loop's first vertex from which it is possible. O(n).</summary>
    Fan,

    /// <summary>A fan around a new vertex at the mean of the loop. O(n).</summary>
    Centroid,

    /// <summary>Advancing front: again and again the corner with the smallest angle is cut off. O(n²), more if many corners are refused.</summary>
    Ear,

    /// <summary>The triangulation with the smallest weight (Barequet–Sharir 1995, Liepa 2003): see <see cref="HoleWeight"/>. O(n³).</summary>
    MinimumWeight,

    /// <summary>
    /// <see cref="MinimumWeight"/>; then, unless refinement or fairing is asked for, whichever of three foretells the ring of faces around the hole best: the triangles as they are, or
    /// refined and faired by slope, or by curvature. O(n³).
    /// </summary>
    Automatic,
}

/// <summary>What <see cref="HoleFillingMethod.MinimumWeight"/> makes small.</summary>
public enum HoleWeight
{
    /// <summary>
    /// The sum over all edges of length times angle, then the area: continues planes and creases from around the hole. A single sharp edge
    /// on the rim, as technical models have, does not spoil the comparison, as it does where the largest bend counts.
    /// </summary>
    TotalBend,

    /// <summary>The largest bend between neighbouring triangles, then the area (Liepa 2003).</summary>
    BendThenArea,

    /// <summary>The area (Barequet–Sharir 1995): flatter across holes whose rim is not smooth.</summary>
    Area,
}

/// <summary>How holes are filled.</summary>
public sealed record HoleFillingOptions
{
    /// <summary>How a hole is triangulated.</summary>
    public HoleFillingMethod Method { get; init => field = Enum.IsDefined(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such method."); } = HoleFillingMethod.Automatic;

    /// <summary>What the triangulation of minimum weight makes small.</summary>
    public HoleWeight Weight { get; init => field = Enum.IsDefined(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such weight."); }

    /// <summary>Whether the patch gets triangles of the size of those around the hole (Liepa 2003, §4).</summary>
    public bool Refine { get; init; }

    /// <summary>Whether the patch is then bent to continue the surface around it smoothly (Liepa 2003, §5).</summary>
    public bool Fair { get; init; }

    /// <summary>How the bent patch meets the surface around it: 0 by position, a membrane; 1 by slope, a thin plate; 2 by slope and curvature.</summary>
    public int Continuity { get; init => field = value is >= 0 and <= 2 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The continuity is 0, 1 or 2."); } = 1;

    /// <summary>Loops with more edges are left open.</summary>
    public int MaxEdges { get; init => field = value >= 3 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A loop has three edges or more."); } = int.MaxValue;

    /// <summary>The most vertices added in all; refinement stops there, and a centroid fan that needs one more is refused.</summary>
    public int MaxNewVertices { get; init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The budget must not be negative."); } = 1_000_000;

    /// <summary>Loops with more edges than this are triangulated by <see cref="HoleFillingMethod.Ear"/> where the cubic method is asked for.</summary>
    public int MaxEdgesForMinimumWeight { get; init => field = value >= 3 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A loop has three edges or more."); } = 1500;
}

/// <summary>Why a hole was not filled.</summary>
public enum HoleRefusal
{
    /// <summary>It was.</summary>
    None,

    /// <summary>The loop has more edges than allowed.</summary>
    TooManyEdges,

    /// <summary>No more vertices may be added.</summary>
    VertexBudget,

    /// <summary>Every triangulation tried would join two vertices that have an edge already.</summary>
    NoTriangulation,
}

/// <summary>What became of one hole.</summary>
/// <param name="FirstVertex">The lowest vertex of the loop.</param>
/// <param name="Edges">The number of its edges.</param>
/// <param name="Filled">Whether it was filled.</param>
/// <param name="Reason">Why not.</param>
/// <param name="Method">The method used.</param>
/// <param name="FacesAdded">The number of new faces.</param>
/// <param name="VerticesAdded">The number of new vertices.</param>
/// <param name="Continuity">How the patch was bent: <see cref="HoleFillingOptions.Continuity"/>; nothing if it was not.</param>
public sealed record HoleReport(
    int FirstVertex, int Edges, bool Filled, HoleRefusal Reason, HoleFillingMethod Method, int FacesAdded, int VerticesAdded, int? Continuity = null);

/// <summary>What became of all holes.</summary>
/// <param name="Loops">One report per loop, by its lowest vertex.</param>
public sealed record HoleFillingResult(IReadOnlyList<HoleReport> Loops)
{
    /// <summary>The number of loops filled.</summary>
    public int Filled => Loops.Count(loop => loop.Filled);

    /// <summary>The number of new faces.</summary>
    public int FacesAdded => Loops.Sum(loop => loop.FacesAdded);
}
