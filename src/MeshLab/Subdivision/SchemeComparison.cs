using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>What a scheme made of a mesh.</summary>
/// <param name="Scheme">The scheme.</param>
/// <param name="Mesh">The result.</param>
/// <param name="Area">Its area, in squared units of length.</param>
/// <param name="Volume">Its signed volume; of an open mesh it depends on the origin.</param>
/// <param name="Bend">The root mean square of the angles between the normals of neighbouring faces, in radians: the less, the smoother.</param>
/// <param name="DistanceToLimit">The largest distance of an interior vertex from where it ends up after infinitely many steps; 0 for interpolating schemes, NaN where it is not known.</param>
/// <param name="Shrinkage">The largest distance of an interior old vertex's limit from its place in the input; NaN where it is not known.</param>
public sealed record SchemeResult(
    SubdivisionScheme Scheme, Mesh Mesh, double Area, double Volume, double Bend, double DistanceToLimit, double Shrinkage);

/// <summary>§8.4 效果比较 (comparison): the schemes side by side on one mesh.</summary>
public static class SchemeComparison
{
    /// <summary>Subdivides with each scheme and measures the results.</summary>
    /// <param name="mesh">Triangles, if a scheme wants them.</param>
    /// <param name="steps">How often.</param>
    /// <param name="schemes">Which; if none are named, Loop, modified butterfly and √3 as in the book.</param>
    /// <exception cref="ArgumentException">As of the schemes.</exception>
    public static IReadOnlyList<SchemeResult> Compare(Mesh mesh, int steps = 2, params SubdivisionScheme[] schemes)
    {
        ArgumentNullException.ThrowIfNull(schemes);
        return Compare(mesh, steps, (IReadOnlyList<SubdivisionScheme>)schemes, null, CancellationToken.None);
    }

    /// <summary>Subdivides with each scheme and measures the results.</summary>
    /// <param name="mesh">Triangles, if a scheme wants them.</param>
    /// <param name="steps">How often.</param>
    /// <param name="schemes">Which; if none are named, Loop, modified butterfly and √3 as in the book.</param>
    /// <param name="progress">Told the part of the schemes that is done.</param>
    /// <param name="cancellationToken">Ends the work.</param>
    /// <exception cref="ArgumentException">As of the schemes.</exception>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    public static IReadOnlyList<SchemeResult> Compare(
        Mesh mesh, int steps, IReadOnlyList<SubdivisionScheme> schemes, IProgress<double>? progress, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(schemes);
        ArgumentOutOfRangeException.ThrowIfNegative(steps);
        mesh = Stepper.Compacted(mesh);
        if (schemes.Count == 0)
            schemes = [SubdivisionScheme.Loop, SubdivisionScheme.ModifiedButterfly, SubdivisionScheme.Sqrt3];
        var results = new List<SchemeResult>(schemes.Count);
        foreach (SubdivisionScheme scheme in schemes)
        {
            results.Add(Measure(mesh, scheme, steps, cancellationToken));
            progress?.Report((double)results.Count / schemes.Count);
        }
        return results;
    }

    private static SchemeResult Measure(Mesh mesh, SubdivisionScheme scheme, int steps, CancellationToken cancellationToken)
    {
        Mesh finer = mesh.Subdivide(scheme, new SubdivisionOptions { Steps = steps }, null, cancellationToken);
        double area = 0, volume = 0;
        var normals = new Vector3D[finer.FaceSlots];
        foreach (Face f in finer.Faces)
        {
            HalfEdge first = f.HalfEdge;
            Vector3D origin = first.Source.Position;
            for (HalfEdge h = first.Next; h.Next != first; h = h.Next)
            {
                normals[f.Index] += 0.5 * Vector3D.Cross(h.Source.Position - origin, h.Target.Position - origin);
                volume += Vector3D.Determinant(origin, h.Source.Position, h.Target.Position) / 6;
            }
            area += normals[f.Index].Length;
        }
        return new(
            scheme, finer, area, volume, Bend(finer, normals),
            LargestDistance(finer, Limit(finer, scheme, cancellationToken), finer.VertexSlots), LargestDistance(mesh, Limit(mesh, scheme, cancellationToken), mesh.VertexSlots));
    }

    private static double Bend(Mesh mesh, Vector3D[] normals)
    {
        double sum = 0;
        int edges = 0;
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary)
                continue;
            double angle = Vector3D.Angle(normals[e.Face0.Index], normals[e.Face1.Index]);
            sum += angle * angle;
            edges++;
        }
        return edges == 0 ? 0 : Math.Sqrt(sum / edges);
    }

    private static Vector3D[]? Limit(Mesh mesh, SubdivisionScheme scheme, CancellationToken cancellationToken) => scheme switch
    {
        SubdivisionScheme.Loop => LimitSurface.OfLoop(mesh, cancellationToken: cancellationToken).Positions,
        SubdivisionScheme.CatmullClark => LimitSurface.OfCatmullClark(mesh, cancellationToken: cancellationToken).Positions,
        SubdivisionScheme.Sqrt3 => Sqrt3Limit(mesh),
        SubdivisionScheme.ModifiedButterfly or SubdivisionScheme.Midpoint => mesh.Positions.ToArray(),
        _ => null,
    };

    /// <summary>(v + 3α m)/(1 + 3α), m the mean of the neighbours: the left eigenvector of √3's matrix (Kobbelt 2000, §4).</summary>
    private static Vector3D[] Sqrt3Limit(Mesh mesh)
    {
        Vector3D[] limit = mesh.Positions.ToArray();
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated || v.IsBoundary)
                continue;
            Vector3D sum = default;
            int valence = 0;
            foreach (Vertex w in v.Neighbors)
            {
                sum += w.Position;
                valence++;
            }
            double alpha = Sqrt3Subdivision.NeighborWeight(valence);
            limit[v.Index] = (v.Position + 3 * alpha / valence * sum) / (1 + 3 * alpha);
        }
        return limit;
    }

    private static double LargestDistance(Mesh mesh, Vector3D[]? limit, int count)
    {
        if (limit is null)
            return double.NaN;
        double largest = 0;
        for (int v = 0; v < count; v++)
        {
            if (!mesh.Vertices[v].IsBoundary)
                largest = Math.Max(largest, Vector3D.Distance(mesh.Positions[v], limit[v]));
        }
        return largest;
    }
}
