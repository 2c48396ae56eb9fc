using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9.5 分割高度数点: vertices of valence above 7 are split along neighbours 0 and 5 until none is left.</summary>
/// <remarks>
/// <code>
///      n1  n2  n3  n4                n1  n2  n3  n4
///        \  | |  /                     \  \ /  /
///     n0 ── v ── n5       ⟶       n0 ──── w ──── n5       w has valence 7, v loses three edges, n0 and n5 gain one
///        /  |  \                       \  │  /
///       …   …   n6                      ─ v ─
/// </code>
/// Needs the fresh ring of §9.4: n0 and n5 have valence 6 there and get 7. The next group begins one neighbour before n0, so that both
/// of its ends are fresh again.
/// </remarks>
public static class HighValence
{
    private const int Group = 5;

    extension(Mesh mesh)
    {
        /// <summary>Splits every inner vertex of valence above 7, in the fresh ring that <c>SplitFacesIntoNine</c> made around it.</summary>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work between two operations; the mesh is valid.</param>
        /// <returns>The number of splits.</returns>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        public int LowerHighValences(IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            Steps.RequireTriangles(mesh);
            int splits = 0, vertices = mesh.VertexSlots;
            for (int i = 0; i < vertices; i++)
            {
                Steps.Check(i, vertices, progress, cancellationToken);
                Vertex v = mesh.Vertices[i];
                if (v.IsDeleted || !Steps.IsInner(v))
                    continue;
                HalfEdge first = v.Outgoing;
                for (int valence = v.Valence; valence > 7; valence -= 3)
                {
                    HalfEdge last = first, before = first.Twin.Next;
                    for (int k = 0; k < Group; k++)
                        last = last.Previous.Twin;
                    v.Split(first.Target, last.Target);
                    first = before;
                    splits++;
                }
            }
            progress?.Report(1);
            return splits;
        }
    }
}
