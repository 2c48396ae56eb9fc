using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Where the vertices of a mesh end up after infinitely many steps, and the limit surface's normals there.</summary>
/// <param name="Positions">Per vertex slot.</param>
/// <param name="Normals">Per vertex slot, of length 1; zero where there is none: isolated vertices, creases and corners.</param>
public sealed record LimitPoints(Vector3D[] Positions, Vector3D[] Normals);

/// <summary>§8.1 极限位置与极限法向 (limit positions and normals) of Loop's and Catmull and Clark's schemes, from the left eigenvectors of the subdivision matrix.</summary>
/// <remarks>
/// Loop, interior: (ω v + Σ pᵢ)/(ω + n) with ω = 3/(8β); tangents Σ cos(2πi/n) pᵢ and Σ sin(2πi/n) pᵢ. Catmull–Clark, after one step (then all faces are
/// quadrilaterals): (n² v + 4 Σ eᵢ + Σ fᵢ)/(n(n + 5)); tangents after Halstead, Kass, DeRose 1993. Boundary and creases: (1, 4, 1)/6 along them, the limit of
/// cubic B-splines; corners stay. O(V + E).
/// </remarks>
public static class LimitSurface
{
    private const int VerticesPerCheck = 4096;

    /// <summary>The limit of Loop's scheme. The mesh is not changed.</summary>
    /// <param name="mesh">Triangles.</param>
    /// <param name="weights">Loop's or Warren's.</param>
    /// <param name="progress">Told the part done, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the work; nothing is returned then.</param>
    /// <exception cref="ArgumentException">A face is not a triangle, or an edge has a finite sharpness: subdivide until it is used up.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static LimitPoints OfLoop(
        Mesh mesh, LoopWeights weights = LoopWeights.Loop1987, IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
        OfLoop(mesh, weights, true, progress, cancellationToken);

    internal static LimitPoints OfLoop(Mesh mesh, LoopWeights weights, bool useCreases, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        Stepper.RequireTriangles(mesh);
        EdgeTrait<double>? sharpness = useCreases ? SharpnessOf(mesh) : null;
        var limit = new LimitPoints(mesh.Positions.ToArray(), new Vector3D[mesh.VertexSlots]);
        int done = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            Check(done++, mesh, progress, cancellationToken);
            if (v.IsIsolated || AtCrease(v, sharpness, limit))
                continue;
            if (v.IsBoundary)
                LoopBoundary(v, limit);
            else
                LoopInterior(v, weights, limit);
        }
        progress?.Report(1);
        return limit;
    }

    /// <summary>The limit of Catmull and Clark's scheme. The mesh is not changed.</summary>
    /// <param name="mesh">Any faces.</param>
    /// <param name="progress">Told the part done, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the work; nothing is returned then.</param>
    /// <exception cref="ArgumentException">An edge has a finite sharpness: subdivide until it is used up.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static LimitPoints OfCatmullClark(Mesh mesh, IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
        OfCatmullClark(mesh, true, progress, cancellationToken);

    internal static LimitPoints OfCatmullClark(Mesh mesh, bool useCreases, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (useCreases)
            SharpnessOf(mesh);
        Mesh compact = Stepper.Compacted(mesh);
        // Isolated and deleted vertices have no place in the finer mesh's order but keep their position.
        Mesh finer = CatmullClarkSubdivision.Subdivide(compact, new SubdivisionOptions { UseCreases = useCreases }, null, cancellationToken);
        EdgeTrait<double>? sharpness = useCreases ? SharpnessOf(finer) : null;
        var ofFiner = new LimitPoints(finer.Positions.ToArray(), new Vector3D[finer.VertexSlots]);
        var limit = new LimitPoints(mesh.Positions.ToArray(), new Vector3D[mesh.VertexSlots]);
        int number = 0;
        foreach (Vertex original in mesh.Vertices)
        {
            Check(number, mesh, progress, cancellationToken);
            Vertex v = finer.Vertices[number++];
            if (v.IsIsolated)
                continue;
            if (!AtCrease(v, sharpness, ofFiner))
            {
                if (v.IsBoundary)
                    CatmullClarkBoundary(v, ofFiner);
                else
                    CatmullClarkInterior(v, ofFiner);
            }
            limit.Positions[original.Index] = ofFiner.Positions[v.Index];
            limit.Normals[original.Index] = ofFiner.Normals[v.Index];
        }
        progress?.Report(1);
        return limit;
    }

    private static void Check(int done, Mesh mesh, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        if (done % VerticesPerCheck != 0)
            return;
        cancellationToken.ThrowIfCancellationRequested();
        progress?.Report((double)done / mesh.Vertices.Count);
    }

    private static EdgeTrait<double>? SharpnessOf(Mesh mesh)
    {
        if (Creases.SharpnessOf(mesh) is not { } sharpness)
            return null;
        foreach (Edge e in mesh.Edges)
        {
            if (sharpness[e] > 0 && double.IsFinite(sharpness[e]))
                throw new ArgumentException($"{e} has the sharpness {sharpness[e]}; the limit is known for 0 and ∞ only.", nameof(mesh));
        }
        return sharpness;
    }

    /// <summary>Places a vertex on a crease or corner; whether it is one.</summary>
    private static bool AtCrease(Vertex v, EdgeTrait<double>? sharpness, LimitPoints limit)
    {
        if (sharpness is null)
            return false;
        CreaseVertex crease = CreaseVertex.Of(v, sharpness);
        if (crease.Count < 2 || (crease.Count == 2 && v.IsBoundary))
            return false;
        limit.Positions[v.Index] = crease.Count > 2 ? v.Position : OnCurve(v.Position, crease.Ends);
        return true;
    }

    /// <summary>The limit of a cubic B-spline: (1, 4, 1)/6.</summary>
    private static Vector3D OnCurve(Vector3D v, Vector3D ends) => 2.0 / 3 * v + 1.0 / 6 * ends;

    private static void LoopInterior(Vertex v, LoopWeights weights, LimitPoints limit)
    {
        int n = v.Valence, i = 0;
        Vector3D sum = default, cosines = default, sines = default;
        foreach (Vertex w in v.Neighbors)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i++ / n);
            sum += w.Position;
            cosines += cos * w.Position;
            sines += sin * w.Position;
        }
        double omega = 3 / (8 * LoopSubdivision.NeighborWeight(n, weights));
        limit.Positions[v.Index] = (omega * v.Position + sum) / (omega + n);
        limit.Normals[v.Index] = Vector3D.Cross(cosines, sines).Normalized();
    }

    /// <summary>
    /// Left eigenvectors of the boundary vertex's matrix have the entries sin jθ at the inner neighbours, θ = π/k for k triangles or 2π/k, with the
    /// eigenvalue λ = 3/8 + ¼ cos θ. For more than six triangles the second of them outweighs the boundary's own tangent (λ = ½).
    /// </summary>
    private static void LoopBoundary(Vertex v, LimitPoints limit)
    {
        Vertex[] ring = v.Neighbors.ToArray();
        int k = ring.Length - 1;
        Vector3D along = k <= 6 ? ring[0].Position - ring[k].Position : Mode(2);
        Vector3D across = k == 1 ? ring[0].Position + ring[1].Position - 2 * v.Position : Mode(1);
        limit.Positions[v.Index] = OnCurve(v.Position, ring[0].Position + ring[k].Position);
        limit.Normals[v.Index] = Vector3D.Cross(along, across).Normalized();

        Vector3D Mode(int m)
        {
            double theta = m * Math.PI / k, lambda = 0.375 + 0.25 * Math.Cos(theta), total = 0;
            Vector3D inner = default;
            for (int j = 1; j < k; j++)
            {
                double sin = Math.Sin(j * theta);
                total += sin;
                inner += sin * ring[j].Position;
            }
            return inner + Ends(m, lambda, Math.Sin(theta) / 8, 0.375 * total, ring[0].Position, ring[k].Position, v.Position);
        }
    }

    /// <summary>
    /// The rest of a boundary eigenvector: u at the outer neighbours and w at the vertex. For m = 1 (the same u at both ends) from (λ − ½) u − w/8 = r and
    /// (λ − ¾) w − u = s; for m = 2 (opposite signs) w = 0 and (λ − ½) u = r.
    /// </summary>
    private static Vector3D Ends(int m, double lambda, double r, double s, Vector3D first, Vector3D last, Vector3D v)
    {
        if (m == 2)
            return r / (lambda - 0.5) * (first - last);
        double determinant = (lambda - 0.5) * (lambda - 0.75) - 0.125;
        double u = (r * (lambda - 0.75) + s / 8) / determinant, w = ((lambda - 0.5) * s + r) / determinant;
        return u * (first + last) + w * v;
    }

    private static void CatmullClarkInterior(Vertex v, LimitPoints limit)
    {
        int n = v.Valence, i = 0;
        double angle = 2 * Math.PI / n, cosine = Math.Cos(angle);
        double edgeWeight = 1 + cosine + Math.Cos(angle / 2) * Math.Sqrt(2 * (9 + cosine));
        Vector3D edges = default, faces = default, cosines = default, sines = default;
        foreach (HalfEdge h in v.OutgoingHalfEdges)
        {
            Vector3D e = h.Target.Position, f = h.Next.Target.Position;
            edges += e;
            faces += f;
            (double sin, double cos) = Math.SinCos(angle * i++);
            (double nextSin, double nextCos) = Math.SinCos(angle * i);
            cosines += edgeWeight * cos * e + (cos + nextCos) * f;
            sines += edgeWeight * sin * e + (sin + nextSin) * f;
        }
        limit.Positions[v.Index] = (n * n * v.Position + 4 * edges + faces) / (n * (n + 5));
        limit.Normals[v.Index] = Vector3D.Cross(cosines, sines).Normalized();
    }

    /// <summary>
    /// As for Loop: entries sin jθ at the inner edges and (sin jθ + sin (j + 1)θ)/(16 μ) at the faces, θ = π/k for k quadrilaterals, or 2π/k; the eigenvalue is
    /// λ = ¼ + μ with μ² = (μ/8 + 1/32)(1 + cos θ). For more than four quadrilaterals the second outweighs the boundary's own tangent.
    /// </summary>
    private static void CatmullClarkBoundary(Vertex v, LimitPoints limit)
    {
        HalfEdge[] spokes = v.OutgoingHalfEdges.ToArray();
        int k = spokes.Length - 1;
        Vector3D first = spokes[0].Target.Position, last = spokes[k].Target.Position;
        Vector3D along = k <= 4 ? first - last : Mode(2), across = k == 1 ? first + last - 2 * v.Position : Mode(1);
        limit.Positions[v.Index] = OnCurve(v.Position, first + last);
        limit.Normals[v.Index] = Vector3D.Cross(along, across).Normalized();

        Vector3D Mode(int m)
        {
            double theta = m * Math.PI / k, a = 1 + Math.Cos(theta), mu = (a + Math.Sqrt(a * a + 8 * a)) / 16, edges = 0, faces = 0;
            Vector3D inner = default;
            for (int j = 0; j < k; j++)
            {
                double sin = Math.Sin(j * theta), face = (sin + Math.Sin((j + 1) * theta)) / (16 * mu);
                edges += sin;
                faces += face;
                inner += face * spokes[j].Next.Target.Position;
                if (j > 0)
                    inner += sin * spokes[j].Target.Position;
            }
            double r = Math.Sin(theta) / 16 * (1 + 1 / (4 * mu));
            return inner + Ends(m, 0.25 + mu, r, 0.375 * edges + 0.25 * faces, first, last, v.Position);
        }
    }
}
