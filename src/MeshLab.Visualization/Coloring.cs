using System.Globalization;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Visualization;

/// <summary>What a <see cref="Coloring"/> gives colours to.</summary>
public enum ColoringKind
{
    /// <summary>One colour for the whole surface.</summary>
    Uniform,

    /// <summary>A number per vertex; between vertices the number is interpolated, then mapped to a colour.</summary>
    VertexScalars,

    /// <summary>A number per face.</summary>
    FaceScalars,

    /// <summary>A label per vertex, painted around it.</summary>
    VertexLabels,

    /// <summary>A label per face.</summary>
    FaceLabels,

    /// <summary>A colour per vertex, interpolated.</summary>
    VertexColors,

    /// <summary>A colour per face.</summary>
    FaceColors,
}

/// <summary>One entry of a legend of labels.</summary>
/// <param name="Name">What stands beside the colour.</param>
/// <param name="Color">The colour.</param>
public readonly record struct LegendEntry(string Name, Color Color);

/// <summary>
/// How a surface is coloured. Arrays are indexed by element slot: vertex or face index of the mesh, deleted ones included. Arrays are not copied.
/// </summary>
public sealed record Coloring
{
    private Coloring(ColoringKind kind) => Kind = kind;

    /// <summary>What is coloured.</summary>
    public ColoringKind Kind { get; }

    /// <summary>The colour of <see cref="ColoringKind.Uniform"/>.</summary>
    public Color Color { get; private init; }

    /// <summary>The numbers of the scalar kinds; NaN is painted neutral grey and noted in the legend.</summary>
    public IReadOnlyList<double>? Values { get; private init; }

    /// <summary>The labels of the label kinds.</summary>
    public IReadOnlyList<int>? Labels { get; private init; }

    /// <summary>The colours of the colour kinds.</summary>
    public IReadOnlyList<Color>? Colors { get; private init; }

    /// <summary>The map from numbers to colours.</summary>
    public ColorMap Map { get; private init; } = ColorMap.Viridis;

    /// <summary>The legend's title; no legend is drawn where it is empty.</summary>
    public string Title { get; private init; } = "";

    /// <summary>The unit of the numbers, shown after the title.</summary>
    public string Unit { get; private init; } = "";

    /// <summary>The number at the lower end of the map.</summary>
    public double Minimum { get; private init; }

    /// <summary>The number at the upper end of the map.</summary>
    public double Maximum { get; private init; } = 1;

    /// <summary>How many lines of equal value are drawn over a per-vertex scalar; 0 for none.</summary>
    public int Isolines { get; private init; }

    /// <summary>The legend of a label or colour kind; empty for one that is made of the labels themselves.</summary>
    public IReadOnlyList<LegendEntry> Entries { get; private init; } = [];

    internal Func<int, Color> LabelColor { get; private init; } = Palette.Categorical;

    /// <summary>The default surface: one light, slightly warm grey.</summary>
    public static Coloring Default { get; } = Uniform(new Color(0.75f, 0.795f, 0.865f));

    /// <summary>One colour for the whole surface.</summary>
    public static Coloring Uniform(Color color) => new(ColoringKind.Uniform) { Color = color };

    /// <summary>A number per vertex, by default from the smallest to the largest finite value.</summary>
    /// <param name="values">By vertex index.</param>
    /// <param name="map">The colour map; <see cref="ColorMap.Viridis"/> if left out.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="unit">The unit shown after the title.</param>
    public static Coloring VertexScalars(IReadOnlyList<double> values, ColorMap? map = null, string title = "", string unit = "") =>
        Scalars(ColoringKind.VertexScalars, values, map, title, unit);

    /// <summary>A number per face, by default from the smallest to the largest finite value.</summary>
    /// <param name="values">By face index.</param>
    /// <param name="map">The colour map; <see cref="ColorMap.Viridis"/> if left out.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="unit">The unit shown after the title.</param>
    public static Coloring FaceScalars(IReadOnlyList<double> values, ColorMap? map = null, string title = "", string unit = "") =>
        Scalars(ColoringKind.FaceScalars, values, map, title, unit);

    /// <summary>A label per face, such as the segment it belongs to; negative is none.</summary>
    /// <param name="labels">By face index.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="entries">The legend; made of the labels that occur if left out.</param>
    public static Coloring FaceLabels(IReadOnlyList<int> labels, string title = "", IReadOnlyList<LegendEntry>? entries = null) =>
        Labelled(ColoringKind.FaceLabels, labels, title, entries, Palette.Categorical);

    /// <summary>A label per vertex, painted on all points that are closest to it; negative is none.</summary>
    /// <param name="labels">By vertex index.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="entries">The legend; made of the labels that occur if left out.</param>
    /// <param name="color">The colour of a label; <see cref="Palette.Categorical"/> if left out.</param>
    public static Coloring VertexLabels(
        IReadOnlyList<int> labels, string title = "", IReadOnlyList<LegendEntry>? entries = null, Func<int, Color>? color = null) =>
        Labelled(ColoringKind.VertexLabels, labels, title, entries, color ?? Palette.Categorical);

    /// <summary>A colour per vertex, interpolated between them.</summary>
    /// <param name="colors">By vertex index.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="entries">The legend.</param>
    public static Coloring VertexColors(IReadOnlyList<Color> colors, string title = "", IReadOnlyList<LegendEntry>? entries = null) =>
        Coloured(ColoringKind.VertexColors, colors, title, entries);

    /// <summary>A colour per face.</summary>
    /// <param name="colors">By face index.</param>
    /// <param name="title">The legend's title; without one there is no legend.</param>
    /// <param name="entries">The legend.</param>
    public static Coloring FaceColors(IReadOnlyList<Color> colors, string title = "", IReadOnlyList<LegendEntry>? entries = null) =>
        Coloured(ColoringKind.FaceColors, colors, title, entries);

    /// <summary>
    /// The valence (度数) of each vertex: near white where it is regular (6 in a triangle mesh, else 4), bluer below, redder above.
    /// </summary>
    public static Coloring ByValence(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        int regular = mesh.IsTriangleMesh ? 6 : 4;
        var valences = new int[mesh.VertexSlots];
        Array.Fill(valences, -1);
        foreach (Vertex v in mesh.Vertices)
            valences[v.Index] = v.Valence;
        // The palette has no further colours beyond three from the regular valence: those share one entry.
        int most = valences.DefaultIfEmpty(0).Max(), fewest = valences.Where(k => k >= 0).DefaultIfEmpty(0).Min();
        LegendEntry[] entries = [.. valences.Where(k => k >= 0).Select(k => Math.Clamp(k, regular - 3, regular + 3)).Distinct().Order()
            .Select(k => new LegendEntry(Name(k), Palette.Valence(k, regular)))];
        return VertexLabels(valences, "valence", entries, k => k < 0 ? ColorMap.NotANumber : Palette.Valence(k, regular));

        string Name(int valence)
        {
            bool more = valence == regular + 3 && most > valence, fewer = valence == regular - 3 && fewest < valence;
            return (more ? "≥ " : fewer ? "≤ " : "") + valence.ToString(CultureInfo.InvariantCulture);
        }
    }

    /// <summary>The same with another range of numbers; values outside take the end's colour.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A bound is not finite, or the upper is not above the lower.</exception>
    public Coloring WithRange(double minimum, double maximum)
    {
        if (!double.IsFinite(minimum))
            throw new ArgumentOutOfRangeException(nameof(minimum), minimum, "The lower end must be a finite number.");
        if (!double.IsFinite(maximum) || maximum <= minimum)
            throw new ArgumentOutOfRangeException(nameof(maximum), maximum, "The upper end must be a finite number above the lower one.");
        return this with { Minimum = minimum, Maximum = maximum };
    }

    /// <summary>
    /// The same with a range that leaves out a share of the values at both ends, so that a few outliers do not wash out the picture.
    /// </summary>
    /// <param name="share">The share left out at each end, at least 0 and below 0.5.</param>
    public Coloring WithoutOutliers(double share = 0.01)
    {
        if (!(share >= 0 && share < 0.5))
            throw new ArgumentOutOfRangeException(nameof(share), share, "A share is at least 0 and below 0.5.");
        double[] sorted = FiniteValues();
        if (sorted.Length == 0)
            return this;
        Array.Sort(sorted);
        double low = sorted[(int)(share * (sorted.Length - 1))], high = sorted[(int)Math.Ceiling((1 - share) * (sorted.Length - 1))];
        return high > low ? this with { Minimum = low, Maximum = high } : this;
    }

    /// <summary>The same with the range made symmetric around 0, as diverging maps want it.</summary>
    public Coloring Symmetric()
    {
        double bound = Math.Max(Math.Abs(Minimum), Math.Abs(Maximum));
        return bound > 0 ? this with { Minimum = -bound, Maximum = bound } : this;
    }

    /// <summary>The same with lines of equal value (等值线) over a per-vertex scalar.</summary>
    /// <param name="count">How many parts the range is cut into; 0 for no lines.</param>
    public Coloring WithIsolines(int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        return this with { Isolines = count };
    }

    /// <summary>How many values of the scalar kinds are NaN or infinite.</summary>
    public int CountNonFinite()
    {
        int count = 0;
        foreach (double value in Values ?? [])
        {
            if (!double.IsFinite(value))
                count++;
        }
        return count;
    }

    /// <summary>Where a value lies on the map, 0 to 1; NaN stays NaN.</summary>
    internal double Normalize(double value) => double.IsFinite(value) ? Math.Clamp((value - Minimum) / (Maximum - Minimum), 0, 1) : double.NaN;

    /// <summary>Throws if an array does not fit the mesh.</summary>
    internal void Check(int vertexSlots, int faceSlots, string parameter)
    {
        int have = Values?.Count ?? Labels?.Count ?? Colors?.Count ?? 0;
        bool perVertex = Kind is ColoringKind.VertexScalars or ColoringKind.VertexLabels or ColoringKind.VertexColors;
        int need = Kind == ColoringKind.Uniform ? 0 : perVertex ? vertexSlots : faceSlots;
        if (have != need)
        {
            throw new ArgumentException(
                $"The coloring has {have} entries, but the mesh has {need} {(perVertex ? "vertices" : "faces")} (deleted ones counted).", parameter);
        }
    }

    private static Coloring Scalars(ColoringKind kind, IReadOnlyList<double> values, ColorMap? map, string title, string unit)
    {
        ArgumentNullException.ThrowIfNull(values);
        ArgumentNullException.ThrowIfNull(title);
        ArgumentNullException.ThrowIfNull(unit);
        double low = double.PositiveInfinity, high = double.NegativeInfinity;
        foreach (double value in values)
        {
            if (!double.IsFinite(value))
                continue;
            low = Math.Min(low, value);
            high = Math.Max(high, value);
        }
        if (!(low <= high))
            (low, high) = (0, 1);
        // A constant still needs a range of some width; around it, so that it takes the middle of the map.
        if (!(high - low > 1e-12 * Math.Max(Math.Abs(low), Math.Abs(high))))
        {
            double pad = low == 0 ? 0.5 : Math.Abs(low) * 0.05;
            (low, high) = (low - pad, high + pad);
        }
        return new(kind) { Values = values, Map = map ?? ColorMap.Viridis, Title = title, Unit = unit, Minimum = low, Maximum = high };
    }

    private static Coloring Labelled(
        ColoringKind kind, IReadOnlyList<int> labels, string title, IReadOnlyList<LegendEntry>? entries, Func<int, Color> color)
    {
        ArgumentNullException.ThrowIfNull(labels);
        ArgumentNullException.ThrowIfNull(title);
        return new(kind) { Labels = labels, Title = title, Entries = entries ?? [], LabelColor = color };
    }

    private static Coloring Coloured(ColoringKind kind, IReadOnlyList<Color> colors, string title, IReadOnlyList<LegendEntry>? entries)
    {
        ArgumentNullException.ThrowIfNull(colors);
        ArgumentNullException.ThrowIfNull(title);
        return new(kind) { Colors = colors, Title = title, Entries = entries ?? [] };
    }

    private double[] FiniteValues() => (Values ?? []).Where(double.IsFinite).ToArray();
}
