using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>The second of two √3 steps on an open mesh (§8.3): boundary edges are cut in three.</summary>
/// <remarks>
/// <code>
///            c                   the face of boundary edge a → b gets two vertices on it instead of one in its middle
///          / │ \                 (x is the first, y the second); the edges b–c and c–a are flipped as all others:
///        /  / \  \               they join y and x to the middle of the next face
///      a ─ x ── y ─ b
/// </code>
/// </remarks>
internal static class BoundaryTrisection
{
    public static Mesh Step(Mesh mesh, CancellationToken cancellationToken)
    {
        (int[] hole, int[] point, int vertices) = NumberPoints(mesh);
        cancellationToken.ThrowIfCancellationRequested();
        var positions = new Vector3D[vertices];
        PlaceVertices(mesh, positions);
        PlacePoints(mesh, hole, point, positions);
        cancellationToken.ThrowIfCancellationRequested();

        var corners = new int[9 * mesh.FaceSlots];
        int at = 0;
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            int h = mesh.halfEdgeOf[f];
            for (int k = 0; k < 3; k++, h = mesh.next[h])
            {
                // Each interior edge is flipped: its half-edge keeps the triangle at its source.
                if (hole[f] == h)
                    Add(point[f], point[f] + 1, mesh.target[mesh.next[h]]);
                else
                    Add(mesh.target[h ^ 1], Apex(h ^ 1), Apex(h));
            }
        }
        return MeshBuilder.FromSoup(new PolygonSoup(positions, PolygonSoup.TriangleStarts(corners.Length, nameof(mesh)), corners), NonManifoldPolicy.Throw, out _);

        void Add(int a, int b, int c)
        {
            corners[at++] = a;
            corners[at++] = b;
            corners[at++] = c;
        }

        // The point of the face of a half-edge that the flipped edge ends at.
        int Apex(int h)
        {
            int f = mesh.face[h];
            if (hole[f] < 0)
                return point[f];
            // In the face of a boundary edge a → b: y for b → c, x for c → a.
            return mesh.next[hole[f]] == h ? point[f] + 1 : point[f];
        }
    }

    /// <summary>Per face its boundary half-edge or −1, and its first new vertex.</summary>
    internal static (int[] Hole, int[] Point, int Vertices) NumberPoints(Mesh mesh)
    {
        int[] hole = new int[mesh.FaceSlots], point = new int[mesh.FaceSlots];
        int vertices = mesh.VertexSlots;
        for (int f = 0; f < hole.Length; f++)
        {
            hole[f] = -1;
            point[f] = vertices++;
            int h = mesh.halfEdgeOf[f];
            for (int k = 0; k < 3; k++, h = mesh.next[h])
            {
                if (mesh.face[h ^ 1] >= 0)
                    continue;
                if (hole[f] >= 0)
                {
                    throw new TopologyException(
                        $"{mesh.Faces[f]} has two boundary edges; they can be cut in three only after a step that leaves the boundary alone.", mesh.Faces[f].ToString());
                }
                hole[f] = h;
                vertices++;
            }
        }
        return (hole, point, vertices);
    }

    private static void PlaceVertices(Mesh mesh, Vector3D[] positions)
    {
        Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                int h = mesh.outgoing[v];
                if (h < 0)
                    positions[v] = mesh.positions[v];
                else if (mesh.face[h] >= 0)
                    positions[v] = Sqrt3Subdivision.Relaxed(mesh, v);
                else
                    positions[v] = 1.0 / 27 * (4 * (mesh.positions[mesh.target[h]] + mesh.positions[mesh.target[mesh.previous[h] ^ 1]]) + 19 * mesh.positions[v]);
            }
        });
    }

    private static void PlacePoints(Mesh mesh, int[] hole, int[] point, Vector3D[] positions)
    {
        Vector3D[] old = mesh.positions;
        int[] next = mesh.next, target = mesh.target;
        for (int f = 0; f < hole.Length; f++)
        {
            int h = mesh.halfEdgeOf[f];
            if (hole[f] < 0)
            {
                positions[point[f]] = 1.0 / 3 * (old[target[mesh.previous[h]]] + old[target[h]] + old[target[next[h]]]);
                continue;
            }
            // The loop runs against the face: its half-edge goes from b to a.
            int loop = hole[f] ^ 1;
            Vector3D b = old[target[hole[f]]], a = old[target[loop]];
            Vector3D beforeA = old[target[next[loop]]], afterB = old[target[mesh.previous[loop] ^ 1]];
            positions[point[f]] = 1.0 / 27 * (beforeA + 16 * a + 10 * b);
            positions[point[f] + 1] = 1.0 / 27 * (10 * a + 16 * b + afterB);
        }
    }
}
