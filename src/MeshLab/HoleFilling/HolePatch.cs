using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>Triangles put into a hole of the mesh, to be refined and faired.</summary>
internal sealed class HolePatch
{
    private readonly HoleLoop loop;
    private readonly int firstVertex;
    private readonly int firstEdge;
    private readonly Dictionary<int, double>? scales;
    private PatchRefinement? refinement;

    private HolePatch(HoleLoop loop, bool toBeRefined)
    {
        this.loop = loop;
        firstVertex = loop.Mesh.VertexSlots;
        firstEdge = loop.Mesh.EdgeSlots;
        FirstFace = loop.Mesh.FaceSlots;
        scales = toBeRefined ? PatchRefinement.RimScales(loop) : null;
    }

    /// <summary>The faces from here on are the patch.</summary>
    public int FirstFace { get; }

    /// <summary>The number of vertices that belong to the patch alone.</summary>
    public int NewVertices => loop.Mesh.VertexSlots - firstVertex;

    /// <summary>Makes faces of the triangles; numbers from n on are new vertices.</summary>
    /// <param name="loop">The hole.</param>
    /// <param name="triangles">Three numbers each, counter-clockwise; together a disk with the loop as its rim.</param>
    /// <param name="inner">Positions of the new vertices.</param>
    /// <param name="toBeRefined">Whether <see cref="Refine"/> may be called later.</param>
    public static HolePatch Insert(HoleLoop loop, List<int> triangles, ReadOnlySpan<Vector3D> inner, bool toBeRefined)
    {
        Mesh mesh = loop.Mesh;
        var patch = new HolePatch(loop, toBeRefined);
        int n = loop.Count;
        var vertices = new List<int>(loop.Vertices);
        foreach (Vector3D p in inner)
            vertices.Add(mesh.NewVertex(p).Index);

        var halfEdge = new Dictionary<(int From, int To), int>(triangles.Count);
        for (int i = 0; i < n; i++)
            halfEdge[(i, (i + 1) % n)] = loop.HalfEdges[i];
        for (int t = 0; t < triangles.Count; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            Face face = mesh.NewFace();
            mesh.LinkTriangle(face, Side(a, b), Side(b, c), Side(c, a));
        }
        // No hole is left at the loop; any half-edge will do.
        for (int i = 0; i < n; i++)
            mesh.SetOutgoing(vertices[i], loop.HalfEdges[i]);
        return patch;

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
    /// <summary>Makes the patch as dense as the surface around it, within a budget of new vertices.</summary>
    public void Refine(int budget)
    {
        ArgumentNullException.ThrowIfNull(scales);
        Mesh mesh = loop.Mesh;
        for (int v = firstVertex; v < mesh.VertexSlots; v++)
            scales[v] = scales.Values.Average();
        refinement = new PatchRefinement(mesh, scales, FirstFace, firstEdge);
        refinement.Run(budget);
    }

    /// <summary>Bends the patch to continue the surface around it.</summary>
    /// <returns>Whether it moved.</returns>
    public bool Fair(int continuity)
    {
        if (!PatchFairing.Run(loop.Mesh, loop, firstVertex, continuity))
            return false;
        // The weights of the first round are those of the flat patch; the second sees the bent one, and edges that suit it.
        refinement?.Relax();
        PatchFairing.Run(loop.Mesh, loop, firstVertex, continuity);
        return true;
    }
}
