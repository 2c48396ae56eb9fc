using MeshLab.Cli.Hosting;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Cli.Values;

/// <summary>Colours for a named value.</summary>
internal static class ValueColoring
{
    public static Coloring Of(Mesh mesh, MeshValue value, ValueOptions options)
    {
        if (value.Components != 1)
            throw new UsageException($"'{value.Mark.Name}' has three components; only values of one can be painted");
        double[] values = value.Scalars(mesh, options);
        Coloring coloring = value.Mark.Kind switch
        {
            ElementKind.Vertex => Coloring.VertexScalars(values, MapOf(value), value.Mark.Name, value.Mark.Unit),
            ElementKind.Face => Coloring.FaceScalars(values, MapOf(value), value.Mark.Name, value.Mark.Unit),
            ElementKind.Edge => Coloring.VertexScalars(MeanAtVertices(mesh, values), MapOf(value), value.Mark.Name, value.Mark.Unit),
            _ => Coloring.FaceScalars(SmallestInFaces(mesh, values), MapOf(value), $"least {value.Mark.Name}", value.Mark.Unit),
        };
        coloring = coloring.WithoutOutliers();
        return value.Mark.Signed ? coloring.Symmetric() : coloring;
    }

    private static ColorMap MapOf(MeshValue value) => value.Mark.Signed ? ColorMap.Coolwarm : ColorMap.Viridis;

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
