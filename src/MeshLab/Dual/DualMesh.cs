using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Dual;

/// <summary>A dual mesh and what its elements stand for.</summary>
/// <param name="Mesh">The dual: a polygon mesh with the orientation of the primal.</param>
/// <param name="SourceFace">Per dual vertex the primal face of which it is the centre; −1 for edge midpoints and boundary vertices.</param>
/// <param name="SourceVertex">Per dual face the primal vertex of which it is the cell.</param>
public sealed record DualResult(Mesh Mesh, int[] SourceFace, int[] SourceVertex);

/// <summary>§3 对偶模型 (dual model): a vertex for every face, a face for every vertex.</summary>
/// <remarks>
/// <code>
///      ●─────●               primal edge h from a to b, face f to its left, g to its right;
///     ╱ ╲ f ╱ ╲              its dual goes from the centre of g to that of f, with the cell of a to its left.
///    ●───a─h─b──●            Around the cell of a the dual edges follow one another as the spokes of a do,
///     ╲ ╱ g ╲ ╱              so next*(h) = twin(previous(h)) and previous*(h) = next(twin(h)): no search at all.
///      ●─────●
/// </code>
/// The first dual vertices are the faces in index order; edge midpoints (cells, or boundary edges in the pure form) follow in order of edges, then boundary vertices.
/// Dual faces are the vertices in index order. On a closed mesh the dual of the pure dual has the connectivity of the primal, index by index.
/// Isolated vertices have no cell. A face whose every corner lies on the boundary leaves an isolated dual vertex if boundary cells are omitted. O(V + E + F).
/// The mesh given is not changed; no hole is filled.
/// </remarks>
public static class DualMesh
{
    extension(Mesh mesh)
    {
        /// <summary>Makes the dual.</summary>
        /// <param name="options">Centres, form and boundary; barycentres, pure and closed if not given.</param>
        /// <exception cref="ArgumentException">Circumcentres are asked for and a face is not a triangle; it is named.</exception>
        /// <exception cref="TopologyException">Two faces share more than one edge, so that the dual would have two edges between the same vertices (pure form only); they are named.</exception>
        public DualResult ComputeDual(DualOptions? options = null)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new();
            var centers = FaceCenters(mesh, options.Center);
            if (!mesh.IsCompact)
                return OfCompactCopy(mesh, centers, options);
            if (options.Form == DualForm.Cells)
                return DualCells.Make(mesh, centers, options);
            return mesh.IsClosed || options.Boundary == DualBoundary.Omitted
                ? PureDual.Make(mesh, centers)
                : DualCells.Make(mesh, centers, options);
        }
    }

    /// <summary>Per face slot its centre.</summary>
    private static Vector3D[] FaceCenters(Mesh mesh, DualCenter center)
    {
        if (center == DualCenter.Circumcenter)
            mesh.RequireTriangles();
        Vector3D[] centers = mesh.ComputeFaceBarycenters();
        if (center == DualCenter.Barycenter)
            return centers;
        int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
        Vector3D[] positions = mesh.positions;
        Parallelism.ForBlocks(centers.Length, (from, to) =>
        {
            for (int f = from; f < to; f++)
            {
                int h = halfEdgeOf[f];
                if (h < 0 || next[next[next[h]]] != h)
                    continue;
                var triangle = new Triangle(positions[target[h ^ 1]], positions[target[h]], positions[target[next[h]]]);
                if (center == DualCenter.CircumcenterIfAcute && !IsAcute(triangle))
                    continue;
                Vector3D circumcenter = triangle.Circumcenter;
                if (circumcenter.IsFinite)
                    centers[f] = circumcenter;
            }
        });
        return centers;
    }

    private static bool IsAcute(Triangle t) =>
        Vector3D.Dot(t.B - t.A, t.C - t.A) > 0 && Vector3D.Dot(t.C - t.B, t.A - t.B) > 0 && Vector3D.Dot(t.A - t.C, t.B - t.C) > 0;

    /// <summary>Deleted elements out of the way, then with the sources named as in the mesh given.</summary>
    private static DualResult OfCompactCopy(Mesh mesh, Vector3D[] centers, DualOptions options)
    {
        int[] faces = [.. mesh.Faces.Select(f => f.Index)], vertices = [.. mesh.Vertices.Select(v => v.Index)];
        var copy = new Mesh();
        copy.Append(mesh);
        copy.Compact();
        Vector3D[] kept = Array.ConvertAll(faces, f => centers[f]);
        DualResult dual = options.Form == DualForm.Pure && (copy.IsClosed || options.Boundary == DualBoundary.Omitted)
            ? PureDual.Make(copy, kept)
            : DualCells.Make(copy, kept, options);
        return new(
            dual.Mesh,
            Array.ConvertAll(dual.SourceFace, f => f < 0 ? -1 : faces[f]),
            Array.ConvertAll(dual.SourceVertex, v => vertices[v]));
    }
}
