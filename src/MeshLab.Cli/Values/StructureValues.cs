using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cli.Values;

/// <summary>Values that the structure alone knows.</summary>
internal static class StructureValues
{
    [MeshValue("valence", ElementKind.Vertex, IsLabel = true)]
    public static double[] Valence(Mesh mesh, ValueOptions options) => PerVertex(mesh, v => v.Valence);

    [MeshValue("boundary", ElementKind.Vertex, IsLabel = true)]
    public static double[] Boundary(Mesh mesh, ValueOptions options) => PerVertex(mesh, v => v.IsBoundary ? 1 : 0);

    [MeshValue("length", ElementKind.Edge)]
    public static double[] Length(Mesh mesh, ValueOptions options)
    {
        var values = new double[mesh.EdgeSlots];
        Array.Fill(values, double.NaN);
        foreach (Edge e in mesh.Edges)
            values[e.Index] = e.Length;
        return values;
    }

    /// <summary>The straight distance from the vertex that --from names; geodesic-edges goes along the surface.</summary>
    [MeshValue("distance", ElementKind.Vertex)]
    public static double[] Distance(Mesh mesh, ValueOptions options)
    {
        Vector3D from = mesh.Vertices[options.Start(mesh)].Position;
        return PerVertex(mesh, v => Vector3D.Distance(v.Position, from));
    }

    private static double[] PerVertex(Mesh mesh, Func<Vertex, double> value)
    {
        var values = new double[mesh.VertexSlots];
        Array.Fill(values, double.NaN);
        foreach (Vertex v in mesh.Vertices)
        {
            if (!v.IsIsolated)
                values[v.Index] = value(v);
        }
        return values;
    }
}
