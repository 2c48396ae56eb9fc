using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9.4 面分裂 1 → 9: two vertices on every edge, at ⅓ and ⅔, and one in every face.</summary>
/// <remarks>
/// <code>
///        c
///       / \
///      ● ─ ●            old vertices keep their valence, every new inner vertex has valence 6,
///     / \ / \           so every old vertex gets a fresh ring of regular vertices
///    ● ─ ● ─ ●
///   / \ / \ / \
///  a ─ ● ─ ● ─ b
/// </code>
/// </remarks>
public static class NineSplit
{
    extension(Mesh mesh)
    {
        /// <summary>Cuts every triangle into nine. Old vertices keep their order, then two per edge, then one per face. Edge traits named
        /// <c>crease</c> go along; other traits do not.</summary>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work; the mesh is not changed anyway.</param>
        /// <exception cref="ArgumentException">A face is not a triangle, or the result would be too large.</exception>
        public Mesh SplitFacesIntoNine(IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            Steps.RequireTriangles(mesh);
            if (mesh.Faces.Count > int.MaxValue / 54)
                throw new ArgumentException($"Nine times {mesh.Faces.Count} faces are too many.");
            var positions = new List<Vector3D>();
            var number = new int[mesh.VertexSlots];
            foreach (Vertex v in mesh.Vertices)
                number[v.Index] = Add(v.Position);
            var nearSource = new int[mesh.HalfEdgeSlots];
            foreach (HalfEdge h in mesh.HalfEdges)
                nearSource[h.Index] = Add(Vector3D.Lerp(h.Source.Position, h.Target.Position, 1 / 3.0));

            var corners = new List<int>(27 * mesh.Faces.Count);
            int done = 0;
            foreach (Face f in mesh.Faces)
            {
                Steps.Check(done++, 2 * mesh.Faces.Count, progress, cancellationToken);
                int center = Add(Center(f));
                foreach (HalfEdge h in f.HalfEdges)
                {
                    int first = nearSource[h.Index], second = nearSource[h.Twin.Index], last = nearSource[h.Previous.Twin.Index];
                    corners.AddRange([number[h.Source.Index], first, last, first, center, last, first, second, center]);
                }
            }
            Mesh result = MeshBuilder.FromTriangles([.. positions], [.. corners]);
            CopyCreases(mesh, result, number, nearSource);
            progress?.Report(1);
            return result;

            int Add(Vector3D p)
            {
                positions.Add(p);
                return positions.Count - 1;
            }
        }
    }

    private static Vector3D Center(Face f)
    {
        Vector3D sum = default;
        foreach (Vertex v in f.Vertices)
            sum += v.Position;
        return sum / 3;
    }

    private static void CopyCreases(Mesh mesh, Mesh fine, int[] number, int[] nearSource)
    {
        if (!mesh.TryGetEdgeTrait(ValenceSimplification.CreaseTrait, out EdgeTrait<int>? old))
            return;
        EdgeTrait<int> crease = ValenceSimplification.AddCreaseTrait(fine);
        foreach (Edge e in mesh.Edges)
        {
            if (old[e] == 0)
                continue;
            HalfEdge h = e.HalfEdge0;
            int[] path = [number[h.Source.Index], nearSource[h.Index], nearSource[h.Twin.Index], number[h.Target.Index]];
            for (int i = 0; i < 3; i++)
                crease[fine.FindEdge(fine.Vertices[path[i]], fine.Vertices[path[i + 1]])] = 1;
        }
    }
}
