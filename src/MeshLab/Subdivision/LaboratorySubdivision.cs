using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>What the laboratory's subdivision did.</summary>
/// <param name="StopReason">Why it ended.</param>
/// <param name="Splits">Edges split: all there were.</param>
/// <param name="Flips">Edges flipped: one per face.</param>
public sealed record LaboratorySubdivisionResult(SubdivisionStop StopReason, int Splits, int Flips);

/// <summary>L2 Loop 细分 by local operations, as the laboratory's script has it: split every edge, flip the edges that join a new vertex with an old one.</summary>
/// <remarks>
/// <code>
///        c                     c                    c
///       / \                   /|\                  / \
///      /   \      split      / | \      flip      /   \
///     /     \      ⟶       m2 |  m1     ⟶      m2 ── m1       three splits make four faces of a face, the wrong ones; the edge from c
///    /       \             / \ | / \            / \   / \      to m0 is the only one between an old and a new vertex that is
///   a ─────── b           a ── m0 ── b         a ── m0 ── b    no half of an old edge, and it is flipped
/// </code>
/// Positions are those of <see cref="LoopSubdivision"/>, computed before anything is split; so is the numbering: old vertices stay, the vertex of edge e follows as V + e
/// (on a mesh without deleted slots). Works on the mesh itself: every step can be recorded, undone and traced. O(F).
/// </remarks>
public static class LaboratorySubdivision
{
    extension(Mesh mesh)
    {
        /// <summary>One step of Loop's scheme by splits and flips.</summary>
        /// <param name="weights">The weights of old vertices.</param>
        /// <param name="trace">Takes the step trace: a line of JSON per split, flip and move; <see langword="null"/> for none.</param>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work; the mesh is valid, but subdivided in part.</param>
        /// <exception cref="ArgumentException">A face is not a triangle; it is named.</exception>
        /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
        public LaboratorySubdivisionResult SubdivideInLaboratory(
            LoopWeights weights = LoopWeights.Loop1987, TextWriter? trace = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            mesh.RequireTriangles(nameof(mesh));
            using OperationTrace? steps = OperationTrace.Of(mesh, StepTrace.Into(trace));
            Vector3D[] vertexPlaces = PlaceVertices(mesh, weights), edgePlaces = PlaceEdges(mesh);
            progress?.Report(0.2);

            int oldVertices = mesh.VertexSlots;
            (Vertex A, Vertex B)[] parents = SplitAllEdges(mesh, edgePlaces, cancellationToken);
            progress?.Report(0.6);
            int flips = FlipEdgesBetweenOldAndNew(mesh, oldVertices, parents, cancellationToken);
            progress?.Report(0.8);
            for (int v = 0; v < oldVertices; v++)
            {
                if (!mesh.IsDeletedVertex(v))
                    mesh.MoveVertex(mesh.Vertices[v], vertexPlaces[v]);
            }
            progress?.Report(1);
            return new(mesh.Faces.Count > 0 ? SubdivisionStop.StepsDone : SubdivisionStop.NothingToDo, parents.Length, flips);
        }
    }

    private static Vector3D[] PlaceVertices(Mesh mesh, LoopWeights weights)
    {
        var places = new Vector3D[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
            places[v.Index] = v.IsIsolated ? v.Position : v.IsBoundary ? OnBoundary(v) : Inside(v, LoopSubdivision.NeighborWeight(v.Valence, weights));
        return places;
    }

    private static Vector3D Inside(Vertex v, double weight)
    {
        Vector3D sum = default;
        foreach (Vertex w in v.Neighbors)
            sum += w.Position;
        return (1 - v.Valence * weight) * v.Position + weight * sum;
    }

    // Only the neighbours along the boundary count.
    private static Vector3D OnBoundary(Vertex v) => 0.75 * v.Position + 0.125 * (v.Outgoing.Target.Position + v.Outgoing.Previous.Source.Position);

    private static Vector3D[] PlaceEdges(Mesh mesh)
    {
        var places = new Vector3D[mesh.EdgeSlots];
        foreach (Edge e in mesh.Edges)
        {
            Vector3D ends = e.Vertex0.Position + e.Vertex1.Position;
            places[e.Index] = e.IsBoundary
                ? 0.5 * ends
                : 0.375 * ends + 0.125 * (e.HalfEdge0.Next.Target.Position + e.HalfEdge1.Next.Target.Position);
        }
        return places;
    }

    /// <summary>Splits the edges that are there now; per new vertex, in order, the ends of the edge that it stands on.</summary>
    private static (Vertex A, Vertex B)[] SplitAllEdges(Mesh mesh, Vector3D[] places, CancellationToken cancellationToken)
    {
        var parents = new List<(Vertex, Vertex)>(places.Length);
        for (int e = 0; e < places.Length; e++)
        {
            if (mesh.IsDeletedEdge(e))
                continue;
            cancellationToken.ThrowIfCancellationRequested();
            Edge edge = mesh.Edges[e];
            parents.Add((edge.Vertex0, edge.Vertex1));
            edge.Split(places[e]);
        }
        return [.. parents];
    }

    private static int FlipEdgesBetweenOldAndNew(Mesh mesh, int oldVertices, (Vertex A, Vertex B)[] parents, CancellationToken cancellationToken)
    {
        int flips = 0;
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (mesh.IsDeletedEdge(e))
                continue;
            cancellationToken.ThrowIfCancellationRequested();
            Edge edge = mesh.Edges[e];
            (Vertex old, Vertex made) = edge.Vertex0.Index < edge.Vertex1.Index ? (edge.Vertex0, edge.Vertex1) : (edge.Vertex1, edge.Vertex0);
            // After the splits no edge joins two old vertices.
            if (old.Index >= oldVertices)
                continue;
            (Vertex a, Vertex b) = parents[made.Index - oldVertices];
            if (old == a || old == b)
                continue;
            edge.Flip();
            flips++;
        }
        return flips;
    }
}
