using MeshLab.Cli.Hosting;
using MeshLab.Geodesics;
using MeshLab.LinearAlgebra;
using MeshLab.Structure;

namespace MeshLab.Cli.Values;

/// <summary>Values that need a linear system or a search through the mesh.</summary>
internal static class SolverValues
{
    [MeshValue("harmonic", ElementKind.Vertex)]
    public static double[] Harmonic(Mesh mesh, ValueOptions options)
    {
        if (options.Fixed.Count == 0)
            return mesh.ComputeHarmonicHeight();
        return mesh.ComputeHarmonicFunction(
            [.. options.Fixed.Select(pair => (VertexAt(mesh, pair.Vertex), pair.Value))], new HarmonicOptions { AllowUndetermined = true });
    }

    [MeshValue("geodesic-edges", ElementKind.Vertex)]
    public static double[] EdgeDistances(Mesh mesh, ValueOptions options)
    {
        double[] distances = mesh.ComputeEdgeDistances(mesh.Vertices[options.Start(mesh)]);
        // Where nothing can be measured there is no value: vertices without edges.
        for (int v = 0; v < distances.Length; v++)
        {
            if (mesh.Outgoing[v] < 0)
                distances[v] = double.NaN;
        }
        return distances;
    }

    /// <summary>Distances over the surface by the heat method; geodesic-edges goes along the edges.</summary>
    [MeshValue("geodesic-heat", ElementKind.Vertex)]
    public static double[] HeatDistances(Mesh mesh, ValueOptions options) =>
        new HeatGeodesics(mesh).ComputeDistances(mesh.Vertices[options.Start(mesh)]);

    private static Vertex VertexAt(Mesh mesh, int index) => index < mesh.VertexSlots && !mesh.IsDeletedVertex(index)
        ? mesh.Vertices[index]
        : throw new UsageException($"--fixed {index}: the mesh has vertices 0 to {mesh.VertexSlots - 1}");
}
