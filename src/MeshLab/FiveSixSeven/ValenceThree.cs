using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9.2 3 → 4: an inner vertex of valence 3 gets a fourth edge.</summary>
/// <remarks>
/// <code>
///        a                    a
///      / | \                / | \
///     /  v  \      ⟶       /  v  \
///    / /   \ \            / / | \ \
///   b ─────── c          b ── m ── c
/// </code>
/// The longest of the edges opposite to v is split at its midpoint m. The vertex beyond it gains an edge too; m has valence 4.
/// </remarks>
public static class ValenceThree
{
    extension(Mesh mesh)
    {
        /// <summary>Raises every inner vertex of valence 3 to 4 or more.</summary>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work between two operations; the mesh is valid.</param>
        /// <returns>The number of edges split.</returns>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public int RaiseValenceThree(IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            Steps.RequireTriangles(mesh);
            int splits = 0;
            int vertices = mesh.VertexSlots;
            for (int i = 0; i < vertices; i++)
            {
                Steps.Check(i, vertices, progress, cancellationToken);
                Vertex v = mesh.Vertices[i];
                if (v.IsDeleted || !Steps.IsInner(v) || v.Valence != 3)
                    continue;
                v.OutgoingHalfEdges.Select(h => h.Next.Edge).MaxBy(e => e.Length).Split();
                splits++;
            }
            progress?.Report(1);
            return splits;
        }
    }
}

/// <summary>What the steps of the book's engine share.</summary>
internal static class Steps
{
    public static void RequireTriangles(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (!mesh.IsTriangleMesh)
            throw new ArgumentException("The steps towards a 5-6-7 mesh need triangles; cut the polygons first.", nameof(mesh));
    }

    /// <summary>Told at every vertex; reports now and then.</summary>
    public static void Check(int done, int all, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        cancellationToken.ThrowIfCancellationRequested();
        if (done % 4096 == 0)
            progress?.Report((double)done / all);
    }

    public static bool IsInner(Vertex v) => !v.IsIsolated && !v.IsBoundary;
}
