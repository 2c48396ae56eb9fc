using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>What <see cref="LaboratoryRemeshing"/> should do; the defaults are the laboratory's.</summary>
public sealed record LaboratoryRemeshingOptions
{
    /// <summary>How often the four steps are done.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 1.</exception>
    public int Passes
    {
        get;
        init
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            field = value;
        }
    }
    = 5;

    /// <summary>How far a vertex moves towards the middle of its neighbours: w of the script.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not in (0, 1].</exception>
    public double SmoothingWeight
    {
        get;
        init
        {
            if (!(value is > 0 and <= 1))
                throw new ArgumentOutOfRangeException(nameof(SmoothingWeight), value, "The weight is in (0, 1].");
            field = value;
        }
    }
    = 0.2;

    /// <summary>The edge length L̄ to aim at, in model units; null for the mean of the mesh.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not positive or not finite.</exception>
    public double? EdgeLength
    {
        get;
        init
        {
            if (value is { } length && (!(length > 0) || !double.IsFinite(length)))
                throw new ArgumentOutOfRangeException(nameof(EdgeLength), value, "A length is positive and finite.");
            field = value;
        }
    }

    /// <summary>Takes the step trace: a line of JSON per operation; <see langword="null"/> for none.</summary>
    public TextWriter? Trace { get; init; }
}

/// <summary>What the laboratory's remeshing did.</summary>
/// <param name="StopReason">Why it ended.</param>
/// <param name="EdgeLength">The edge length L̄ aimed at.</param>
/// <param name="Splits">Edges split.</param>
/// <param name="Collapses">Edges contracted.</param>
/// <param name="Flips">Edges flipped.</param>
/// <param name="RefusedCollapses">Short edges that stay, because an edge would get too long or the topology change.</param>
public sealed record LaboratoryRemeshingResult(RemeshingStop StopReason, double EdgeLength, int Splits, int Collapses, int Flips, int RefusedCollapses);

/// <summary>L4 各向同性重新网格化 (isotropic remeshing) as the laboratory's script has it: four steps on the mesh itself, without projection.</summary>
/// <remarks>
/// With L̄ the mean edge length, five times: (1) split every edge longer than 4/3 L̄ at its midpoint; (2) collapse every edge
/// shorter than 4/5 L̄ to its midpoint, unless that makes an edge longer than 4/3 L̄ or changes the topology; (3) flip every edge where that
/// brings the four valences closer to 6 (4 on the boundary); (4) move every vertex by w = 1/5 of the way to the middle of its neighbours, less
/// the part along its normal. Boundary vertices keep their places, except where an edge between two of them is collapsed. The surface
/// drifts away from the input a little with every pass: <see cref="IsotropicRemeshing"/> does not. O(n) per pass.
/// </remarks>
public static class LaboratoryRemeshing
{
    private const double Long = 4.0 / 3, Short = 4.0 / 5;

    extension(Mesh mesh)
    {
        /// <summary>Remeshes this mesh by the laboratory's four steps.</summary>
        /// <param name="options">How; null for the script's five passes.</param>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work; the mesh stays valid as it is then.</param>
        /// <exception cref="ArgumentException">A face is not a triangle (it is named), or more than 50 million faces would come out.</exception>
        /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
        public LaboratoryRemeshingResult RemeshInLaboratory(
            LaboratoryRemeshingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            mesh.RequireTriangles(nameof(mesh));
            options ??= new();
            double length = options.EdgeLength ?? mesh.MeanEdgeLength;
            if (length > 0 && RemeshingOptions.BeyondBudget(mesh, length, RemeshingOptions.DefaultFaceBudget) is { } beyond)
                throw new ArgumentException(beyond, nameof(options));
            int splits = 0, collapses = 0, flips = 0, refused = 0;
            using OperationTrace? trace = OperationTrace.Of(mesh, StepTrace.Into(options.Trace));
            for (int pass = 0; pass < options.Passes && length > 0; pass++)
            {
                splits += SplitLongEdges(mesh, Long * length);
                Check(0.25);
                (int done, refused) = CollapseShortEdges(mesh, Short * length, Long * length);
                collapses += done;
                Check(0.5);
                flips += FlipTowardsRegularValence(mesh);
                Check(0.75);
                SmoothTangentially(mesh, options.SmoothingWeight);
                Check(1);

                void Check(double share)
                {
                    progress?.Report((pass + share) / options.Passes);
                    cancellationToken.ThrowIfCancellationRequested();
                }
            }
            return new(length > 0 ? RemeshingStop.PassesDone : RemeshingStop.NothingToDo, length, splits, collapses, flips, refused);
        }
    }

    // Sweeps over the edges that are there when the sweep begins, until none is too long.
    private static int SplitLongEdges(Mesh mesh, double longest)
    {
        int splits = 0, before;
        do
        {
            before = splits;
            int edges = mesh.EdgeSlots;
            for (int e = 0; e < edges; e++)
            {
                if (mesh.IsDeletedEdge(e) || Length(mesh.Edges[e]) <= longest)
                    continue;
                mesh.Edges[e].Split();
                splits++;
            }
        }
        while (splits > before);
        return splits;
    }

    private static (int Done, int Refused) CollapseShortEdges(Mesh mesh, double shortest, double longest)
    {
        int done = 0, refused = 0;
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (mesh.IsDeletedEdge(e) || Length(mesh.Edges[e]) >= shortest)
                continue;
            HalfEdge h = mesh.Edges[e].HalfEdge0;
            Vector3D position = CollapsePosition(h);
            if (MakesLongEdge(h, position, longest) || !h.TryCollapse(position, out _))
                refused++;
            else
                done++;
        }
        return (done, refused);
    }

    // The midpoint; but a vertex of the boundary stays there.
    private static Vector3D CollapsePosition(HalfEdge h) => (h.Source.IsBoundary, h.Target.IsBoundary) switch
    {
        (true, false) => h.Source.Position,
        (false, true) => h.Target.Position,
        _ => (h.Source.Position + h.Target.Position) * 0.5,
    };

    private static bool MakesLongEdge(HalfEdge h, Vector3D position, double longest)
    {
        foreach (Vertex end in (ReadOnlySpan<Vertex>)[h.Source, h.Target])
        {
            foreach (Vertex w in end.Neighbors)
            {
                if (w != h.Source && w != h.Target && Vector3D.Distance(w.Position, position) > longest)
                    return true;
            }
        }
        return false;
    }

    private static int FlipTowardsRegularValence(Mesh mesh)
    {
        int flips = 0;
        foreach (Edge edge in mesh.Edges)
        {
            if (edge.IsBoundary)
                continue;
            HalfEdge h = edge.HalfEdge0;
            Vertex a = h.Source, b = h.Target, c = h.Next.Target, d = h.Twin.Next.Target;
            int before = Deviation(a, 0) + Deviation(b, 0) + Deviation(c, 0) + Deviation(d, 0);
            int after = Deviation(a, -1) + Deviation(b, -1) + Deviation(c, 1) + Deviation(d, 1);
            if (after < before && !edge.FlipFolds() && edge.TryFlip(out _))
                flips++;
        }
        return flips;
    }

    private static int Deviation(Vertex v, int change) => Math.Abs(v.Valence + change - (v.IsBoundary ? 4 : 6));

    // All new places come from all old ones.
    private static void SmoothTangentially(Mesh mesh, double weight)
    {
        Vector3D[] normals = mesh.ComputeVertexNormals(VertexNormalWeight.Area);
        var places = new Vector3D[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            places[v.Index] = v.Position;
            if (v.IsBoundary || v.IsIsolated)
                continue;
            Vector3D sum = default;
            foreach (Vertex w in v.Neighbors)
                sum += w.Position;
            Vector3D move = sum / v.Valence - v.Position, n = normals[v.Index];
            places[v.Index] = v.Position + weight * (move - Vector3D.Dot(move, n) * n);
        }
        foreach (Vertex v in mesh.Vertices)
        {
            if (places[v.Index] != v.Position)
                mesh.MoveVertex(v, places[v.Index]);
        }
    }

    private static double Length(Edge edge) => Vector3D.Distance(edge.Vertex0.Position, edge.Vertex1.Position);
}
