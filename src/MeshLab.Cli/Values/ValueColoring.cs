using System.Globalization;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Cli.Values;

/// <summary>Colours and a legend for a named value.</summary>
internal static class ValueColoring
{
    private static readonly string[] AxisNames = ["x", "y", "z"];

    public static Coloring Of(Mesh mesh, MeshValue value, ValueOptions options)
    {
        if (value.Components == 3)
            return OfVectors(value, value.Vectors(mesh, options));
        double[] values = value.Scalars(mesh, options);
        return value.Mark.IsLabel ? OfLabels(mesh, value, values) : OfScalars(mesh, value, values);
    }

    private static Coloring OfScalars(Mesh mesh, MeshValue value, double[] values)
    {
        ColorMap map = value.Mark.Signed ? ColorMap.Coolwarm : ColorMap.Viridis;
        (string name, string unit) = (value.Mark.Name, value.Mark.Unit);
        Coloring coloring = value.Mark.Kind switch
        {
            ElementKind.Vertex => Coloring.VertexScalars(values, map, name, unit),
            ElementKind.Face => Coloring.FaceScalars(values, map, name, unit),
            ElementKind.Edge => Coloring.VertexScalars(MeanAtVertices(mesh, values), map, $"{name}, mean at vertices", unit),
            _ => Coloring.FaceScalars(SmallestInFaces(mesh, values), map, $"least {name}", unit),
        };
        coloring = coloring.WithoutOutliers();
        return value.Mark.Signed ? coloring.Symmetric() : coloring;
    }

    private static Coloring OfLabels(Mesh mesh, MeshValue value, double[] values)
    {
        if (value.Mark.Name == "valence")
            return Coloring.ByValence(mesh);
        int[] labels = Array.ConvertAll(values, v => double.IsNaN(v) ? -1 : (int)v);
        return value.Mark.Kind == ElementKind.Face
            ? Coloring.FaceLabels(labels, value.Mark.Name)
            : Coloring.VertexLabels(labels, value.Mark.Name, value.Mark.Name == "boundary" ? BoundaryEntries(labels) : null);
    }

    private static LegendEntry[] BoundaryEntries(int[] labels) =>
        [.. labels.Where(label => label >= 0).Distinct().Order().Select(label => new LegendEntry(label == 0 ? "inside" : "boundary", Palette.Categorical(label)))];

    /// <summary>Vectors as mixtures of red, green and blue for x, y and z: unit vectors from −1 to 1, lines by the size of their parts, points by their place in the box.</summary>
    private static Coloring OfVectors(MeshValue value, Vector3D[] vectors)
    {
        (Vector3D low, Vector3D high) = (new(-1, -1, -1), new(1, 1, 1));
        Func<Vector3D, Vector3D> shown = v => v;
        LegendEntry[] entries;
        if (value.Mark.Signed)
        {
            entries = [.. new[] { 1, -1 }.SelectMany(sign => AxisNames.Select((name, axis) => new LegendEntry($"{(sign > 0 ? '+' : '-')}{name}", Mix(sign * Axis(axis)))))];
        }
        else if (value.Mark.IsAxis)
        {
            (low, shown) = (default, v => new(Math.Abs(v.X), Math.Abs(v.Y), Math.Abs(v.Z)));
            entries = [.. AxisNames.Select((name, axis) => new LegendEntry($"along {name}", Mix(Axis(axis))))];
        }
        else
        {
            var box = BoundingBox.Of(vectors.Where(v => v.IsFinite).ToArray());
            (low, high) = (box.Min, box.Max);
            entries = [.. AxisNames.Select((name, axis) => new LegendEntry(
                string.Create(CultureInfo.InvariantCulture, $"{name}: {low[axis]:G4} to {high[axis]:G4}"), Mix(Corner(axis))))];
        }
        Color[] colors = Array.ConvertAll(vectors, v => v.IsFinite ? Mix(shown(v)) : ColorMap.NotANumber);
        return value.Mark.Kind == ElementKind.Face
            ? Coloring.FaceColors(colors, value.Mark.Name, entries)
            : Coloring.VertexColors(colors, value.Mark.Name, entries);

        Vector3D Corner(int axis) => new(axis == 0 ? high.X : low.X, axis == 1 ? high.Y : low.Y, axis == 2 ? high.Z : low.Z);

        Color Mix(Vector3D v) => new(Share(v.X, low.X, high.X), Share(v.Y, low.Y, high.Y), Share(v.Z, low.Z, high.Z));

        static float Share(double x, double from, double to) => to > from ? (float)Math.Clamp((x - from) / (to - from), 0, 1) : 0.5f;
    }

    private static Vector3D Axis(int axis) => new(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

    /// <summary>A picture has no colours on edges: each vertex shows the mean of its edges that have a value.</summary>
    private static double[] MeanAtVertices(Mesh mesh, double[] values)
    {
        var mean = new double[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            int count = 0;
            foreach (Edge e in v.Edges)
            {
                if (double.IsNaN(values[e.Index]))
                    continue;
                mean[v.Index] += values[e.Index];
                count++;
            }
            mean[v.Index] /= count;
        }
        return mean;
    }

    private static double[] SmallestInFaces(Mesh mesh, double[] values)
    {
        var least = new double[mesh.FaceSlots];
        foreach (Face f in mesh.Faces)
        {
            least[f.Index] = double.PositiveInfinity;
            foreach (HalfEdge h in f.HalfEdges)
                least[f.Index] = Math.Min(least[f.Index], values[h.Index]);
        }
        return least;
    }
}
