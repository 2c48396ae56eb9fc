using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>How far the vertex normals of one kind are from exact ones.</summary>
/// <param name="Weight">The kind.</param>
/// <param name="MeanError">The mean angle, in radians.</param>
/// <param name="RmsError">The root of the mean squared angle, in radians.</param>
/// <param name="MaxError">The largest angle, in radians.</param>
/// <param name="Compared">The number of vertices with a normal.</param>
public readonly record struct NormalError(VertexNormalWeight Weight, double MeanError, double RmsError, double MaxError, int Compared);

/// <summary>§10.4.5 比较: the four kinds of vertex normals beside the exact normals of an analytic surface (Jin, Lewis, West 2005).</summary>
public static class VertexNormalComparison
{
    /// <summary>Compares all four kinds. O(V + H).</summary>
    /// <param name="mesh">Vertices on the surface.</param>
    /// <param name="exactNormal">The outward normal of the surface at a point, of any length.</param>
    /// <returns>One entry per kind, in the order of the enumeration.</returns>
    public static IReadOnlyList<NormalError> Compare(Mesh mesh, Func<Vector3D, Vector3D> exactNormal)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(exactNormal);
        return [.. Enum.GetValues<VertexNormalWeight>().Select(weight => Compare(mesh, exactNormal, weight))];
    }

    private static NormalError Compare(Mesh mesh, Func<Vector3D, Vector3D> exactNormal, VertexNormalWeight weight)
    {
        Vector3D[] normals = mesh.ComputeVertexNormals(weight);
        double sum = 0, squares = 0, max = 0;
        int count = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            if (normals[v.index] == default)
                continue;
            double angle = Vector3D.Angle(normals[v.index], exactNormal(v.Position));
            sum += angle;
            squares += angle * angle;
            max = Math.Max(max, angle);
            count++;
        }
        return new(weight, sum / count, Math.Sqrt(squares / count), max, count);
    }
}
