using System.Numerics;

namespace MeshLab.Visualization;

/// <summary>A <see cref="Coloring"/> made ready for millions of look-ups: the light of each vertex or face, or the number and a table.</summary>
internal sealed class SurfaceColors
{
    private const int TableSize = 1024;

    private readonly RenderGeometry geometry;
    private readonly Coloring coloring;
    private readonly Vector3[] lights;
    private readonly float[] values;
    private readonly Vector3 notANumber = Oklab.ToLinear(ColorMap.NotANumber);

    /// <summary>Prepares the coloring, which must fit the geometry.</summary>
    public SurfaceColors(RenderGeometry geometry, Coloring coloring)
    {
        this.geometry = geometry;
        this.coloring = coloring;
        values = coloring.Values is { } numbers ? [.. numbers.Select(v => (float)coloring.Normalize(v))] : [];
        lights = coloring switch
        {
            { Values: not null } => Table(coloring.Map),
            { Labels: { } labels } => LabelLights(labels, coloring.LabelColor),
            { Colors: { } colors } => [.. colors.Select(Oklab.ToLinear)],
            _ => [Oklab.ToLinear(coloring.Color)],
        };
    }

    /// <summary>Whether <see cref="ScalarAt"/> is to be called and mapped.</summary>
    public bool HasIsolines => coloring is { Kind: ColoringKind.VertexScalars, Isolines: > 0 };

    /// <summary>The light of the surface at a point of a triangle, before shading.</summary>
    /// <param name="t">The triangle.</param>
    /// <param name="weights">Barycentric coordinates.</param>
    public Vector3 At(int t, Vector3 weights)
    {
        int[] corners = geometry.Triangles;
        switch (coloring.Kind)
        {
            case ColoringKind.VertexScalars:
                return OfScalar(ScalarAt(t, weights));
            case ColoringKind.FaceScalars:
                return OfScalar(values[geometry.FaceOfTriangle[t]]);
            case ColoringKind.FaceLabels or ColoringKind.FaceColors:
                return lights[geometry.FaceOfTriangle[t]];
            case ColoringKind.VertexColors:
                return lights[corners[3 * t]] * weights.X + lights[corners[3 * t + 1]] * weights.Y + lights[corners[3 * t + 2]] * weights.Z;
            case ColoringKind.VertexLabels:
                int nearest = weights.X >= weights.Y && weights.X >= weights.Z ? 0 : weights.Y >= weights.Z ? 1 : 2;
                return lights[corners[3 * t + nearest]];
            default:
                return lights[0];
        }
    }

    /// <summary>The number at a point of a triangle on the map's range 0 to 1.</summary>
    public float ScalarAt(int t, Vector3 weights) =>
        values[geometry.Triangles[3 * t]] * weights.X + values[geometry.Triangles[3 * t + 1]] * weights.Y + values[geometry.Triangles[3 * t + 2]] * weights.Z;

    private Vector3 OfScalar(float value) =>
        float.IsNaN(value) ? notANumber : lights[Math.Clamp((int)(value * (TableSize - 1) + 0.5f), 0, TableSize - 1)];

    private static Vector3[] Table(ColorMap map)
    {
        var table = new Vector3[TableSize];
        for (int i = 0; i < TableSize; i++)
            table[i] = Oklab.ToLinear(map.Sample(i / (TableSize - 1.0)));
        return table;
    }

    private static Vector3[] LabelLights(IReadOnlyList<int> labels, Func<int, MeshLab.Numerics.Color> color)
    {
        var known = new Dictionary<int, Vector3>();
        var lights = new Vector3[labels.Count];
        for (int i = 0; i < lights.Length; i++)
        {
            if (!known.TryGetValue(labels[i], out lights[i]))
                known[labels[i]] = lights[i] = Oklab.ToLinear(color(labels[i]));
        }
        return lights;
    }
}
