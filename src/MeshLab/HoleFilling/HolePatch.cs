using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>Puts triangles into a hole of the mesh.</summary>
internal static class HolePatch
{
    /// <summary>Makes faces of the triangles; numbers from n on are new vertices.</summary>
    /// <param name="loop">The hole.</param>
    /// <param name="triangles">Three numbers each, counter-clockwise; together a disk with the loop as its rim.</param>
    /// <param name="inner">Positions of the new vertices.</param>
    /// <returns>The new faces.</returns>
    public static List<Face> Insert(HoleLoop loop, List<int> triangles, ReadOnlySpan<Vector3D> inner)
    {
        Mesh mesh = loop.Mesh;
        int n = loop.Count;
        var vertices = new List<int>(loop.Vertices);
        foreach (Vector3D p in inner)
            vertices.Add(mesh.NewVertex(p).Index);

        var halfEdge = new Dictionary<(int From, int To), int>(triangles.Count);
        for (int i = 0; i < n; i++)
            halfEdge[(i, (i + 1) % n)] = loop.HalfEdges[i];
        var faces = new List<Face>(triangles.Count / 3);
        for (int t = 0; t < triangles.Count; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            Face face = mesh.NewFace();
            mesh.LinkTriangle(face, Side(a, b), Side(b, c), Side(c, a));
            faces.Add(face);
        }
        // No hole is left at the loop; any half-edge will do.
        for (int i = 0; i < n; i++)
            mesh.SetOutgoing(vertices[i], loop.HalfEdges[i]);
        return faces;

        HalfEdge Side(int from, int to)
        {
            if (!halfEdge.TryGetValue((from, to), out int h))
            {
                h = mesh.NewEdge(vertices[from], vertices[to]);
                halfEdge[(from, to)] = h;
                halfEdge[(to, from)] = h ^ 1;
                if (from >= n)
                    mesh.SetOutgoing(vertices[from], h);
                if (to >= n)
                    mesh.SetOutgoing(vertices[to], h ^ 1);
            }
            return new(mesh, h);
        }
    }
}
