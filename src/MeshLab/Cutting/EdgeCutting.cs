using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>A mesh cut open, and where its elements come from.</summary>
/// <param name="Mesh">The cut mesh: faces in the old order; old vertices in the old order, then the further copies in order of the vertex they come from.</param>
/// <param name="SourceVertex">Per vertex of the cut mesh the old vertex.</param>
/// <param name="SourceFace">Per face of the cut mesh the old face.</param>
/// <param name="NewFace">Per old face slot the face of the cut mesh; −1 for deleted faces.</param>
/// <param name="Copies">Per old vertex slot its copies, the one in its old place first; empty for deleted vertices.</param>
/// <param name="Uncut">Edges asked for that could not be cut: both ends stayed whole, so that the two sides are still one edge. In index order.</param>
public sealed record EdgeCutResult(
    Mesh Mesh, int[] SourceVertex, int[] SourceFace, int[] NewFace, IReadOnlyList<IReadOnlyList<int>> Copies, IReadOnlyList<Edge> Uncut);

/// <summary>§6.4 沿选择的边切开: cuts a mesh open along any set of edges.</summary>
/// <remarks>
/// <code>
///        ●                     ●
///      / ║ \                 /   \           cut edges ║ part the faces around a vertex into fans;
///     ● ─v─ ●     ⟶        ● ─v v'─ ●        every fan gets its own copy of the vertex
///      \ ║ /                 \   /
///        ●                     ●
/// </code>
/// Boundary edges are cut already. An end of a cut path inside the mesh has one fan and stays one vertex; a single edge with two such ends
/// cannot open, because its two sides would be two edges between the same two vertices. Copies have the traits of what they were. O(V + E). The mesh given is not changed.
/// </remarks>
public static class EdgeCutting
{
    /// <summary>Cuts along the edges.</summary>
    /// <param name="mesh">Any mesh.</param>
    /// <param name="edges">The edges to cut along; repeated and boundary edges do no harm.</param>
    /// <param name="opening">How far each copy moves away from its cut, along normal × edge, in model units; 0 leaves the two sides in one place.</param>
    /// <exception cref="ArgumentException">An edge is none, deleted, or of another mesh; it is named. The opening is not finite.</exception>
    public static EdgeCutResult CutAlong(Mesh mesh, IEnumerable<Edge> edges, double opening = 0)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(edges);
        if (!double.IsFinite(opening))
            throw new ArgumentException($"The opening {opening} is not finite.", nameof(opening));
        var isCut = new bool[mesh.EdgeSlots];
        foreach (Edge e in edges)
        {
            mesh.CheckOwn(e, nameof(edges));
            isCut[e.index] = true;
        }

        List<int> sources = [.. mesh.Vertices.Select(v => v.index)];
        var copies = new List<int>[mesh.VertexSlots];
        int[] cornerVertex = SplitFans(mesh, isCut, sources, copies);
        Vector3D[] positions = Positions(mesh, sources, copies, cornerVertex, isCut, opening);
        Mesh cut = MeshBuilder.FromPolygons(positions, [.. mesh.Faces.Select(f => f.HalfEdges.Select(h => cornerVertex[h.index]).ToArray())]);
        int[] sourceVertex = [.. sources], sourceFace = [.. mesh.Faces.Select(f => f.index)];
        PartTraits.Derive(mesh, cut, sourceVertex, sourceFace, null, null);
        return new(
            cut,
            sourceVertex,
            sourceFace,
            MeshPart.Inverse(sourceFace, mesh.FaceSlots),
            Array.ConvertAll(copies, list => (IReadOnlyList<int>)(list ?? [])),
            [.. mesh.Edges.Where(e => isCut[e.index] && IsWhole(e, cornerVertex))]);
    }

    /// <summary>Gives every fan between cuts its own vertex: per half-edge with a face, the new vertex that it leaves.</summary>
    private static int[] SplitFans(Mesh mesh, bool[] isCut, List<int> sources, List<int>[] copies)
    {
        var cornerVertex = new int[mesh.HalfEdgeSlots];
        Array.Fill(cornerVertex, -1);
        int kept = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            int current = kept++;
            copies[v.index] = [current];
            if (v.IsIsolated)
                continue;
            int first = FirstSpoke(v, isCut), h = first;
            bool isFirstFan = true;
            do
            {
                if (mesh.face[h] >= 0)
                {
                    // A fan begins after a cut, turning counter-clockwise; the hole of a boundary vertex lies before the first.
                    if (!isFirstFan && isCut[h >> 1])
                    {
                        current = sources.Count;
                        copies[v.index].Add(current);
                        sources.Add(v.index);
                    }
                    cornerVertex[h] = current;
                    isFirstFan = false;
                }
                h = mesh.previous[h] ^ 1;
            }
            while (h != first);
        }
        return cornerVertex;
    }

    /// <summary>A spoke where a fan begins: at the hole, else on the lowest cut edge, else any.</summary>
    private static int FirstSpoke(Vertex v, bool[] isCut)
    {
        int best = v.Outgoing.index;
        if (v.IsBoundary)
            return best;
        foreach (HalfEdge h in v.OutgoingHalfEdges)
        {
            if (isCut[h.Edge.index] && (!isCut[best >> 1] || h.index < best))
                best = h.index;
        }
        return best;
    }

    /// <summary>Whether the edge has two sides, which still have the same ends.</summary>
    private static bool IsWhole(Edge e, int[] cornerVertex)
    {
        HalfEdge h = e.HalfEdge0, t = e.HalfEdge1;
        return cornerVertex[h.index] == cornerVertex[t.Next.index] && cornerVertex[t.index] == cornerVertex[h.Next.index];
    }

    private static Vector3D[] Positions(Mesh mesh, List<int> sources, List<int>[] copies, int[] cornerVertex, bool[] isCut, double opening)
    {
        var positions = new Vector3D[sources.Count];
        for (int v = 0; v < positions.Length; v++)
            positions[v] = mesh.positions[sources[v]];
        if (opening == 0)
            return positions;

        // Normal × edge points to the left, into the face: away from the cut.
        var away = new Vector3D[sources.Count];
        foreach (Edge e in mesh.Edges)
        {
            if (!isCut[e.index] || e.IsBoundary)
                continue;
            foreach (HalfEdge h in (ReadOnlySpan<HalfEdge>)[e.HalfEdge0, e.HalfEdge1])
            {
                Vector3D inward = Vector3D.Cross(h.Face.Normal, (h.Target.Position - h.Source.Position).Normalized());
                away[cornerVertex[h.index]] += inward;
                away[cornerVertex[h.Next.index]] += inward;
            }
        }
        for (int v = 0; v < positions.Length; v++)
        {
            // A vertex that was not copied is the end of a cut and stays.
            if (copies[sources[v]].Count > 1)
                positions[v] += away[v].Normalized() * opening;
        }
        return positions;
    }
}
