using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 补洞: fills holes by a fan, a fan around the centre, an advancing front, or the triangulation of minimum weight; refined and faired if wanted.</summary>
/// <remarks>
/// The mesh is a manifold before, after, and between any two holes: no chord is used that is an edge already, and a loop for which no way is left stays as
/// it was, with the reason in the report. Loops that touch, cross or knot in space are no special case for this. New vertices, edges and faces come after the old ones; nothing is renumbered.
/// </remarks>
public static class HoleFiller
{
    extension(Mesh mesh)
    {
        /// <summary>Fills every hole of the mesh, by the lowest vertex of its loop.</summary>
        /// <param name="options">How; chosen for each hole if not given.</param>
        /// <param name="progress">Told the share of loops done.</param>
        /// <param name="cancellationToken">Stops between holes, or while a triangulation is sought: holes filled by then stay filled.</param>
        public HoleFillingResult FillHoles(HoleFillingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new();
            int[] starts = [.. BoundaryLoops.LoopStarts(mesh).Select(h => LowestStart(mesh, h))];
            Array.Sort(starts, (a, b) => mesh.target[a ^ 1].CompareTo(mesh.target[b ^ 1]));
            var reports = new List<HoleReport>(starts.Length);
            int budget = options.MaxNewVertices;
            foreach (int start in starts)
            {
                cancellationToken.ThrowIfCancellationRequested();
                HoleReport report = Fill(mesh, start, options, budget, null, cancellationToken);
                budget -= report.VerticesAdded;
                reports.Add(report);
                progress?.Report((double)reports.Count / starts.Length);
            }
            return new(reports);
        }

        /// <summary>Fills one hole.</summary>
        /// <param name="boundary">A half-edge of its loop.</param>
        /// <param name="options">How; chosen for each hole if not given.</param>
        /// <param name="progress">Told how far the triangulation is.</param>
        /// <param name="cancellationToken">Stops while a triangulation is sought; the mesh is then as it was.</param>
        /// <exception cref="ArgumentException">The half-edge is none, deleted, of another mesh, or has a face; it is named.</exception>
        public HoleReport FillHole(HalfEdge boundary, HoleFillingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            mesh.CheckOwn(boundary, nameof(boundary));
            if (!boundary.IsBoundary)
                throw new ArgumentException($"{boundary} has the face {boundary.Face} and is no part of a hole's loop.", nameof(boundary));
            options ??= new();
            return Fill(mesh, LowestStart(mesh, boundary.index), options, options.MaxNewVertices, progress, cancellationToken);
        }
    }

    private static int LowestStart(Mesh mesh, int start)
    {
        int lowest = start;
        for (int h = mesh.next[start]; h != start; h = mesh.next[h])
        {
            if (mesh.target[h ^ 1] < mesh.target[lowest ^ 1])
                lowest = h;
        }
        return lowest;
    }

    private static HoleReport Fill(Mesh mesh, int start, HoleFillingOptions options, int budget, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var loop = new HoleLoop(mesh, start);
        HoleRefusal why = Triangulate(loop, options, budget, progress, cancellationToken, out List<int> triangles, out HoleFillingMethod method);
        if (why != HoleRefusal.None)
            return new(loop.Vertices[0], loop.Count, false, why, method, 0, 0);

        bool choose = options.Method == HoleFillingMethod.Automatic && !options.Refine && !options.Fair && method == HoleFillingMethod.MinimumWeight;
        int continuity = choose ? FillingTrial.Choose(loop, cancellationToken) : options.Fair ? options.Continuity : FillingTrial.Flat;
        bool refine = choose ? continuity != FillingTrial.Flat : options.Refine;
        int firstFace = mesh.FaceSlots;
        using OperationScope operation = mesh.BeginOperation(OperationKind.AddFace, firstFace);
        HolePatch patch = HolePatch.Insert(loop, triangles, method == HoleFillingMethod.Centroid ? [Mean(loop.Points)] : [], refine);
        if (refine)
            patch.Refine(budget - patch.NewVertices);
        bool faired = continuity != FillingTrial.Flat && patch.Fair(continuity);
        operation.Complete();
        return new(loop.Vertices[0], loop.Count, true, HoleRefusal.None, method, mesh.FaceSlots - firstFace, patch.NewVertices, faired ? continuity : null);
    }

    private static HoleRefusal Triangulate(
        HoleLoop loop, HoleFillingOptions options, int budget, IProgress<double>? progress, CancellationToken cancellationToken, out List<int> triangles, out HoleFillingMethod method)
    {
        triangles = [];
        method = options.Method == HoleFillingMethod.Automatic ? HoleFillingMethod.MinimumWeight : options.Method;
        if (loop.Count > options.MaxEdges)
            return HoleRefusal.TooManyEdges;
        if (method == HoleFillingMethod.MinimumWeight && loop.Count > options.MaxEdgesForMinimumWeight)
            method = HoleFillingMethod.Ear;
        List<int>? found = method switch
        {
            HoleFillingMethod.Fan => FanTriangulation.FromVertex(loop),
            HoleFillingMethod.Ear => EarTriangulation.Triangulate(loop, cancellationToken),
            HoleFillingMethod.MinimumWeight => MinimumWeightTriangulation.Triangulate(loop, options.Weight, progress, cancellationToken),
            _ => null,
        };
        // Where the loop's own chords do not suffice, a new vertex in the middle always does.
        if (found is null && options.Method is HoleFillingMethod.MinimumWeight or HoleFillingMethod.Automatic)
            method = HoleFillingMethod.Centroid;
        if (method == HoleFillingMethod.Centroid)
        {
            if (budget < 1)
                return HoleRefusal.VertexBudget;
            found = FanTriangulation.AroundCenter(loop);
        }
        if (found is null)
            return HoleRefusal.NoTriangulation;
        triangles = found;
        return HoleRefusal.None;
    }

    private static Vector3D Mean(Vector3D[] points)
    {
        Vector3D sum = default;
        foreach (Vector3D p in points)
            sum += p - points[0];
        return points[0] + sum / points.Length;
    }
}
