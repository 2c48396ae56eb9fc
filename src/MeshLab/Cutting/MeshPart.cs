using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>A mesh made from part of another one, and where its elements come from.</summary>
/// <param name="Mesh">The part, with the traits of what it comes from.</param>
/// <param name="SourceVertex">Per vertex of the part the old vertex; −1 for new ones: <see cref="SourceEdge"/> says where they were made.</param>
/// <param name="SourceFace">Per face of the part the old face that it is, or is a piece of; −1 for new ones.</param>
/// <param name="NewVertex">Per old vertex slot the vertex of the part, the lowest if there are several copies; −1 if none.</param>
/// <param name="NewFace">Per old face slot the face of the part, the lowest if there are several pieces; −1 if none.</param>
public sealed record MeshPart(Mesh Mesh, int[] SourceVertex, int[] SourceFace, int[] NewVertex, int[] NewFace)
{
    /// <summary>Per vertex of the part that a cut made, the old edge on which it lies; −1 for old vertices, and for the centres of caps.</summary>
    public int[] SourceEdge { get; internal init; } = NoEdges(SourceVertex.Length);

    /// <summary>After <see cref="FaceDetachment"/>: per vertex that the mesh left behind got, in order of index from its old number of slots on, the vertex of which it is a copy, because faces met there in a point alone.</summary>
    public IReadOnlyList<int> CopiesLeftBehind { get; internal init; } = [];

    /// <summary>The part that some faces are, with their vertices in the old order. Faces that met in a vertex alone get a copy each.</summary>
    internal static MeshPart OfFaces(Mesh mesh, List<int> faces)
    {
        int[] next = mesh.next, target = mesh.target;
        var number = new int[mesh.VertexSlots];
        var start = new int[faces.Count + 1];
        var corners = new List<int>(3 * faces.Count);
        for (int i = 0; i < faces.Count; i++)
        {
            int first = mesh.halfEdgeOf[faces[i]], h = first;
            do
            {
                int v = target[h ^ 1];
                number[v] = 1;
                corners.Add(v);
                h = next[h];
            }
            while (h != first);
            start[i + 1] = corners.Count;
        }
        var sources = new List<int>();
        for (int v = 0; v < number.Length; v++)
        {
            if (number[v] == 0)
                continue;
            number[v] = sources.Count;
            sources.Add(v);
        }
        int[] renumbered = [.. corners.Select(v => number[v])];
        var soup = new PolygonSoup([.. sources.Select(v => mesh.positions[v])], start, renumbered);
        Mesh part = MeshBuilder.FromSoup(soup, NonManifoldPolicy.Split, out BuildReport report);
        int[] sourceVertex = report.SourceVertices is { } copies ? Array.ConvertAll(copies, v => sources[v]) : [.. sources];
        return Of(mesh, part, sourceVertex, [.. faces], null, null);
    }

    /// <summary>Fills the maps and derives the traits.</summary>
    /// <param name="source">The mesh that the part was made from.</param>
    /// <param name="part">The part, without traits.</param>
    /// <param name="sourceVertex">Per vertex of the part.</param>
    /// <param name="sourceFace">Per face of the part.</param>
    /// <param name="cutHalfEdge">Per vertex of the part the half-edge on which it is a new point, −1 for old ones; or <see langword="null"/>.</param>
    /// <param name="parameter">Where on that half-edge.</param>
    internal static MeshPart Of(Mesh source, Mesh part, int[] sourceVertex, int[] sourceFace, int[]? cutHalfEdge, double[]? parameter)
    {
        PartTraits.Derive(source, part, sourceVertex, sourceFace, cutHalfEdge, parameter);
        var result = new MeshPart(part, sourceVertex, sourceFace, Inverse(sourceVertex, source.VertexSlots), Inverse(sourceFace, source.FaceSlots));
        return cutHalfEdge is null ? result : result with { SourceEdge = Array.ConvertAll(cutHalfEdge, h => h < 0 ? -1 : h >> 1) };
    }

    private static int[] NoEdges(int count)
    {
        var none = new int[count];
        Array.Fill(none, -1);
        return none;
    }

    /// <summary>Per old slot the lowest new element that comes from it; −1 if none.</summary>
    internal static int[] Inverse(int[] source, int slots)
    {
        var inverse = new int[slots];
        Array.Fill(inverse, -1);
        for (int i = source.Length - 1; i >= 0; i--)
        {
            if (source[i] >= 0)
                inverse[source[i]] = i;
        }
        return inverse;
    }
}
