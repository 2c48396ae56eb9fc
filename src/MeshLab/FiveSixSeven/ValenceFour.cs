using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9.3 4 → 5: a triangle and its three neighbours become sixteen triangles; the six vertices around gain an edge each.</summary>
/// <remarks>
/// <code>
///             c                              c
///           / | \                          / | \
///         /       \                     lm ─ s_m ─ rm
///   a_l  /         \  a_r       ⟶      /  \ /   \ /  \          lm, rm, mm: midpoints of the sides, joined to a_l, a_r, a_m;
///      /             \                / ─ s_l ── s_r ─ \        s_m, s_l, s_r: midpoints between them
///    l ─────────────── r             l ──── mm ──────── r
/// </code>
/// In steps: split the three sides; one flip makes the inner four triangles; split the three inner edges; one flip makes the innermost triangle.
/// All six new vertices have valence 5 (on a boundary less), so the number of vertices of valence 4 falls every time, and the step ends.
/// </remarks>
public static class ValenceFour
{
    extension(Mesh mesh)
    {
        /// <summary>Raises every inner vertex of valence 4 to 5 or more; there must be none of valence 3.</summary>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work between two operations; the mesh is valid.</param>
        /// <returns>The number of triangles replaced.</returns>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public int RaiseValenceFour(IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            Steps.RequireTriangles(mesh);
            int replaced = 0;
            for (int i = 0; i < mesh.VertexSlots; i++)
            {
                Steps.Check(i, mesh.VertexSlots, progress, cancellationToken);
                Vertex v = mesh.Vertices[i];
                if (v.IsDeleted)
                    continue;
                while (Steps.IsInner(v) && v.Valence == 4)
                {
                    ReplaceBySixteen(mesh, BestFace(v));
                    replaced++;
                }
            }
            progress?.Report(1);
            return replaced;
        }
    }

    /// <summary>The face with the lowest sum of valences among the six vertices that gain an edge.</summary>
    private static Face BestFace(Vertex v) => v.Faces.MinBy(f => f.HalfEdges.Sum(h => h.Target.Valence + (h.Twin.IsBoundary ? 0 : h.Twin.Next.Target.Valence)));

    private static void ReplaceBySixteen(Mesh mesh, Face face)
    {
        Vertex[] corners = [.. face.Vertices];
        (Vertex c, Vertex l, Vertex r) = (corners[0], corners[1], corners[2]);
        Vertex lm = mesh.FindEdge(c, l).Split(), rm = mesh.FindEdge(r, c).Split(), mm = mesh.FindEdge(l, r).Split();
        mesh.FindEdge(lm, r).Flip();

        Vertex sm = mesh.FindEdge(lm, rm).Split();
        mesh.FindEdge(lm, mm).Split();
        mesh.FindEdge(mm, rm).Split();
        mesh.FindEdge(sm, mm).Flip();
    }
}
