using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>How normals are chosen for the light.</summary>
public enum Shading
{
    /// <summary>Normals are averaged around vertices except across sharp edges (see <see cref="RenderOptions.CreaseAngle"/>).</summary>
    Smooth,

    /// <summary>One normal per face (平面着色): every face is seen.</summary>
    Flat,

    /// <summary>No light: the colours as they are.</summary>
    None,
}

/// <summary>Which axis of the model points up in the picture.</summary>
public enum UpAxis
{
    /// <summary>z is up; azimuth 0 looks along +y.</summary>
    Z,

    /// <summary>y is up; azimuth 0 looks along −z.</summary>
    Y,
}

/// <summary>From where the model is seen (视角). The camera's distance is chosen so that the model fills the picture.</summary>
/// <param name="Azimuth">Degrees the viewer walks to the right around the model, from the front.</param>
/// <param name="Elevation">Degrees the viewer is above the horizon, −90 to 90.</param>
public sealed record View(double Azimuth = 30, double Elevation = 20)
{
    /// <summary>Degrees the viewer walks to the right around the model, from the front.</summary>
    public double Azimuth { get; init; } = double.IsFinite(Azimuth)
        ? Azimuth : throw new ArgumentOutOfRangeException(nameof(Azimuth), Azimuth, "An azimuth is a finite number of degrees.");

    /// <summary>Degrees the viewer is above the horizon, −90 to 90.</summary>
    public double Elevation { get; init; } = Elevation is >= -90 and <= 90
        ? Elevation : throw new ArgumentOutOfRangeException(nameof(Elevation), Elevation, "An elevation is −90 to 90 degrees.");

    /// <summary>The axis of the model that points up.</summary>
    public UpAxis Up { get; init; } = UpAxis.Z;

    /// <summary>The larger opening angle of the camera in degrees, 1 (nearly parallel) to 120.</summary>
    public double FieldOfView
    {
        get;
        init => field = value is >= 1 and <= 120
            ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A field of view is 1 to 120 degrees.");
    } = 28;

    /// <summary>Magnification around the middle; 1 fits the whole model.</summary>
    public double Zoom
    {
        get;
        init => field = value is >= 0.05 and <= 50 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A zoom is 0.05 to 50.");
    } = 1;
}

/// <summary>A chain of points drawn over the surface, hidden where the surface is in front: a section line, a path, an arc.</summary>
/// <param name="Points">The points in order.</param>
/// <param name="Color">Colour with opacity.</param>
/// <param name="Width">Width in pixels.</param>
public sealed record Polyline(IReadOnlyList<Vector3D> Points, Color Color, double Width = 2.5)
{
    /// <summary>Whether the last point is joined to the first.</summary>
    public bool Closed { get; init; }

    /// <summary>How much of the opacity is left where the surface hides the line, 0 to 1.</summary>
    public double HiddenOpacity { get; init; }
}

/// <summary>Edges of the mesh drawn with their own colour: features, seams, boundary.</summary>
/// <param name="Edges">Edge indices.</param>
/// <param name="Color">Colour with opacity.</param>
/// <param name="Width">Width in pixels.</param>
public sealed record EdgeMarks(IReadOnlyList<int> Edges, Color Color, double Width = 3)
{
    /// <summary>How much of the opacity is left where the surface hides the edge, 0 to 1.</summary>
    public double HiddenOpacity { get; init; }
}

/// <summary>The shape of a mark at a point.</summary>
public enum MarkShape
{
    /// <summary>A lit ball, part of the scene.</summary>
    Sphere,

    /// <summary>A flat disc that faces the viewer.</summary>
    Disc,
}

/// <summary>Marks at points, such as critical points.</summary>
/// <param name="Points">Where.</param>
/// <param name="Color">Colour with opacity (balls are opaque).</param>
/// <param name="Size">Diameter in pixels.</param>
/// <param name="Shape">Ball or disc.</param>
public sealed record PointMarks(IReadOnlyList<Vector3D> Points, Color Color, double Size = 14, MarkShape Shape = MarkShape.Sphere);

/// <summary>A short text at a point of the model, such as <c>v12</c>.</summary>
/// <param name="Position">Where.</param>
/// <param name="Text">What.</param>
/// <param name="Color">Its colour.</param>
/// <param name="Size">The font's size in pixels.</param>
public sealed record TextLabel(Vector3D Position, string Text, Color Color, double Size = 14);

/// <summary>Everything that can be chosen about a picture of a mesh. The defaults make a calm figure for a textbook.</summary>
public sealed record RenderOptions
{
    /// <summary>Pixels per row, legend included; 1 to 16384.</summary>
    public int Width { get; init => field = Between(value, 1, 16384); } = 900;

    /// <summary>Rows; 1 to 16384.</summary>
    public int Height { get; init => field = Between(value, 1, 16384); } = 700;

    /// <summary>From where the model is seen.</summary>
    public View View { get; init => field = NotNull(value); } = new();

    /// <summary>How normals are chosen.</summary>
    public Shading Shading { get; init; } = Shading.Smooth;

    /// <summary>
    /// Degrees between face normals beyond which <see cref="Shading.Smooth"/> shows an edge; 180 smooths everything. If none is given,
    /// 40, and 60 for more than 30,000 triangles, where steps of that size are mostly the scanner's noise.
    /// </summary>
    public double? CreaseAngle
    {
        get;
        init => field = value is null or (>= 0 and <= 180)
            ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "An angle is 0 to 180 degrees.");
    }

    /// <summary>How the surface is coloured.</summary>
    public Coloring Coloring { get; init => field = NotNull(value); } = Coloring.Default;

    /// <summary>The tint of the surface's inner side.</summary>
    public Color BackFaceColor { get; init; } = new(0.72f, 0.47f, 0.40f);

    /// <summary>Whether faces are drawn; without them, lines and points are seen through.</summary>
    public bool Surface { get; init; } = true;

    /// <summary>Whether edges are drawn over the surface (线框).</summary>
    public bool Wireframe { get; init; }

    /// <summary>Colour and opacity of the wireframe; it fades by itself where edges are shorter than a few pixels.</summary>
    public Color WireframeColor { get; init; } = new(0.10f, 0.13f, 0.20f, 0.75f);

    /// <summary>Width of the wireframe in pixels.</summary>
    public double WireframeWidth { get; init => field = Positive(value); } = 1.1;

    /// <summary>Whether every vertex is drawn as a disc.</summary>
    public bool Vertices { get; init; }

    /// <summary>Colour of the vertices.</summary>
    public Color VertexColor { get; init; } = new(0.09f, 0.17f, 0.36f);

    /// <summary>Diameter of the vertices in pixels.</summary>
    public double VertexSize { get; init => field = Positive(value); } = 5;

    /// <summary>Edges drawn with their own colour.</summary>
    public IReadOnlyList<EdgeMarks> HighlightedEdges { get; init => field = NotNull(value); } = [];

    /// <summary>Chains of points drawn over the surface.</summary>
    public IReadOnlyList<Polyline> Polylines { get; init => field = NotNull(value); } = [];

    /// <summary>Marks at points.</summary>
    public IReadOnlyList<PointMarks> Points { get; init => field = NotNull(value); } = [];

    /// <summary>Short texts at points of the model; drawn last, never hidden.</summary>
    public IReadOnlyList<TextLabel> Labels { get; init => field = NotNull(value); } = [];

    /// <summary>A title at the top left.</summary>
    public string Title { get; init => field = NotNull(value); } = "";

    /// <summary>Whether a legend is drawn when the coloring has a title.</summary>
    public bool Legend { get; init; } = true;

    /// <summary>The background; a soft white if none is given, and an opacity below 1 makes it see-through.</summary>
    public Color? Background { get; init; }

    /// <summary>Whether the model throws a soft shadow on the ground under it.</summary>
    public bool GroundShadow { get; init; } = true;

    /// <summary>Whether hollows are darkened (环境光遮蔽).</summary>
    public bool AmbientOcclusion { get; init; } = true;

    /// <summary>Samples per pixel and axis against jagged edges, 1 to 4; lowered by itself for pictures of more than 50 million samples.</summary>
    public int Supersampling { get; init => field = Between(value, 1, 4); } = 3;

    /// <summary>How many threads may work; −1 for all. The picture's bits do not depend on it.</summary>
    public int MaxDegreeOfParallelism
    {
        get;
        init => field = value is -1 or > 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A number of threads is −1 or positive.");
    } = -1;

    internal double CreaseAngleFor(int triangles) => CreaseAngle ?? (triangles > 30_000 ? 60 : 40);

    private static int Between(int value, int low, int high) =>
        value >= low && value <= high ? value : throw new ArgumentOutOfRangeException(nameof(value), value, $"The value must be {low} to {high}.");

    private static double Positive(double value) =>
        value > 0 && value <= 1000 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The value must be above 0 and at most 1000 pixels.");

    private static T NotNull<T>(T value)
        where T : class
    {
        ArgumentNullException.ThrowIfNull(value);
        return value;
    }
}
