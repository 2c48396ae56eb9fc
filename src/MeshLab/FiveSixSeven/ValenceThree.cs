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
        /// <returns>The number of edges split.</returns>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public int RaiseValenceThree()
        {
            Steps.RequireTriangles(mesh);
            int splits = 0;
            int vertices = mesh.VertexSlots;
            for (int i = 0; i < vertices; i++)
            {
                Vertex v = mesh.Vertices[i];
                if (v.IsDeleted || !Steps.IsInner(v) || v.Valence != 3)
                    continue;
                v.OutgoingHalfEdges.Select(h => h.Next.Edge).MaxBy(e => e.Length).Split();
                splits++;
            }
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

    public static bool IsInner(Vertex v) => !v.IsIsolated && !v.IsBoundary;
}
